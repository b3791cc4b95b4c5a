//! Teams of the profile `fast` in syntax that C and Rust share: the tests of bids, in order, and the ways to go.

use super::block::{Block, unused};
use super::syntax::Syntax;
use crate::ir::{Module, Successor};
use crate::passes::schedule::{Bid, LazyBid, Sparing, TeamSchedule};
use std::collections::{BTreeMap, BTreeSet};
use tpg_graph::ScalarType;

/// The minimum number of edges whose comparisons are worth functions.
const EDGES: usize = 32;

/// Tests for a graph whose bids are compared in functions: on a processor without doubles a comparison is a call, and with its
/// arguments and what follows from it, it takes most of the code of a team.
pub(crate) fn compares_in_functions(module: &Module<'_>) -> bool {
    module.graph.scalar() == ScalarType::F64 && module.leaves.is_empty() && module.edges() >= EDGES
}

/// A team; `J` is a language's jump to a destination.
pub(super) struct TeamView<J> {
    pub(super) label: u32,
    /// The type of its bids.
    pub(super) kind: &'static str,
    /// The variable that holds the winner: its destination, or its place.
    pub(super) winner: &'static str,
    /// Its value before a bid wins.
    pub(super) initial: String,
    /// The first bid, where it is a number: it leads without a test.
    pub(super) first: Option<BidView>,
    pub(super) eager: Vec<BidView>,
    pub(super) lazy: Vec<BidView>,
    pub(super) decision: TeamDecision<J>,
}

/// The end of a team's code.
pub(super) enum TeamDecision<J> {
    /// There is one way to go.
    Always(J),
    /// Of two bids the first wins under a condition: there is no variable for the winner.
    Either(String, J, J),
    /// The winner is the answer.
    Winner,
    /// The winners of each destination; the last is also taken if no bid wins.
    Ways(Vec<(Vec<String>, J)>),
}

/// A bid and the conditions for computing it.
#[derive(Default)]
pub(super) struct BidView {
    /// Computed before the conditions.
    pub(super) before: Vec<String>,
    /// The condition for evaluating even the bound.
    pub(super) considered: Option<String>,
    pub(super) bound: Vec<String>,
    /// The condition for computing the bid.
    pub(super) guard: Option<String>,
    pub(super) statements: Vec<String>,
    pub(super) value: String,
    pub(super) rank: String,
    /// The condition under which it becomes the leader.
    pub(super) wins: String,
    /// An equal bid wins.
    pub(super) ascending: bool,
    /// The last bid of its team: the best bid is not read after it.
    pub(super) last: bool,
}

/// The destinations of teams, and a language's jump to one.
pub(super) struct Destinations<'a, J> {
    pub(super) module: &'a Module<'a>,
    /// The names of the actions.
    pub(super) names: Vec<String>,
    /// The answers that they are.
    pub(super) answers: Vec<String>,
    /// The jump to a label, or out of the function with an answer.
    pub(super) jump: &'a dyn Fn(Successor, Result<String, String>) -> J,
}

impl<J> Destinations<'_, J> {
    pub(super) fn jump(&self, to: Successor) -> J {
        (self.jump)(to, self.answer(to).map_or_else(|| Ok(self.label(to)), Err))
    }

    /// The label of a team or leaf.
    pub(super) fn label(&self, to: Successor) -> String {
        match to {
            Successor::Team(team) => format!("team_{}", self.module.teams[team].label),
            Successor::Action(leaf) => format!("leaf_{}", self.module.leaves[usize::from(leaf.0)].label),
        }
    }

    /// The answer that a destination is, if nothing remains to be done there.
    pub(super) fn answer(&self, to: Successor) -> Option<String> {
        match to {
            Successor::Action(action) if self.module.leaves.is_empty() => {
                Some(self.answers[usize::from(action.0)].clone())
            }
            Successor::Team(_) | Successor::Action(_) => None,
        }
    }

    /// The name of a bid for it.
    pub(super) fn bid(&self, to: Successor) -> String {
        match to {
            Successor::Action(action) if self.module.leaves.is_empty() => self.names[usize::from(action.0)].clone(),
            Successor::Team(_) | Successor::Action(_) => format!("to_{}", self.label(to)),
        }
    }
}

/// Views a team.
pub(super) fn view<J>(syntax: &impl Syntax, plan: &TeamSchedule, to: &Destinations<'_, J>) -> TeamView<J> {
    let targets = plan.destinations();
    let ascending = plan.is_ascending();
    let answers: Option<Vec<String>> = targets.iter().map(|&target| to.answer(target)).collect();
    let answers = answers.filter(|_| ascending && !syntax.leads());
    let ranks = match &answers {
        Some(answers) => answers.clone(),
        None => (1..=targets.len()).map(|number| syntax.index(number)).collect(),
    };
    let is_direct = answers.is_some();
    let chooses_of_two = plan.eager.len() == 2 && plan.targets.len() == 2 && !syntax.leads();
    // Only a number that another bid is compared with later is hidden.
    let hides_zeros = !chooses_of_two && syntax.hides_zeros();
    let mut team =
        TeamBuilder { syntax, plan, targets: &targets, ranks, ascending, hides_zeros, block: block(syntax, plan, to) };
    let (mut eager, mut lazy, mut first) = (Vec::new(), Vec::new(), None);
    // With one way to go, no bid matters.
    if targets.len() > 1 {
        eager.extend(plan.eager.iter().map(|bid| team.eager(bid)));
        first = plan.leads_at_first(syntax.nodes()).then(|| eager.remove(0));
        lazy.extend(plan.lazy.iter().map(|lazy| team.lazy(lazy)));
    }
    if let Some(bid) = lazy.last_mut().or(eager.last_mut()) {
        bid.last = true;
    }
    let bids = [plan.targets.first(), plan.targets.last()].map(|to| to.copied().unwrap_or(targets[0]));
    let decision = match (&first, &eager[..]) {
        _ if targets.len() == 1 => TeamDecision::Always(to.jump(targets[0])),
        _ if !chooses_of_two => match is_direct {
            true => TeamDecision::Winner,
            false => TeamDecision::Ways(team.ways(to)),
        },
        (Some(first), [second]) => {
            TeamDecision::Either(format!("{} >= {}", second.value, first.value), to.jump(bids[1]), to.jump(bids[0]))
        }
        (None, [first, second]) => {
            let (value, other) = (&first.value, &second.value);
            let wins = format!("({value} >= {}) && !({other} >= {value})", syntax.lowest());
            TeamDecision::Either(wins, to.jump(bids[0]), to.jump(bids[1]))
        }
        _ => TeamDecision::Ways(team.ways(to)),
    };
    TeamView {
        label: plan.label,
        kind: syntax.scalar(),
        winner: match is_direct {
            _ if syntax.leads() => "lead.winner",
            true => "action",
            false if ascending => "next",
            false => "edge",
        },
        initial: if ascending { team.rank_of(targets.len() - 1) } else { syntax.index(0) },
        first,
        eager,
        lazy,
        decision,
    }
}

/// The block of a team's bids, each called after its destination.
fn block<'a, S: Syntax, J>(syntax: &'a S, plan: &TeamSchedule, to: &Destinations<'_, J>) -> Block<'a, S> {
    let mut taken = BTreeSet::new();
    let mut names = BTreeMap::new();
    for (place, &target) in plan.targets.iter().enumerate() {
        names.insert(place, unused(to.bid(target), &mut taken));
    }
    let mut reads = Vec::new();
    for bid in &plan.eager {
        reads.push((bid.value, names.get(&bid.place).cloned()));
    }
    for LazyBid { bid, sparing, bound } in &plan.lazy {
        let name = &names[&bid.place];
        reads.extend(sparing.map(|sparing| (sparing.argument, Some(unused(format!("{name}_argument"), &mut taken)))));
        reads.extend(bound.map(|bound| (bound, Some(unused(format!("{name}_bound"), &mut taken)))));
        reads.push((bid.value, Some(name.clone())));
    }
    let reads = if plan.destinations().len() > 1 { reads } else { Vec::new() };
    Block::new(syntax, reads)
}

struct TeamBuilder<'a, S> {
    syntax: &'a S,
    plan: &'a TeamSchedule,
    /// The distinct destinations of the edges; the last is the last edge's.
    targets: &'a [Successor],
    /// The value of the winner's variable for each of them, where bids are evaluated in ascending order.
    ranks: Vec<String>,
    /// All bids are evaluated in ascending order: the winner's destination identifies it well enough.
    ascending: bool,
    hides_zeros: bool,
    block: Block<'a, S>,
}

impl<S: Syntax> TeamBuilder<'_, S> {
    fn rank_of(&self, destination: usize) -> String {
        self.ranks[destination].clone()
    }

    fn rank(&self, bid: &Bid) -> String {
        if !self.ascending {
            return self.syntax.index(bid.place + 1);
        }
        let target = self.plan.targets[bid.place];
        self.rank_of(self.targets.iter().position(|&other| other == target).unwrap_or_default())
    }

    fn ways<J>(&self, to: &Destinations<'_, J>) -> Vec<(Vec<String>, J)> {
        let ranks = |(number, &target): (usize, &Successor)| match self.ascending {
            true => vec![self.rank_of(number)],
            false => {
                let leads = self.plan.targets.iter().enumerate().filter(|&(_, &to)| to == target);
                let no_winner = (number + 1 == self.targets.len() && !self.plan.leads_at_first(self.syntax.nodes()))
                    .then(|| self.syntax.index(0));
                no_winner.into_iter().chain(leads.map(|(place, _)| self.syntax.index(place + 1))).collect()
            }
        };
        self.targets.iter().enumerate().map(|way| (ranks(way), to.jump(*way.1))).collect()
    }

    fn eager(&mut self, bid: &Bid) -> BidView {
        let mut statements = self.block.statements(bid.value);
        let mut value = self.block.value(bid.value);
        let is_zero = self.syntax.nodes()[bid.value.index()].as_constant() == Some(0.0);
        let is_last = self.plan.lazy.is_empty() && self.plan.eager.last() == Some(bid);
        if is_zero && self.hides_zeros && !is_last {
            statements.extend(self.syntax.hidden_zero(&value));
            value = "zero".to_owned();
        }
        let wins = format!("{value} >= best");
        BidView { statements, value, rank: self.rank(bid), wins, ascending: true, ..BidView::default() }
    }

    fn lazy(&mut self, LazyBid { bid, sparing, bound }: &LazyBid) -> BidView {
        let rank = self.rank(bid);
        let before = sparing.map_or_else(Vec::new, |sparing| self.block.statements(sparing.argument));
        let considered =
            sparing.map(|sparing| format!("!({})", low(self.syntax, sparing, &self.block.value(sparing.argument))));
        let outside = considered.is_some().then(|| self.block.known.clone());
        let bound_statements = bound.map_or_else(Vec::new, |bound| self.block.statements(bound));
        // Also true where the bound is NaN and says nothing.
        let can_win = |bound: String| match bid.ascending {
            _ if self.syntax.leads() => self.syntax.can_win(&bound, (!bid.ascending).then_some(&*rank)),
            true => format!("!(best > {bound})"),
            false => format!("!((best > {bound}) || ((best >= {bound}) && (edge >= {rank})))"),
        };
        let guard = match bound {
            Some(bound) => Some(can_win(self.block.value(*bound))),
            // Nothing is higher than infinity; in ascending order, an equal bid wins.
            None if bid.ascending => None,
            None if self.syntax.leads() => Some(can_win(self.syntax.literal(f64::INFINITY))),
            None => Some(format!("(best < {}) || (edge < {rank})", self.syntax.literal(f64::INFINITY))),
        };
        let stays = guard.is_none() && !S::BRACES;
        let before_bid = self.block.known.clone();
        let statements = self.block.statements(bid.value);
        self.block.known = match outside {
            Some(outside) => outside,
            None if stays => std::mem::take(&mut self.block.known),
            None => before_bid,
        };
        let value = self.block.value(bid.value);
        let wins = match bid.ascending {
            true => format!("{value} >= best"),
            false => format!("({value} >= best) && (({value} > best) || (edge < {rank}))"),
        };
        BidView {
            before,
            considered,
            bound: bound_statements,
            guard,
            statements,
            value,
            rank,
            wins,
            ascending: bid.ascending,
            last: false,
        }
    }
}

/// The condition under which an argument is low and the best bid is not.
pub(super) fn low(syntax: &impl Syntax, Sparing { at_most, below, .. }: Sparing, argument: &str) -> String {
    let [at_most, below] = [at_most, below].map(|number| syntax.literal(number));
    let best = if syntax.leads() { "lead.best" } else { "best" };
    format!("({argument} <= {at_most}) && ({best} >= {below})")
}
