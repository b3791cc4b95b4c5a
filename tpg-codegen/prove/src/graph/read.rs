//! A reader of `graph.json`, versions 1 and 2, in binary32, or in whole numbers if it is one of counts.

use super::{Destination::*, Graph, GraphEdge, GraphLine, GraphOperand, GraphTeam, circle};
use crate::input::{Missing, Result};
use crate::machine::Interface;
use serde::Deserialize as _;
use serde_json::Value as Json;
use std::collections::HashMap;
use std::ops::RangeInclusive;

/// A part of the file, and its place there. A part that is missing is null.
struct Part<'j> {
    json: &'j Json,
    place: String,
}

/// The greatest whole number up to which binary64 holds all.
const MOST: f64 = 9_007_199_254_740_992.0;

/// Places in a list by the ids of its items.
type Ids = HashMap<u64, usize>;

impl<'j> Part<'j> {
    fn fault(&self, accepted: impl std::fmt::Display) -> Missing {
        Missing::new(&*self.place, format!("found {}, expected {accepted}", self.json))
    }

    fn member(&self, name: &str) -> Self {
        Self { json: &self.json[name], place: format!("{}.{name}", self.place) }
    }

    /// Refuses other members than these: what is not read could change what the graph means.
    fn only(&self, names: &str) -> Result<()> {
        let members = self.json.as_object().ok_or_else(|| self.fault("an object"))?;
        match members.keys().find(|key| !names.split(' ').any(|name| name == *key)) {
            Some(other) => Err(self.member(other).fault(format!("one of {names}"))),
            None => Ok(()),
        }
    }

    fn items(&self) -> Result<Vec<Self>> {
        let items = match self.json {
            Json::Null => &[][..],
            json => json.as_array().ok_or_else(|| self.fault("a list"))?,
        };
        let places = items.iter().enumerate();
        Ok(places.map(|(at, json)| Self { json, place: format!("{}[{at}]", self.place) }).collect())
    }

    /// The items of a list of objects that have these members.
    fn objects(&self, names: &str) -> Result<Vec<Self>> {
        let items = self.items()?;
        items.iter().try_for_each(|item| item.only(names))?;
        Ok(items)
    }

    fn text(&self) -> Result<String> {
        self.json.as_str().map(str::to_owned).ok_or_else(|| self.fault("a text"))
    }

    /// Which of several words this is.
    fn word(&self, words: &[&str]) -> Result<usize> {
        let found = words.iter().position(|word| self.json == word);
        found.ok_or_else(|| self.fault(words.join(" or ")))
    }

    fn whole(&self, range: RangeInclusive<usize>) -> Result<usize> {
        let number = self.json.as_u64().and_then(|number| usize::try_from(number).ok());
        let accepted = || self.fault(format!("a whole number from {} to {}", range.start(), range.end()));
        number.filter(|number| range.contains(number)).ok_or_else(accepted)
    }

    /// The binary32 number nearest to the binary64 number nearest to what is written, as the format says; or a whole number.
    fn number(&self, whole: bool) -> Result<f64> {
        let number = self.json.as_f64().map(|number| if whole { number } else { f64::from(number as f32) });
        let is_exact = |number: &f64| number.fract() == 0.0 && number.abs() <= MOST;
        let number = number.filter(|number| if whole { is_exact(number) } else { number.is_finite() });
        number
            .ok_or_else(|| self.fault(if whole { "a whole number up to 2^53" } else { "a finite number of binary32" }))
    }

    fn numbers<const N: usize>(&self, names: [&str; N], whole: bool) -> Result<[f64; N]> {
        let mut numbers = [0.0; N];
        for (number, name) in numbers.iter_mut().zip(names) {
            *number = self.member(name).number(whole)?;
        }
        Ok(numbers)
    }

    /// The bytes of the type of counts.
    fn bytes(&self) -> Result<u8> {
        self.only("bits scale offset")?;
        Ok(if self.member("bits").whole(2..=16)? > 8 { 2 } else { 1 })
    }

    /// The lowest and the highest value of a feature of an image of so many rows and columns.
    fn feature(&self, [rows, columns]: [usize; 2]) -> Result<[i128; 2]> {
        let [row, column, contrast, sum] = ["row", "column", "contrast", "sum"].map(|name| self.member(name));
        let is = |part: &Self| !part.json.is_null();
        let size = |part: &Self, name: &str| part.member(name).whole(1..=1 << 16);
        // a cell that is not 0 may not be there, a window is
        let none = |part: &Self| if ["first", "last"].iter().any(|name| is(&part.member(name))) { -1 } else { 0 };
        Ok(match () {
            () if is(&row) => [none(&row), rows as i128 - 1],
            () if is(&column) => [none(&column), columns as i128 - 1],
            () if is(&contrast) => {
                let windows = ["brightest", "darkest"].map(|name| contrast.member(name));
                let size = windows.iter().find(|window| is(window)).map_or(Ok(0), |window| size(window, "size"))?;
                [0, (255 * size * size) as i128]
            }
            () if is(&sum) => [0, (255 * size(&sum, "height")? * size(&sum, "width")?) as i128],
            () => [0, 255],
        })
    }

    fn id(&self) -> Result<u64> {
        self.json.as_u64().ok_or_else(|| self.fault("an id"))
    }

    /// The place of what this is the id of.
    fn find(&self, ids: &Ids) -> Result<usize> {
        ids.get(&self.id()?).copied().ok_or_else(|| self.fault("the id of something that is there"))
    }
}

/// The lowest and the highest number of a signed type.
fn held(bytes: u8) -> [i128; 2] {
    let end = 1 << (8 * bytes - 1);
    [-end, end - 1]
}

fn ids(items: &[Part<'_>]) -> Result<Ids> {
    let mut ids = Ids::new();
    for (place, item) in items.iter().enumerate() {
        let id = item.member("id");
        if ids.insert(id.id()?, place).is_some() {
            return Err(id.fault("an id that no other has"));
        }
    }
    Ok(ids)
}

impl Graph {
    /// Reads a graph.
    ///
    /// # Errors
    /// The first fault.
    pub fn read(file: &str, text: &str) -> Result<Self> {
        let mut json = serde_json::Deserializer::from_str(text);
        let fault = |place: &str, error: serde_json::Error| {
            Missing::new(format!("{file}: {place}"), format!("found {error}, expected a graph in JSON"))
        };
        let whole = Json::deserialize(&mut json).map_err(|error| fault("graph", error))?;
        json.end().map_err(|error| fault("the end", error))?;
        Self::resolve(&Part { json: &whole, place: format!("{file}: graph") })
    }

    fn resolve(top: &Part<'_>) -> Result<Self> {
        top.only(
            "format version scalar maths registers sources instructions actions outputs memory root teams leaves \
             programs provenance",
        )?;
        top.member("format").word(&["tpg-graph"])?;
        top.member("version").whole(1..=2)?;
        let sources = top.member("sources").objects("name length unit ranges image counts")?;
        let whole = sources.iter().any(|source| !source.member("counts").json.is_null());
        top.member("scalar").word(&[if whole { "f64" } else { "f32" }])?;
        let own_maths = top.member("maths").word(&["own", "system"])? == 0;
        let registers = top.member("registers").whole(1..=256)?;
        let (mut interface, mut ranges, mut limits) = (Interface::default(), Vec::new(), Vec::new());
        let mut values = HashMap::new();
        // the proof is of the decision for a state, however its values came about: what an image becomes is not read
        for source in sources {
            let (name, length) = (source.member("name").text()?, source.member("length").whole(0..=1 << 20)?);
            let declared = source.member("ranges").items()?;
            for at in 0..length {
                values.insert(format!("{name}[{at}]"), ranges.len() as u32);
                let range = match declared.get(at).or(declared.first()) {
                    None => [f64::NEG_INFINITY, f64::INFINITY],
                    Some(range) => match &range.items()?[..] {
                        [low, high] => [low.number(whole)?, high.number(whole)?],
                        _ => return Err(range.fault("two numbers")),
                    },
                };
                ranges.push(range);
            }
            interface.sources.push((name, length as u32));
            if whole {
                let list = source.member("counts");
                let counts = list.items()?;
                if counts.len() != length {
                    return Err(list.fault(format!("counts of {length} values")));
                }
                let bytes = counts.iter().map(Part::bytes).collect::<Result<Vec<_>>>()?;
                let bytes = bytes.into_iter().max().unwrap_or(2);
                interface.bytes.push(bytes);
                let image = source.member("image");
                if image.json.is_null() {
                    interface.counts.extend(vec![held(bytes); length]);
                    continue;
                }
                let [Some(rows), Some(columns)] = [0, 1].map(|at| image.json["shape"][at].as_u64()) else {
                    return Err(image.member("shape").fault("rows and columns"));
                };
                for feature in image.member("features").items()? {
                    interface.counts.push(feature.feature([rows as usize, columns as usize])?);
                }
                if interface.counts.len() != ranges.len() {
                    return Err(image.member("features").fault(format!("features of {length} values")));
                }
            }
        }
        let mut answered = Vec::new();
        for output in top.member("outputs").objects("name unit min max nan counts")? {
            interface.outputs.push(output.member("name").text()?);
            limits.push(output.numbers(["min", "max", "nan"], whole)?);
            let counts = output.member("counts");
            match (whole, counts.json.is_null()) {
                (false, true) => {}
                (true, false) => answered.push(counts.bytes()?),
                _ => return Err(counts.fault("counts of all sources and outputs, or of none")),
            }
        }
        for memory in top.member("memory").objects("name min max initial")? {
            let name = memory.member("name").text()?;
            values.insert(format!("{name}[0]"), ranges.len() as u32);
            interface.memory.push(name);
            let [low, high, initial] = memory.numbers(["min", "max", "initial"], whole)?;
            ranges.push([low, high]);
            limits.push([low, high, initial]);
            if whole {
                interface.bytes.push(4);
                interface.counts.push([low as i128, high as i128]);
            }
        }
        interface.bytes.extend(answered);
        let written = top.member("programs").objects("id lines")?;
        let program_ids = ids(&written)?;
        let mut programs = Vec::new();
        for program in written {
            let lines = program.member("lines").objects("to op args")?;
            programs.push(lines.iter().map(|line| line.line(&values, registers, whole)).collect::<Result<_>>()?);
        }
        let written = top.member("leaves").objects("id programs memory")?;
        let leaf_ids = ids(&written)?;
        let mut leaves = Vec::new();
        for leaf in written {
            let mut all = Vec::new();
            for (name, count) in [("programs", interface.outputs.len()), ("memory", interface.memory.len())] {
                let list = leaf.member(name);
                let items = list.items()?;
                if items.len() != count {
                    return Err(list.fault(format!("{count} programs")));
                }
                for id in items {
                    all.push(id.find(&program_ids)?);
                }
            }
            leaves.push(all);
        }
        let actions = top.member("actions").items()?.len();
        let written = top.member("teams").objects("id edges")?;
        let team_ids = ids(&written)?;
        let mut teams = Vec::new();
        for team in written {
            let list = team.member("edges");
            let mut edges = Vec::new();
            for edge in list.objects("program team action leaf")? {
                let [team, action, leaf] = ["team", "action", "leaf"].map(|name| edge.member(name));
                let to = match [&team, &action, &leaf].map(|to| to.json.is_null()) {
                    [false, true, true] => Team(team.find(&team_ids)?),
                    [true, false, true] if actions == 0 => return Err(action.fault("no action: there is none")),
                    [true, false, true] => Action(action.whole(0..=actions - 1)? as u32),
                    [true, true, false] => Leaf(leaf.find(&leaf_ids)?),
                    _ => return Err(edge.fault("a team, an action or a leaf")),
                };
                edges.push(GraphEdge { program: edge.member("program").find(&program_ids)?, to });
            }
            if edges.is_empty() {
                return Err(list.fault("at least one edge"));
            }
            teams.push(GraphTeam { id: team.member("id").id()?, edges });
        }
        let root = top.member("root");
        let start = if root.json.is_null() && leaves.len() == 1 { Leaf(0) } else { Team(root.find(&team_ids)?) };
        // every team must come before those that it leads to
        let to = |edge: &GraphEdge| if let Team(to) = edge.to { Some(to) } else { None };
        let after: Vec<Vec<usize>> = teams.iter().map(|team| team.edges.iter().filter_map(to).collect()).collect();
        if circle(&after).is_some() {
            return Err(top.member("teams").fault("teams that never lead back"));
        }
        Ok(Self { interface, ranges, registers, own_maths, programs, teams, leaves, limits, start })
    }
}

impl Part<'_> {
    /// A line of a program, of the numbers of values by their names.
    fn line(&self, values: &HashMap<String, u32>, registers: usize, whole: bool) -> Result<GraphLine> {
        let mut operands = Vec::new();
        for operand in self.member("args").items()? {
            let register = |name: &str| name.strip_prefix('r')?.parse().ok().filter(|&register| register < registers);
            operands.push(match operand.json.as_str() {
                None => GraphOperand::Constant(operand.number(whole)?),
                Some(name) => match (values.get(name), register(name)) {
                    (Some(&index), _) => GraphOperand::Source(index),
                    (None, Some(register)) => GraphOperand::Register(register),
                    _ => return Err(operand.fault("a register or a value of a source or memory")),
                },
            });
        }
        let to = self.member("to").whole(0..=registers - 1)?;
        Ok(GraphLine { to, word: self.member("op").text()?, operands })
    }
}
