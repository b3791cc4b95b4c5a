//! Nodes as C expressions.

use super::field;
use crate::emit::names;
use crate::emit::syntax::Syntax;
use crate::ir::Node;
use crate::passes::bytecode::Width;
use Instruction::*;
use tpg_graph::{Graph, Input, MathsProvider, ScalarType::*};
use tpg_runtime::ops::Instruction;

/// Writes nodes.
#[derive(Clone, Copy)]
pub(super) struct CPrinter<'a> {
    pub(super) graph: &'a Graph,
    pub(super) nodes: &'a [Node],
    pub(super) prefix: &'a str,
    /// Inputs are GEGELATI's globals.
    pub(super) gegelati: bool,
    /// Calls of the platform's logarithm and exponential go through helpers that handle the simple cases themselves.
    pub(super) short_cuts: bool,
    /// No branches: instructions with a comparison go through functions that choose by masks.
    pub(super) branch_free: bool,
    /// [Functions](crate::emit::team::compares_in_functions) compare bids.
    pub(super) leads: bool,
    /// Numbers are whole.
    pub(super) integers: bool,
}

impl Syntax for CPrinter<'_> {
    fn graph(&self) -> &Graph {
        self.graph
    }

    fn nodes(&self) -> &[Node] {
        self.nodes
    }

    fn scalar(&self) -> &'static str {
        match self.graph.scalar() {
            F32 => "float",
            F64 => "double",
        }
    }

    fn suffix(&self, width: Width) -> &'static str {
        if width.bits() == 64 { "ULL" } else { "U" }
    }

    fn unsigned(&self, width: Width) -> String {
        format!("uint{}_t", width.bits())
    }

    fn literal(&self, value: f64) -> String {
        let scalar = self.graph.scalar();
        match scalar {
            _ if self.integers && value == f64::from(i32::MIN) => "INT32_MIN".to_owned(),
            _ if self.integers => (value as i64).to_string(),
            F32 if value.is_finite() => format!("{:?}f", value as f32),
            F64 if value.is_finite() => format!("{value:?}"),
            _ => {
                let sign = if value < 0.0 { "-" } else { "" };
                let cast = if scalar == F64 { "(double)" } else { "" };
                format!("{sign}{cast}{}", if value.is_nan() { "NAN" } else { "INFINITY" })
            }
        }
    }

    fn hidden(&self, number: &str) -> String {
        format!("{}_hidden({number})", self.prefix)
    }

    fn hidden_zero(&self, zero: &str) -> Vec<String> {
        let scalar = self.scalar();
        vec![
            "/* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */".to_owned(),
            format!("const volatile {scalar} constant = {zero};"),
            format!("const {scalar} zero = constant;"),
        ]
    }

    fn declaration(&self, name: &str, expression: &str) -> String {
        format!("const {} {name} = {expression};", self.scalar())
    }

    fn lowest(&self) -> String {
        format!("-{}", self.greatest())
    }

    fn is_taken(&self, name: &str) -> bool {
        /// Variables of generated functions; compilers take `main` for the program's.
        const OURS: &str = "action best constant edge end frame hop lead main next programs start state to vertex zero";
        OURS.split(' ').any(|word| word == name) || field::is_taken(name)
    }

    fn index(&self, number: usize) -> String {
        format!("{number}U")
    }

    fn leads(&self) -> bool {
        self.leads
    }

    fn can_win(&self, bound: &str, edge: Option<&str>) -> String {
        match edge {
            Some(edge) => format!("{}_can_at(&lead, {bound}, {edge}) != 0U", self.prefix),
            None => format!("{}_can(&lead, {bound}) != 0U", self.prefix),
        }
    }

    const BRACES: bool = true;

    fn input(&self, input: Input) -> String {
        if self.gegelati {
            let (source, place) = self.graph.source_of(input);
            let number = self.graph.sources().iter().position(|s| s.name == source.name).unwrap_or(0) + 1;
            format!("in{number}[{place}]")
        } else {
            field::member(self.graph, input)
        }
    }

    fn upper(&self, instruction: Instruction, argument: &str) -> String {
        format!("{}_{}_upper({argument})", self.prefix, instruction.name())
    }

    fn call(&self, instruction: Instruction, arguments: &str) -> String {
        let function = match instruction {
            Cos => self.maths("cos", "cos", false),
            Sin => self.maths("sin", "sin", false),
            Tan => self.maths("tan", "tan", false),
            Ln => self.maths("ln", "log", true),
            Exp => self.maths("exp", "exp", true),
            Atan => self.maths("atan", "atan", false),
            Tanh => self.maths("tanh", "tanh", false),
            Abs => self.function("fabs"),
            Sqrt if !self.branch_free => self.root(),
            _ => format!("{}_{}", self.prefix, instruction.name()),
        };
        format!("{function}({arguments})")
    }
}

impl CPrinter<'_> {
    /// The prefix in capitals.
    pub(super) fn upper(&self) -> String {
        self.prefix.to_ascii_uppercase()
    }

    /// The macro of the highest finite number, whose negative is the lowest.
    pub(super) fn greatest(&self) -> &'static str {
        match self.graph.scalar() {
            F32 => "FLT_MAX",
            F64 => "DBL_MAX",
        }
    }

    /// The constants of the actions.
    pub(super) fn constants(&self) -> Vec<String> {
        let constant = |name: String| format!("{}_{name}", self.prefix).to_ascii_uppercase();
        names::actions(self.graph).into_iter().map(constant).collect()
    }

    /// The value in place of NaN, where it is the same for every output.
    pub(super) fn same_nan(&self) -> Option<f64> {
        let (first, others) = self.graph.outputs().split_first()?;
        others.iter().all(|output| output.nan.to_bits() == first.nan.to_bits()).then_some(first.nan)
    }

    fn maths(&self, own: &str, system: &str, has_short_cut: bool) -> String {
        match self.graph.maths() {
            MathsProvider::System if !(self.short_cuts && has_short_cut) => self.function(system),
            MathsProvider::System | MathsProvider::Own => format!("{}_{own}", self.prefix),
        }
    }

    /// The name of the function that computes a square root: of `<math.h>`, or one that needs no library where an FPU has it.
    pub(super) fn root(&self) -> String {
        match (self.graph.scalar(), self.graph.maths()) {
            (F32, MathsProvider::Own) => format!("{}_root", self.prefix),
            _ => self.function("sqrt"),
        }
    }

    /// The name of a function of `<math.h>` in the graph's scalar type.
    pub(super) fn function(&self, name: &str) -> String {
        match self.graph.scalar() {
            F32 => format!("{name}f"),
            F64 => name.to_owned(),
        }
    }
}
