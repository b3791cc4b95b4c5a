//! Binding of a graph to an environment: maps the graph's sources and actions to those of the environment.

use crate::action::{ActionSpace, Output};
use crate::policy::{Destination, Edge, Line, Operand, PolicyGraph};
use crate::source_set::state_length;
use tpg_graph::error::InputError;
use tpg_graph::{Action, ActionDocument, Graph, Input, SourceDocument};

/// Turns a graph into a policy of these sources and actions, or outputs. Sources, actions and outputs are matched by name, in any
/// order.
///
/// # Errors
/// If the graph reads a source that is not there, takes an action that is not known, or asks a policy that is not there. `file` is
/// the name shown in the error.
pub fn bind(
    file: &str,
    graph: &Graph,
    known: &[SourceDocument],
    space: &ActionSpace,
) -> Result<PolicyGraph, InputError> {
    let places = places(file, graph.sources(), known)?;
    if let (ActionSpace::Box(known), false) = (space, graph.outputs().is_empty()) {
        let outputs = outputs(file, graph, known)?;
        let ends: Vec<u16> = (0..graph.leaves().len() as u16).collect();
        let policy = renumbered(PolicyGraph::from(graph), &places, &ends);
        let limits = outputs.iter().map(|&at| policy.outputs[at]).collect();
        let leaves = policy.leaves.iter().map(|leaf| outputs.iter().map(|&at| leaf[at]).collect()).collect();
        return Ok(policy.with_outputs(limits, leaves));
    }
    if !graph.outputs().is_empty() {
        let found = format!("a graph with {} outputs", graph.outputs().len());
        let accepted = "a graph that chooses among the problem's actions";
        return Err(InputError::new(file, "$.outputs", found, accepted));
    }
    let ActionSpace::Discrete(named) = space else {
        let found = format!("a graph that chooses among {} actions", graph.actions().len());
        return Err(InputError::new(file, "$.actions", found, "a problem with named actions"));
    };
    let mut actions = Vec::new();
    for (number, action) in graph.actions().iter().enumerate() {
        let Some(at) = named.iter().position(|other| is_same(action, other)) else {
            if let Some(asked) = &action.ask {
                let found = format!("{asked:?}: a graph that does not act alone");
                let accepted = "the asked policy beside the graph: `tpg-train eval --tpg GRAPH --policy FILE`";
                return Err(InputError::new(file, format!("$.actions[{number}].ask"), found, accepted));
            }
            let names: Vec<&str> = space.names().collect();
            let (path, found) = (format!("$.actions[{number}].name"), format!("{:?}", action.name));
            return Err(InputError::new(file, path, found, names.join(", ")));
        };
        actions.push(at as u16);
    }
    Ok(renumbered(PolicyGraph::from(graph), &places, &actions))
}

/// Returns the place in a state of `known` sources of each value of a graph's own `sources`. Of an image, a graph has the features
/// that it reads.
///
/// # Errors
/// If the graph reads what the known sources do not have.
pub fn places(file: &str, sources: &[SourceDocument], known: &[SourceDocument]) -> Result<Vec<u16>, InputError> {
    let mut places = Vec::new();
    for (number, source) in sources.iter().enumerate() {
        let path = || format!("$.sources[{number}].name");
        let names = || known.iter().map(|source| source.name.as_str()).collect::<Vec<_>>().join(", ");
        let Some(at) = known.iter().position(|other| other.name == source.name) else {
            return Err(InputError::new(file, path(), format!("{:?}", source.name), names()));
        };
        let first = state_length(&known[..at]);
        if let (Some(image), Some(given)) = (&source.image, &known[at].image) {
            for (place, feature) in image.features.iter().enumerate() {
                let found = given.features.iter().position(|other| other == feature);
                let found = found.filter(|_| image.shape == given.shape).ok_or_else(|| {
                    let accepted = format!("the features of {:?} of an image of {:?}", source.name, given.shape);
                    let path = format!("$.sources[{number}].image.features[{place}]");
                    InputError::new(file, path, format!("{feature:?} of an image of {:?}", image.shape), accepted)
                })?;
                places.push((first + found) as u16);
            }
            continue;
        }
        let (length, wanted) = (known[at].length as usize, source.ranges.len());
        if length != wanted {
            let found = format!("{:?} of {wanted} values", source.name);
            return Err(InputError::new(file, path(), found, format!("{length} values")));
        }
        if known[at].counts != source.counts {
            let kind = |is_counts: bool| if is_counts { "counts" } else { "values" };
            let found = format!("{:?} in {}", source.name, kind(!source.counts.is_empty()));
            let accepted = format!("{}, as the environment gives them", kind(!known[at].counts.is_empty()));
            return Err(InputError::new(file, format!("$.sources[{number}].counts"), found, accepted));
        }
        places.extend((first..first + length).map(|place| place as u16));
    }
    Ok(places)
}

/// Turns a graph into a policy that reads a state of these sources, and answers as the graph does.
///
/// # Errors
/// As [`places`].
pub fn reading(file: &str, graph: &Graph, known: &[SourceDocument]) -> Result<PolicyGraph, InputError> {
    let ends: Vec<u16> = (0..graph.ends() as u16).collect();
    Ok(renumbered(PolicyGraph::from(graph), &places(file, graph.sources(), known)?, &ends))
}

/// Compares a graph's action with an environment's: by what it asks, by its effect, or else by name.
fn is_same(action: &Action, other: &ActionDocument) -> bool {
    match (&action.ask, &action.effect, &other.effect) {
        (Some(_), ..) => action.ask == other.ask,
        (None, Some(effect), Some(known)) => other.ask.is_none() && effect == known,
        (None, ..) => other.ask.is_none() && action.name == other.name,
    }
}

/// Returns the place in the graph of each output that the environment expects.
fn outputs(file: &str, graph: &Graph, known: &[Output]) -> Result<Vec<usize>, InputError> {
    if graph.outputs().len() != known.len() {
        let names: Vec<&str> = known.iter().map(|output| output.name.as_str()).collect();
        let found = format!("{} outputs", graph.outputs().len());
        let accepted = format!("{}: {}", known.len(), names.join(", "));
        return Err(InputError::new(file, "$.outputs", found, accepted));
    }
    let mut places = Vec::new();
    for output in known {
        let Some(at) = graph.outputs().iter().position(|other| other.name == output.name) else {
            return Err(InputError::new(file, "$.outputs", "no output of that name", format!("{:?}", output.name)));
        };
        let range = graph.outputs()[at].range;
        if range.min < output.min || range.max > output.max {
            let (found, accepted) = (range.to_string(), format!("at least {}, at most {}", output.min, output.max));
            return Err(InputError::new(file, format!("$.outputs[{at}]"), found, accepted));
        }
        places.push(at);
    }
    Ok(places)
}

/// Renumbers the inputs and actions of a policy.
fn renumbered(policy: PolicyGraph, places: &[u16], actions: &[u16]) -> PolicyGraph {
    let operand = |operand: Operand| match operand {
        Operand::Input(input) => Operand::Input(places[Input(input).index()]),
        other => other,
    };
    let line = |line: Line| Line { operands: line.operands.map(operand), ..line };
    let edge = |edge: Edge| match edge.to {
        Destination::Action(action) => Edge { to: Destination::Action(actions[usize::from(action)]), ..edge },
        Destination::Team(_) => edge,
    };
    let PolicyGraph { registers, teams, programs, outputs, leaves } = policy;
    PolicyGraph {
        outputs,
        leaves,
        registers,
        teams: teams.into_iter().map(|team| team.into_iter().map(edge).collect()).collect(),
        programs: programs.iter().map(|lines| lines.iter().copied().map(line).collect()).collect(),
    }
}
