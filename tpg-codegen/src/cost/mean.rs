//! The mean cost of decisions: the program's steps, counted state by state.

use super::{Cost, Costs, Guard, Step, Work};
use crate::ir::Target;
use crate::passes::arithmetic::Arithmetic;
use crate::passes::evaluate::evaluate;
use crate::passes::schedule::Sparing;
use tpg_graph::in_arithmetic_of;
use tpg_graph::states::StateSet;
use tpg_runtime::ops::Maths;
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

impl Costs<'_> {
    /// The mean cost of a decision over a set of states, for each of several forms of a graph; 0 without states. Sampled
    /// states are drawn once, batch by batch.
    ///
    /// # Panics
    /// If the set is of another graph.
    pub(crate) fn means(forms: &[Self], set: &StateSet) -> Vec<Cost<f64>> {
        let mut totals = vec![Cost::<u64>::default(); forms.len()];
        set.each_batch(|states| {
            for (form, total) in forms.iter().zip(&mut totals) {
                let Cost { teams, bids, operations, maths_calls } = form.count(states).0;
                total.teams += teams;
                total.bids += bids;
                total.operations += operations;
                total.maths_calls += maths_calls;
            }
        });
        totals.into_iter().map(|total| divided(total, set.count())).collect()
    }

    /// The sum, and the action of every state: tests check by the actions that the right steps were counted.
    pub(super) fn count(&self, states: &[f64]) -> (Cost<u64>, Vec<ActionId>) {
        let graph = self.module.graph;
        assert_eq!(states.len() % graph.state_length(), 0, "whole states");
        in_arithmetic_of!(graph, self.count_in(states))
    }

    fn count_in<S: Scalar, M: Maths<S>>(&self, states: &[f64]) -> (Cost<u64>, Vec<ActionId>) {
        let graph = self.module.graph;
        let arithmetic = Arithmetic::new(graph);
        let lowest = -S::from_f64(arithmetic.greatest());
        let mut total = Cost::<u64>::default();
        let mut values = vec![S::ZERO; self.nodes.len()];
        let actions = (states.chunks_exact(graph.state_length()))
            .map(|state| {
                evaluate::<S, M>(graph.scalar(), self.nodes, state, &mut values);
                self.walk(&values, lowest, &mut total)
            })
            .collect();
        (total, actions)
    }

    fn walk<S: Scalar>(&self, values: &[S], lowest: S, total: &mut Cost<u64>) -> ActionId {
        add(total, self.once);
        if self.all_teams {
            total.bids += self.teams.iter().map(|steps| steps.len() as u64).sum::<u64>();
        }
        let mut team = 0;
        loop {
            total.teams += 1;
            let mut seen = Cost::default();
            let place = winner(&self.teams[team], values, lowest, &mut seen);
            if !self.all_teams {
                total.bids += seen.bids;
                total.operations += seen.operations;
                total.maths_calls += seen.maths_calls;
            }
            let edges = &self.module.teams[team].edges;
            match edges[place.unwrap_or(edges.len() - 1)].to {
                Target::Team(next) => team = next,
                Target::Action(action) => {
                    add(total, self.leaves.get(usize::from(action.0)).copied().unwrap_or_default());
                    return action;
                }
            }
        }
    }
}

fn divided(total: Cost<u64>, count: usize) -> Cost<f64> {
    let mean = |sum: u64| if count == 0 { 0.0 } else { sum as f64 / count as f64 };
    let Cost { teams, bids, operations, maths_calls } = total;
    Cost { teams: mean(teams), bids: mean(bids), operations: mean(operations), maths_calls: mean(maths_calls) }
}

/// The place of the winning bid; none where every bid is −∞ or NaN, for the code begins with the lowest finite number.
fn winner<S: Scalar>(steps: &[Step], values: &[S], lowest: S, seen: &mut Cost<u64>) -> Option<usize> {
    let (mut best, mut winner) = (lowest, None);
    for &Step { bid, sparing, guard, first, before, inside } in steps {
        add(seen, first);
        // The code compares places counted from 1: before a bid wins, the place is below every bid's.
        let comes_after = winner.is_none_or(|winner| winner < bid.place);
        let is_low = |Sparing { argument, at_most, below }: Sparing| {
            values[argument.index()] <= S::from_f64(at_most) && best >= S::from_f64(below)
        };
        if sparing.is_some_and(is_low) {
            continue;
        }
        add(seen, before);
        let spared = match guard {
            Guard::None => false,
            Guard::Bound(bound) => {
                let bound = values[bound.index()];
                best > bound || (!bid.ascending && best >= bound && !comes_after)
            }
            Guard::Above(bound) => best > values[bound.index()],
            Guard::Over(bound) => best > S::from_f64(bound),
            Guard::Place => best >= -S::NEG_INFINITY && !comes_after,
        };
        if spared {
            continue;
        }
        seen.bids += 1;
        add(seen, inside);
        let value = values[bid.value.index()];
        if value > best || (value >= best && (bid.ascending || comes_after)) {
            (best, winner) = (value, Some(bid.place));
        }
    }
    winner
}

fn add(total: &mut Cost<u64>, work: Work) {
    total.operations += work.operations;
    total.maths_calls += work.maths_calls;
}

#[cfg(test)]
mod tests {
    use super::super::{Cost, Costs};
    use super::divided;
    use crate::options::{Language, Options, Profile, Style};
    use crate::program::compile;
    use tpg_graph::Graph;
    use tpg_graph::sample::{self, Shape};
    use tpg_graph::{interpret, states};

    fn mean(costs: &Costs<'_>, states: &[f64]) -> Cost<f64> {
        let (total, actions) = costs.count(states);
        divided(total, actions.len())
    }

    fn shapes() -> impl Iterator<Item = (Language, Options)> {
        let options = Options::new("arm".parse().expect("a prefix"));
        let gegelati = Options { style: Style::Gegelati, ..options.clone() };
        let profiles = [Language::C, Language::Rust].into_iter().flat_map(move |language| {
            let options = options.clone();
            Profile::ALL.map(move |profile| (language, Options { profile: Some(profile), ..options.clone() }))
        });
        profiles.chain([(Language::C, gegelati)])
    }

    #[test]
    fn what_is_counted_takes_the_interpreters_way_and_never_exceeds_the_worst() {
        for seed in 0..60 {
            let shape = if seed % 2 == 0 { Shape::random(seed) } else { Shape::random_with_outputs(seed) };
            let graph = sample::graph(&shape, seed);
            let states = states::sample(&graph, 300, seed);
            let expected = graph.outputs().is_empty().then(|| interpret::actions(&graph, &states));
            for (language, options) in shapes().filter(|(_, it)| expected.is_some() || it.style == Style::Pure) {
                let program = compile(&graph, &options, language);
                let costs = Costs::of(&program);
                let (_, actions) = costs.count(&states);
                assert!(expected.as_ref().is_none_or(|expected| actions == *expected), "graph {seed}, {options:?}");
                let worst = costs.worst();
                for state in states.chunks_exact(graph.state_length()) {
                    let cost = mean(&costs, state);
                    assert!(cost.teams <= worst.teams as f64, "graph {seed}: {cost:?} {worst:?}");
                    assert!(cost.bids <= worst.bids as f64, "graph {seed}: {cost:?} {worst:?}");
                    assert!(cost.operations <= worst.operations as f64, "graph {seed}: {cost:?} {worst:?}");
                    assert!(cost.maths_calls <= worst.maths_calls as f64, "graph {seed}: {cost:?} {worst:?}");
                }
            }
        }
    }

    fn fixture() -> Graph {
        Graph::from_json("fixture", include_str!("../../tests/fixtures/all_instructions.json")).expect("a valid graph")
    }

    /// Counted by hand on the fixture: programs 1 (sub), 2 (sin, mul, abs), 3 (none), 9 (sub), 8 (div) in the root;
    /// 4 (exp, div, negate_if_less), 5 (ln, max), 3 in team 9; 6 (cos, min), 7 (cos, add), 10 (cos), 12 (tan, fmod, gate), 13
    /// (sqrt, atan, tanh) in team 11.
    #[test]
    fn bid_by_bid_every_operation_of_a_walk_counts() {
        let gegelati = Options { style: Style::Gegelati, ..Options::new("arm".parse().expect("a prefix")) };
        let worst = Costs::of(&compile(&fixture(), &gegelati, Language::C)).worst();
        assert_eq!((worst.teams, worst.bids, worst.operations, worst.maths_calls), (3, 13, 6 + 5 + 11, 1 + 2 + 6));
    }

    #[test]
    fn constant_time_costs_the_same_for_every_state() {
        let options =
            Options { profile: Some(Profile::ConstantTime), ..Options::new("arm".parse().expect("a prefix")) };
        let graph = fixture();
        let program = compile(&graph, &options, Language::C);
        let costs = Costs::of(&program);
        let worst = costs.worst();
        let mean = mean(&costs, &states::sample(&graph, 100, 1));
        assert_eq!(mean.operations, worst.operations as f64);
        assert_eq!(mean.maths_calls, worst.maths_calls as f64);
        assert_eq!(mean.bids, worst.bids as f64);
        // cos motors[1] is in two programs and is computed once.
        assert_eq!(worst.maths_calls, 8);
    }

    #[test]
    fn the_worst_case_of_fast_code_is_reached_where_nothing_can_be_spared() {
        let options = Options { profile: Some(Profile::Fast), ..Options::new("arm".parse().expect("a prefix")) };
        let graph = fixture();
        let program = compile(&graph, &options, Language::C);
        let costs = Costs::of(&program);
        let states = states::sample(&graph, 5000, 1);
        let highest =
            (states.chunks_exact(graph.state_length())).map(|state| mean(&costs, state).operations).fold(0.0, f64::max);
        let worst = costs.worst().operations as f64;
        assert!(highest > 0.5 * worst, "{highest} of {worst}: the bound is not idle");
        assert!(mean(&costs, &states).operations < worst, "guards spare something");
    }
}
