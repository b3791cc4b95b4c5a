//! Properties that the fast profile relies on: its plans look at every bid once, and the bids they leave out cannot win.

use tpg_codegen::ir::{Module, Node, NodeId, needed};
use tpg_codegen::passes::interval::Assumption;
use tpg_codegen::passes::schedule::{Bid, Infinite, Schedule, Sparing, TeamSchedule, schedule};
use tpg_codegen::passes::{estimate, optimise};
use tpg_graph::sample::{self, Shape};
use tpg_graph::states;
use tpg_graph::{Graph, MathsProvider, ScalarType};
use tpg_runtime::ops::{Instruction, Maths, Own, System};
use tpg_runtime::scalar::Scalar;

/// Random graphs, of own maths and of the platform's, whose bids may be certain without being computed.
fn graphs() -> impl Iterator<Item = (u64, Graph)> {
    (0..200).map(|seed| (seed, sample::graph(&Shape::random(seed), seed)))
}

/// A graph's plans, every other time in the order of recorded wins.
fn planned(seed: u64, graph: &Graph) -> (Module<'_>, Schedule) {
    let module = optimise(graph, Assumption::Nothing).0;
    let recorded = if seed.is_multiple_of(2) { Vec::new() } else { states::sample(graph, 40, seed) };
    let schedule = schedule(&module, &recorded);
    (module, schedule)
}

fn apply<S: Scalar, M: Maths<S>>(instruction: Instruction, a: f64, b: f64) -> f64 {
    instruction.apply::<S, M>(S::from_f64(a), S::from_f64(b)).to_f64()
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
            Node::Upper(instruction, value) => {
                graph.scalar().round(estimate::upper(graph.scalar(), instruction, values[value.index()]))
            }
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
        let (module, schedule) = planned(seed, &graph);
        assert_eq!(schedule.plans.len(), module.teams.len());
        for (plan, team) in schedule.plans.iter().zip(&module.teams) {
            assert_eq!(plan.label, team.label);
            assert_eq!(plan.targets, team.edges.iter().map(|edge| edge.to).collect::<Vec<_>>());
            let mut places: Vec<usize> = bids(plan).iter().map(|bid| bid.place).collect();
            let mut before = plan.infinite.map(|infinite| infinite.place);
            for bid in bids(plan) {
                assert_eq!(bid.ascending, before.is_none_or(|before| before < bid.place), "graph {seed}: {plan:?}");
                before = before.max(Some(bid.place));
            }
            assert!(plan.eager.is_sorted_by_key(|bid| bid.place), "graph {seed}: {plan:?}");
            assert!(plan.eager_before.is_sorted_by_key(|bid| bid.place), "graph {seed}: {plan:?}");
            let waits = |place: usize| plan.infinite.is_some_and(|infinite| place < infinite.place);
            assert!(plan.eager_before.iter().all(|bid| waits(bid.place)), "graph {seed}: {plan:?}");
            assert!(
                plan.lazy.iter().all(|lazy| lazy.before_infinite == waits(lazy.bid.place)),
                "graph {seed}: {plan:?}"
            );
            places.sort_unstable();
            assert_eq!(places, (0..team.edges.len()).collect::<Vec<_>>(), "graph {seed}: {plan:?}");
        }
    }
}

#[test]
fn only_what_is_expensive_waits_and_only_for_what_is_cheap() {
    let mut bounded = 0;
    for (seed, graph) in graphs() {
        let (_, Schedule { nodes, plans, .. }) = planned(seed, &graph);
        for lazy in plans.iter().flat_map(|plan| &plan.lazy) {
            assert!(transcendental(&nodes, lazy.bid.value), "graph {seed}: {lazy:?}");
            for bound in lazy.bound.iter().chain(&lazy.certain) {
                assert!(!transcendental(&nodes, *bound), "graph {seed}: {lazy:?}");
                bounded += 1;
            }
        }
    }
    assert!(bounded > 100, "{bounded} bounds");
}

#[test]
fn bids_are_the_modules_and_bounds_are_on_their_side_of_them() {
    let (mut spared, mut certain, mut low, mut infinite) = (0, 0, 0, 0);
    for (seed, graph) in graphs() {
        let (module, schedule) = planned(seed, &graph);
        for state in states::sample(&graph, 200, seed).chunks_exact(graph.state_length()) {
            let of_module = evaluate(&graph, &module.nodes, state);
            let values = evaluate(&graph, &schedule.nodes, state);
            for (plan, team) in schedule.plans.iter().zip(&module.teams) {
                for bid in bids(plan) {
                    let bidder = &module.bidders[team.edges[bid.place].bidder];
                    let [found, expected] = [values[bid.value.index()], of_module[bidder.value.index()]];
                    assert_eq!(found.to_bits(), expected.to_bits(), "graph {seed}, program {}", bidder.label);
                }
                if let Some(Infinite { place, argument, above }) = plan.infinite
                    && values[argument.index()] > above
                {
                    let lazy = plan.lazy.iter().find(|lazy| lazy.bid.place == place).expect("it is among them");
                    assert_eq!(values[lazy.bid.value.index()], f64::INFINITY, "graph {seed}: {plan:?}");
                    infinite += 1;
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
                    // What is certain must not be promised of a NaN, which bids −∞.
                    if let Some(least) = lazy.certain.map(|least| values[least.index()]) {
                        let never = least.is_nan() || least == f64::NEG_INFINITY;
                        assert!(never || value >= least, "graph {seed}: {value} below {least}");
                        certain += usize::from(!never);
                    }
                }
            }
        }
    }
    assert!(spared > 1000 && certain > 100, "{spared} finite bounds, {certain} certain bids");
    assert!(low > 1000 && infinite > 100, "{low} low arguments, {infinite} infinite bids");
}
