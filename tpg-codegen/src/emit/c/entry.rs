//! The entry point: the function that decides, and the types that it takes.

use super::expression::CPrinter;
use tpg_graph::Graph;

/// The names that the body of a policy has for the types it works on, and the head of the function that decides.
///
/// With memory these are the file's own: a state and the memory as one, an answer and the next memory as one. The public
/// function takes them apart, and a compiler puts the two into one.
pub(super) struct Entry {
    /// The type of what is read.
    pub(super) state: String,
    /// The type of what is answered, for a policy with outputs.
    pub(super) answer: String,
    /// The type of an action, or of the values that are answered.
    pub(super) action: String,
    /// The function that decides.
    pub(super) function: String,
    /// Its head.
    pub(super) head: String,
}

impl CPrinter<'_> {
    /// Names the entry point of the graph.
    pub(super) fn entry(&self) -> Entry {
        let (prefix, graph): (&str, &Graph) = (self.prefix, self.graph);
        let [state, answer, function] = match graph.memory() {
            0 => ["state_t", "action_t", "infer"],
            _ => ["view_t", "answer_t", "decide"],
        }
        .map(|name| format!("{prefix}_{name}"));
        let head = match (graph.outputs().len(), graph.memory()) {
            (0, _) => format!("{prefix}_action_t {function}(const {state} *state)"),
            (_, 0) => format!("void {function}(const {state} *state, {answer} *action)"),
            _ => format!("static void {function}(const {state} *state, {answer} *action)"),
        };
        Entry { state, answer, action: format!("{prefix}_action_t"), function, head }
    }
}
