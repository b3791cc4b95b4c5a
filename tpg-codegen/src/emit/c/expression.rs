//! Nodes as C expressions.

use crate::emit::field;
use crate::emit::syntax::Syntax;
use crate::ir::{Node, NodeId};
use crate::passes::bytecode::Width;
use tpg_graph::{Graph, Input, MathsProvider, ScalarType};
use tpg_runtime::ops::Instruction;

/// Writes nodes.
#[derive(Clone, Copy)]
pub(super) struct Printer<'a> {
    pub(super) graph: &'a Graph,
    pub(super) nodes: &'a [Node],
    pub(super) prefix: &'a str,
    /// Inputs are GEGELATI's globals.
    pub(super) gegelati: bool,
    /// Calls of the platform's logarithm and exponential go through helpers that handle the simple cases themselves.
    pub(super) short_cuts: bool,
    /// [Functions](super::fast::compares_in_functions) compare bids.
    pub(super) leads: bool,
}

impl Syntax for Printer<'_> {
    fn graph(&self) -> &Graph {
        self.graph
    }

    fn nodes(&self) -> &[Node] {
        self.nodes
    }

    fn scalar(&self) -> &'static str {
        match self.graph.scalar() {
            ScalarType::F32 => "float",
            ScalarType::F64 => "double",
        }
    }

    fn unsigned(&self, width: Width) -> String {
        format!("uint{}_t", width.bits())
    }

    fn literal(&self, value: f64) -> String {
        let scalar = self.graph.scalar();
        match scalar {
            ScalarType::F32 if value.is_finite() => format!("{:?}F", value as f32),
            ScalarType::F64 if value.is_finite() => format!("{value:?}"),
            _ => {
                let sign = if value < 0.0 { "-" } else { "" };
                let cast = if scalar == ScalarType::F64 { "(double)" } else { "" };
                format!("{sign}{cast}{}", if value.is_nan() { "NAN" } else { "INFINITY" })
            }
        }
    }

    fn hidden(&self, number: &str) -> String {
        format!("{}_hidden({number})", self.prefix)
    }

    fn hidden_zero(&self, zero: &str) -> Vec<String> {
        let scalar = self.scalar();
        vec![format!("const volatile {scalar} constant = {zero};"), format!("const {scalar} zero = constant;")]
    }

    fn statement(&self, id: NodeId) -> String {
        format!("const {} v{} = {};", self.scalar(), id.0, self.operation(id))
    }

    fn index(&self, number: usize) -> String {
        format!("{number}U")
    }

    fn lead_prefix(&self) -> Option<&str> {
        self.leads.then_some(self.prefix)
    }

    const BRACES: bool = true;

    fn number(&self, value: f64) -> String {
        let text = self.literal(value);
        if text.starts_with('-') { format!("({text})") } else { text }
    }

    fn input(&self, input: Input) -> String {
        let (source, place) = self.graph.source_of(input);
        if self.gegelati {
            let number = self.graph.sources().iter().position(|s| s.name == source.name).unwrap_or(0) + 1;
            format!("in{number}[{place}]")
        } else {
            format!("state->{}[{place}]", field(self.graph, &source.name))
        }
    }

    fn upper(&self, instruction: Instruction, argument: &str) -> String {
        format!("{}_{}_upper({argument})", self.prefix, instruction.name())
    }

    fn call(&self, instruction: Instruction, arguments: &str) -> String {
        let function = match instruction {
            Instruction::Cos => self.maths("cos", "cos", false),
            Instruction::Sin => self.maths("sin", "sin", false),
            Instruction::Tan => self.maths("tan", "tan", false),
            Instruction::Ln => self.maths("ln", "log", true),
            Instruction::Exp => self.maths("exp", "exp", true),
            Instruction::Abs => self.function("fabs"),
            _ => format!("{}_{}", self.prefix, instruction.name()),
        };
        format!("{function}({arguments})")
    }
}

impl Printer<'_> {
    /// The macro of the highest finite number, whose negative is the lowest.
    pub(super) fn lowest(&self) -> &'static str {
        match self.graph.scalar() {
            ScalarType::F32 => "FLT_MAX",
            ScalarType::F64 => "DBL_MAX",
        }
    }

    fn maths(&self, own: &str, system: &str, has_short_cut: bool) -> String {
        match self.graph.maths() {
            MathsProvider::System if !(self.short_cuts && has_short_cut) => self.function(system),
            MathsProvider::System | MathsProvider::Own => format!("{}_{own}", self.prefix),
        }
    }

    /// The name of a function of `<math.h>` in the graph's scalar type.
    pub(super) fn function(&self, name: &str) -> String {
        match self.graph.scalar() {
            ScalarType::F32 => format!("{name}f"),
            ScalarType::F64 => name.to_owned(),
        }
    }
}
