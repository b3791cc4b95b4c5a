//! What C and Rust spell their own way.

use crate::emit::c::field::member;
use crate::emit::file::{comment, one_line};
use crate::integers::{input_bits, output_bits};
use crate::options::Language;
use crate::program::Program;
use tpg_graph::{Graph, Input, Output};

/// The spelling of a language.
pub(in crate::emit) struct IntegerSpelling<'a> {
    is_c: bool,
    graph: &'a Graph,
    prefix: &'a str,
}

impl<'a> IntegerSpelling<'a> {
    pub(super) fn new(program: &'a Program<'_>) -> Self {
        let (graph, prefix) = (program.graph(), program.options.prefix.lower());
        Self { is_c: program.language == Language::C, graph, prefix }
    }

    /// The spelling in C, or in Rust.
    fn either<T>(&self, c: T, rust: T) -> T {
        if self.is_c { c } else { rust }
    }

    /// The type of a value in 32 bits, or in 64.
    pub(super) fn integer(&self, wide: bool) -> &'static str {
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
        self.either(member(self.graph, input), format!("s[{}]", input.index()))
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

    /// A call of a function.
    pub(super) fn call(&self, function: &str, wide: bool, arguments: &[String]) -> String {
        let (end, all) = (self.end(wide), arguments.join(", "));
        match function {
            _ if self.is_c => format!("{}_{function}{end}({all})", self.prefix),
            "shift" => format!("({})", arguments.join(" >> ")),
            "min" | "max" | "abs" | "clamp" => format!("({}).{function}({})", arguments[0], arguments[1..].join(", ")),
            _ => format!("{function}{end}({all})"),
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

    /// The lines of a comment.
    pub(super) fn comment(&self, said: &str) -> Vec<String> {
        if self.is_c { wrapped(&comment(said)) } else { vec![format!("// {}", one_line(said))] }
    }

    /// The place of a destination among a team's.
    pub(super) fn place(&self, place: usize) -> String {
        format!("{place}{}", self.either("U", ""))
    }

    /// A value of 32 bits in the type of an output.
    pub(super) fn answered(&self, output: &Output, value: &str) -> String {
        match self.either(output_bits(output), answer_bits(self.graph)) {
            32 => value.to_owned(),
            bits => self.either(format!("(int{bits}_t){value}"), format!("({value}) as i{bits}")),
        }
    }
}

/// Bits of the type of every value of a state in Rust: that of the widest.
pub(crate) fn state_bits(graph: &Graph) -> u32 {
    graph.inputs().map(|input| input_bits(graph, input)).max().unwrap_or(16)
}

/// Bits of the type of every output in Rust.
pub(in crate::emit) fn answer_bits(graph: &Graph) -> u32 {
    graph.outputs().iter().map(output_bits).max().unwrap_or(16)
}

/// A comment of C on as many lines as it takes.
fn wrapped(said: &str) -> Vec<String> {
    const WIDTH: usize = 102;
    let mut lines = vec!["/*".to_owned()];
    // The end of the comment stays with the last word.
    for word in format!("{said}\u{a0}*/").split(' ') {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= WIDTH => *line += &format!(" {word}"),
            _ => lines.push(format!(" * {word}")),
        }
    }
    lines.into_iter().map(|line| line.replace('\u{a0}', " ")).collect()
}
