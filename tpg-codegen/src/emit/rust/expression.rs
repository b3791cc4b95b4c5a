//! Nodes as Rust expressions.

use crate::emit::layout;
use crate::emit::syntax::Syntax;
use crate::ir::Node;
use crate::passes::bytecode::Width;
use tpg_graph::{Graph, Input, MathsProvider, ScalarType};
use tpg_runtime::ops::Instruction;

/// Keywords of Rust, and the variables and functions of generated code.
const TAKEN: [&str; 5] = [
    "abstract action as async await become best bid bidder bool box break char const continue core cos crate ct",
    "do dyn edge else enum exp exp_upper extern f32 f64 false final fn for frame gen if impl in lead leaf let ln",
    "ln_upper loop macro match memory mod move mut next operand ops out override priv program pub ref return run",
    "s self sin span state static struct super tan trait true try type typeof unsafe unsized use vertex virtual",
    "walk where while yield zero",
];

/// Writes nodes.
#[derive(Clone, Copy)]
pub(super) struct RustPrinter<'a> {
    pub(super) graph: &'a Graph,
    pub(super) nodes: &'a [Node],
    /// Calls of sine, cosine, tangent, logarithm and exponential go through helpers that are not inlined; for the platform's maths,
    /// these handle the simple cases themselves.
    pub(super) short_cuts: bool,
    /// No branches: instructions with a comparison go through `ct`, a `ConstantTime`.
    pub(super) branch_free: bool,
    /// A structure's functions compare bids, as in C.
    pub(super) leads: bool,
}

impl Syntax for RustPrinter<'_> {
    fn graph(&self) -> &Graph {
        self.graph
    }

    fn nodes(&self) -> &[Node] {
        self.nodes
    }

    fn scalar(&self) -> &'static str {
        self.graph.scalar().name()
    }

    fn unsigned(&self, width: Width) -> String {
        format!("u{}", width.bits())
    }

    fn literal(&self, value: f64) -> String {
        let scalar = self.graph.scalar();
        let name = scalar.name();
        match scalar {
            _ if value.is_nan() => format!("{name}::NAN"),
            _ if value.is_infinite() => format!("{name}::{}", if value < 0.0 { "NEG_INFINITY" } else { "INFINITY" }),
            ScalarType::F32 => format!("{:?}_f32", value as f32),
            ScalarType::F64 => format!("{value:?}_f64"),
        }
    }

    fn hidden(&self, number: &str) -> String {
        format!("core::hint::black_box({number})")
    }

    fn hidden_zero(&self, zero: &str) -> Vec<String> {
        vec![format!("let zero = core::hint::black_box({zero});")]
    }

    fn declaration(&self, name: &str, expression: &str) -> String {
        format!("let {name} = {expression};")
    }

    fn lowest(&self) -> String {
        format!("{}::MIN", self.scalar())
    }

    fn is_taken(&self, name: &str) -> bool {
        TAKEN.iter().any(|words| words.split(' ').any(|word| word == name))
    }

    fn index(&self, number: usize) -> String {
        number.to_string()
    }

    fn leads(&self) -> bool {
        self.leads
    }

    fn can_win(&self, bound: &str, edge: Option<&str>) -> String {
        match edge {
            Some(edge) => format!("lead.can_at({bound}, {edge})"),
            None => format!("lead.can({bound})"),
        }
    }

    const BRACES: bool = false;

    fn input(&self, input: Input) -> String {
        format!("s[{}]", input.index())
    }

    fn upper(&self, instruction: Instruction, argument: &str) -> String {
        format!("{}_upper({argument})", instruction.name())
    }

    fn call(&self, instruction: Instruction, arguments: &str) -> String {
        let place = match instruction {
            Instruction::Abs => format!("{}::", self.scalar()),
            _ if instruction.is_transcendental() => {
                if self.masked_maths() {
                    "ct.".to_owned()
                } else if self.short_cuts {
                    String::new()
                } else {
                    format!("{}::", self.provider())
                }
            }
            _ => if self.branch_free { "ct." } else { "ops::" }.to_owned(),
        };
        format!("{place}{}({arguments})", instruction.name())
    }
}

impl RustPrinter<'_> {
    /// The type that implements the transcendental functions.
    pub(super) fn provider(&self) -> &'static str {
        match self.graph.maths() {
            MathsProvider::Own => "Own",
            MathsProvider::System => "System",
        }
    }

    /// A value limited to an output's range, as an element of an array in the body of a method: a line of its own, unless it is the
    /// array's only one.
    pub(super) fn clamp(&self, value: &str, limits: &str, is_single: bool) -> String {
        let name = if self.branch_free { "ct.clamp" } else { "ops::clamp" };
        // rustfmt counts a function's name, not a method's, where the call shares its line with brackets.
        let counted = if is_single && !self.branch_free { name.len() + "()".len() } else { 0 };
        let indent = if is_single { 8 } else { 12 };
        format!("{name}({})", layout::arguments(&format!("{value}, {limits}"), counted, indent))
    }

    /// Tests whether `ct` implements the graph's maths.
    fn masked_maths(&self) -> bool {
        self.branch_free && self.graph.maths() == MathsProvider::Own && self.graph.scalar() == ScalarType::F32
    }
}
