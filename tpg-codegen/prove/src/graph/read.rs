//! A reader of `graph.json`, versions 1 and 2, in binary32.

use super::{Destination::*, Graph, GraphEdge, GraphLine, GraphOperand, GraphTeam, ValueLimits, circle};
use crate::input::InputError;
use crate::machine::Interface;
use serde::Deserialize;
use serde::de::IgnoredAny;
use std::collections::HashMap;

/// The file. What is not read could change what the graph means: it is refused.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "some members are read to be checked")]
struct GraphJson {
    format: FormatJson,
    version: u32,
    scalar: ScalarJson,
    maths: MathsJson,
    registers: usize,
    #[serde(default)]
    sources: Vec<SourceJson>,
    instructions: IgnoredAny,
    #[serde(default)]
    actions: Vec<IgnoredAny>,
    #[serde(default)]
    outputs: Vec<OutputJson>,
    #[serde(default)]
    memory: Vec<MemoryJson>,
    root: Option<u64>,
    #[serde(default)]
    teams: Vec<TeamJson>,
    #[serde(default)]
    leaves: Vec<LeafJson>,
    programs: Vec<ProgramJson>,
    provenance: Option<IgnoredAny>,
}

#[derive(Deserialize)]
enum FormatJson {
    #[serde(rename = "tpg-graph")]
    Graph,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum ScalarJson {
    F32,
}

#[derive(Deserialize, PartialEq)]
#[serde(rename_all = "lowercase")]
enum MathsJson {
    Own,
    System,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "a unit is for people")]
struct SourceJson {
    name: String,
    length: u32,
    unit: Option<IgnoredAny>,
    #[serde(default)]
    ranges: Vec<[NumberJson; 2]>,
    /// The proof is of the decision for a state, however its values came about.
    image: Option<IgnoredAny>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
#[expect(dead_code, reason = "a unit is for people")]
struct OutputJson {
    name: String,
    unit: Option<IgnoredAny>,
    min: NumberJson,
    max: NumberJson,
    nan: NumberJson,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MemoryJson {
    name: String,
    min: NumberJson,
    max: NumberJson,
    initial: NumberJson,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct TeamJson {
    id: u64,
    edges: Vec<EdgeJson>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct EdgeJson {
    program: u64,
    team: Option<u64>,
    action: Option<u32>,
    leaf: Option<u64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LeafJson {
    id: u64,
    #[serde(default)]
    programs: Vec<u64>,
    #[serde(default)]
    memory: Vec<u64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ProgramJson {
    id: u64,
    lines: Vec<LineJson>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct LineJson {
    to: usize,
    op: String,
    args: Vec<OperandJson>,
}

#[derive(Deserialize)]
#[serde(
    untagged,
    expecting = "something else, expected a finite number of binary32, a register or a value of a source or memory"
)]
enum OperandJson {
    Number(NumberJson),
    Name(String),
}

/// The binary32 number nearest to the binary64 number nearest to what is written, as the format says.
#[derive(Clone, Copy, Deserialize)]
#[serde(try_from = "f64")]
struct NumberJson(f32);

impl TryFrom<f64> for NumberJson {
    type Error = String;

    fn try_from(value: f64) -> Result<Self, String> {
        let number = Some(Self(value as f32)).filter(|number| number.0.is_finite());
        number.ok_or_else(|| format!("{value}, expected a finite number of binary32"))
    }
}

/// A fault of the file that is being read.
fn fault(place: String, found: impl ToString, accepted: &str) -> InputError {
    InputError { file: String::new(), place, found: found.to_string(), accepted: accepted.to_owned() }
}

/// The places of a list's items by their ids.
struct Ids {
    list: &'static str,
    places: HashMap<u64, usize>,
}

impl Ids {
    fn new(list: &'static str, ids: impl Iterator<Item = u64>) -> Result<Self, InputError> {
        let mut places = HashMap::new();
        for (place, id) in ids.enumerate() {
            if places.insert(id, place).is_some() {
                return Err(fault(format!("graph.{list}[{place}].id"), id, "an id that no other has"));
            }
        }
        Ok(Self { list, places })
    }

    fn find(&self, id: u64, place: impl FnOnce() -> String) -> Result<usize, InputError> {
        let known = self.places.get(&id).copied();
        known.ok_or_else(|| fault(place(), id, &format!("an id of {}", self.list)))
    }
}

impl Graph {
    /// Reads a graph.
    ///
    /// # Errors
    /// The first fault.
    pub fn read(file: &str, text: &str) -> Result<Self, InputError> {
        let mut json = serde_json::Deserializer::from_str(text);
        let read = serde_path_to_error::deserialize(&mut json).map_err(|error| {
            let (path, message) = (error.path().to_string(), error.inner().to_string());
            let (found, accepted) = message.split_once(", expected ").unwrap_or((&message, "a graph in JSON"));
            let place = if path == "." { "graph".to_owned() } else { format!("graph.{path}") };
            fault(place, found, accepted)
        });
        let end = |written| json.end().map(|()| written).map_err(|error| fault("the end".to_owned(), error, "nothing"));
        let graph = read.and_then(end).and_then(|written| Self::resolve(&written));
        graph.map_err(|error| InputError { file: file.to_owned(), ..error })
    }

    fn resolve(written: &GraphJson) -> Result<Self, InputError> {
        if !(1..=2).contains(&written.version) {
            return Err(fault("graph.version".to_owned(), written.version, "1 or 2"));
        }
        let registers = written.registers;
        if !(1..=256).contains(&registers) {
            return Err(fault("graph.registers".to_owned(), registers, "1 to 256"));
        }
        let (mut interface, mut ranges, mut values) = (Interface::default(), Vec::new(), HashMap::new());
        for SourceJson { name, length, ranges: declared, .. } in &written.sources {
            for at in 0..*length {
                values.insert(format!("{name}[{at}]"), interface.state_length() + at);
                let range = declared.get(at as usize).or(declared.first());
                ranges.push(range.map_or([f32::NEG_INFINITY, f32::INFINITY], |ends| ends.map(|end| end.0)));
            }
            interface.sources.push((name.clone(), *length));
        }
        let mut limits: Vec<ValueLimits> = Vec::new();
        for OutputJson { name, min, max, nan, .. } in &written.outputs {
            interface.outputs.push(name.clone());
            limits.push([min.0, max.0, nan.0]);
        }
        let state = interface.state_length();
        for (number, MemoryJson { name, min, max, initial }) in (state..).zip(&written.memory) {
            values.insert(format!("{name}[0]"), number);
            interface.memory.push(name.clone());
            ranges.push([min.0, max.0]);
            limits.push([min.0, max.0, initial.0]);
        }
        let programs = (written.programs.iter().enumerate()).map(|(place, program)| {
            let lines = program.lines.iter().enumerate();
            lines
                .map(|(line, it)| it.read(&format!("graph.programs[{place}].lines[{line}]"), &values, registers))
                .collect()
        });
        let programs = programs.collect::<Result<_, _>>()?;
        let program_ids = Ids::new("programs", written.programs.iter().map(|program| program.id))?;
        let leaf_ids = Ids::new("leaves", written.leaves.iter().map(|leaf| leaf.id))?;
        let mut leaves = Vec::new();
        for (place, leaf) in written.leaves.iter().enumerate() {
            let mut all = Vec::new();
            for (member, ids, count) in
                [("programs", &leaf.programs, written.outputs.len()), ("memory", &leaf.memory, written.memory.len())]
            {
                let list = format!("graph.leaves[{place}].{member}");
                if ids.len() != count {
                    return Err(fault(list, format!("{} programs", ids.len()), &format!("{count} programs")));
                }
                for (at, &id) in ids.iter().enumerate() {
                    all.push(program_ids.find(id, || format!("{list}[{at}]"))?);
                }
            }
            leaves.push(all);
        }
        let team_ids = Ids::new("teams", written.teams.iter().map(|team| team.id))?;
        let mut teams = Vec::new();
        for (place, team) in written.teams.iter().enumerate() {
            let mut edges = Vec::new();
            for (at, edge) in team.edges.iter().enumerate() {
                let place = |member: &str| format!("graph.teams[{place}].edges[{at}]{member}");
                let to = match (edge.team, edge.action, edge.leaf) {
                    (Some(id), None, None) => Team(team_ids.find(id, || place(".team"))?),
                    (None, Some(action), None) if (action as usize) < written.actions.len() => Action(action),
                    (None, Some(action), None) => return Err(fault(place(".action"), action, "the id of an action")),
                    (None, None, Some(id)) => Leaf(leaf_ids.find(id, || place(".leaf"))?),
                    _ => return Err(fault(place(""), "none of them or several", "a team, an action or a leaf")),
                };
                edges.push(GraphEdge { program: program_ids.find(edge.program, || place(".program"))?, to });
            }
            if edges.is_empty() {
                return Err(fault(format!("graph.teams[{place}].edges"), "none", "at least one edge"));
            }
            teams.push(GraphTeam { id: team.id, edges });
        }
        let start = match (written.root, leaves.len()) {
            (Some(id), _) => Team(team_ids.find(id, || "graph.root".to_owned())?),
            (None, 1) => Leaf(0),
            (None, _) => return Err(fault("graph.root".to_owned(), "none", "the id of a team")),
        };
        let own_maths = written.maths == MathsJson::Own;
        let graph = Self { interface, ranges, registers, own_maths, programs, teams, leaves, limits, start };
        graph.leads_forward()?;
        Ok(graph)
    }

    /// Refuses teams that lead back: every team must come before those that it leads to.
    fn leads_forward(&self) -> Result<(), InputError> {
        let to = |edge: &GraphEdge| if let Team(to) = edge.to { Some(to) } else { None };
        let after: Vec<Vec<usize>> = self.teams.iter().map(|team| team.edges.iter().filter_map(to).collect()).collect();
        match circle(&after) {
            None => Ok(()),
            Some(_) => Err(fault("graph.teams".to_owned(), "a circle of teams", "teams that never lead back")),
        }
    }
}

impl LineJson {
    /// The line at a place, of the numbers of values by their names.
    fn read(&self, place: &str, values: &HashMap<String, u32>, registers: usize) -> Result<GraphLine, InputError> {
        if self.to >= registers {
            return Err(fault(format!("{place}.to"), self.to, "a register"));
        }
        let operand = |(at, operand): (usize, &OperandJson)| {
            let name = match operand {
                OperandJson::Number(number) => return Ok(GraphOperand::Constant(number.0)),
                OperandJson::Name(name) => name,
            };
            let register = name.strip_prefix('r').and_then(|number| number.parse().ok());
            let register = register.filter(|&register| register < registers).map(GraphOperand::Register);
            let value = values.get(name).map(|&index| GraphOperand::Source(index)).or(register);
            value.ok_or_else(|| {
                fault(format!("{place}.args[{at}]"), name, "a register or a value of a source or memory")
            })
        };
        let operands = self.args.iter().enumerate().map(operand).collect::<Result<_, _>>()?;
        Ok(GraphLine { to: self.to, word: self.op.clone(), operands })
    }
}
