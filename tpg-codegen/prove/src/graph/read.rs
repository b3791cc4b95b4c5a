//! A reader of `graph.json`, versions 1 and 2, in binary32.

use super::{Destination, Edge, Graph, Line, Operand, Team};
use crate::input::InputError;
use crate::machine::Interface;
use serde_json::Value;
use std::collections::HashMap;

/// A JSON value and its place in the file.
struct At<'a> {
    file: &'a str,
    place: String,
    value: &'a Value,
}

impl<'a> At<'a> {
    fn error(&self, accepted: &str) -> InputError {
        let mut found = self.value.to_string();
        if found.chars().count() > 60 {
            found = found.chars().take(57).chain("...".chars()).collect();
        }
        InputError { file: self.file.to_owned(), place: self.place.clone(), found, accepted: accepted.to_owned() }
    }

    fn member(&self, name: &str) -> At<'a> {
        let value = self.value.get(name).unwrap_or(&Value::Null);
        At { file: self.file, place: format!("{}.{name}", self.place), value }
    }

    /// Refuses members that are none of these: what is not read could change what the graph means.
    fn only(&self, names: &[&str]) -> Result<(), InputError> {
        let members = self.value.as_object().into_iter().flatten();
        match members.map(|(name, _)| name).find(|name| !names.contains(&name.as_str())) {
            None => Ok(()),
            Some(other) => Err(self.member(other).error(&format!("none but {}", names.join(", ")))),
        }
    }

    fn list(&self) -> Result<Vec<At<'a>>, InputError> {
        match self.value {
            Value::Null => Ok(Vec::new()),
            Value::Array(items) => Ok((0..).zip(items).map(|(at, value): (usize, _)| self.item(at, value)).collect()),
            _ => Err(self.error("a list")),
        }
    }

    fn item(&self, at: usize, value: &'a Value) -> At<'a> {
        At { file: self.file, place: format!("{}[{at}]", self.place), value }
    }

    fn text(&self) -> Result<&'a str, InputError> {
        self.value.as_str().ok_or_else(|| self.error("a text"))
    }

    fn number(&self) -> Result<u64, InputError> {
        self.value.as_u64().ok_or_else(|| self.error("a whole number"))
    }

    /// The binary32 number nearest to the binary64 number nearest to what is written, as the format says.
    fn float(&self) -> Result<f32, InputError> {
        let value = self.value.as_f64().map(|value| value as f32);
        value.filter(|value| value.is_finite()).ok_or_else(|| self.error("a finite number of binary32"))
    }

    fn index(&self, of: &HashMap<u64, usize>, what: &str) -> Result<usize, InputError> {
        let id = self.number()?;
        of.get(&id).copied().ok_or_else(|| self.error(&format!("the id of a {what}")))
    }
}

/// The places of a list's items by their ids.
fn ids(items: &[At<'_>]) -> Result<HashMap<u64, usize>, InputError> {
    let mut places = HashMap::new();
    for (place, item) in items.iter().enumerate() {
        let id = item.member("id");
        if places.insert(id.number()?, place).is_some() {
            return Err(id.error("an id that no other has"));
        }
    }
    Ok(places)
}

/// The operands' numbers by their names.
struct Names {
    values: HashMap<String, u32>,
    registers: usize,
}

impl Names {
    fn operand(&self, at: &At<'_>) -> Result<Operand, InputError> {
        let Some(name) = at.value.as_str() else { return at.float().map(Operand::Constant) };
        if let Some(&index) = self.values.get(name) {
            return Ok(Operand::Source(index));
        }
        let register = name.strip_prefix('r').and_then(|number| number.parse().ok());
        let register = register.filter(|&register| register < self.registers);
        register.map(Operand::Register).ok_or_else(|| at.error("a number, a register or a value of a source or memory"))
    }

    fn line(&self, at: &At<'_>) -> Result<Line, InputError> {
        at.only(&["to", "op", "args"])?;
        let to = at.member("to");
        let register = usize::try_from(to.number()?).ok().filter(|&register| register < self.registers);
        let to = register.ok_or_else(|| to.error("a register"))?;
        let operands =
            at.member("args").list()?.iter().map(|operand| self.operand(operand)).collect::<Result<_, _>>()?;
        Ok(Line { to, word: at.member("op").text()?.to_owned(), operands })
    }
}

impl Graph {
    /// Reads a graph.
    ///
    /// # Errors
    /// The first fault.
    pub fn read(file: &str, text: &str) -> Result<Self, InputError> {
        let fault = |found: String| InputError {
            file: file.to_owned(),
            place: "the file".to_owned(),
            found,
            accepted: "a graph in JSON".to_owned(),
        };
        let value: Value = serde_json::from_str(text).map_err(|error| fault(error.to_string()))?;
        let top = At { file, place: "graph".to_owned(), value: &value };
        top.only(&[
            "format",
            "version",
            "scalar",
            "maths",
            "registers",
            "sources",
            "instructions",
            "actions",
            "outputs",
            "memory",
            "root",
            "teams",
            "leaves",
            "programs",
            "provenance",
        ])?;
        for (member, accepted) in [("format", &["tpg-graph"][..]), ("scalar", &["f32"])] {
            let at = top.member(member);
            if !accepted.contains(&at.text()?) {
                return Err(at.error(&accepted.join(" or ")));
            }
        }
        if !(1..=2).contains(&top.member("version").number()?) {
            return Err(top.member("version").error("1 or 2"));
        }
        Self::parts(&top)
    }

    fn parts(top: &At<'_>) -> Result<Self, InputError> {
        let registers = top.member("registers").number()?;
        let registers = usize::try_from(registers).ok().filter(|count| (1..=256).contains(count));
        let registers = registers.ok_or_else(|| top.member("registers").error("1 to 256"))?;
        let (mut interface, mut ranges, mut values) = (Interface::default(), Vec::new(), HashMap::new());
        for source in top.member("sources").list()? {
            source.only(&["name", "length", "unit", "ranges"])?;
            let (name, length) = (source.member("name").text()?, source.member("length"));
            let length = u32::try_from(length.number()?).map_err(|_| length.error("fewer values"))?;
            let declared = source.member("ranges").list()?;
            for at in 0..length {
                values.insert(format!("{name}[{at}]"), interface.state_length() + at);
                let range = declared.get(at as usize).or(declared.first());
                ranges.push(range.map_or(Ok([f32::NEG_INFINITY, f32::INFINITY]), ends)?);
            }
            interface.sources.push((name.to_owned(), length));
        }
        let (mut limits, state) = (Vec::new(), interface.state_length());
        for output in top.member("outputs").list()? {
            output.only(&["name", "unit", "min", "max", "nan"])?;
            interface.outputs.push(output.member("name").text()?.to_owned());
            limits.push(["min", "max", "nan"].map(|member| output.member(member).float()));
        }
        for (number, memory) in (state..).zip(top.member("memory").list()?) {
            memory.only(&["name", "min", "max", "initial"])?;
            let name = memory.member("name").text()?;
            values.insert(format!("{name}[0]"), number);
            interface.memory.push(name.to_owned());
            let [low, high, initial] = ["min", "max", "initial"].map(|member| memory.member(member).float());
            ranges.push([low.clone()?, high.clone()?]);
            limits.push([low, high, initial]);
        }
        let limits = limits.into_iter().map(|[low, high, nan]| Ok([low?, high?, nan?])).collect::<Result<_, _>>()?;
        let names = Names { values, registers };
        let written = top.member("programs").list()?;
        let program_ids = ids(&written)?;
        let mut programs = Vec::new();
        for program in &written {
            program.only(&["id", "lines"])?;
            programs
                .push(program.member("lines").list()?.iter().map(|line| names.line(line)).collect::<Result<_, _>>()?);
        }
        let written = top.member("leaves").list()?;
        let leaf_ids = ids(&written)?;
        let mut leaves = Vec::new();
        for leaf in &written {
            leaf.only(&["id", "programs", "memory"])?;
            let mut all = Vec::new();
            for (member, count) in [("programs", interface.outputs.len()), ("memory", interface.memory.len())] {
                let list = leaf.member(member);
                let members = list.list()?;
                if members.len() != count {
                    return Err(list.error(&format!("{count} programs")));
                }
                for program in members {
                    all.push(program.index(&program_ids, "program")?);
                }
            }
            leaves.push(all);
        }
        let actions = top.member("actions").list()?.len() as u64;
        let (teams, start) = teams(top, &program_ids, &leaf_ids, actions)?;
        let maths = top.member("maths");
        let own_maths = match maths.text()? {
            "own" => true,
            "system" => false,
            _ => return Err(maths.error("own or system")),
        };
        let graph = Self { interface, ranges, registers, own_maths, programs, teams, leaves, limits, start };
        graph.leads_forward(top)?;
        Ok(graph)
    }

    /// Refuses teams that lead back.
    fn leads_forward(&self, top: &At<'_>) -> Result<(), InputError> {
        // 1: on the way, 2: done
        let mut seen = vec![0; self.teams.len()];
        let Destination::Team(start) = self.start else { return Ok(()) };
        let mut way = vec![(start, 0)];
        seen[start] = 1;
        while let Some((team, next)) = way.last_mut() {
            let Some(edge) = self.teams[*team].edges.get(*next) else {
                seen[*team] = 2;
                way.pop();
                continue;
            };
            *next += 1;
            if let Destination::Team(to) = edge.to {
                match seen[to] {
                    0 => {
                        seen[to] = 1;
                        way.push((to, 0));
                    }
                    1 => return Err(top.member("teams").error("teams that never lead back")),
                    _ => {}
                }
            }
        }
        Ok(())
    }
}

fn teams(
    top: &At<'_>,
    programs: &HashMap<u64, usize>,
    leaves: &HashMap<u64, usize>,
    actions: u64,
) -> Result<(Vec<Team>, Destination), InputError> {
    let written = top.member("teams").list()?;
    let team_ids = ids(&written)?;
    let mut teams = Vec::new();
    for team in &written {
        team.only(&["id", "edges"])?;
        let mut edges = Vec::new();
        for edge in team.member("edges").list()? {
            edge.only(&["program", "team", "action", "leaf"])?;
            let program = edge.member("program").index(programs, "program")?;
            let [to_team, action, leaf] = ["team", "action", "leaf"].map(|member| edge.member(member));
            let to = match [&to_team, &action, &leaf].map(|end| !end.value.is_null()) {
                [true, false, false] => Destination::Team(to_team.index(&team_ids, "team")?),
                [false, true, false] => {
                    let number = action.number()?;
                    let number = u32::try_from(number).ok().filter(|_| number < actions);
                    Destination::Action(number.ok_or_else(|| action.error("the id of an action"))?)
                }
                [false, false, true] => Destination::Leaf(leaf.index(leaves, "leaf")?),
                _ => return Err(edge.error("an edge to a team, an action or a leaf")),
            };
            edges.push(Edge { program, to });
        }
        if edges.is_empty() {
            return Err(team.member("edges").error("at least one edge"));
        }
        teams.push(Team { id: team.member("id").number()?, edges });
    }
    let root = top.member("root");
    let start = match (root.value.is_null(), leaves.len()) {
        (false, _) => Destination::Team(root.index(&team_ids, "team")?),
        (true, 1) => Destination::Leaf(0),
        _ => return Err(root.error("the id of a team")),
    };
    Ok((teams, start))
}

fn ends(range: &At<'_>) -> Result<[f32; 2], InputError> {
    match range.list()?[..] {
        [ref low, ref high] => Ok([low.float()?, high.float()?]),
        _ => Err(range.error("[lowest, highest]")),
    }
}
