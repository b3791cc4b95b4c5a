//! Nodes as people write them.

use crate::infix::Infix;
use crate::ir::{Module, Node, NodeId};
use Instruction::*;
use Node::*;
use std::collections::BTreeMap;
use tpg_graph::{Graph, ScalarType, Word};
use tpg_runtime::ops::Instruction;

/// The formula of a value, for a message.
pub(crate) fn text(module: &Module<'_>, value: NodeId) -> String {
    let formulas = Formulas::new(module, &[value]);
    let named = formulas.shared().iter().map(|(name, formula)| format!(", {name} = {formula}"));
    std::iter::once(formulas.formula(value).to_owned()).chain(named).collect()
}

/// The formulas of a team's bids. What occurs more than once has a name, so that no formula is longer than its program.
pub(crate) struct Formulas {
    /// The term of each node: a name, or its expression.
    terms: BTreeMap<NodeId, Infix>,
    shared: Vec<(String, String)>,
    /// The graph has C++'s minimum, or maximum, and no other.
    of_cpp: [bool; 2],
}

impl Formulas {
    /// Formulas of the values that a team's edges bid.
    pub(crate) fn new(module: &Module<'_>, bids: &[NodeId]) -> Self {
        let mut needed: Vec<NodeId> = bids.iter().flat_map(|&bid| module.operations_of(bid)).collect();
        needed.sort_unstable();
        needed.dedup();
        let mut uses: BTreeMap<NodeId, usize> = BTreeMap::new();
        let operands = needed.iter().flat_map(|&id| module.nodes[id.index()].operands());
        for &id in operands.chain(bids) {
            *uses.entry(id).or_default() += 1;
        }
        let has = |word: Word| module.graph.instructions().contains(&word);
        let of_cpp = [(Min, Word::StdMin), (Max, Word::StdMax)];
        let of_cpp = of_cpp.map(|(own, cpp)| has(cpp) && !has(own.into()));
        let mut formulas = Self { terms: BTreeMap::new(), shared: Vec::new(), of_cpp };
        for &id in bids.iter().chain(needed.iter().flat_map(|id| module.nodes[id.index()].operands())) {
            if let Some(term) = leaf(module.graph, module.node(id)) {
                formulas.terms.insert(id, term);
            }
        }
        // Operands come before operations.
        for id in needed {
            let Operation(instruction, operands) = module.node(id) else { continue };
            let mut term = formulas.operation(instruction, operands);
            if uses.get(&id).is_some_and(|&uses| uses > 1) {
                let name = format!("t{}", formulas.shared.len() + 1);
                formulas.shared.push((name.clone(), term.text));
                term = Infix::atom(name);
            }
            formulas.terms.insert(id, term);
        }
        formulas
    }

    /// The named subexpressions.
    pub(crate) fn shared(&self) -> &[(String, String)] {
        &self.shared
    }

    /// The formula of a bid.
    pub(crate) fn formula(&self, bid: NodeId) -> &str {
        &self.terms[&bid].text
    }

    fn operation(&self, instruction: Instruction, [a, b]: [NodeId; 2]) -> Infix {
        let [a, b] = [a, b].map(|id| &self.terms[&id]);
        let call = |name: &str, operands: &[&Infix]| {
            let operands: Vec<&str> = operands.iter().map(|term| term.text.as_str()).collect();
            Infix::atom(format!("{name}({})", operands.join(", ")))
        };
        match instruction {
            // Only the sign of a zero differs, which no comparison sees.
            Add if a.text == "0" => b.clone(),
            Add => a.plus(b),
            Sub => a.minus(b),
            Mul => a.times(b),
            Div => a.over(b),
            // C++'s have their operands the other way round.
            Min if self.of_cpp[0] => call("std_min", &[b, a]),
            Max if self.of_cpp[1] => call("std_max", &[b, a]),
            _ => call(instruction.name(), &[a, b][..instruction.arity()]),
        }
    }
}

/// A number or a value of the state.
fn leaf(graph: &Graph, node: Node) -> Option<Infix> {
    let text = match node {
        Input(input) => graph.input_label(input),
        Constant(bits) => {
            let value = f64::from_bits(bits);
            let text = match graph.scalar() {
                ScalarType::F32 => format!("{:?}", value as f32),
                ScalarType::F64 => format!("{value:?}"),
            };
            text.strip_suffix(".0").map_or(text.clone(), str::to_owned)
        }
        Operation(..) | Upper(..) => return None,
    };
    Some(Infix { is_number: matches!(node, Constant(_)), ..Infix::atom(text) })
}

#[cfg(test)]
mod tests {
    use super::Formulas;
    use crate::ir::{Module, Node, NodeId, Values};
    use tpg_graph::{Graph, Input};
    use tpg_runtime::ops::Instruction::{self, Abs, Add, Div, Exp, Max, Mul, Sub};

    const FIXTURE: &str = include_str!("../tests/fixtures/all_instructions.json");

    fn formulas(
        text: &str,
        build: impl Fn(&mut dyn FnMut(Instruction, NodeId, NodeId) -> NodeId, NodeId, NodeId) -> Vec<NodeId>,
    ) -> Vec<String> {
        let graph = Graph::from_json("fixture", text).expect("valid");
        let mut values = Values::default();
        let x = values.intern(Node::Input(Input(0)));
        let two = values.intern(Node::constant(-2.0));
        let bids = build(&mut |i, a, b| values.intern(Node::Operation(i, [a, b])), x, two);
        let module = Module { nodes: values.into_nodes(), ..Module::empty(&graph) };
        let formulas = Formulas::new(&module, &bids);
        let shared = formulas.shared().iter().map(|(name, formula)| format!("{name} = {formula}"));
        shared.chain(bids.iter().map(|&bid| formulas.formula(bid).to_owned())).collect()
    }

    #[test]
    fn brackets_stand_where_the_order_of_operations_needs_them() {
        let found = formulas(FIXTURE, |op, x, two| {
            let sum = op(Add, x, two);
            let square = op(Mul, x, x);
            let product = op(Mul, sum, square);
            vec![op(Sub, x, product)]
        });
        assert_eq!(found, ["target[0] - target[0] * target[0] * (target[0] - 2)"]);
        let found = formulas(FIXTURE, |op, x, two| {
            let quotient = op(Div, two, x);
            let inner = op(Sub, x, quotient);
            let absolute = op(Abs, inner, inner);
            let outer = op(Sub, absolute, x);
            vec![op(Max, outer, two)]
        });
        assert_eq!(found, ["max(abs(target[0] + 2 / target[0]) - target[0], -2)"]);
    }

    #[test]
    fn minima_of_cpp_have_their_names_and_their_order() {
        let text = FIXTURE.replace("\"min\"", "\"std_min\"").replace("\"max\"", "\"std_max\"");
        let extremes = |text: &str| formulas(text, |op, x, two| vec![op(Instruction::Min, x, two), op(Max, x, two)]);
        assert_eq!(extremes(&text), ["std_min(-2, target[0])", "std_max(-2, target[0])"]);
        assert_eq!(extremes(FIXTURE), ["min(target[0], -2)", "max(target[0], -2)"]);
    }

    #[test]
    fn what_occurs_twice_has_a_name_so_formulas_stay_short() {
        let found = formulas(FIXTURE, |op, x, _| {
            let mut value = op(Exp, x, x);
            for _ in 0..40 {
                value = op(Add, value, value);
            }
            vec![value, x]
        });
        assert_eq!(found[0], "t1 = exp(target[0])");
        assert_eq!(found[1], "t2 = t1 + t1");
        assert_eq!(found[40], "t40 + t40");
        assert_eq!(found[41], "target[0]");
    }
}
