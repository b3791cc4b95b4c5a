//! What C and Rust spell their own way: a text of several lines is indented where it is written.

use crate::emit::c::field::field;
use crate::emit::file::{comment, one_line};
use crate::emit::interface::actions;
use crate::integers::{input_bits, output_bits};
use crate::options::Language;
use crate::program::Program;
use Function::*;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use tpg_graph::{ActionId, Graph, Input, Output};

/// A function that expressions call.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Function {
    /// Rounded down to a multiple of a power of two, and divided by it.
    Shift,
    /// A quotient rounded down, of a divisor that is not 0.
    Divide,
    /// [`Instruction::Quotient`](tpg_runtime::ops::Instruction::Quotient).
    Quotient,
    Min,
    Max,
    Abs,
    NegateIfLess,
    Gate,
    /// Limited to a range.
    Clamp,
}

/// The functions that are called, and whether in 64 bits.
pub(super) type Called = BTreeSet<(Function, bool)>;

/// The functions of one width, for a template.
pub(super) struct IntegerHelpers {
    pub(super) int: &'static str,
    /// The end of their names.
    pub(super) end: &'static str,
    called: BTreeSet<Function>,
}

impl IntegerHelpers {
    pub(super) fn calls(&self, function: Function) -> bool {
        self.called.contains(&function)
    }
}

/// The spelling of a language.
pub(super) struct IntegerSpelling<'a> {
    is_c: bool,
    graph: &'a Graph,
    prefix: &'a str,
    /// The actions' constants in C.
    constants: Vec<(String, String)>,
}

impl<'a> IntegerSpelling<'a> {
    pub(super) fn new(program: &'a Program<'_>) -> Self {
        let (graph, prefix) = (program.graph(), &program.options.prefix);
        Self {
            is_c: program.language == Language::C,
            graph,
            prefix: prefix.lower(),
            constants: actions(graph, &prefix.upper()),
        }
    }

    /// The spelling in C, or in Rust.
    pub(super) fn either<T>(&self, c: T, rust: T) -> T {
        if self.is_c { c } else { rust }
    }

    /// The functions of 32 bits, then those of 64.
    pub(super) fn helpers(&self, called: &Called) -> [IntegerHelpers; 2] {
        [false, true].map(|wide| {
            let called = called.iter().filter(|(_, is_wide)| *is_wide == wide).map(|(function, _)| *function);
            IntegerHelpers { int: self.integer(wide), end: self.end(wide), called: called.collect() }
        })
    }

    /// The type of a value in 32 bits, or in 64.
    fn integer(&self, wide: bool) -> &'static str {
        if wide { self.either("int64_t", "i64") } else { self.either("int32_t", "i32") }
    }

    /// The end of the name of a function of such values.
    fn end(&self, wide: bool) -> &'static str {
        if wide { self.either("64", "_64") } else { "" }
    }

    /// A value of the state in 32 bits, or in 64.
    pub(super) fn input(&self, input: Input, wide: bool) -> String {
        let bits = self.either(input_bits(self.graph, input), state_bits(self.graph));
        let value = self.value(input);
        match (self.is_c, wide) {
            (_, false) if bits == 32 => value,
            (true, _) => format!("({}){value}", self.integer(wide)),
            (false, _) => format!("{}::from({value})", self.integer(wide)),
        }
    }

    /// A value of the state of 8 bits as C holds it.
    pub(super) fn byte(&self, input: Input) -> Option<String> {
        (self.is_c && input_bits(self.graph, input) == 8).then(|| self.value(input))
    }

    /// A value of the state in its own type.
    fn value(&self, input: Input) -> String {
        let (source, place) = self.graph.source_of(input);
        let name = field(self.graph, &source.name);
        match source.counts.len() {
            _ if !self.is_c => format!("s[{}]", input.index()),
            0 => format!("memory->{name}"),
            1 => format!("state->{name}"),
            _ => format!("state->{name}[{place}]"),
        }
    }

    /// A whole number.
    pub(super) fn literal(&self, value: i64, wide: bool) -> String {
        let text = match (value, wide) {
            _ if !self.is_c => return format!("{value}_{}", self.integer(wide)),
            (-2_147_483_648, false) => return "INT32_MIN".to_owned(),
            (2_147_483_647, false) => return "INT32_MAX".to_owned(),
            (_, true) => format!("INT64_C({})", value.unsigned_abs()),
            (_, false) => value.unsigned_abs().to_string(),
        };
        if value < 0 { format!("(-{text})") } else { text }
    }

    /// An operand of 32 bits in 64.
    pub(super) fn widened(&self, text: &str) -> String {
        self.either(format!("(int64_t){text}"), format!("i64::from({text})"))
    }

    /// An operand of 64 bits that is known to fit 32.
    pub(super) fn narrowed(&self, text: &str) -> String {
        self.either(format!("(int32_t){text}"), format!("{text} as i32"))
    }

    /// A call.
    pub(super) fn call(&self, function: Function, wide: bool, arguments: &[String]) -> String {
        let name = match function {
            Shift => "shift",
            Divide => "divide",
            Quotient => "quotient",
            Min => "min",
            Max => "max",
            Abs => "abs",
            NegateIfLess => "negate_if_less",
            Gate => "gate",
            Clamp => "clamp",
        };
        let (end, all) = (self.end(wide), arguments.join(", "));
        match function {
            Shift => {
                self.either(format!("{}_{name}{end}({all}U)", self.prefix), format!("({})", arguments.join(" >> ")))
            }
            _ if self.is_c => format!("{}_{name}{end}({all})", self.prefix),
            Min | Max | Abs | Clamp => {
                format!("({}).{name}({})", arguments[0], arguments[1..].join(", "))
            }
            _ => format!("{name}{end}({all})"),
        }
    }

    /// The quotient of a number that is not negative by a power of two.
    pub(super) fn halved(&self, text: &str, bits: u32, wide: bool) -> String {
        let int = self.integer(wide);
        self.either(format!("({int})((u{int}){text} >> {bits}U)"), format!("({text} >> {bits})"))
    }

    /// The statement that names a value.
    pub(super) fn statement(&self, name: &str, wide: bool, value: &str) -> String {
        let int = self.integer(wide);
        self.either(format!("const {int} {name} = {value};"), format!("let {name}: {int} = {value};"))
    }

    /// A comment at a level of indentation.
    pub(super) fn comment(&self, said: &str, depth: usize) -> String {
        if self.is_c { wrapped(&comment(said), 110 - depth * 4) } else { format!("// {}", one_line(said)) }
    }

    /// The name of an action in comments.
    pub(super) fn said(&self, action: ActionId) -> String {
        self.either(self.graph.actions()[usize::from(action.0)].name.clone(), self.graph.end_name(action))
    }

    /// An action.
    pub(super) fn action(&self, action: ActionId) -> String {
        self.either(self.constants[usize::from(action.0)].0.clone(), action.0.to_string())
    }

    /// The place of a destination among a team's.
    pub(super) fn place(&self, place: usize) -> String {
        format!("{place}{}", self.either("U", ""))
    }

    /// The declaration of a team's best bid, which changes where there are more than two.
    pub(super) fn best(&self, wide: bool, changes: bool) -> String {
        let int = self.integer(wide);
        match changes {
            true => self.either(format!("{int} best"), format!("let mut best: {int}")),
            false => self.either(format!("const {int} best"), format!("let best: {int}")),
        }
    }

    /// The variable of the winner, which is an action or a destination, and its declaration.
    pub(super) fn winner(&self, is_action: bool) -> (&'static str, String) {
        match self.is_c {
            true if is_action => ("action", format!("{}_action_t action", self.prefix)),
            true => ("way", "uint_fast8_t way".to_owned()),
            false => ("to", "let mut to".to_owned()),
        }
    }

    /// The beginning of a block under a condition.
    pub(super) fn when(&self, condition: &str) -> String {
        self.either(format!("if ({condition}) {{"), format!("if {condition} {{"))
    }

    /// The beginning of a vertex's block.
    pub(super) fn head(&self, vertex: &str, is_first: bool, is_last: bool) -> String {
        match self.is_c {
            true if is_first => "    {\n".to_owned(),
            true => format!("{vertex}:\n    {{\n"),
            false => format!("{:16}{} => {{\n", "", if is_last { "_" } else { vertex }),
        }
    }

    /// The statement that goes to a vertex.
    pub(super) fn go(&self, vertex: &str) -> String {
        self.either(format!("goto {vertex};"), format!("vertex = {vertex};"))
    }

    /// The statement that answers an action, in the code of one of several vertices or at the end of the body.
    pub(super) fn answer(&self, action: &str, several: bool) -> String {
        match self.is_c {
            true => format!("return {action};"),
            false if several => format!("return ActionId({action});"),
            false => format!("ActionId({action})"),
        }
    }

    /// The first of two values if a condition holds, else the second.
    pub(super) fn one_of_two(&self, condition: &str, [one, other]: &[String; 2]) -> String {
        self.either(
            format!("({condition}) ? {one} : {other}"),
            format!("if {condition} {{ {one} }} else {{ {other} }}"),
        )
    }

    /// One of some statements, as the winner is their place.
    pub(super) fn choice(&self, ways: &[String]) -> String {
        let mut text = self.either("", "match to {\n").to_owned();
        for (place, way) in ways.iter().enumerate() {
            let is_last = place + 1 == ways.len();
            text += &match self.is_c {
                true if is_last => way.clone(),
                true => format!("if (way == {place}U) {{\n    {way}\n}}\n"),
                false if is_last => format!("    _ => {},\n}}", way.trim_end_matches(';')),
                false => format!("    {place} => {},\n", way.trim_end_matches(';')),
            };
        }
        text
    }

    /// The variable of an output, if it gets one.
    pub(super) fn variable(&self, output: &Output) -> Option<String> {
        self.is_c.then(|| field(self.graph, &output.name))
    }

    /// The statements that answer values in their ranges.
    pub(super) fn outputs(&self, values: &[String], several: bool) -> String {
        if !self.is_c {
            let bits = answer_bits(self.graph);
            let cast = |value: &String| if bits == 32 { value.clone() } else { format!("({value}) as i{bits}") };
            let answer = values.iter().map(cast).collect::<Vec<_>>().join(", ");
            return if several { format!("return [{answer}];") } else { format!("[{answer}]") };
        }
        // What is remembered is read before it is written.
        let is_later = self.graph.memory() > 0;
        let (mut first, mut text) = (String::new(), String::new());
        for (place, (output, value)) in self.graph.outputs().iter().zip(values).enumerate() {
            let to = if output.counts.is_some() { "action" } else { "memory" };
            let cast = match output_bits(output) {
                32 => String::new(),
                bits => format!("(int{bits}_t)"),
            };
            let next = format!("next_{place}");
            if is_later {
                let _ = writeln!(first, "const int32_t {next} = {value};");
            }
            let value = if is_later { &next } else { value };
            let _ = writeln!(text, "{to}->{} = {cast}{value};", field(self.graph, &output.name));
        }
        first + &text + if several { "return;" } else { "" }
    }
}

/// Bits of the type of every value of a state in Rust: that of the widest.
pub(super) fn state_bits(graph: &Graph) -> u32 {
    graph.inputs().map(|input| input_bits(graph, input)).max().unwrap_or(16)
}

/// Bits of the type of every output in Rust.
pub(super) fn answer_bits(graph: &Graph) -> u32 {
    graph.outputs().iter().map(output_bits).max().unwrap_or(16)
}

/// A comment of C on as many lines as it takes.
fn wrapped(said: &str, width: usize) -> String {
    let mut lines = vec!["/*".to_owned()];
    // The end of the comment stays with the last word.
    for word in format!("{said}\u{a0}*/").split(' ') {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= width => *line += &format!(" {word}"),
            _ => lines.push(format!(" * {word}")),
        }
    }
    lines.join("\n").replace('\u{a0}', " ")
}
