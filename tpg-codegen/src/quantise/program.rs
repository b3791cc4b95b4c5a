//! Whole numbers as lines of programs.

use crate::ir::{Node::*, NodeId, Values, needed};
use std::collections::{BTreeMap, BTreeSet};
use tpg_graph::{Graph, LineDocument, OperandDocument};
use tpg_runtime::ops::Instruction;

/// Programs under construction: each list of lines once.
#[derive(Default)]
pub(super) struct Programs {
    pub(super) all: Vec<(String, Vec<LineDocument>)>,
    /// Registers that they need.
    pub(super) registers: u32,
    /// Words that they use.
    pub(super) words: BTreeSet<String>,
}

impl Programs {
    /// The number of the program that computes a value; one that bids has one destination.
    pub(super) fn add(&mut self, graph: &Graph, values: &Values, value: NodeId, to: String) -> u32 {
        let lines = self.lines(graph, values, value);
        self.words.extend(lines.iter().map(|line| line.op.clone()));
        let program = (to, lines);
        let known = self.all.iter().position(|other| *other == program).unwrap_or_else(|| {
            self.all.push(program);
            self.all.len() - 1
        });
        known as u32
    }

    fn lines(&mut self, graph: &Graph, values: &Values, value: NodeId) -> Vec<LineDocument> {
        let operations = needed(values.nodes(), value, |_| true);
        let mut last: BTreeMap<NodeId, usize> = BTreeMap::new();
        let mut uses: BTreeMap<NodeId, usize> = BTreeMap::new();
        for (place, &id) in operations.iter().enumerate() {
            for &operand in values.nodes()[id.index()].operands() {
                last.insert(operand, place);
                *uses.entry(operand).or_default() += 1;
            }
        }
        let is_product =
            |id: NodeId| matches!(values.node(id), Operation(Instruction::Mul, _)) && uses.get(&id) == Some(&1);
        // Products that are added to a sum are part of its line.
        let mut added = BTreeSet::new();
        for (place, &id) in operations.iter().enumerate() {
            if let Operation(Instruction::Add, [a, b]) = values.node(id)
                && is_product(b)
                && values.node(a).is_computed()
                && uses.get(&a) == Some(&1)
                && !added.contains(&a)
            {
                added.insert(b);
                // The factors are read where the sum is.
                for &factor in values.node(b).operands() {
                    last.entry(factor).and_modify(|last| *last = place.max(*last));
                }
            }
        }
        let mut registers: BTreeMap<NodeId, u32> = BTreeMap::new();
        let mut lines = Vec::new();
        for (place, &id) in operations.iter().enumerate() {
            let Operation(instruction, [a, b]) = values.node(id) else { continue };
            if added.contains(&id) {
                continue;
            }
            let (op, operands, fixed) = match values.node(b) {
                Operation(_, [x, y]) if instruction == Instruction::Add && added.contains(&b) => {
                    ("multiply_add", vec![x, y], registers.remove(&a))
                }
                _ if instruction.arity() == 1 => (instruction.name(), vec![a], None),
                _ => (instruction.name(), vec![a, b], None),
            };
            let args = operands.iter().map(|&operand| match values.node(operand) {
                Constant(bits) => OperandDocument::Constant(f64::from_bits(bits)),
                Input(input) => OperandDocument::Place(graph.input_name(input)),
                Operation(..) | Upper(..) => OperandDocument::Place(format!("r{}", registers[&operand])),
            });
            let args = args.collect();
            let is_later = |operand: &NodeId| last.get(operand).is_some_and(|&last| last > place);
            registers.retain(|operand, _| is_later(operand));
            let free = || (0..).find(|register| !registers.values().any(|used| used == register)).unwrap_or(0);
            let to = if id == value && fixed.is_none() { 0 } else { fixed.unwrap_or_else(free) };
            registers.insert(id, to);
            self.registers = self.registers.max(to + 1);
            lines.push(LineDocument { to, op: op.to_owned(), args });
        }
        match registers.get(&value) {
            Some(0) => {}
            Some(register) => lines.push(copy(OperandDocument::Place(format!("r{register}")))),
            None => match values.node(value) {
                Constant(bits) if f64::from_bits(bits) == 0.0 => {}
                Constant(bits) => lines.push(copy(OperandDocument::Constant(f64::from_bits(bits)))),
                Input(input) => lines.push(copy(OperandDocument::Place(graph.input_name(input)))),
                Operation(..) | Upper(..) => {}
            },
        }
        lines
    }
}

fn copy(operand: OperandDocument) -> LineDocument {
    LineDocument { to: 0, op: "copy".to_owned(), args: vec![operand] }
}
