//! Properties that the fast profile relies on: its plans look at every bid once, and the bids they leave out cannot win.

use crate::ir::{Module, Node, NodeId, needed};
use crate::passes::estimate::{EXP_BELOW, EXP_BETWEEN, EXP_INFINITE_ABOVE, EXP_OFFSET, EXP_SCALE, LN_OFFSET, LN_SCALE};
use crate::passes::optimise;
use crate::passes::schedule::{Bid, Schedule, Sparing, TeamSchedule, schedule};
use tpg_graph::sample::{self, Shape};
use tpg_graph::states;
use tpg_graph::{Graph, MathsProvider, ScalarType};
use tpg_runtime::ops::{Instruction, Maths, Own, System};
use tpg_runtime::scalar::Scalar;

/// Random graphs, of own maths and of the platform's.
fn graphs() -> impl Iterator<Item = (u64, Graph)> {
    (0..200).map(|seed| (seed, sample::graph(&Shape::random(seed), seed)))
}

fn planned(graph: &Graph) -> (Module<'_>, Schedule) {
    let module = optimise(graph);
    let schedule = schedule(&module);
    (module, schedule)
}

fn apply<S: Scalar, M: Maths<S>>(instruction: Instruction, a: f64, b: f64) -> f64 {
    instruction.apply::<S, M>(S::from_f64(a), S::from_f64(b)).to_f64()
}

/// The estimate that generated code computes: not below the function's value, or NaN.
pub(super) fn upper(instruction: Instruction, x: f64) -> f64 {
    let (least, greatest) = EXP_BETWEEN;
    if instruction == Instruction::Exp {
        if least <= x && x <= greatest {
            f64::from_bits(((x * EXP_SCALE) as i64 as u64).wrapping_add(EXP_OFFSET))
        } else if x < least {
            EXP_BELOW
        } else if x > EXP_INFINITE_ABOVE {
            f64::INFINITY
        } else {
            f64::NAN
        }
    } else if (f64::MIN_POSITIVE..=f64::MAX).contains(&x) {
        x.to_bits() as i64 as f64 * LN_SCALE - LN_OFFSET
    } else if x <= 0.0 {
        f64::NEG_INFINITY
    } else if x > f64::MAX {
        f64::INFINITY
    } else {
        f64::NAN
    }
}

/// The value of every node.
fn evaluate(graph: &Graph, nodes: &[Node], state: &[f64]) -> Vec<f64> {
    let apply = match (graph.scalar(), graph.maths()) {
        (ScalarType::F32, MathsProvider::Own) => apply::<f32, Own>,
        (ScalarType::F32, MathsProvider::System) => apply::<f32, System>,
        (ScalarType::F64, MathsProvider::Own) => apply::<f64, Own>,
        (ScalarType::F64, MathsProvider::System) => apply::<f64, System>,
    };
    let mut values: Vec<f64> = Vec::with_capacity(nodes.len());
    for node in nodes {
        values.push(match *node {
            Node::Constant(bits) => f64::from_bits(bits),
            Node::Input(input) => state[input.index()],
            Node::Operation(instruction, [a, b]) => apply(instruction, values[a.index()], values[b.index()]),
            Node::Upper(instruction, value) => upper(instruction, values[value.index()]),
        });
    }
    values
}

/// In the order in which they are looked at.
fn bids(plan: &TeamSchedule) -> Vec<Bid> {
    plan.bids().collect()
}

fn transcendental(nodes: &[Node], value: NodeId) -> bool {
    let is = |id: &NodeId| matches!(nodes[id.index()], Node::Operation(i, _) if i.is_transcendental());
    needed(nodes, value, |_| true).iter().any(is)
}

#[test]
fn a_plan_looks_at_every_bid_of_its_team_once() {
    for (seed, graph) in graphs() {
        let (module, schedule) = planned(&graph);
        assert_eq!(schedule.plans.len(), module.teams.len());
        for (plan, team) in schedule.plans.iter().zip(&module.teams) {
            assert_eq!(plan.label, team.label);
            assert_eq!(plan.targets, team.edges.iter().map(|edge| edge.to).collect::<Vec<_>>());
            let mut places: Vec<usize> = bids(plan).iter().map(|bid| bid.place).collect();
            let mut before = None;
            for bid in bids(plan) {
                assert_eq!(bid.ascending, before.is_none_or(|before| before < bid.place), "graph {seed}: {plan:?}");
                before = before.max(Some(bid.place));
            }
            assert!(plan.eager.is_sorted_by_key(|bid| bid.place), "graph {seed}: {plan:?}");
            places.sort_unstable();
            assert_eq!(places, (0..team.edges.len()).collect::<Vec<_>>(), "graph {seed}: {plan:?}");
        }
    }
}

#[test]
fn only_what_is_expensive_waits_and_only_for_what_is_cheap() {
    let mut bounded = 0;
    for (seed, graph) in graphs() {
        let (_, Schedule { nodes, plans, .. }) = planned(&graph);
        for lazy in plans.iter().flat_map(|plan| &plan.lazy) {
            assert!(transcendental(&nodes, lazy.bid.value), "graph {seed}: {lazy:?}");
            if let Some(bound) = lazy.bound {
                assert!(!transcendental(&nodes, bound), "graph {seed}: {lazy:?}");
                bounded += 1;
            }
        }
    }
    assert!(bounded > 100, "{bounded} bounds");
}

#[test]
fn bids_are_the_modules_and_bounds_are_on_their_side_of_them() {
    let (mut spared, mut low) = (0, 0);
    for (seed, graph) in graphs() {
        let (module, schedule) = planned(&graph);
        for state in states::sample(&graph, 200, seed).chunks_exact(graph.state_length()) {
            let of_module = evaluate(&graph, &module.nodes, state);
            let values = evaluate(&graph, &schedule.nodes, state);
            for (plan, team) in schedule.plans.iter().zip(&module.teams) {
                for bid in bids(plan) {
                    let bidder = &module.bidders[team.edges[bid.place].bidder];
                    let [found, expected] = [values[bid.value.index()], of_module[bidder.value.index()]];
                    assert_eq!(found.to_bits(), expected.to_bits(), "graph {seed}, program {}", bidder.label);
                }
                for lazy in &plan.lazy {
                    let value = values[lazy.bid.value.index()];
                    if let Some(Sparing { argument, at_most, below }) = lazy.sparing
                        && values[argument.index()] <= at_most
                    {
                        assert!(value.is_nan() || value < below, "graph {seed}: {value} not below {below}");
                        low += 1;
                    }
                    if let Some(bound) = lazy.bound.map(|bound| values[bound.index()]) {
                        assert!(
                            value.is_nan() || bound.is_nan() || value <= bound,
                            "graph {seed}: {value} above {bound}"
                        );
                        spared += usize::from(bound.is_finite());
                    }
                }
            }
        }
    }
    assert!(spared > 1000 && low > 1000, "{spared} finite bounds, {low} low arguments");
}

#[test]
fn the_passes_find_something_in_them() {
    let size = |module: &Module<'_>| {
        let operations = module.nodes.iter().filter(|node| node.is_computed()).count();
        [operations, module.edges(), module.teams.len()]
    };
    let mut shrunk = [0; 3];
    for (_, graph) in graphs() {
        let (before, after) = (size(&Module::lower(&graph)), size(&optimise(&graph)));
        shrunk.iter_mut().zip(before.iter().zip(after)).for_each(|(shrunk, (before, after))| *shrunk += before - after);
    }
    assert!(shrunk.iter().all(|&count| count > 0), "operations, edges and teams go from random graphs: {shrunk:?}");
}
