//! Available expressions over the graph of teams: values that are computed on every path to a team.
//!
//! A team computes some values unconditionally: its eager bids, the guards of others, and bounds outside every condition.
//! A decision reads one state, so these values stay valid in the team's successors. A value is available on entry to a team if
//! in every predecessor it is available on entry or computed unconditionally. Nothing is available at the root. Teams are
//! visited in topological order, so one pass suffices.

use super::schedule::{LazyBid, Schedule, TeamSchedule, cost};
use crate::ir::{Node, NodeId, Target, needed};
use std::collections::BTreeSet;

/// The least cost of a value worth keeping, in additions, as [`cost`] counts: that of an estimated exponential or logarithm.
/// GCC finds many of the shared cheap values by itself; keeping the others cost as much as it gained.
const WORTH_KEEPING: u32 = 6;

/// The values available on entry to teams, and those that the teams reuse.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Available {
    order: Vec<usize>,
    together: usize,
    entry: Vec<BTreeSet<NodeId>>,
    read: Vec<BTreeSet<NodeId>>,
    entries: Vec<bool>,
    saved: usize,
}

impl Available {
    /// Analyses teams in topological order, `together` of them in each function: values of another function are not available.
    pub fn analyse(schedule: &Schedule, order: Vec<usize>, together: usize) -> Self {
        let Schedule { nodes, plans, .. } = schedule;
        let mut function = vec![0; order.len()];
        for (number, teams) in order.chunks(together).enumerate() {
            teams.iter().for_each(|&team| function[team] = number);
        }
        let mut entry: Vec<Option<BTreeSet<NodeId>>> = vec![None; order.len()];
        entry[0] = Some(BTreeSet::new());
        let mut entries = vec![false; order.len()];
        entries[0] = true;
        for &team in &order {
            let mut on_exit = entry[team].clone().unwrap_or_default();
            on_exit.extend(unconditional(nodes, &plans[team]));
            for target in plans[team].destinations() {
                match target {
                    Target::Team(to) if function[to] == function[team] => match &mut entry[to] {
                        Some(known) => known.retain(|id| on_exit.contains(id)),
                        unknown => *unknown = Some(on_exit.clone()),
                    },
                    Target::Team(to) => {
                        entry[to] = Some(BTreeSet::new());
                        entries[to] = true;
                    }
                    Target::Action(_) => {}
                }
            }
        }
        let mut entry: Vec<BTreeSet<NodeId>> = entry.into_iter().map(Option::unwrap_or_default).collect();
        let worth: Vec<bool> = (0..).map(NodeId).take(nodes.len()).map(|id| is_worth_keeping(nodes, id)).collect();
        entry.iter_mut().for_each(|values| values.retain(|id| worth[id.index()]));
        let read = plans.iter().zip(&entry).map(|(plan, entry)| read(nodes, plan, entry)).collect();
        let reused =
            |(plan, entry): (&TeamSchedule, &BTreeSet<NodeId>)| possible(nodes, plan).intersection(entry).count();
        let saved = plans.iter().zip(&entry).map(reused).sum();
        Self { order, together, entry, read, entries, saved }
    }

    /// The teams in topological order.
    pub fn order(&self) -> &[usize] {
        &self.order
    }

    /// The teams of each function, in this order.
    pub fn functions(&self) -> impl Iterator<Item = &[usize]> {
        self.order.chunks(self.together)
    }

    /// Values available on entry to a team.
    pub fn on_entry(&self, team: usize) -> &BTreeSet<NodeId> {
        &self.entry[team]
    }

    /// Available values that the team reuses.
    pub fn read(&self, team: usize) -> &BTreeSet<NodeId> {
        &self.read[team]
    }

    /// Tests whether another function leads to a team.
    pub fn is_entry(&self, team: usize) -> bool {
        self.entries[team]
    }

    /// The number of operations that teams reuse instead of computing them, in total.
    pub fn saved(&self) -> usize {
        self.saved
    }
}

/// Tests whether a value is more expensive than a live variable, which takes a register, or stack across calls.
fn is_worth_keeping(nodes: &[Node], id: NodeId) -> bool {
    let mut total = 0;
    for id in needed(nodes, id, |_| true) {
        total += match nodes[id.index()] {
            Node::Operation(instruction, _) => cost(instruction),
            Node::Upper(..) => WORTH_KEEPING,
            Node::Constant(_) | Node::Input(_) => 0,
        };
    }
    total >= WORTH_KEEPING
}

/// The values that a team computes unconditionally, with their operands.
pub fn unconditional(nodes: &[Node], plan: &TeamSchedule) -> BTreeSet<NodeId> {
    let outside = |lazy: &LazyBid| lazy.sparing.is_none() && !lazy.before_infinite;
    let bounds =
        plan.lazy.iter().filter(|lazy| outside(lazy)).flat_map(|lazy| lazy.bound.into_iter().chain(lazy.certain));
    let sparing = plan.lazy.iter().filter_map(|lazy| lazy.sparing).map(|sparing| sparing.argument);
    let infinite = plan.infinite.iter().map(|infinite| infinite.argument);
    let eager = plan.eager.iter().map(|bid| bid.value);
    if has_choice(plan) {
        operations(nodes, infinite.chain(eager).chain(sparing).chain(bounds))
    } else {
        BTreeSet::new()
    }
}

/// The values that a team may compute.
fn possible(nodes: &[Node], plan: &TeamSchedule) -> BTreeSet<NodeId> {
    operations(nodes, values(plan))
}

/// The available values that a team reads: directly, or as operands of operations that it computes.
fn read(nodes: &[Node], plan: &TeamSchedule, available: &BTreeSet<NodeId>) -> BTreeSet<NodeId> {
    let missing = |value| needed(nodes, value, |id| !available.contains(&id));
    let operands = |id: NodeId| nodes[id.index()].operands().iter().copied();
    let asked = values(plan).flat_map(|value| missing(value).into_iter().flat_map(operands).chain([value]));
    asked.filter(|id| available.contains(id)).collect()
}

/// Every value that a team's code mentions. Bids that can win without being computed have functions of their own.
fn values(plan: &TeamSchedule) -> impl Iterator<Item = NodeId> {
    let infinite = plan.infinite.iter().map(|infinite| infinite.argument);
    let always = plan.eager.iter().chain(&plan.eager_before).map(|bid| bid.value);
    let lazy = plan.lazy.iter().flat_map(|LazyBid { bid, sparing, bound, certain, .. }| {
        let ends = sparing.map(|sparing| sparing.argument).into_iter().chain(*bound);
        ends.chain([certain.unwrap_or(bid.value)])
    });
    infinite.chain(always).chain(lazy).filter(|_| has_choice(plan))
}

/// With one way to go, no bid matters.
fn has_choice(plan: &TeamSchedule) -> bool {
    plan.destinations().len() > 1
}

fn operations(nodes: &[Node], values: impl Iterator<Item = NodeId>) -> BTreeSet<NodeId> {
    values.flat_map(|value| needed(nodes, value, |_| true)).collect()
}

#[cfg(test)]
mod tests {
    use super::{Available, is_worth_keeping, unconditional};
    use crate::ir::{Node, NodeId, Target, topological};
    use crate::passes::interval::Assumption;
    use crate::passes::optimise;
    use crate::passes::schedule::{Bid, LazyBid, Schedule, Sparing, TeamSchedule, schedule};
    use std::collections::BTreeSet;
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{ActionId, Input};
    use tpg_runtime::ops::Instruction;

    const NONE: TeamSchedule = TeamSchedule {
        label: 0,
        infinite: None,
        eager: Vec::new(),
        eager_before: Vec::new(),
        lazy: Vec::new(),
        targets: Vec::new(),
    };

    fn bid(place: usize, value: u32) -> Bid {
        Bid { place, value: NodeId(value), ascending: true }
    }

    fn ids<const N: usize>(ids: [u32; N]) -> BTreeSet<NodeId> {
        ids.map(NodeId).into()
    }

    /// Two inputs, an estimate, its sine, the sine's bound, and the estimate's double.
    fn nodes() -> Vec<Node> {
        let operation = |instruction, a, b| Node::Operation(instruction, [NodeId(a), NodeId(b)]);
        vec![
            Node::Input(Input(0)),
            Node::Input(Input(1)),
            Node::Upper(Instruction::Exp, NodeId(0)),
            operation(Instruction::Sin, 2, 2),
            operation(Instruction::Abs, 2, 2),
            operation(Instruction::Add, 2, 2),
        ]
    }

    /// The root leads to both others, the second also to the third. The estimate is computed in the root, the sine perhaps; the
    /// double in the second only.
    fn two_ways(spared: bool) -> Schedule {
        let sparing = spared.then_some(Sparing { argument: NodeId(2), at_most: 1.0, below: 1.0 });
        let bound = Some(NodeId(4));
        let lazy = LazyBid { bid: bid(1, 3), sparing, before_infinite: false, bound, certain: None };
        let [second, third, action] = [Target::Team(1), Target::Team(2), Target::Action(ActionId(0))];
        let root = TeamSchedule { eager: vec![bid(0, 0)], lazy: vec![lazy], targets: vec![second, third], ..NONE };
        let middle = TeamSchedule { eager: vec![bid(0, 5), bid(1, 0)], targets: vec![third, action], ..NONE };
        let last = TeamSchedule {
            eager: vec![bid(0, 4), bid(1, 5)],
            targets: vec![action, Target::Action(ActionId(1))],
            ..NONE
        };
        Schedule { nodes: nodes(), plans: vec![root, middle, last], leaves: Vec::new() }
    }

    #[test]
    fn there_is_what_both_ways_compute() {
        let available = Available::analyse(&two_ways(false), vec![0, 1, 2], 3);
        assert_eq!(available.on_entry(0), &ids([]));
        assert_eq!(available.on_entry(1), &ids([2, 4]), "the bound is outside of its condition, the sine is not");
        assert_eq!(available.on_entry(2), &ids([2, 4]), "the double is not there on the short way");
        assert_eq!(available.read(1), &ids([2]));
        assert_eq!(available.read(2), &ids([2, 4]));
        assert_eq!(available.saved(), 1 + 2);
    }

    #[test]
    fn what_may_be_spared_is_not_there() {
        let available = Available::analyse(&two_ways(true), vec![0, 1, 2], 3);
        assert_eq!(available.on_entry(1), &ids([2]), "the bound is inside of a condition now");
    }

    #[test]
    fn nothing_comes_from_another_function() {
        let available = Available::analyse(&two_ways(false), vec![0, 1, 2], 2);
        assert_eq!(available.on_entry(1), &ids([2, 4]));
        assert_eq!(available.on_entry(2), &ids([]));
        assert_eq!(available.saved(), 1);
    }

    #[test]
    fn a_team_with_one_way_to_go_computes_nothing() {
        let mut schedule = two_ways(false);
        schedule.plans[0].targets = vec![Target::Team(1); 2];
        let available = Available::analyse(&schedule, vec![0, 1, 2], 3);
        assert_eq!(available.on_entry(1), &ids([]));
    }

    /// Walks every way from the root; `None` where there are too many.
    fn met_over_all_ways(schedule: &Schedule, function: impl Fn(usize) -> usize) -> Option<Vec<BTreeSet<NodeId>>> {
        let mut met: Vec<Option<BTreeSet<NodeId>>> = vec![None; schedule.plans.len()];
        let mut open = vec![(0, BTreeSet::new())];
        let mut steps = 0;
        while let Some((team, mut there)) = open.pop() {
            steps += 1;
            if steps > 20_000 {
                return None;
            }
            match &mut met[team] {
                Some(met) => met.retain(|id| there.contains(id)),
                unknown => *unknown = Some(there.clone()),
            }
            there.extend(unconditional(&schedule.nodes, &schedule.plans[team]));
            for target in schedule.plans[team].destinations() {
                let Target::Team(to) = target else { continue };
                open.push((to, if function(to) == function(team) { there.clone() } else { BTreeSet::new() }));
            }
        }
        let kept = |id: &NodeId| is_worth_keeping(&schedule.nodes, *id);
        let met = met.into_iter().map(|met| met.expect("every team can be reached"));
        Some(met.map(|met| met.into_iter().filter(kept).collect()).collect())
    }

    #[test]
    fn there_is_what_every_way_of_random_graphs_computes() {
        let (mut graphs, mut saved) = (0, 0);
        for seed in 0..300 {
            let shape = Shape { teams: 2 + seed as usize % 12, ..Shape::random(seed) };
            let graph = sample::graph(&shape, seed);
            let module = optimise(&graph, Assumption::Nothing).0;
            let schedule = schedule(&module, &[]);
            let order = topological(&module.teams);
            let together = if seed % 3 == 0 { 3 } else { order.len() };
            let place = |team| order.iter().position(|&other| other == team).expect("it has a place");
            let Some(met) = met_over_all_ways(&schedule, |team| place(team) / together) else { continue };
            let available = Available::analyse(&schedule, order, together);
            for (team, met) in met.iter().enumerate() {
                assert_eq!(available.on_entry(team), met, "graph {seed}, team {team}");
            }
            graphs += 1;
            saved += available.saved();
        }
        assert!(graphs > 200 && saved > 0, "{graphs} graphs, {saved} operations saved");
    }
}
