//! The states of the self-test: chosen until each constant of the graph is noticed if it is changed by a hundredth.
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
/// The number of constants that are changed at most, one after another.
const CHANGES: usize = 1_000;
/// The number of lines of programs that are run at most in a search for states.
const WORK: usize = 4_000_000;

/// The states of a self-test.
pub(crate) struct Vectors {
    /// The states, one after another.
    pub(crate) states: Vec<f64>,
    /// The answer to each.
    pub(crate) answers: Vec<Answer>,
    /// The number of constants that were changed.
    pub(crate) changes: usize,
    /// The number of changes that a state notices.
    pub(crate) noticed: usize,
}

impl Vectors {
    /// Says how good the states are; nothing where the graph has no constants.
    pub(crate) fn quality(&self) -> Option<String> {
        let Self { changes, noticed, .. } = self;
        (*changes > 0)
            .then(|| format!("They notice {noticed} of {changes} constants of the graph that are changed by 1 %."))
    }
}

/// Chooses the states.
pub(crate) fn vectors(graph: &Graph) -> Vectors {
    let lines: usize = graph.programs().iter().map(|program| program.lines.len().max(1)).sum();
    let candidates = candidates(graph, (WORK / 40 / lines).clamp(FIRST, SAMPLES));
    let expected = interpret::answers(graph, &candidates);
    let length = graph.state_length();
    let state = |candidate: usize| &candidates[candidate * length..(candidate + 1) * length];
    let differs = |changed: &Graph, candidate: usize| {
        let answers = interpret::answers(changed, state(candidate));
        answers[..] != expected[candidate..=candidate]
    };
    let mut left = WORK;
    let mut open = changed(graph);
    let changes = open.len();
    let mut chosen = Vec::new();
    let mut noticed = 0;
    let mut take = |candidate: usize, open: &mut Vec<Graph>| {
        let before = open.len();
        open.retain(|changed| !differs(changed, candidate));
        noticed += before - open.len();
        chosen.push(candidate);
        chosen.len() < MOST
    };
    let mut more = (0..FIRST).fold(true, |_, candidate| take(candidate, &mut open));
    while more && let Some(changed) = open.pop() {
        let Some(rest) = left.checked_sub(lines * expected.len()) else { break };
        left = rest;
        let answers = interpret::answers(&changed, &candidates);
        if let Some(candidate) = answers.iter().zip(&expected).position(|(answer, expected)| answer != expected) {
            open.push(changed);
            more = take(candidate, &mut open);
        }
    }
    let states = chosen.iter().flat_map(|&candidate| state(candidate)).copied().collect();
    let answers = chosen.iter().map(|&candidate| expected[candidate].clone()).collect();
    Vectors { states, answers, changes, noticed }
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
    let nearer = inside.chunks_exact(length).zip(1..).flat_map(|(state, number)| {
        let share = 0.5_f64.powi(number % 12);
        state.iter().map(move |&value| value * share)
    });
    let nearer: Vec<f64> = nearer.map(|value| exact(graph, value)).collect();
    // The platform's functions may round to the other side of a border.
    let rounds = |word: &Word| matches!(word, Word::Instruction(instruction) if instruction.is_transcendental());
    let is_exact = graph.maths() == MathsProvider::Own || !graph.instructions().iter().any(rounds);
    let borders = if is_exact { borders(graph, &inside) } else { Vec::new() };
    [first, borders, nearer, inside].concat()
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

/// The graph with each of its constants changed in turn, where a program's result depends on it.
fn changed(graph: &Graph) -> Vec<Graph> {
    let document = graph.to_document();
    let mut places = Vec::new();
    for (program, code) in graph.programs().iter().enumerate() {
        let read = dataflow::effective(usize::from(graph.registers()), &code.lines);
        for (line, _) in read.into_iter().enumerate().filter(|(_, read)| *read) {
            let operands = &document.programs[program].lines[line].args;
            let constant =
                |operand: &OperandDocument| matches!(operand, OperandDocument::Constant(value) if *value != 0.0);
            let constants = operands.iter().enumerate().filter(|(_, operand)| constant(operand));
            places.extend(constants.map(|(operand, _)| (program, line, operand)));
        }
    }
    let step = places.len().div_ceil(CHANGES).max(1);
    let change = |&(program, line, operand): &(usize, usize, usize)| {
        let mut document = document.clone();
        if let OperandDocument::Constant(value) = &mut document.programs[program].lines[line].args[operand] {
            let more = exact(graph, *value * 1.01);
            *value = if more == *value { *value + value.signum() } else { more };
        }
        Graph::from_document("the self-test", document).ok()
    };
    places.iter().step_by(step).filter_map(change).collect()
}
