//! The fewest bits of a graph in integers that keep its return.

use std::fmt;
use std::slice::from_ref;
use tpg_codegen::quantise::{Agreement, QuantiseReport, Request, quantise};
use tpg_engine::{Sample, finite};
use tpg_graph::Graph;
use tpg_graph::error::InputError;
use tpg_graph::states::StateSet;

/// The numbers of bits that are tried.
const BITS: [u32; 5] = [8, 10, 12, 14, 16];
/// The multiple of the visited ranges that fills the bits.
const MARGIN: f64 = 2.0;

/// Episodes that a graph has played.
#[derive(Clone, Debug)]
pub struct Visit {
    /// The return of each.
    pub returns: Vec<f64>,
    /// The states in which it decided, concatenated: values in the order of its inputs, without its memory.
    pub states: Vec<f64>,
}

/// A graph in integers, and what that changes.
#[derive(Clone, Debug)]
pub struct InIntegers {
    /// The graph.
    pub graph: Graph,
    report: QuantiseReport,
    /// The return of the floats.
    floats: Sample,
    tried: Vec<Tried>,
}

/// A return in integers.
#[derive(Clone, Debug)]
struct Tried {
    bits: u32,
    result: Sample,
    /// The return less that of the floats, episode by episode.
    difference: Sample,
}

impl InIntegers {
    /// Puts a graph into integers, with inputs and weights of so many bits, or of the fewest of 8, 10, 12, 14 and 16 with which the
    /// mean return is at most one standard error lower. Both graphs play the same episodes, at least two: `play` returns those of
    /// a graph. The bits hold the ranges of `given` states, or twice the ranges that the floats visit. `file` is the graph's name
    /// in messages.
    ///
    /// # Errors
    /// If the graph cannot be put into integers, or cannot be played.
    pub fn keeping_return<E: From<InputError>>(
        file: &str,
        graph: &Graph,
        bits: Option<u32>,
        given: Option<StateSet>,
        mut play: impl FnMut(&Graph) -> Result<Visit, E>,
    ) -> Result<Self, E> {
        let scores = |visit: &Visit| visit.returns.iter().map(|&score| finite(score)).collect::<Vec<_>>();
        let visit = play(graph)?;
        let returns = scores(&visit);
        let floats = Sample::new(&returns);
        let margin = if given.is_some() { 1.0 } else { MARGIN };
        let states = given.unwrap_or_else(|| visited(graph, &varied(visit.states, graph.observed_length())));
        let (mut tried, mut found) = (Vec::new(), None);
        for &bits in bits.as_ref().map_or(&BITS[..], from_ref) {
            let (whole, mut report) = quantise(file, graph, &Request { margin, ..Request::of_bits(bits, &states) })?;
            let visit = play(&whole)?;
            report.comparison = Agreement::new(graph, &whole, &visited(graph, &visit.states));
            let result = scores(&visit);
            let differences: Vec<f64> = result.iter().zip(&returns).map(|(whole, float)| whole - float).collect();
            let one = Tried { bits, result: Sample::new(&result), difference: Sample::new(&differences) };
            let is_kept = one.keeps(&floats);
            tried.push(one);
            found = Some((whole, report));
            if is_kept {
                break;
            }
        }
        let (graph, report) = found.expect("some bits were tried");
        Ok(Self { graph, report, floats, tried })
    }
}

impl Tried {
    fn keeps(&self, floats: &Sample) -> bool {
        -self.difference.mean <= standard_error(floats)
    }
}

fn standard_error(sample: &Sample) -> f64 {
    sample.sample_deviation() / (sample.count as f64).sqrt()
}

/// Returns visited states as those of a graph; its memory is 0.
fn visited(graph: &Graph, states: &[f64]) -> StateSet {
    let memory = vec![0.0; graph.memory()];
    let states = states.chunks_exact(graph.observed_length());
    let origin = format!("{} states that the integers visit", states.len());
    let states = states.flat_map(|state| state.iter().chain(&memory)).copied().collect();
    StateSet { states, is_visited: true, origin }
}

/// Adds a state, so that a value that never changed has a range, too.
fn varied(mut states: Vec<f64>, length: usize) -> Vec<f64> {
    for place in 0..length {
        let mut values = states.iter().skip(place).step_by(length);
        let first = values.next().copied().unwrap_or_default();
        let is_constant = values.all(|&value| value == first);
        states.push(if is_constant { first + 1.0 } else { first });
    }
    states
}

impl fmt::Display for InIntegers {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { report, floats, tried, .. } = self;
        let [low, high] = floats.interval();
        writeln!(f, "{report}mean return of {} episodes", floats.count)?;
        writeln!(f, "  floats   {:.2} (95 %: {low:.2} to {high:.2})", floats.mean)?;
        for Tried { bits, result, difference } in tried {
            let ([low, high], [less, more]) = (result.interval(), difference.interval());
            write!(f, "  {:9}{:.2} (95 %: {low:.2} to {high:.2}), ", format!("{bits} bits"), result.mean)?;
            writeln!(f, "difference {:+.2} (95 %: {less:+.2} to {more:+.2})", difference.mean)?;
        }
        let last = &tried[tried.len() - 1];
        let words = if last.keeps(floats) { "at most" } else { "more than" };
        let error = standard_error(floats);
        writeln!(f, "with {} bits, it is {words} one standard error lower ({error:.2})", last.bits)
    }
}
