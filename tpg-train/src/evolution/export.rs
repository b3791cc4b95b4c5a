//! Export of an engine policy to a graph that can be written, compiled and run anywhere.

use super::vocabulary::Vocabulary;
use std::collections::BTreeMap;
use tpg_engine::{ActionSpace, Destination, Operand, Policy};
use tpg_graph::dataflow::effective;
use tpg_graph::error::{InputError, Place};
use tpg_graph::{
    Document, EdgeDocument, FORMAT, Graph, LineDocument, MathsProvider, OperandDocument, ProgramDocument, Provenance,
    ScalarType, SourceDocument, TeamDocument,
};
use tpg_runtime::ops::Instruction;

/// Converts a policy to a graph. Lines without effect are removed; a program that bids for several destinations is
/// duplicated, because a graph's program has only one.
///
/// # Errors
/// If the actions are not named, or the graph is invalid, which would be a defect of the trainer.
pub fn graph(
    policy: &Policy,
    vocabulary: &Vocabulary,
    sources: Vec<SourceDocument>,
    actions: ActionSpace,
    provenance: Provenance,
) -> Result<Graph, InputError> {
    let ActionSpace::Discrete(actions) = actions else {
        let found = "actions that are not a list of names";
        return Err(InputError::new("<evolved graph>", Place::Whole, found, "a discrete action space"));
    };
    let names: Vec<String> = (sources.iter())
        .flat_map(|source| (0..source.length).map(move |index| format!("{}[{index}]", source.name)))
        .collect();
    let mut copies: BTreeMap<(u32, (u8, u32)), u32> = BTreeMap::new();
    let mut programs = Vec::new();
    let mut teams = Vec::new();
    for (id, team) in (0..).zip(&policy.teams) {
        let edges = team.iter().map(|edge| {
            let (destination, to_team, to_action) = match edge.to {
                Destination::Team(team) => ((0, team), Some(team), None),
                Destination::Action(action) => ((1, u32::from(action)), None, Some(u32::from(action))),
            };
            let program = *copies.entry((edge.program, destination)).or_insert_with(|| {
                let id = programs.len() as u32;
                programs.push(ProgramDocument { id, lines: lines(policy, edge.program, &names) });
                id
            });
            EdgeDocument { program, team: to_team, action: to_action, leaf: None }
        });
        teams.push(TeamDocument { id, edges: edges.collect() });
    }
    let mut instructions = vocabulary.instructions().to_vec();
    if vocabulary.bound(0).is_some() && !instructions.contains(&Instruction::Min) {
        instructions.push(Instruction::Min);
    }
    let sources = sources.into_iter().map(|source| exact(source, vocabulary.scalar())).collect();
    let document = Document {
        format: FORMAT.to_owned(),
        version: 1,
        scalar: vocabulary.scalar(),
        maths: MathsProvider::Own,
        registers: u32::from(policy.registers),
        sources,
        instructions: instructions.iter().map(|i| i.name().to_owned()).collect(),
        actions,
        root: Some(0),
        teams,
        programs,
        provenance,
        ..Document::default()
    };
    Graph::from_document("<evolved graph>", document)
}

/// Moves the ends of a range outwards to the next numbers that are exact in the graph's scalar type, as a graph
/// requires.
fn exact(source: SourceDocument, scalar: ScalarType) -> SourceDocument {
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

fn lines(policy: &Policy, program: u32, names: &[String]) -> Vec<LineDocument> {
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
