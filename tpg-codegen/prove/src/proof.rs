//! Three answers: proven for all inputs, different in a state, or not decided.

use crate::graph::Graph;
use crate::graph::meaning::Meaning;
use crate::input::{Missing, Result};
use crate::machine::Machine;
use crate::order::together;
use crate::product::{Comparison, Effort, Queries, Work, excluded, in_ranges};
use crate::states::Stream;
use crate::term::Terms;
use Verdict::*;
use serde_json::{Value, json};
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fmt;

/// States in which a difference is looked for if there is no proof.
const STATES: u64 = 20_000;

/// A state in which the code answers something else. Both answers were computed anew for that state alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Difference {
    /// The values of the state, then those of the memory
    pub state: Vec<String>,
    /// The graph's answer
    pub expected: String,
    /// The code's answer
    pub found: String,
}

/// The result of a proof.
#[derive(Clone, Debug)]
pub enum Verdict {
    /// The code answers what the graph does, for all inputs
    Proven,
    /// It does not
    Different(Difference),
    /// Nothing is known
    Undecided(Missing),
}

/// What was found, and what was done for it.
#[derive(Clone, Debug)]
pub struct Proof {
    /// The result
    pub verdict: Verdict,
    /// The work
    pub work: Work,
    /// The rules that were applied, with how often each was
    pub lemmas: BTreeMap<&'static str, u64>,
    /// Every answer is a number in its range, for all inputs; nothing for actions
    pub in_range: Option<bool>,
    /// Only states in the declared ranges are claimed
    pub assumed_ranges: bool,
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let inputs = if self.assumed_ranges { "all inputs in the declared ranges" } else { "all inputs" };
        match &self.verdict {
            Proven => write!(f, "proven equal to the graph for {inputs}")?,
            Undecided(missing) => write!(f, "not decided: {missing}")?,
            Different(Difference { state, expected, found }) => {
                write!(f, "different: the code answers {found} instead of {expected} for [{}]", state.join(", "))?;
            }
        }
        if self.in_range == Some(true) && matches!(self.verdict, Proven) {
            write!(f, "; every answer is a number in its range for {inputs}")?;
        }
        Ok(())
    }
}

/// Compares code with a graph. The code is read anew for each attempt. What is decided also goes to `queries`, as scripts that
/// no state satisfies.
pub fn prove<M: Machine>(
    graph: &Graph,
    read: &dyn Fn() -> Result<M>,
    assume_ranges: bool,
    effort: Effort,
    queries: Queries<'_>,
) -> Proof {
    let ranges = if assume_ranges { &graph.ranges[..] } else { &[] };
    let in_range = (!graph.leaves.is_empty()).then(|| in_range(graph, ranges, effort, queries));
    let (work, lemmas) = (Work::default(), BTreeMap::new());
    let mut machine = match read() {
        Ok(machine) => machine,
        Err(missing) => {
            return Proof { verdict: Undecided(missing), work, lemmas, in_range, assumed_ranges: assume_ranges };
        }
    };
    let mut comparison = Comparison::new(graph, &mut machine, Terms::new(), ranges, effort);
    comparison.queries = queries;
    let verdict = match comparison.prove() {
        Ok(()) => Proven,
        Err(missing) => {
            let state = difference(&mut comparison, graph, assume_ranges);
            state.and_then(|state| replayed(graph, &state, read)).map_or(Undecided(missing), Different)
        }
    };
    let (work, lemmas) = (comparison.work.clone(), comparison.terms.lemmas());
    Proof { verdict, work, lemmas, in_range, assumed_ranges: assume_ranges }
}

/// Tests whether every answer is proven to be a number in its range.
fn in_range(graph: &Graph, ranges: &[[f64; 2]], effort: Effort, queries: Queries<'_>) -> bool {
    let (terms, mut meaning) = (Terms::new(), Meaning::new(graph));
    let claimed = in_ranges(graph, &terms, ranges);
    let all = (0..graph.leaves.len()).all(|leaf| {
        let Ok(inside) = meaning.in_range(&terms, leaf) else { return false };
        let sides = [&[inside, !inside][..], &[Terms::TRUE]];
        let found = together(&terms, claimed, sides, effort.cases);
        let holds = found.as_ref().is_some_and(|found| !found.incomplete && !found.pairs.contains(&(1, 0)));
        if let (true, Some(found), Some(take)) = (holds, found, queries) {
            take(excluded(&terms, claimed, sides, &found.pairs));
        }
        holds
    });
    all && terms.complete(String::new).is_ok()
}

/// A state in which code and graph differ, among many.
fn difference(comparison: &mut Comparison<'_>, graph: &Graph, inside: bool) -> Option<Vec<u32>> {
    let mut stream = Stream::new(1);
    let borders = comparison.terms.borders();
    for number in 0..STATES {
        let mut state = stream.state(graph, inside);
        if number % 2 == 1 && !borders.is_empty() {
            stream.approach(&borders[number as usize / 2 % borders.len()], graph, inside, &mut state);
        }
        let [expected, found] = comparison.answers_for(&state).ok()?;
        if expected != found {
            return Some(state);
        }
    }
    None
}

/// A difference in one of so many states, each computed by itself: nothing that a proof uses has a part in it.
pub fn sampled<M: Machine>(graph: &Graph, read: &dyn Fn() -> Result<M>, states: u64, seed: u64) -> Option<Difference> {
    let mut stream = Stream::new(seed);
    (0..states).find_map(|_| replayed(graph, &stream.state(graph, false), read))
}

/// The difference in a state, computed with that state's numbers from the start on.
fn replayed<M: Machine>(graph: &Graph, state: &[u32], read: &dyn Fn() -> Result<M>) -> Option<Difference> {
    let mut machine = read().ok()?;
    let mut comparison = Comparison::new(graph, &mut machine, Terms::for_state(state), &[], Effort::default());
    let [expected, found] = comparison.answers_for(state).ok()?;
    let text = |&bits: &u32| match graph.is_whole() {
        true => (bits as i32).to_string(),
        false => format!("{:?}", f32::from_bits(bits)),
    };
    let state = state.iter().map(text).collect();
    (expected != found).then_some(Difference { state, expected, found })
}

/// The SHA-256 of a file's bytes.
fn sha256(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

/// Assumptions of every proof.
const ASSUMPTIONS: [&str; 5] = [
    "binary32 arithmetic as IEEE 754 defines it, rounded to nearest, ties to even",
    "subnormal numbers are not flushed to zero",
    "sign and payload of a NaN are not observed",
    "the terms' rules, each an identity over all bit patterns (docs/proven.md)",
    "this tool",
];

impl Proof {
    /// A certificate. The files are named with their SHA-256.
    #[must_use]
    pub fn certificate(&self, files: &[(&str, &[u8])], more_assumptions: &[&str]) -> Value {
        let (result, details) = match &self.verdict {
            Proven => ("proven", Value::Null),
            Undecided(missing) => ("not decided", json!(missing.to_string())),
            Different(difference) => (
                "different",
                json!({ "state": difference.state, "graph": difference.expected, "code": difference.found }),
            ),
        };
        let files: serde_json::Map<_, _> =
            files.iter().map(|&(name, bytes)| (name.to_owned(), json!({ "sha256": sha256(bytes) }))).collect();
        let ranges = self.assumed_ranges.then_some("every value of the state is a number in its declared range");
        let assumptions: Vec<_> = ASSUMPTIONS.iter().chain(more_assumptions).copied().chain(ranges).collect();
        json!({
            "tool": { "name": env!("CARGO_PKG_NAME"), "version": env!("CARGO_PKG_VERSION") },
            "files": files,
            "result": result,
            "details": details,
            "outputs_in_range": self.in_range,
            "pairs": self.work.pairs,
            "pieces": self.work.pieces,
            "cases": self.work.cases,
            "lemmas": self.lemmas,
            "assumptions": assumptions,
        })
    }
}
