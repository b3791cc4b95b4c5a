//! The states of the self-test: chosen until each number of the graph is noticed if it is changed by a hundredth.
//!
//! Looked at are states in the declared ranges, the same states nearer to zero, where fewer outputs are at their limits, and
//! neighbours of which each gets another action.

use tpg_graph::interpret::{self, Answer};
use tpg_graph::{Graph, MathsProvider, OperandDocument, Word, dataflow, states};

/// The number of states at most.
const MOST: usize = 24;
/// The number of states that are taken without a choice.
const FIRST: usize = 4;
/// The number of states to choose from, in the ranges and again nearer to zero, for a small graph.
const SAMPLES: usize = 400;
const SEED: u64 = 1;
/// The count of numbers that are changed at most, one after another.
const CHANGES: usize = 1_000;
/// The number of lines of programs that are run at most in a search for states.
const WORK: usize = 40_000_000;

/// The states of a self-test.
pub(crate) struct Vectors {
    /// The states, one after another.
    pub(crate) states: Vec<f64>,
    /// The answer to each.
    pub(crate) answers: Vec<Answer>,
    /// The number of constants and limits that were changed.
    pub(crate) changes: usize,
    /// The number of changes that a state notices.
    pub(crate) noticed: usize,
    /// The number of changes that none of the candidates would notice, and that of the candidates.
    silent: [usize; 2],
}

impl Vectors {
    /// Says how good the states are; nothing where the graph has none.
    pub(crate) fn quality(&self) -> Option<String> {
        let Self { changes, noticed, silent: [silent, candidates], .. } = self;
        let rest = match silent {
            0 => String::new(),
            _ => format!("; in {silent} it changes no answer to any of {candidates} states"),
        };
        (*changes > 0).then(|| format!("A change by 1 % is noticed in {noticed} of {changes} constants{rest}."))
    }
}

/// Chooses the states: a few of any kind, then each time the one that notices most of what no other has noticed.
pub(crate) fn vectors(graph: &Graph) -> Vectors {
    let lines: usize = graph.programs().iter().map(|program| program.lines.len().max(1)).sum();
    let candidates = candidates(graph, (WORK / 400 / lines).clamp(FIRST, SAMPLES));
    let expected = interpret::answers(graph, &candidates);
    let changed = changed(graph, (WORK / lines / expected.len()).clamp(1, CHANGES));
    let noticed_by = |changed: &Graph| -> Vec<usize> {
        let answers = interpret::answers(changed, &candidates);
        (0..expected.len()).filter(|&candidate| answers[candidate] != expected[candidate]).collect()
    };
    let mut open: Vec<Vec<usize>> = changed.iter().map(noticed_by).collect();
    open.retain(|noticed_by| noticed_by.first().is_none_or(|&candidate| candidate >= FIRST));
    let mut chosen: Vec<usize> = (0..FIRST).collect();
    while chosen.len() < MOST {
        let mut counts = vec![0; expected.len()];
        open.iter().flatten().for_each(|&candidate| counts[candidate] += 1);
        // The first of equals; where nothing is noticed any more, the next of those where actions meet.
        let place = (0..counts.len()).rev().filter(|place| !chosen.contains(place)).max_by_key(|&place| counts[place]);
        let Some(place) = place.filter(|_| changed.is_empty() || !open.is_empty()) else { break };
        chosen.push(place);
        open.retain(|noticed_by| !noticed_by.contains(&place));
    }
    let (changes, length) = (changed.len(), graph.state_length());
    let state = |&candidate: &usize| &candidates[candidate * length..(candidate + 1) * length];
    let states = chosen.iter().flat_map(state).copied().collect();
    let answers = chosen.iter().map(|&candidate| expected[candidate].clone()).collect();
    let silent = open.iter().filter(|noticed_by| noticed_by.is_empty()).count();
    Vectors { states, answers, changes, noticed: changes - open.len(), silent: [silent, expected.len()] }
}

/// The states to choose from, one after another.
fn candidates(graph: &Graph, samples: usize) -> Vec<f64> {
    let length = graph.state_length();
    // Counts may be the least that their type holds.
    let first = if graph.has_counts() {
        states::sample(graph, FIRST, SEED)
    } else {
        states::sample_in_range(graph, FIRST, SEED)
    };
    let inside = states::sample_in_range(graph, samples, SEED + 1);
    let shrunk = inside.chunks_exact(length).zip(1..).flat_map(|(state, number)| {
        let share = 0.5_f64.powi(number % 12);
        state.iter().map(move |&value| value * share)
    });
    let shrunk: Vec<f64> = shrunk.map(|value| exact(graph, value)).collect();
    // The platform's functions may round to the other side of a border.
    let rounds = |word: &Word| matches!(word, Word::Instruction(instruction) if instruction.is_transcendental());
    let is_exact = graph.maths() == MathsProvider::Own || !graph.instructions().iter().any(rounds);
    let borders = if is_exact { borders(graph, &inside) } else { Vec::new() };
    [first, borders, shrunk, inside].concat()
}

/// The value of the graph's type, or the count, that is nearest.
fn exact(graph: &Graph, value: f64) -> f64 {
    if graph.has_counts() { value.round() + 0.0 } else { graph.scalar().round(value) }
}

/// Pairs of neighbours between states that lead to different ends.
fn borders(graph: &Graph, states: &[f64]) -> Vec<f64> {
    let length = graph.state_length();
    let ends = interpret::actions(graph, states);
    let mut borders = Vec::new();
    for (number, pair) in ends.windows(2).enumerate() {
        if pair[0] == pair[1] {
            continue;
        }
        let at = |number: usize| states[number * length..(number + 1) * length].to_vec();
        let (mut low, mut high) = (at(number), at(number + 1));
        loop {
            let middle: Vec<f64> = low.iter().zip(&high).map(|(low, high)| exact(graph, (low + high) / 2.0)).collect();
            if middle == low || middle == high {
                break;
            }
            let end = interpret::actions(graph, &middle);
            *(if end == pair[..1] { &mut low } else { &mut high }) = middle;
        }
        borders.extend(low.into_iter().chain(high));
    }
    borders
}

/// A number of a graph.
#[derive(Clone, Copy)]
enum CheckedPlace {
    /// A constant: program, line and operand.
    Operand(usize, usize, usize),
    /// The lower or upper limit of an output.
    Limit(usize, bool),
}

/// The graph with each of its numbers changed in turn: constants that a program's result depends on, and limits of outputs.
fn changed(graph: &Graph, most: usize) -> Vec<Graph> {
    let document = graph.to_document();
    let limits =
        (0..document.outputs.len()).flat_map(|output| [false, true].map(|upper| CheckedPlace::Limit(output, upper)));
    let mut places: Vec<CheckedPlace> = limits.collect();
    for (program, code) in graph.programs().iter().enumerate() {
        let read = dataflow::effective(usize::from(graph.registers()), &code.lines);
        for (line, _) in read.into_iter().enumerate().filter(|(_, read)| *read) {
            let operands = 0..document.programs[program].lines[line].args.len();
            places.extend(operands.map(|operand| CheckedPlace::Operand(program, line, operand)));
        }
    }
    let change = |place: CheckedPlace| {
        let mut document = document.clone();
        let (value, share) = match place {
            CheckedPlace::Operand(program, line, operand) => {
                match &mut document.programs[program].lines[line].args[operand] {
                    OperandDocument::Constant(value) => (value, 1.01),
                    OperandDocument::Place(_) => return None,
                }
            }
            // nearer to zero, where the rest of the output stays valid
            CheckedPlace::Limit(output, false) => (&mut document.outputs[output].min, 0.99),
            CheckedPlace::Limit(output, true) => (&mut document.outputs[output].max, 0.99),
        };
        let more = exact(graph, *value * share);
        *value = match more == *value {
            true if *value == 0.0 => return None,
            true => *value + value.signum() * (share - 1.0).signum(),
            false => more,
        };
        Graph::from_document("the self-test", document).ok()
    };
    let step = places.len().div_ceil(most).max(1);
    places.into_iter().step_by(step).filter_map(change).collect()
}
