//! A controller of your own as formulas, in a `law.toml`: read as a graph, it is evaluated like any other.

use crate::evolution::export::{exact, finite};
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;
use tpg_engine::ActionSpace;
use tpg_graph::error::{Finding, InputError, counted};
use tpg_graph::files::read_text;
use tpg_graph::import::{Expression, Reading};
use tpg_graph::{
    Document, EdgeDocument, FORMAT, Graph, LeafDocument, LineDocument, MathsProvider, MemoryDocument, OperandDocument,
    OutputDocument, ProgramDocument, Provenance, ScalarType, SourceDocument, TeamDocument, Word, settings,
};

const ACCEPTED: &str = "a section [law] with a formula for each output, or a bid for each action; [memory] with ranges";

/// The content of a `law.toml`.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct LawFile {
    /// The formula of each output, or the bid of each named action; and the next value of what is remembered.
    law: BTreeMap<String, String>,
    /// The range of each value that is remembered; it begins with 0, or the nearest value of the range.
    #[serde(default)]
    memory: BTreeMap<String, [f64; 2]>,
}

/// True if the file can be read and has a section `[law]`.
pub(super) fn is_law(path: &str) -> bool {
    let table = std::fs::read_to_string(path).ok().and_then(|text| text.parse::<toml::Table>().ok());
    table.is_some_and(|table| table.contains_key("law"))
}

/// Reads the law of a problem with these sources and actions.
///
/// # Errors
/// If it cannot be read, is no law, or not one for these sources and actions.
pub(super) fn read(path: &Path, sources: Vec<SourceDocument>, actions: ActionSpace) -> Result<Graph, InputError> {
    let (file, text) = (path.display().to_string(), read_text(path, "a law.toml")?);
    let law: LawFile = settings::from_toml(&file, &text, ACCEPTED)?;
    let document = law.document(sources, actions).map_err(|finding| settings::place(&file, &text, finding))?;
    Graph::from_document(&file, document).map(Graph::without_unread_features)
}

impl LawFile {
    fn document(self, sources: Vec<SourceDocument>, actions: ActionSpace) -> Result<Document, Finding> {
        let ends: Vec<String> = actions.names().map(str::to_owned).collect();
        let (mut outputs, mut choices) = (Vec::new(), Vec::new());
        match actions {
            ActionSpace::Box(found) => outputs = found,
            ActionSpace::Discrete(found) => choices = found,
        }
        if outputs.is_empty() && !self.memory.is_empty() {
            let found = counted(self.memory.len(), "value");
            return Err(Finding::new("memory", found, "no [memory]: it needs a problem with continuous outputs"));
        }
        let values = sources
            .iter()
            .flat_map(|source| (0..source.length).map(|place| (source.name.clone(), place, source.length)));
        let places: Vec<_> = values.chain(self.memory.keys().map(|name| (name.clone(), 0, 1))).collect();
        let mut programs = BTreeMap::new();
        let (mut words, mut registers) = (BTreeSet::new(), 1);
        for (name, text) in &self.law {
            let path = format!("law.{name}");
            if !ends.contains(name) && !self.memory.contains_key(name) {
                let found = format!("{name:?}, which the problem does not answer");
                return Err(Finding::new(path, found, format!("{}, or a name of [memory]", ends.join(", "))));
            }
            let names = |(name, place, length): &(String, u32, u32)| match length {
                1 => name.clone(),
                _ => format!("{name}[{place}]"),
            };
            let operand = |text: &str| {
                let place = places
                    .iter()
                    .position(|value| text == names(value) || text == format!("{}[{}]", value.0, value.1))
                    .map(|place| Expression::Operand(place, 0));
                place.ok_or_else(|| format!("{text:?}, an unknown name"))
            };
            let formula = Expression::formula(text, operand).map_err(|found| {
                let known = places.iter().map(names).collect::<Vec<_>>().join(", ");
                Finding::new(path, found, format!("a formula of numbers, {known}"))
            })?;
            let formula = match formula {
                call @ Expression::Call(..) => call,
                value => Expression::Call(Word::Copy, vec![value]),
            };
            formula.words(&mut words);
            registers = registers.max(1 + formula.scratch());
            let read = |reading: &Reading| match *reading {
                Reading::Operand(place, _) => {
                    OperandDocument::Place(format!("{}[{}]", places[place].0, places[place].1))
                }
                Reading::Number(value) => OperandDocument::Constant(f64::from(value as f32)),
                Reading::Register(register) => OperandDocument::Place(format!("r{register}")),
                Reading::Constant(_) => unreachable!("a law has no constants by name"),
            };
            let mut lines = Vec::new();
            formula.spell(0, 1, &mut |to, word, reads| {
                lines.push(LineDocument { to, op: word.name().to_owned(), args: reads.iter().map(read).collect() });
            });
            programs.insert(name.clone(), ProgramDocument { id: programs.len() as u32, lines });
        }
        let id = |name: &String| match programs.get(name) {
            Some(program) => Ok(program.id),
            None => Err(Finding::new("law", format!("no formula of {name}"), ACCEPTED)),
        };
        let bidding = choices.iter().filter_map(|action| Some((programs.get(&action.name)?.id, action.id)));
        let edges: Vec<_> = bidding
            .map(|(program, action)| EdgeDocument { program, team: None, action: Some(action), leaf: None })
            .collect();
        let leaf = LeafDocument {
            id: 0,
            programs: outputs.iter().map(|output| id(&output.name)).collect::<Result<_, _>>()?,
            memory: self.memory.keys().map(id).collect::<Result<_, _>>()?,
        };
        let is_choice = outputs.is_empty();
        Ok(Document {
            format: FORMAT.to_owned(),
            version: 2,
            scalar: ScalarType::F32,
            maths: MathsProvider::Own,
            registers,
            sources: sources.into_iter().map(|source| exact(finite(source), ScalarType::F32)).collect(),
            instructions: words.into_iter().map(|word| word.name().to_owned()).collect(),
            actions: choices,
            outputs: outputs
                .into_iter()
                .map(|it| OutputDocument {
                    name: it.name,
                    unit: it.unit,
                    min: it.min,
                    max: it.max,
                    nan: 0.0,
                    counts: None,
                })
                .collect(),
            memory: self
                .memory
                .into_iter()
                .map(|(name, [min, max])| MemoryDocument { name, min, max, initial: min.max(0.0).min(max) })
                .collect(),
            root: is_choice.then_some(0),
            teams: if is_choice { vec![TeamDocument { id: 0, edges }] } else { Vec::new() },
            leaves: if is_choice { Vec::new() } else { vec![leaf] },
            programs: programs.into_values().collect(),
            provenance: Provenance::default(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::read;
    use tpg_graph::ActionId;
    use tpg_graph::interpret::{self, Answer};
    use tpg_problems::{Problem, ProblemName};

    /// Returns the answers of a law of a problem to states, or the error.
    fn answers(problem: ProblemName, law: &str, states: &[f64]) -> Result<Vec<Answer>, String> {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let path = folder.path().join("law.toml");
        std::fs::write(&path, law).expect("a file");
        let environment = Problem::new(problem).environment::<f32>();
        let graph = read(&path, environment.sources(), environment.actions()).map_err(|error| error.to_string())?;
        Ok(interpret::answers(&graph, states))
    }

    #[test]
    fn a_law_computes_its_formulas() {
        let law = "[law]\ntorque = \"-2 * sin_theta - omega[0] / 4 + total\"\ntotal = \"max(total, 1)\"\n\
                   [memory]\ntotal = [-1, 1.5]\n";
        let found = answers(ProblemName::Pendulum, law, &[1.0, 0.5, 2.0, 0.25, 0.0, 9.0, 0.0, 3.0]).expect("a law");
        let expected = [[-1.25, 1.0], [-2.0, 1.5]].map(|values| Answer::Values(values.into()));
        assert_eq!(found, expected, "torque and memory, limited");
        let relay = "[law]\nright = \"theta + omega\"\nleft = \"0\"\n";
        let found = answers(ProblemName::Cartpole, relay, &[0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, -0.2]).expect("a law");
        assert_eq!(found, [1, 0].map(|action| Answer::Action(ActionId(action))));
    }

    #[test]
    fn what_is_no_law_is_refused_at_its_line() {
        for (law, found) in [
            (
                "[law]\ntorque = \"2 * sinus\"\n",
                "line 2: law.torque = \"sinus\", an unknown name; accepted: a formula of numbers, cos_theta, sin_theta, omega",
            ),
            ("[law]\nforce = \"2\"\ntorque = \"1\"\n", "line 2: law.force"),
            ("[law]\n", "no formula of torque"),
            ("[law]\ntorque = \"omega\"\n[memory]\nlast = [0, 1]\n", "no formula of last"),
            ("torque = \"1\"\n", "unknown field"),
        ] {
            let error = answers(ProblemName::Pendulum, law, &[]).expect_err(law);
            assert!(error.contains(found), "{error}");
        }
    }
}
