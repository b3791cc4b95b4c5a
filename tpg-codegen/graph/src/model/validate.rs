//! Conversion of a document to a graph. Every possible error in a graph is detected here, once.

mod counts;
mod image;
mod values;

use super::document::{Document, EdgeDocument, FORMAT, LineDocument, OperandDocument, SourceDocument, VERSIONS};
use super::effect::Effect;
use super::graph::{
    Destination, Edge, Graph, Input, Leaf, Line, Operand, Output, Program, ProgramId, Reg, Team, TeamId,
};
use super::name;
use super::read::other_version;
use crate::dataflow::{Cycle, depth_first};
use crate::error::{InputError, Place, counted};
use crate::word::Word;
use std::collections::{BTreeMap, BTreeSet};
use tpg_runtime::policy::ActionId;

/// Maximum number of registers of a program, as in GEGELATI's line format.
const MAX_REGISTERS: u32 = 256;
/// Maximum number of values in a state and of actions: both are numbered in 16 bits.
pub const MAX_NUMBERED: usize = 1 << 16;

impl Graph {
    /// Validates a document.
    ///
    /// # Errors
    /// The first error found, by JSON path.
    pub fn from_document(file: &str, document: Document) -> Result<Self, InputError> {
        Validator { file, document: &document }.graph()
    }
}

impl Document {
    /// Checks everything except root, teams and programs.
    pub(crate) fn check_declarations(&self, file: &str) -> Result<(), InputError> {
        let validator = Validator { file, document: self };
        validator.header()?;
        validator.sources()?;
        validator.instructions()?;
        if validator.outputs()?.is_empty() { validator.actions() } else { Ok(()) }
    }
}

struct Validator<'a> {
    file: &'a str,
    document: &'a Document,
}

/// Named elements of the graph, indexed by their names in the file.
struct KnownNames<'a> {
    /// First input and length of each source.
    sources: BTreeMap<&'a str, (usize, usize)>,
    teams: BTreeMap<u32, TeamId>,
    leaves: BTreeMap<u32, ActionId>,
    programs: BTreeMap<u32, ProgramId>,
    instructions: Vec<Word>,
}

impl Validator<'_> {
    fn error(&self, path: impl Into<String>, found: impl Into<String>, accepted: impl Into<String>) -> InputError {
        InputError::new(self.file, Place::Path(path.into()), found, accepted)
    }

    fn refuse<T>(
        &self,
        path: impl Into<String>,
        found: impl Into<String>,
        accepted: impl Into<String>,
    ) -> Result<T, InputError> {
        Err(self.error(path, found, accepted))
    }

    fn graph(&self) -> Result<Graph, InputError> {
        self.header()?;
        let mut sources = self.sources()?;
        let memory = self.memory(&mut sources)?;
        let names = KnownNames {
            sources,
            instructions: self.instructions()?,
            teams: self.numbered("teams", self.document.teams.iter().map(|team| team.id), TeamId)?,
            leaves: self.leaf_ids()?,
            programs: self.numbered("programs", self.document.programs.iter().map(|p| p.id), ProgramId)?,
        };
        let mut outputs = self.outputs()?;
        if outputs.is_empty() {
            self.actions()?;
        }
        outputs.extend(memory.iter().cloned());
        let leaves = self.leaves(&names)?;
        let is_formula = self.is_formula()?;
        let (root, teams) = if is_formula {
            (TeamId(0), vec![Team::leading_to(&leaves[0])])
        } else {
            let teams = self.teams(&names)?;
            (self.root(&names, &teams)?, teams)
        };
        self.one_destination_each(&teams, &leaves)?;
        self.every_leaf_is_reached(&teams)?;
        self.acyclic(&teams)?;
        let programs = self.programs(&names)?;
        Ok(Graph {
            scalar: self.document.scalar,
            maths: self.document.maths,
            registers: self.document.registers as u16,
            sources: self.document.sources.iter().cloned().chain(memory.iter().map(remembered)).collect(),
            instructions: names.instructions,
            actions: self.document.actions.clone(),
            outputs,
            memory: memory.len(),
            leaves,
            root,
            is_formula,
            teams,
            programs,
            provenance: self.document.provenance.clone(),
        })
    }

    fn header(&self) -> Result<(), InputError> {
        let Document { format, version, registers, .. } = self.document;
        if format != FORMAT {
            return self.refuse("$.format", format!("{format:?}"), format!("{FORMAT:?}"));
        }
        if !VERSIONS.contains(version) {
            return Err(other_version(self.file, u64::from(*version)));
        }
        if !(1..=MAX_REGISTERS).contains(registers) {
            return self.refuse("$.registers", registers.to_string(), format!("1 to {MAX_REGISTERS}"));
        }
        Ok(())
    }

    fn sources(&self) -> Result<BTreeMap<&str, (usize, usize)>, InputError> {
        let mut places = BTreeMap::new();
        let mut first = 0;
        for (index, source) in self.document.sources.iter().enumerate() {
            let path = format!("$.sources[{index}]");
            self.name_and_unit(&path, &source.name, &source.unit)?;
            let length = source.length as usize;
            if source.ranges.len() != length || length == 0 {
                let found = format!("{} for a length of {length}", counted(source.ranges.len(), "range"));
                return self.refuse(format!("{path}.ranges"), found, "one range for each value, at least one");
            }
            for (place, [min, max]) in source.ranges.iter().enumerate() {
                if !(min <= max && self.is_exact(*min) && self.is_exact(*max)) {
                    let found = format!("[{min}, {max}]");
                    let scalar = self.document.scalar.name();
                    let accepted = format!("[lowest, highest], finite and exact in {scalar}");
                    return self.refuse(format!("{path}.ranges[{place}]"), found, accepted);
                }
            }
            self.source_counts(&path, source)?;
            self.source_image(&path, source)?;
            if places.insert(source.name.as_str(), (first, length)).is_some() {
                let found = format!("{:?} a second time", source.name);
                return self.refuse(format!("{path}.name"), found, "a name that no other source has");
            }
            first += length;
        }
        if first == 0 || first > MAX_NUMBERED {
            return self.refuse("$.sources", format!("{first} values"), format!("1 to {MAX_NUMBERED} values"));
        }
        Ok(places)
    }

    fn name_and_unit(&self, path: &str, name: &str, unit: &str) -> Result<(), InputError> {
        if !name::is_source(name) {
            return self.refuse(format!("{path}.name"), format!("{name:?}"), name::SOURCE);
        }
        if !name::is_text(unit) {
            return self.refuse(format!("{path}.unit"), format!("{unit:?}"), name::TEXT);
        }
        Ok(())
    }

    /// Tests for a finite number that the scalar type has.
    fn is_exact(&self, value: f64) -> bool {
        value.is_finite() && self.document.scalar.round(value) == value
    }

    /// Looks up an element by the id that the file names at `path`.
    fn known<Id: Copy>(&self, path: String, what: &str, ids: &BTreeMap<u32, Id>, id: u32) -> Result<Id, InputError> {
        let missing = || self.error(path, format!("{what} {id}, which does not exist"), format!("the id of a {what}"));
        ids.get(&id).copied().ok_or_else(missing)
    }

    fn instructions(&self) -> Result<Vec<Word>, InputError> {
        let mut set = Vec::new();
        for (index, name) in self.document.instructions.iter().enumerate() {
            let path = format!("$.instructions[{index}]");
            let instruction = Word::from_name(name)
                .ok_or_else(|| self.error(&path, format!("unknown instruction {name:?}"), known_instructions()))?;
            if set.contains(&instruction) {
                return self.refuse(path, format!("{name:?} a second time"), "each instruction once");
            }
            set.push(instruction);
        }
        if set.is_empty() {
            return self.refuse("$.instructions", "an empty list", known_instructions());
        }
        Ok(set)
    }

    fn numbered<Id>(
        &self,
        list: &str,
        ids: impl Iterator<Item = u32>,
        new: impl Fn(u32) -> Id,
    ) -> Result<BTreeMap<u32, Id>, InputError> {
        let mut by_id = BTreeMap::new();
        for (index, id) in (0u32..).zip(ids) {
            if by_id.insert(id, new(index)).is_some() {
                let path = format!("$.{list}[{index}].id");
                return self.refuse(path, format!("{id} a second time"), "an id that no other one of the list has");
            }
        }
        Ok(by_id)
    }

    fn actions(&self) -> Result<(), InputError> {
        let actions = &self.document.actions;
        for (index, action) in actions.iter().enumerate() {
            if action.id as usize != index {
                let path = format!("$.actions[{index}].id");
                return self.refuse(path, action.id.to_string(), format!("{index}, its place in the list"));
            }
            if !name::is_text(&action.name) {
                let path = format!("$.actions[{index}].name");
                return self.refuse(path, format!("{:?}", action.name), name::TEXT);
            }
        }
        if actions.is_empty() || actions.len() > MAX_NUMBERED {
            return self.refuse("$.actions", format!("{} actions", actions.len()), format!("1 to {MAX_NUMBERED}"));
        }
        self.asks()?;
        self.effects()
    }

    fn asks(&self) -> Result<(), InputError> {
        let mut asked = Vec::new();
        for (index, action) in self.document.actions.iter().enumerate() {
            let Some(ask) = &action.ask else { continue };
            let refuse = |found: String, accepted: &str| {
                self.refuse(format!("$.actions[{index}].ask"), found, accepted.to_owned())
            };
            if !name::is_source(ask) {
                return refuse(format!("{ask:?}"), name::SOURCE);
            }
            if action.effect.is_some() {
                return refuse(format!("{ask:?} beside an effect"), "an action that asks, or one with an effect");
            }
            if asked.contains(&ask) {
                return refuse(format!("{ask:?} a second time"), "a name that no other action asks");
            }
            asked.push(ask);
        }
        if asked.len() == self.document.actions.len() {
            let found = "actions that all ask".to_owned();
            return self.refuse("$.actions", found, "an action of the graph's own, too");
        }
        Ok(())
    }

    fn effects(&self) -> Result<(), InputError> {
        let mut effects = self.document.actions.iter().enumerate().filter_map(|(index, action)| {
            let effect = action.effect.as_ref()?;
            let key = if effect.name == Effect::MOVE { "move" } else { "effect" };
            Some((format!("$.actions[{index}].{key}"), effect))
        });
        let Some((first, _)) = effects.clone().next() else { return Ok(()) };
        let length = effects.clone().next().map_or(0, |(_, effect)| effect.values.len());
        effects.try_for_each(|(path, effect)| {
            if let Some(value) = effect.values.iter().find(|value| !value.is_finite()) {
                return self.refuse(path, value.to_string(), "finite numbers");
            }
            if effect.values.len() != length {
                let found = format!("{} numbers", effect.values.len());
                return self.refuse(path, found, format!("{length}, as {first}"));
            }
            Ok(())
        })
    }

    fn teams(&self, names: &KnownNames<'_>) -> Result<Vec<Team>, InputError> {
        if self.document.teams.is_empty() {
            return self.refuse("$.teams", "no teams", "at least one");
        }
        let mut teams = Vec::new();
        for (index, team) in self.document.teams.iter().enumerate() {
            if team.edges.is_empty() {
                let path = format!("$.teams[{index}].edges");
                return self.refuse(path, format!("team {} without edges", team.id), "at least one edge");
            }
            let edges = (team.edges.iter().enumerate())
                .map(|(place, edge)| self.edge(&format!("$.teams[{index}].edges[{place}]"), edge, names))
                .collect::<Result<_, _>>()?;
            teams.push(Team { label: team.id, edges });
        }
        Ok(teams)
    }

    fn edge(&self, path: &str, edge: &EdgeDocument, names: &KnownNames<'_>) -> Result<Edge, InputError> {
        let program = self.known(format!("{path}.program"), "program", &names.programs, edge.program)?;
        let end = if self.document.outputs.is_empty() { "action" } else { "leaf" };
        let accepted = format!("either \"team\" or \"{end}\"");
        let to = match (edge.team, edge.action, edge.leaf) {
            (Some(team), None, None) => {
                Destination::Team(self.known(format!("{path}.team"), "team", &names.teams, team)?)
            }
            (None, Some(action), None) if end == "action" => {
                let last = self.document.actions.len() - 1;
                if action as usize > last {
                    let accepted = format!("0 to {last}");
                    return self.refuse(format!("{path}.action"), format!("action {action}"), accepted);
                }
                Destination::Action(ActionId(action as u16))
            }
            (None, None, Some(leaf)) if end == "leaf" => {
                Destination::Action(self.known(format!("{path}.leaf"), "leaf", &names.leaves, leaf)?)
            }
            (None, Some(_), None) => {
                return self.refuse(format!("{path}.action"), "an action of a policy with outputs", accepted);
            }
            (None, None, Some(_)) => {
                return self.refuse(format!("{path}.leaf"), "a leaf of a policy without outputs", accepted);
            }
            (None, None, None) => return self.refuse(path, "no destination", accepted),
            _ => return self.refuse(path, "several destinations", accepted),
        };
        Ok(Edge { program, to })
    }

    /// Checks that each program has one destination. GEGELATI clones a program before it changes the destination, and
    /// `.dot` cannot express anything else.
    fn one_destination_each(&self, teams: &[Team], leaves: &[Leaf]) -> Result<(), InputError> {
        let mut destination = BTreeMap::new();
        for (index, team) in teams.iter().enumerate() {
            for (place, edge) in team.edges.iter().enumerate() {
                if *destination.entry(edge.program).or_insert(edge.to) != edge.to {
                    let program = self.document.programs[edge.program.index()].id;
                    return self.refuse(
                        format!("$.teams[{index}].edges[{place}]"),
                        format!("a second destination for program {program}"),
                        "one destination for each program: give the copy an id of its own",
                    );
                }
            }
        }
        let computing: BTreeSet<ProgramId> = leaves.iter().flat_map(|leaf| leaf.programs.iter().copied()).collect();
        let is_used = |id: ProgramId| destination.contains_key(&id) || computing.contains(&id);
        let unused = (0u32..).zip(&self.document.programs).find(|(id, _)| !is_used(ProgramId(*id)));
        match unused {
            Some((index, program)) => self.refuse(
                format!("$.programs[{index}]"),
                format!("program {}, which no edge and no leaf uses", program.id),
                "programs that bid, or compute an output",
            ),
            None => Ok(()),
        }
    }

    /// Checks that the declared root is the only team without incoming edges. Together with [`acyclic`](Self::acyclic)
    /// this makes every team reachable.
    fn root(&self, names: &KnownNames<'_>, teams: &[Team]) -> Result<TeamId, InputError> {
        let declared = self.document.root.ok_or_else(|| self.error("$.root", "no root", "the id of a team"))?;
        let root = self.known("$.root".to_owned(), "team", &names.teams, declared)?;
        let mut entered = vec![false; teams.len()];
        for edge in teams.iter().flat_map(|team| &team.edges) {
            if let Destination::Team(team) = edge.to {
                entered[team.index()] = true;
            }
        }
        if entered[root.index()] {
            let found = format!("no root: edges lead to team {declared}");
            return self.refuse("$.root", found, "the one team that no edge leads to");
        }
        match (0u32..).zip(&entered).find(|&(index, &entered)| !entered && TeamId(index) != root) {
            Some((index, _)) => {
                let other = teams[index as usize].label;
                let found = format!("a second root: no edge leads to team {other} (the root is {declared})");
                self.refuse(format!("$.teams[{index}]"), found, "exactly one team that no edge leads to")
            }
            None => Ok(root),
        }
    }

    /// Checks that no team leads back to itself.
    fn acyclic(&self, teams: &[Team]) -> Result<(), InputError> {
        let edge = |team: usize, place: usize| {
            teams[team].edges.get(place).map(|edge| match edge.to {
                Destination::Team(to) => Some(to.index()),
                Destination::Action(_) => None,
            })
        };
        depth_first(teams.len(), 0..teams.len(), edge).map(drop).map_err(|Cycle { nodes, closed_by: (team, place) }| {
            let names: Vec<String> =
                nodes.iter().chain(nodes.first()).map(|&team| teams[team].label.to_string()).collect();
            let found = format!("a cycle: team {}", names.join(" → "));
            self.error(format!("$.teams[{team}].edges[{place}]"), found, "edges that never lead back")
        })
    }

    fn programs(&self, names: &KnownNames<'_>) -> Result<Vec<Program>, InputError> {
        let mut programs = Vec::new();
        for (index, program) in self.document.programs.iter().enumerate() {
            let lines = (program.lines.iter().enumerate())
                .map(|(place, line)| self.line(&format!("$.programs[{index}].lines[{place}]"), line, names))
                .collect::<Result<_, _>>()?;
            programs.push(Program { label: program.id, lines });
        }
        Ok(programs)
    }

    fn line(&self, path: &str, line: &LineDocument, names: &KnownNames<'_>) -> Result<Line, InputError> {
        let to = self.register(&format!("{path}.to"), Some(line.to), &line.to.to_string())?;
        let declared = |i: &Word| names.instructions.contains(i);
        let instruction = Word::from_name(&line.op).filter(declared).ok_or_else(|| {
            let accepted = format!("one of the declared instructions: {}", self.document.instructions.join(", "));
            self.error(format!("{path}.op"), format!("instruction {:?}", line.op), accepted)
        })?;
        let operands: Vec<Operand> = (line.args.iter().enumerate())
            .map(|(place, operand)| self.operand(&format!("{path}.args[{place}]"), operand, names))
            .collect::<Result<_, _>>()?;
        let operands = match (instruction.arity(), operands.as_slice()) {
            (1, &[a]) => [a, a],
            (2, &[a, b]) => [a, b],
            (arity, found) => {
                let found = format!("{} of {:?}", counted(found.len(), "operand"), line.op);
                return self.refuse(format!("{path}.args"), found, arity.to_string());
            }
        };
        Ok(Line { to, instruction, operands })
    }

    /// Checks a register. `None` is a number that does not fit and was written as `found`.
    fn register(&self, path: &str, register: Option<u32>, found: &str) -> Result<Reg, InputError> {
        match register {
            Some(register) if register < self.document.registers => Ok(Reg(register as u16)),
            _ => {
                let accepted = format!("register 0 to {}", self.document.registers - 1);
                self.refuse(path, format!("register {found}"), accepted)
            }
        }
    }

    fn operand(&self, path: &str, operand: &OperandDocument, names: &KnownNames<'_>) -> Result<Operand, InputError> {
        let place = match operand {
            OperandDocument::Constant(value) => return self.constant(path, *value),
            OperandDocument::Place(place) => place,
        };
        if name::is_register(place) {
            let number = &place[1..];
            return self.register(path, number.parse().ok(), number).map(Operand::Register);
        }
        let accepted = || "a number, a register \"r0\", or a value of a source \"name[0]\"";
        let (name, index) = (place.strip_suffix(']').and_then(|place| place.split_once('[')))
            .ok_or_else(|| self.error(path, format!("{place:?}"), accepted()))?;
        let &(first, length) = names.sources.get(name).ok_or_else(|| {
            let known: Vec<&str> = names.sources.keys().copied().collect();
            self.error(path, format!("unknown source {name:?}"), format!("one of {}", known.join(", ")))
        })?;
        match index.parse::<usize>() {
            Ok(offset) if offset < length && name::is_number(index) => {
                Ok(Operand::Input(Input((first + offset) as u16)))
            }
            _ => self.refuse(path, format!("{place:?}"), format!("{name}[0] to {name}[{}]", length - 1)),
        }
    }

    fn constant(&self, path: &str, value: f64) -> Result<Operand, InputError> {
        let scalar = self.document.scalar;
        let rounded = scalar.round(value);
        if rounded.is_finite() {
            Ok(Operand::Constant(rounded))
        } else {
            let found = format!("the constant {value:e}, which does not fit {}", scalar.name());
            let largest = match scalar {
                super::ScalarType::F32 => f64::from(f32::MAX),
                super::ScalarType::F64 => f64::MAX,
            };
            self.refuse(path, found, format!("a magnitude of at most {largest:e}"))
        }
    }
}

/// The source by which programs read a value of the memory.
fn remembered(memory: &Output) -> SourceDocument {
    SourceDocument::new(&memory.name, &memory.unit, vec![[memory.range.min, memory.range.max]])
}

fn known_instructions() -> String {
    Word::ALL.map(Word::name).join(", ")
}
