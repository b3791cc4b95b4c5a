//! Measured times from motor positions to a move, including everything in between.
//!
//! Episodes are run once to record the poses, and the decisions along these poses are then timed: the kinematics that a
//! controller needs, the policy, and for a hybrid its guard and its switch, but no simulated arm.

use std::hint::black_box;
use std::time::Instant;
use tpg_arm::cycle::{Brent, CycleDetector};
use tpg_arm::episode::Episode;
use tpg_arm::hybrid::{Hybrid, HybridEpisode, Switch};
use tpg_arm::kinematics::{Lattice, Vector};
use tpg_arm::observation::Observation;
use tpg_arm::{Arm, Move, Pose};
use tpg_problems::arm::targets::{Start, Task};
use tpg_runtime::policy::Policy;

/// Nanoseconds per action.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Time {
    /// Mean over all actions; the fastest round of each episode counts.
    pub mean: f64,
    /// Slowest action; the fastest round of each action counts, including the clock's overhead.
    pub worst: f64,
}

/// Number of rounds, of which the fastest counts.
const ROUNDS: usize = 7;

/// The recorded trajectory of an episode.
struct Way<S> {
    target: Vector<S>,
    poses: Vec<Pose>,
}

/// Times a policy that acts alone.
pub fn of_policy<S, P>(arm: &Arm<S>, policy: &P, start: Start, tasks: &[Task]) -> Time
where
    S: Lattice,
    P: Policy<State = Observation<S>, Action = Move> + ?Sized,
{
    of_policy_along(arm, policy, policy, start, tasks)
}

/// Times a policy along the trajectories of another one.
pub fn of_policy_along<S, P, G>(arm: &Arm<S>, policy: &P, guide: &G, start: Start, tasks: &[Task]) -> Time
where
    S: Lattice,
    P: Policy<State = Observation<S>, Action = Move> + ?Sized,
    G: Policy<State = Observation<S>, Action = Move> + ?Sized,
{
    let ways = ways(tasks, |task, poses| {
        Episode::new(arm, task.problem(start), Brent::new()).run(guide, |pose| poses.push(pose));
    });
    // A policy that caches values of its target must start with an empty cache.
    let begin = || {
        policy.decide(&Observation::at(arm, arm.home, [S::ZERO; 3]));
    };
    along(&ways, begin, |(), way, pose, _| policy.decide(&Observation::at(arm, pose, way.target)))
}

/// Times two policies that share the arm.
pub fn of_hybrid<S, T, P, D>(hybrid: &Hybrid<'_, S, T, P>, detector: &D, start: Start, tasks: &[Task]) -> Time
where
    S: Lattice,
    T: Policy<State = Observation<S>, Action = Move>,
    P: Policy<State = Observation<S>, Action = Move>,
    D: CycleDetector<Pose> + Clone,
{
    let ways = ways(tasks, |task, poses| {
        HybridEpisode::new(hybrid, task.problem(start), detector.clone()).run(|_, pose| poses.push(pose));
    });
    let begin = || None;
    along(&ways, begin, |state: &mut Option<(Switch<S, D>, Option<_>)>, way, pose, first| {
        let seen = Observation::at(hybrid.arm, pose, way.target);
        if first {
            *state = Some((Switch::new(hybrid.settings, detector.clone(), &seen), None));
        }
        let (switch, chosen) = state.as_mut().expect("a first pose came");
        // The effect of the previous action is known only now.
        if let Some(chosen) = chosen.take() {
            switch.acted(chosen, &seen);
        }
        let now = hybrid.decide(switch, &seen);
        *chosen = Some(now);
        now.wanted
    })
}

fn ways<S: Lattice>(tasks: &[Task], mut go: impl FnMut(&Task, &mut Vec<Pose>)) -> Vec<Way<S>> {
    let way = |task: &Task| {
        let mut poses = vec![task.start];
        go(task, &mut poses);
        // No decision is made in the final pose.
        poses.pop();
        Way { target: task.target.map(S::from_f64), poses }
    };
    tasks.iter().map(way).collect()
}

/// Times each episode separately, several times: an episode takes less than a millisecond, so that at least one round
/// is undisturbed even on a busy machine.
fn along<S, T>(ways: &[Way<S>], begin: impl Fn() -> T, decide: impl Fn(&mut T, &Way<S>, Pose, bool) -> Move) -> Time {
    let actions: usize = ways.iter().map(|way| way.poses.len()).sum();
    let mut whole = 0.0;
    let mut worst = 0.0f64;
    for way in ways {
        let round = |_| {
            let mut state = begin();
            let began = Instant::now();
            for (index, &pose) in way.poses.iter().enumerate() {
                black_box(decide(&mut state, way, black_box(pose), index == 0));
            }
            began.elapsed().as_secs_f64() * 1e9
        };
        whole += (0..ROUNDS).map(round).fold(f64::INFINITY, f64::min);
        let mut fastest = vec![f64::INFINITY; way.poses.len()];
        for _ in 0..ROUNDS {
            let mut state = begin();
            for (index, (&pose, fastest)) in way.poses.iter().zip(&mut fastest).enumerate() {
                let began = Instant::now();
                black_box(decide(&mut state, way, black_box(pose), index == 0));
                *fastest = fastest.min(began.elapsed().as_secs_f64() * 1e9);
            }
        }
        worst = fastest.into_iter().fold(worst, f64::max);
    }
    Time { mean: whole / actions.max(1) as f64, worst }
}
