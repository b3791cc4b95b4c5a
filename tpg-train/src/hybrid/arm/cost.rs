//! Time of one decision on this machine, in the trainer's own evaluation. (Compiled code: `tpg-paper table2`.)

use super::graph::GraphPolicy;
use super::narrowed::Narrowed;
use super::study::{Cell, Study};
use std::hint::black_box;
use std::time::Instant;
use tpg_arm::Move;
use tpg_arm::cycle::Brent;
use tpg_arm::episode::Episode;
use tpg_arm::hybrid::Guard;
use tpg_arm::kinematics::Plane;
use tpg_arm::observation::Observation;
use tpg_graph::Graph;
use tpg_graph::error::InputError;
use tpg_graph::in_arithmetic_of;
use tpg_problems::arm::ArmScalar;
use tpg_runtime::ops::Maths;
use tpg_runtime::policy::Policy;

/// Nanoseconds per decision.
#[derive(Clone, Debug, PartialEq)]
pub struct Costs {
    /// For each graph.
    pub tpg: Vec<f64>,
    /// For each actor.
    pub sac: Vec<f64>,
    /// For each guard, in the order of [`Guard::ALL`].
    pub guards: [f64; 4],
}

impl Costs {
    /// Measures every policy of a study on states of its own tasks.
    ///
    /// # Errors
    /// If a graph does not fit the arm.
    pub fn measure(study: &Study) -> Result<Self, InputError> {
        let tpg = study.tpgs.iter().map(|(file, graph)| of_graph(file, graph, study)).collect::<Result<_, _>>()?;
        let arm = study.arm.to_f32();
        let sac = study.sacs.iter().map(|(_, actor)| {
            let policy = actor.policy();
            let states = states::<f32, _>(&policy, study);
            best_of(&states, |seen| policy.decide(seen))
        });
        let sac: Vec<f64> = sac.collect();
        let policy = study.sacs[0].1.policy();
        let states = states::<f32, _>(&Narrowed::<f32, _>::new(&policy), study);
        let single = Move([3, 0, 0, 0]);
        let collision = |moved| Plane::at(&arm, moved).collision(&arm.shapes);
        let guards = Guard::ALL.map(|guard| best_of(&states, |seen| guard.refuses(&arm, seen.pose, single, collision)));
        // Cost of the loop itself: the time of the guard that does nothing.
        let [nothing, ..] = guards;
        Ok(Self { tpg, sac, guards: guards.map(|ns| (ns - nothing).max(0.0)) })
    }

    /// Returns the mean time of an action in a cell: decisions of both policies and guard checks, counted exactly,
    /// times their costs.
    pub fn ns_per_action(&self, cell: &Cell) -> f64 {
        let guard = Guard::ALL.iter().position(|guard| guard.name() == cell.guard).unwrap_or(0);
        // A refused decision also took time.
        let of_network = if cell.guard == Guard::Both.name() { self.guards[guard] } else { 0.0 };
        let tpg_decisions = cell.tpg_action_ratio + cell.hand_overs_guard / cell.actions.max(1.0);
        tpg_decisions * (self.tpg[cell.tpg] + self.guards[guard])
            + (1.0 - cell.tpg_action_ratio) * (self.sac[cell.sac] + of_network)
    }
}

fn of_graph(file: &str, graph: &Graph, study: &Study) -> Result<f64, InputError> {
    in_arithmetic_of!(graph, of(file, graph, study))
}

fn of<S: ArmScalar, M: Maths<S>>(file: &str, graph: &Graph, study: &Study) -> Result<f64, InputError> {
    let policy = GraphPolicy::<S, M>::new(file, graph, &study.arm)?;
    let states = states(&policy, study);
    Ok(best_of(&states, |seen| policy.decide(seen)))
}

/// Number of episodes whose states are measured.
const EPISODES: usize = 20;
/// Number of rounds; the fastest counts because slower ones were disturbed.
const ROUNDS: usize = 5;

/// Returns the observations of a policy on the way to the first targets.
fn states<S, P>(policy: &P, study: &Study) -> Vec<Observation<S>>
where
    S: ArmScalar,
    P: Policy<State = Observation<S>, Action = Move> + ?Sized,
{
    let arm = S::arm(&study.arm);
    let mut states = Vec::new();
    for task in study.tasks.iter().take(EPISODES) {
        let target = task.target.map(S::from_f64);
        states.push(Observation::at(&arm, task.start, target));
        Episode::new(&arm, study.problem.reach(task), Brent::new())
            .run(policy, |pose| states.push(Observation::at(&arm, pose, target)));
    }
    states
}

fn best_of<S, T>(states: &[Observation<S>], decide: impl Fn(&Observation<S>) -> T) -> f64 {
    let round = |_| {
        let began = Instant::now();
        states.iter().for_each(|seen| {
            black_box(decide(black_box(seen)));
        });
        began.elapsed().as_secs_f64() * 1e9 / states.len().max(1) as f64
    };
    (0..ROUNDS).map(round).fold(f64::INFINITY, f64::min)
}
