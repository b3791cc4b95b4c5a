//! Export of an engine policy to a graph that can be written, compiled and run anywhere.

use super::vocabulary::Vocabulary;
use std::collections::BTreeMap;
use tpg_engine::{ActionSpace, Destination, Limits, Operand, Output, PolicyGraph};
use tpg_graph::dataflow::effective;
use tpg_graph::error::InputError;
use tpg_graph::{
    Document, EdgeDocument, FORMAT, Graph, LeafDocument, LineDocument, MathsProvider, MemoryDocument, OperandDocument,
    OutputDocument, ProgramDocument, Provenance, ScalarType, SourceDocument, TeamDocument,
};

/// Converts a policy to a graph. Lines without effect are removed; a program that bids for several destinations is
/// duplicated, because a graph's program has only one. The last `memory` outputs and sources are the policy's memory.
///
/// # Errors
/// If the actions are not named, or the graph is invalid, which would be a defect of the trainer.
pub(super) fn graph(
    policy: &PolicyGraph,
    vocabulary: &Vocabulary,
    sources: Vec<SourceDocument>,
    actions: ActionSpace,
    memory: usize,
    provenance: Provenance,
) -> Result<Graph, InputError> {
    let mut outputs: Vec<OutputDocument> = (actions.outputs().iter().zip(&vocabulary.outputs))
        .map(|(Output { name, unit, .. }, &Limits { min, max, nan })| OutputDocument {
            name: name.clone(),
            unit: unit.clone(),
            min,
            max,
            nan,
            counts: None,
        })
        .collect();
    let remembered = outputs.split_off(outputs.len() - memory.min(outputs.len()));
    let memory: Vec<MemoryDocument> = (remembered.into_iter())
        .map(|OutputDocument { name, min, max, nan, .. }| MemoryDocument { name, min, max, initial: nan })
        .collect();
    let actions = match actions {
        ActionSpace::Discrete(actions) => actions,
        ActionSpace::Box(_) => Vec::new(),
    };
    let names: Vec<String> = (sources.iter())
        .flat_map(|source| (0..source.length).map(move |index| format!("{}[{index}]", source.name)))
        .collect();
    let mut copies: BTreeMap<(u32, (u8, u32)), u32> = BTreeMap::new();
    let mut programs = Vec::new();
    let mut teams = Vec::new();
    let mut copy = |program: u32, destination: (u8, u32)| {
        *copies.entry((program, destination)).or_insert_with(|| {
            let id = programs.len() as u32;
            programs.push(ProgramDocument { id, lines: lines(policy, program, &names) });
            id
        })
    };
    // A single leaf needs no team, and its bid does not matter.
    let is_formula = matches!(&policy.teams[..], [team] if team.len() == 1) && !outputs.is_empty();
    for (id, team) in (0..).zip(policy.teams.iter().filter(|_| !is_formula)) {
        let edges = team.iter().map(|edge| {
            let (destination, team) = match edge.to {
                Destination::Team(team) => ((0, team), Some(team)),
                Destination::Action(end) => ((1, u32::from(end)), None),
            };
            let program = copy(edge.program, destination);
            let end = team.is_none().then_some(destination.1);
            let (action, leaf) = if outputs.is_empty() { (end, None) } else { (None, end) };
            EdgeDocument { program, team, action, leaf }
        });
        teams.push(TeamDocument { id, edges: edges.collect() });
    }
    let leaves = (0..).zip(&policy.leaves).map(|(id, leaf)| {
        let mut programs: Vec<u32> = leaf.iter().map(|&program| copy(program, (2, 0))).collect();
        let memory = programs.split_off(outputs.len());
        LeafDocument { id, programs, memory }
    });
    let leaves: Vec<LeafDocument> = leaves.collect();
    let mut words = Vec::new();
    vocabulary.instructions.iter().for_each(|instruction| instruction.words(&mut words));
    let observed = sources.len() - memory.len();
    let sees = sources.iter().any(|source| source.image.is_some());
    let sources = sources.into_iter().take(observed).map(|source| exact(source, vocabulary.scalar)).collect();
    let document = Document {
        format: FORMAT.to_owned(),
        version: if outputs.is_empty() && !sees { 1 } else { 2 },
        scalar: vocabulary.scalar,
        maths: MathsProvider::Own,
        registers: u32::from(policy.registers),
        sources,
        instructions: words.into_iter().map(|word| word.name().to_owned()).collect(),
        actions,
        outputs,
        memory,
        root: (!is_formula).then_some(0),
        teams,
        leaves,
        programs,
        provenance,
    };
    Graph::from_document("<evolved graph>", document)
}

/// Returns a source with finite ranges, for a graph that is only evaluated: no answer depends on them.
pub(crate) fn finite(mut source: SourceDocument) -> SourceDocument {
    source.ranges.iter_mut().flatten().for_each(|end| *end = end.clamp(-1e6, 1e6));
    source
}

/// Moves the ends of a range outwards to the next numbers that are exact in the graph's scalar type, as a graph
/// requires.
pub(crate) fn exact(source: SourceDocument, scalar: ScalarType) -> SourceDocument {
    let outwards = |[min, max]: [f64; 2]| match scalar {
        ScalarType::F64 => [min, max],
        ScalarType::F32 => {
            let (low, high) = (min as f32, max as f32);
            let low = if f64::from(low) > min { low.next_down() } else { low };
            let high = if f64::from(high) < max { high.next_up() } else { high };
            [low, high].map(f64::from)
        }
    };
    SourceDocument { ranges: source.ranges.into_iter().map(outwards).collect(), ..source }
}

fn lines(policy: &PolicyGraph, program: u32, names: &[String]) -> Vec<LineDocument> {
    let lines = &policy.programs[program as usize];
    let operand = |operand: &Operand| match *operand {
        Operand::Register(register) => OperandDocument::Place(format!("r{register}")),
        Operand::Input(input) => OperandDocument::Place(names[usize::from(input)].clone()),
        Operand::Constant(value) => OperandDocument::Constant(value),
    };
    (lines.iter().zip(effective(policy.registers.into(), lines)))
        .filter(|(_, effective)| *effective)
        .map(|(line, _)| LineDocument {
            to: u32::from(line.to),
            op: line.instruction.name().to_owned(),
            args: line.operands.iter().take(line.instruction.arity()).map(operand).collect(),
        })
        .collect()
}
