//! The values of a block of code: those read once are written where they are read, the others get a name.

use super::syntax::Syntax;
use crate::infix::{Infix, Level::Sum};
use crate::ir::{Node, NodeId, needed};
use Node::*;
use Origin::*;
use std::collections::{BTreeMap, BTreeSet};
use tpg_graph::{Input, MathsProvider};
use tpg_runtime::ops::Instruction::*;

/// The longest sum that is written where it is read, in characters: it takes lines of its own.
const LONGEST_SUM: usize = 190;
/// The longest operand of a sum, and of a product: rustfmt leaves them on one line.
const LONGEST_TERM: usize = 80;
const LONGEST_FACTOR: usize = 60;
/// The longest arguments of a call.
pub(super) const LONGEST_ARGUMENTS: usize = 48;

/// The inputs that a value is made of.
#[derive(Clone, Copy, PartialEq)]
enum Origin {
    Nothing,
    One(Input),
    Several,
}

impl Origin {
    fn and(self, other: Self) -> Self {
        match (self, other) {
            (Self::Nothing, origin) | (origin, Self::Nothing) => origin,
            (a, b) if a == b => a,
            _ => Self::Several,
        }
    }
}

/// The values that a block reads.
pub(super) struct Block<'a, S> {
    syntax: &'a S,
    /// The operations that are written where they are read.
    inline: BTreeMap<NodeId, Infix>,
    /// The names of the others, and the expressions that compute them.
    named: BTreeMap<NodeId, (String, String)>,
    /// Named operations in scope.
    pub(super) known: BTreeSet<NodeId>,
    /// The inputs of the operations.
    made_of: BTreeMap<NodeId, Origin>,
    /// Names in use.
    taken: BTreeSet<String>,
}

impl<'a, S: Syntax> Block<'a, S> {
    /// Plans a block that reads values, each as often as it is given; one with a name gets a statement where it is an operation.
    pub(super) fn new(syntax: &'a S, reads: impl IntoIterator<Item = (NodeId, Option<String>)>) -> Self {
        let nodes = syntax.nodes();
        let mut uses: BTreeMap<NodeId, usize> = BTreeMap::new();
        let mut wanted: BTreeMap<NodeId, String> = BTreeMap::new();
        let mut operations = BTreeSet::new();
        for (value, name) in reads {
            *uses.entry(value).or_default() += 1;
            operations.extend(needed(nodes, value, |id| !operations.contains(&id)));
            if let Some(name) = name {
                wanted.entry(value).or_insert(name);
            }
        }
        for operand in operations.iter().flat_map(|id| nodes[id.index()].operands()) {
            *uses.entry(*operand).or_default() += 1;
        }
        let mut block = Self {
            syntax,
            inline: BTreeMap::new(),
            named: BTreeMap::new(),
            known: BTreeSet::new(),
            made_of: BTreeMap::new(),
            taken: wanted.values().cloned().collect(),
        };
        for id in operations {
            let origin = nodes[id.index()].operands().iter().fold(Nothing, |origin, operand| {
                origin.and(match nodes[operand.index()] {
                    Node::Input(input) => One(input),
                    Constant(_) => Nothing,
                    Operation(..) | Upper(..) => block.made_of[operand],
                })
            });
            block.made_of.insert(id, origin);
            let expression = block.operation(id);
            if let Some(name) = wanted.remove(&id) {
                block.named.insert(id, (name, expression.text));
            } else {
                let is_long = expression.text.len() > LONGEST_SUM;
                block.inline.insert(id, expression);
                if uses[&id] > 1 || is_long {
                    block.name(id);
                }
            }
        }
        block
    }

    /// Gives an operation a name: after its input, if it has only one.
    fn name(&mut self, id: NodeId) {
        let Some(expression) = self.inline.remove(&id) else { return };
        let base = match self.made_of[&id] {
            One(input) => match self.syntax.graph().source_of(input) {
                (source, _) if source.ranges.len() == 1 => format!("{}_term", source.name),
                (source, place) => format!("{}_{place}_term", source.name),
            },
            Nothing | Several => "term".to_owned(),
        };
        self.named.insert(id, (unused(base, &mut self.taken), expression.text));
    }

    /// Statements for the named operations that a value needs and that are not in scope yet.
    pub(super) fn statements(&mut self, value: NodeId) -> Vec<String> {
        let missing = needed(self.syntax.nodes(), value, |id| !self.known.contains(&id));
        let mut statements = Vec::new();
        for id in missing {
            if let Some((name, expression)) = self.named.get(&id) {
                statements.push(self.syntax.declaration(name, expression));
                self.known.insert(id);
            }
        }
        statements
    }

    /// A value: a number, an input, a name or an expression.
    pub(super) fn value(&self, id: NodeId) -> String {
        self.operand(id).text
    }

    /// A value as an argument of a call, with the statements for it: a long expression gets a name.
    pub(super) fn argument(&mut self, id: NodeId, name: impl FnOnce() -> String) -> (Vec<String>, String) {
        let mut statements = self.statements(id);
        let mut value = self.value(id);
        if value.len() > LONGEST_ARGUMENTS {
            let name = unused(name(), &mut self.taken);
            statements.push(self.syntax.declaration(&name, &value));
            value = name;
        }
        (statements, value)
    }

    fn operand(&self, id: NodeId) -> Infix {
        match self.syntax.nodes()[id.index()] {
            Constant(bits) => Infix { is_number: true, ..Infix::atom(self.syntax.literal(f64::from_bits(bits))) },
            Node::Input(input) => Infix::atom(self.syntax.input(input)),
            Operation(..) | Upper(..) => match self.named.get(&id) {
                Some((name, _)) => Infix::atom(name.clone()),
                None => self.inline[&id].clone(),
            },
        }
    }

    /// An operand, which gets a name if it is longer than the limit.
    fn within(&mut self, id: NodeId, limit: usize) -> Infix {
        if self.inline.get(&id).is_some_and(|expression| expression.text.len() > limit) {
            self.name(id);
        }
        self.operand(id)
    }

    /// The expression that computes an operation.
    fn operation(&mut self, id: NodeId) -> Infix {
        let node = self.syntax.nodes()[id.index()];
        match node {
            Operation(instruction @ (Add | Sub), [a, b]) => {
                // A sum begins with the only operand that is one; another is in parentheses.
                let is_sum = |id| self.operand(id).level == Sum;
                let left = if instruction == Add && is_sum(b) && !is_sum(a) { b } else { a };
                let mut limited = |id| {
                    let limit = if id == left && self.operand(id).level == Sum { LONGEST_SUM } else { LONGEST_TERM };
                    self.within(id, limit)
                };
                let (a, b) = (limited(a), limited(b));
                if instruction == Add { a.plus(&b) } else { a.minus(&b) }
            }
            Operation(instruction @ (Mul | Div), [a, b]) => {
                let (a, b) = (self.within(a, LONGEST_FACTOR), self.within(b, LONGEST_FACTOR));
                if instruction == Mul { a.times(&b) } else { a.over(&b) }
            }
            Operation(instruction, _) => {
                let total: usize = node.operands().iter().map(|&id| self.value(id).len() + 2).sum();
                let limit = if total > LONGEST_ARGUMENTS { LONGEST_ARGUMENTS / 3 } else { LONGEST_ARGUMENTS };
                let arguments: Vec<String> =
                    node.operands().iter().map(|&id| self.call_argument(node, id, limit)).collect();
                Infix::atom(self.syntax.call(instruction, &arguments.join(", ")))
            }
            Upper(instruction, value) => {
                let value = self.within(value, LONGEST_ARGUMENTS).text;
                Infix::atom(self.syntax.upper(instruction, &value))
            }
            Constant(_) | Node::Input(_) => self.operand(id),
        }
    }

    /// An argument of a function. A compiler that knew a number would compute the platform's function of it itself, and round
    /// another way than the platform does.
    fn call_argument(&mut self, node: Node, id: NodeId, limit: usize) -> String {
        let operand = self.within(id, limit);
        let platforms = node.is_transcendental() && self.syntax.graph().maths() == MathsProvider::System;
        if operand.is_number && platforms { self.syntax.hidden(&operand.text) } else { operand.text }
    }
}

/// A name that is not taken, which it is then.
pub(crate) fn unused(base: String, taken: &mut BTreeSet<String>) -> String {
    let others = (2..).map(|number| format!("{base}_{number}"));
    let name = std::iter::once(base.clone()).chain(others).find(|name| !taken.contains(name)).unwrap_or(base);
    taken.insert(name.clone());
    name
}
