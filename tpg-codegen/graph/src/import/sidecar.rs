//! The sidecar: a TOML file that supplies what a `.dot` file leaves out.

use super::composed::{Expression, FORM, OPERANDS, Operator, Windows};
use crate::Word;
use crate::error::{InputError, Place, serde_message};
use crate::model::{
    ActionDocument, Document, FORMAT, MAX_NUMBERED, MathsProvider, OutputDocument, ScalarType, SourceDocument,
};
use crate::settings;
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};

/// The contents of a `graph.json` that a `.dot` file leaves out: everything except teams and programs.
///
/// ```
/// use tpg_graph::import::Sidecar;
///
/// let text = r#"
///     scalar = "f64"              # scalar type of programs: "f32" or "f64"
///     maths = "system"            # provider of sin, cos, tan, ln, exp: "own" or "system"
///     registers = 8
///     sources = [                 # in the order of the environment, without the registers and program constants
///         { name = "position", length = 3, unit = "mm", range = [-600, 600] },
///         { name = "motors", length = 2, unit = "ticks", ranges = [[0, 4095], [512, 512]] },
///     ]
///     instructions = [            # in the order of their numbers in the file
///         "sub", "std_max",
///         { name = "scale", is = "mul(a, div(b, 10))" },     # composed of words; a and b are its operands
///         { name = "tan" },       # no program of the file uses it
///     ]
///     actions = [                 # by node label; "move" or effect = { name, values } is for the problem
///         { id = 0, name = "left", move = [-3, 0, 0, 0] },
///         { id = 1, name = "right", move = [3, 0, 0, 0] },
///     ]
/// "#;
/// let sidecar = Sidecar::from_toml("arm.toml", text)?;
/// assert_eq!(sidecar.document().sources[0].ranges, [[-600.0, 600.0]; 3]);
/// # Ok::<(), tpg_graph::error::InputError>(())
/// ```
///
/// A policy that answers with values has `outputs` instead of actions, and `values` says which registers they are.
#[derive(Clone, Debug)]
pub struct Sidecar {
    file: String,
    text: String,
    document: Document,
    instructions: Vec<Operator>,
    /// The expression through which each output's value goes before it is limited; `None` for none.
    activations: Vec<Option<Expression>>,
    values: Values,
    /// Rows and columns of each source of two dimensions.
    shapes: Vec<Option<[u32; 2]>>,
    /// Registers of a program in the `.dot` file, without those for intermediate values.
    registers: u32,
}

/// The file as written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Described {
    scalar: ScalarType,
    maths: MathsProvider,
    registers: u32,
    sources: Vec<DescribedSource>,
    instructions: Vec<DescribedInstruction>,
    #[serde(default)]
    actions: Vec<ActionDocument>,
    #[serde(default)]
    outputs: Vec<DescribedOutput>,
    #[serde(default)]
    values: Values,
}

/// The origin of the values of GEGELATI 2's continuous actions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum Values {
    /// Register 0 of an action's programs, one for each value that its label names; another value is 0
    /// (`useMultiActionProgram`).
    #[default]
    Programs,
    /// Registers 0, 1, … of an action's only program (`useActionProgram`).
    Registers,
    /// Registers 1, 2, … of the program that won the bid.
    Bid,
}

/// An output; `is` is made of the value `a`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DescribedOutput {
    name: String,
    unit: String,
    min: f64,
    max: f64,
    nan: f64,
    is: Option<String>,
}

/// An instruction: a word, or a name with what it is composed of.
#[derive(Deserialize)]
#[serde(untagged, expecting = "invalid instruction, expected a word, or { name = \"…\", is = \"…\" }")]
enum DescribedInstruction {
    Word(String),
    Composed(Composed),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Composed {
    name: String,
    is: Option<String>,
    #[serde(default)]
    windows: BTreeMap<String, Vec<u32>>,
}

/// A source, with either one range for all its values or one range per value.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DescribedSource {
    name: String,
    length: u32,
    shape: Option<[u32; 2]>,
    unit: String,
    range: Option<[f64; 2]>,
    ranges: Option<Vec<[f64; 2]>>,
}

impl Sidecar {
    /// The text of an example, with a comment on each field.
    pub const EXAMPLE: &'static str = include_str!("../../sidecar.example.toml");

    /// Reads and validates a sidecar. `file` is its name in messages.
    ///
    /// # Errors
    /// Any error in the sidecar, with line and column.
    pub fn from_toml(file: &str, text: &str) -> Result<Self, InputError> {
        let described: Described = toml::from_str(text).map_err(|error| {
            let place = error.span().map_or(Place::Whole, |span| place_of(text, span.start));
            let (found, accepted) = serde_message(error.message());
            InputError::new(
                file,
                place,
                found,
                accepted.unwrap_or("the fields that a sidecar has: `tpg-codegen sidecar` prints one"),
            )
        })?;
        let mut sidecar = Self {
            file: file.to_owned(),
            text: text.to_owned(),
            document: Document::default(),
            instructions: Vec::new(),
            activations: Vec::new(),
            values: described.values,
            shapes: described.sources.iter().map(|source| source.shape).collect(),
            registers: described.registers,
        };
        sidecar.instructions = sidecar.instructions_of(&described)?;
        sidecar.activations = sidecar.activations_of(&described)?;
        sidecar.document = sidecar.document_of(described)?;
        let checked = sidecar.document.check_declarations(file);
        checked.map_err(|error| sidecar.place_error(error))?;
        Ok(sidecar)
    }

    /// Returns the described document, which lacks root, teams and programs.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// Returns the meaning of each instruction number of the `.dot` file.
    pub(super) fn instructions(&self) -> &[Operator] {
        &self.instructions
    }

    /// Returns the number of registers of a program in the `.dot` file; the graph has more for intermediate values.
    pub(super) fn registers(&self) -> u32 {
        self.registers
    }

    /// Returns what becomes of each output's value before it is limited; `None` for nothing.
    pub(super) fn activations(&self) -> &[Option<Expression>] {
        &self.activations
    }

    /// Tests for instructions that read constants of their line: those behind a program's lines then belong to the lines.
    pub(super) fn constants_of_lines(&self) -> bool {
        self.instructions.iter().filter_map(|operator| operator.value.as_ref()).any(|value| value.constants() > 0)
    }

    /// Returns where the values of outputs come from.
    pub(super) fn values(&self) -> Values {
        self.values
    }

    /// Returns rows and columns of each source of two dimensions.
    pub(super) fn shapes(&self) -> &[Option<[u32; 2]>] {
        &self.shapes
    }

    /// Moves an error about the sidecar's document from its JSON path to the place in the TOML text.
    pub(super) fn place_error(&self, error: InputError) -> InputError {
        match &error.place {
            Place::Path(path) => InputError { file: self.file.clone(), place: self.place(path), ..error },
            _ => error,
        }
    }

    fn error(&self, path: &str, found: impl Into<String>, accepted: &str) -> InputError {
        InputError::new(&self.file, self.place(path), found, accepted)
    }

    fn refuse<T>(&self, path: &str, found: impl Into<String>, accepted: &str) -> Result<T, InputError> {
        Err(self.error(path, found, accepted))
    }

    fn instructions_of(&self, described: &Described) -> Result<Vec<Operator>, InputError> {
        let mut operators: Vec<Operator> = Vec::new();
        for (index, instruction) in described.instructions.iter().enumerate() {
            let path = format!("$.instructions[{index}]");
            let (name, value, windows) = match instruction {
                DescribedInstruction::Word(name) => {
                    let found = || format!("unknown instruction {name:?}");
                    let words = Word::ALL.map(Word::name).join(", ");
                    let accepted = || format!("{words}; or {{ name = {name:?}, is = … }}, {FORM}");
                    let word = Word::from_name(name).ok_or_else(|| self.error(&path, found(), &accepted()))?;
                    (name, Some(Expression::word(word)), Windows::default())
                }
                DescribedInstruction::Composed(Composed { name, is, windows }) => {
                    let windows = self.windows(&path, windows)?;
                    let value = is.as_ref().map(|text| Expression::parse(text, &windows)).transpose();
                    (name, value.map_err(|found| self.error(&path, found, FORM))?, windows)
                }
            };
            if operators.iter().any(|operator| operator.name == *name) {
                return self.refuse(&path, format!("{name:?} a second time"), "each instruction once");
            }
            operators.push(Operator { name: name.clone(), value, windows });
        }
        Ok(operators)
    }

    /// Returns the extent of each operand; the error is at an operand that is none, or has another number of dimensions.
    fn windows(&self, path: &str, described: &BTreeMap<String, Vec<u32>>) -> Result<Windows, InputError> {
        let mut windows = Windows::default();
        for (name, extent) in described {
            let path = format!("{path}.windows.{name}");
            let Some(place) = OPERANDS.iter().position(|operand| operand == name) else {
                return self.refuse(&path, format!("a window {name:?}"), &OPERANDS.join(", "));
            };
            if !(1..=2).contains(&extent.len()) || extent.contains(&0) {
                let accepted = "[columns] or [rows, columns], as in double[3] and double[3][3]";
                return self.refuse(&path, format!("a window of {extent:?}"), accepted);
            }
            windows[place].clone_from(extent);
        }
        Ok(windows)
    }

    fn activations_of(&self, described: &Described) -> Result<Vec<Option<Expression>>, InputError> {
        let outputs = &described.outputs;
        let needed = match described.values {
            Values::Programs => 1,
            Values::Registers => outputs.len(),
            Values::Bid => outputs.len() + 1,
        };
        if !outputs.is_empty() && needed > described.registers as usize {
            let found = format!("{} registers for {} outputs", described.registers, outputs.len());
            return self.refuse("$.registers", found, &format!("at least {needed}"));
        }
        (outputs.iter().enumerate())
            .map(|(index, output)| {
                let Some(text) = &output.is else { return Ok(None) };
                let path = format!("$.outputs[{index}].is");
                let value =
                    Expression::parse(text, &Windows::default()).map_err(|found| self.error(&path, found, FORM))?;
                match (value.arity(), value.constants()) {
                    (0 | 1, 0) => Ok(Some(value)),
                    _ => self.refuse(&path, format!("{text:?}"), "a call on the value a alone"),
                }
            })
            .collect()
    }

    /// Returns every composition: of instructions, and of what becomes of outputs.
    fn compositions(&self) -> impl Iterator<Item = &Expression> {
        let values = self.instructions.iter().filter_map(|operator| operator.value.as_ref());
        values.chain(self.activations.iter().flatten())
    }

    /// Returns the words that the instructions are made of: the instruction set of the graph.
    fn words(&self) -> Vec<String> {
        let mut words = BTreeSet::new();
        self.compositions().for_each(|call| call.words(&mut words));
        if !self.activations.is_empty() && self.values != Values::Programs {
            words.insert(Word::Copy);
        }
        words.into_iter().map(|word| word.name().to_owned()).collect()
    }

    /// Returns the number of registers for intermediate values.
    fn scratch(&self) -> u32 {
        self.compositions().map(Expression::scratch).max().unwrap_or(0)
    }

    fn document_of(&self, described: Described) -> Result<Document, InputError> {
        let mut sources = Vec::new();
        for (index, source) in described.sources.into_iter().enumerate() {
            let path = format!("$.sources[{index}]");
            let DescribedSource { name, length, shape, unit, range, ranges } = source;
            if length as usize > MAX_NUMBERED {
                return self.refuse(&format!("{path}.length"), length.to_string(), "1 to 65536");
            }
            if let Some([rows, columns]) = shape.filter(|[rows, columns]| rows.checked_mul(*columns) != Some(length)) {
                let accepted = format!("two numbers whose product is the length, {length}");
                return self.refuse(&format!("{path}.shape"), format!("{rows} by {columns}"), &accepted);
            }
            let ranges = match (range, ranges) {
                (Some(range), None) => vec![range; length as usize],
                (None, Some(ranges)) => ranges,
                (Some(_), Some(_)) => return self.refuse(&path, "both \"range\" and \"ranges\"", "one of the two"),
                (None, None) => {
                    let accepted = "\"range\" for all its values, or \"ranges\" with one for each";
                    return self.refuse(&path, "a source without range", accepted);
                }
            };
            sources.push(SourceDocument { length, ..SourceDocument::new(name, unit, ranges) });
        }
        Ok(Document {
            format: FORMAT.to_owned(),
            version: if described.outputs.is_empty() { 1 } else { 2 },
            scalar: described.scalar,
            maths: described.maths,
            registers: described.registers.saturating_add(self.scratch()),
            sources,
            instructions: self.words(),
            actions: described.actions,
            outputs: (described.outputs.into_iter())
                .map(|DescribedOutput { name, unit, min, max, nan, .. }| OutputDocument {
                    name,
                    unit,
                    min,
                    max,
                    nan,
                    counts: None,
                })
                .collect(),
            ..Document::default()
        })
    }

    /// Finds the place in the text that a JSON path names, or else the nearest enclosing element that the text has.
    fn place(&self, path: &str) -> Place {
        settings::position(&self.text, path).map_or(Place::Whole, |byte| place_of(&self.text, byte))
    }
}

fn place_of(text: &str, byte: usize) -> Place {
    let before = text.get(..byte).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    Place::Column(before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}
