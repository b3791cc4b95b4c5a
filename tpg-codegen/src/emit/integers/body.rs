//! The body of a decision: teams, leaves and the ways between them, which a language only spells.

use super::comment::Comments;
use super::lines::Lines;
use super::spelling::{Called, IntegerSpelling};
use crate::emit::names;
use crate::integers::{Integers, Whole};
use crate::ir::{Module, Node, NodeId, Target, reached, topological};
use Target::*;
use std::collections::BTreeSet;
use std::fmt::Write as _;
use tpg_graph::ActionId;
use tpg_runtime::ops::Instruction;

/// The body's text, and the functions that it calls.
pub(super) fn body<'a>(
    module: &'a Module<'a>,
    integers: &'a Integers,
    spelling: &'a IntegerSpelling<'a>,
) -> (String, Called) {
    let teams = topological(&module.teams);
    let leaf = module.only_leaf();
    let several = leaf.is_none() && (teams.len() > 1 || !module.leaves.is_empty());
    let lines = Lines::new(module, integers, spelling);
    let mut body =
        IntegerBody { module, integers, spelling, lines, several, depth: spelling.either(1, 2), text: String::new() };
    match leaf {
        Some(leaf) => body.leaf(&leaf.values),
        None if several => body.vertices(&teams),
        None => body.team(teams[0]),
    }
    (body.text, body.lines.called())
}

struct IntegerBody<'a> {
    module: &'a Module<'a>,
    integers: &'a Integers,
    spelling: &'a IntegerSpelling<'a>,
    lines: Lines<'a>,
    /// There is more than one vertex.
    several: bool,
    /// Levels by which lines are indented.
    depth: usize,
    text: String,
}

impl IntegerBody<'_> {
    fn line(&mut self, text: &str) {
        for line in text.lines() {
            let _ = writeln!(self.text, "{:1$}{line}", "", self.depth * 4);
        }
    }

    fn vertices(&mut self, teams: &[usize]) {
        let module = self.module;
        let leaves = reached(&module.leaves).map(|(number, _)| Action(ActionId(number as u16)));
        let all: Vec<Target> = teams.iter().map(|&team| Team(team)).chain(leaves).collect();
        // Rust numbers vertices as the module does: teams from 0, the root, then leaves.
        self.line(self.spelling.either("", "let mut vertex = 0_u32;\nloop {\n    match vertex {"));
        let depth = self.spelling.either(1, 4);
        for (place, &vertex) in all.iter().enumerate() {
            let head = self.spelling.head(&self.vertex(vertex), place == 0, place + 1 == all.len());
            self.text.push_str(&head);
            self.depth = depth + 1;
            match vertex {
                Team(team) => self.team(team),
                Action(leaf) => self.leaf(&module.leaves[usize::from(leaf.0)].values),
            }
            self.depth = depth;
            self.line("}");
        }
        self.depth = 2;
        self.line(self.spelling.either("", "    }\n}"));
    }

    /// The action that a destination is, unless it is a vertex.
    fn action(&self, to: Target) -> Option<ActionId> {
        match to {
            Action(action) if self.module.leaves.is_empty() => Some(action),
            _ => None,
        }
    }

    /// The label of a vertex in variables.
    fn label(&self, to: Target) -> String {
        match to {
            Team(team) => format!("team_{}", self.module.teams[team].label),
            Action(leaf) => format!("leaf_{}", self.module.leaves[usize::from(leaf.0)].label),
        }
    }

    fn vertex(&self, to: Target) -> String {
        self.spelling.either(self.label(to), self.module.vertex(to).to_string())
    }

    /// The statement that goes to a destination.
    fn go(&self, to: Target) -> String {
        let spelling = self.spelling;
        match self.action(to) {
            Some(action) => spelling.answer(&spelling.action(action), self.several),
            None => spelling.go(&self.vertex(to)),
        }
    }

    fn team(&mut self, team: usize) {
        let module = self.module;
        let edges = &module.teams[team].edges;
        let mut ends: Vec<Target> = Vec::new();
        for edge in edges {
            if !ends.contains(&edge.to) {
                ends.push(edge.to);
            }
        }
        if let [end] = ends[..] {
            return self.line(&self.go(end));
        }
        let actions = ends.iter().filter(|&&end| self.action(end).is_some()).count();
        let is_action = actions == ends.len();
        let by_number = self.spelling.either(false, actions == 0);
        let bids: Vec<NodeId> = edges.iter().map(|edge| module.bidders[edge.bidder].value).collect();
        let said = |to: Target| match self.action(to) {
            Some(action) => self.spelling.said(action),
            None => self.label(to).replace('_', " "),
        };
        let said: Vec<_> = bids.iter().zip(edges).map(|(&bid, edge)| (bid, said(edge.to))).collect();
        let comments = Comments::for_bids(module, &self.integers.forms, &said);
        let wide = bids.iter().any(|&bid| self.lines.is_wide(bid));
        let mut open: BTreeSet<NodeId> = self.lines.choose(&bids).into_iter().collect();
        let names = names::actions(module.graph);
        let name = |to: Target| match self.action(to) {
            Some(action) => names[usize::from(action.0)].clone(),
            None => self.label(to),
        };
        let variables = bids.iter().zip(edges).map(|(&bid, edge)| (bid, format!("to_{}", name(edge.to)))).collect();
        self.lines.name(variables);
        let is_choice_of_two = is_action && bids.len() == 2;
        let (winner, declaration) = self.spelling.winner(is_action);
        for (place, (&bid, edge)) in bids.iter().zip(edges).enumerate() {
            for id in module.operations_of(bid) {
                if open.remove(&id) {
                    self.statement(id, &comments);
                }
            }
            if is_choice_of_two {
                continue;
            }
            let value = self.lines.operand(bid, wide);
            let spelling = self.spelling;
            let to = match self.action(edge.to) {
                Some(action) if is_action => spelling.action(action),
                _ if by_number => self.vertex(edge.to),
                _ => spelling.place(ends.iter().position(|&end| end == edge.to).unwrap_or(0)),
            };
            if place == 0 {
                let best = spelling.best(wide, bids.len() > 2);
                self.line(&format!("{best} = {value};\n{declaration} = {to};"));
                continue;
            }
            let when = spelling.when(&format!("{value} >= best"));
            let best = if place + 1 < bids.len() { format!("    best = {value};\n") } else { String::new() };
            self.line(&format!("{when}\n{best}    {winner} = {to};\n}}"));
        }
        let spelling = self.spelling;
        let last = if is_choice_of_two {
            let [one, other] = [0, 1].map(|place| self.lines.operand(bids[place], wide));
            let actions =
                [1, 0].map(|place| self.action(edges[place].to).map_or(String::new(), |to| spelling.action(to)));
            spelling.answer(&spelling.one_of_two(&format!("{other} >= {one}"), &actions), self.several)
        } else if is_action {
            spelling.answer(winner, self.several)
        } else if by_number {
            spelling.go(winner)
        } else {
            spelling.choice(&ends.iter().map(|&end| self.go(end)).collect::<Vec<_>>())
        };
        self.line(&last);
    }

    fn statement(&mut self, id: NodeId, comments: &Comments<'_>) {
        if let Some(said) = comments.text(id, self.integers.interval(id)) {
            self.line(&self.spelling.comment(&said, self.depth));
        }
        self.line(&self.lines.statement(id));
    }

    fn leaf(&mut self, values: &[NodeId]) {
        let module = self.module;
        let outputs = module.graph.outputs();
        let comments = Comments::for_outputs(module, &self.integers.forms, values);
        let named = self.lines.choose(values);
        let names = outputs.iter().zip(values).filter_map(|(output, &value)| {
            let name = self.spelling.variable(output)?;
            let inner = match module.node(value) {
                Node::Operation(Instruction::Quotient, [sum, _]) => Some((sum, format!("{name}_sum"))),
                _ => None,
            };
            Some(inner.into_iter().chain([(value, name)]))
        });
        self.lines.name(names.flatten().collect());
        for id in named {
            self.statement(id, &comments);
        }
        let limited = outputs.iter().zip(values).map(|(output, &value)| {
            let range = Whole { low: output.range.min as i64, high: output.range.max as i64 };
            self.lines.limited(value, range)
        });
        self.line(&self.spelling.outputs(&limited.collect::<Vec<_>>(), self.several));
    }
}
