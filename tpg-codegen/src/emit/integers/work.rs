//! Teams and leaves in integers, as the emitters of C and Rust show them.

use super::comment::Comments;
use super::lines::Lines;
use super::spelling::IntegerSpelling;
use crate::emit::block::unused;
use crate::emit::interface::OutputView;
use crate::emit::team::{BidView, Destinations, TeamDecision, TeamView};
use crate::integers::{Integers, Whole};
use crate::ir::{Module, Node, NodeId, Successor};
use crate::program::Program;
use std::collections::BTreeSet;
use tpg_graph::ActionId;
use tpg_runtime::ops::Instruction;

/// A program in integers, and the spelling of its language.
pub(in crate::emit) struct Work<'a> {
    pub(super) module: &'a Module<'a>,
    pub(super) integers: &'a Integers,
    pub(in crate::emit) spelling: IntegerSpelling<'a>,
}

impl<'a> Work<'a> {
    pub(in crate::emit) fn new(program: &'a Program<'_>, integers: &'a Integers) -> Self {
        Self { module: &program.module, integers, spelling: IntegerSpelling::new(program) }
    }

    /// Views a team: its first bid leads until another is as high.
    pub(in crate::emit) fn team<J>(&self, number: usize, to: &Destinations<'_, J>) -> TeamView<J> {
        let (module, team) = (self.module, &self.module.teams[number]);
        let mut targets: Vec<Successor> = Vec::new();
        for edge in &team.edges {
            if !targets.contains(&edge.to) {
                targets.push(edge.to);
            }
        }
        let answers: Option<Vec<String>> = targets.iter().map(|&target| to.answer(target)).collect();
        let is_direct = answers.is_some();
        let ranks = answers.unwrap_or_else(|| (0..targets.len()).map(|place| self.spelling.place(place)).collect());
        let bids: Vec<(NodeId, Successor)> =
            team.edges.iter().map(|edge| (module.bidders[edge.bidder].value, edge.to)).collect();
        let said: Vec<_> = bids.iter().map(|&(bid, target)| (bid, self.said(target, to))).collect();
        let comments = Comments::for_bids(module, &self.integers.forms, &said);
        let mut taken = BTreeSet::new();
        let names = bids.iter().map(|&(bid, target)| (bid, unused(to.bid(target), &mut taken))).collect();
        let roots: Vec<NodeId> = bids.iter().map(|&(bid, _)| bid).collect();
        let mut lines = Lines::new(self, &roots, names);
        let wide = roots.iter().any(|&bid| lines.is_wide(bid));
        let mut views = Vec::new();
        for &(bid, target) in bids.iter().filter(|_| targets.len() > 1) {
            let statements = lines.statements(bid, &comments);
            let value = lines.operand(bid, wide);
            let rank =
                targets.iter().position(|&other| other == target).map_or_else(String::new, |at| ranks[at].clone());
            let (wins, last) = (format!("{value} >= best"), views.len() + 1 == bids.len());
            views.push(BidView { statements, value, rank, wins, ascending: true, last, ..BidView::default() });
        }
        let decision = match (&views[..], &bids[..]) {
            ([], _) => TeamDecision::Always(to.jump(targets[0])),
            ([first, second], &[(_, one), (_, other)]) => {
                TeamDecision::Either(format!("{} >= {}", second.value, first.value), to.jump(other), to.jump(one))
            }
            _ if is_direct => TeamDecision::Winner,
            _ => TeamDecision::Ways(
                ranks.into_iter().map(|rank| vec![rank]).zip(targets.iter().map(|&it| to.jump(it))).collect(),
            ),
        };
        let mut eager = views.into_iter();
        TeamView {
            label: team.label,
            kind: self.spelling.integer(wide),
            winner: if is_direct { "action" } else { "next" },
            initial: String::new(),
            first: eager.next(),
            eager: eager.collect(),
            lazy: Vec::new(),
            decision,
        }
    }

    /// The name of a destination in comments.
    fn said<J>(&self, target: Successor, to: &Destinations<'_, J>) -> String {
        match target {
            Successor::Action(ActionId(action)) if self.module.leaves.is_empty() => {
                self.module.graph.actions()[usize::from(action)].name.clone()
            }
            _ => to.label(target).replace('_', " "),
        }
    }

    /// The statements that compute a leaf's values, and the values in their ranges.
    pub(in crate::emit) fn leaf(&self, values: &[NodeId], outputs: &[OutputView]) -> (Vec<String>, Vec<String>) {
        let module = self.module;
        let comments = Comments::for_outputs(module, &self.integers.forms, values);
        let names = outputs.iter().zip(values).flat_map(|(OutputView { variable, .. }, &value)| {
            let inner = match module.node(value) {
                Node::Operation(Instruction::Quotient, [sum, _]) => Some((sum, format!("{variable}_sum"))),
                _ => None,
            };
            inner.into_iter().chain([(value, variable.clone())])
        });
        let mut lines = Lines::new(self, values, names.collect());
        let statements = values.iter().flat_map(|&value| lines.statements(value, &comments)).collect();
        let limited = module.graph.outputs().iter().zip(values).map(|(output, &value)| {
            let range = Whole { low: output.range.min as i64, high: output.range.max as i64 };
            self.spelling.answered(output, &lines.limited(value, range))
        });
        (statements, limited.collect())
    }
}
