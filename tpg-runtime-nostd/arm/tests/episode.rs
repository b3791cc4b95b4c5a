//! Every way an episode can end, and which one counts where several fall together.

use proptest::prelude::*;
use std::cell::Cell;
use tpg_arm::cycle::{Brent, CycleDetector, Visited};
use tpg_arm::episode::{Episode, Outcome, ReachTask, Summary};
use tpg_arm::kinematics;
use tpg_arm::observation::Observation;
use tpg_arm::{Collision, Invalid, JOINTS, Joint, Move, Play, Pose, WIDOWX};
use tpg_runtime::policy::Policy;

/// Does what it is told, move by move, and then stops.
struct Script<'a> {
    moves: &'a [Move],
    next: Cell<usize>,
}

impl Policy for Script<'_> {
    type State = Observation<f64>;
    type Action = Move;

    fn decide(&self, _seen: &Observation<f64>) -> Move {
        let next = self.next.replace(self.next.get() + 1);
        self.moves.get(next).copied().unwrap_or(Move::STOP)
    }
}

const FAR: [f64; 3] = [0.0, 0.0, 1000.0];
const PROBLEM: ReachTask<f64> = ReachTask { start: WIDOWX.home, target: FAR, tolerance: 3.0, max_actions: 1707 };

fn forwards(joint: u8) -> Move {
    Move::single(Joint(joint), 3)
}

fn backwards(joint: u8) -> Move {
    Move::single(Joint(joint), -3)
}

fn run_with(detector: impl CycleDetector<Pose>, problem: ReachTask<f64>, moves: &[Move]) -> (Summary<f64>, Vec<Pose>) {
    let mut poses = Vec::new();
    let script = Script { moves, next: Cell::new(0) };
    let summary = Episode::new(&WIDOWX, problem, detector).run(&script, |pose| poses.push(pose));
    assert_eq!(poses.len(), summary.actions as usize);
    assert_eq!(poses.last(), Some(&summary.pose));
    (summary, poses)
}

fn run(problem: ReachTask<f64>, moves: &[Move]) -> Summary<f64> {
    run_with(Visited::<2048>::new(), problem, moves).0
}

/// The place of the hand after some moves from home.
fn hand_after(moves: &[Move]) -> [f64; 3] {
    let pose = moves.iter().fold(WIDOWX.home, |pose, &wanted| WIDOWX.step(pose, wanted).pose);
    kinematics::hand(&WIDOWX, pose)
}

#[test]
fn reached() {
    let moves = [forwards(0); 100];
    let target = hand_after(&moves);
    let summary = run(ReachTask { target, ..PROBLEM }, &moves);
    // A step is 1.6 mm, so the hand is nearer than 3 mm one step early.
    assert_eq!((summary.outcome, summary.actions), (Outcome::Reached, 99));
    assert!(summary.distance < 3.0);
}

#[test]
fn the_tolerance_is_strict() {
    let target = hand_after(&[forwards(0)]);
    let distance = kinematics::distance(target, hand_after(&[forwards(0), forwards(1)]));
    let moves = [forwards(0), forwards(1)];
    let away =
        ReachTask { tolerance: distance, target: hand_after(&moves), start: hand_start(&[forwards(0)]), ..PROBLEM };
    // Stopping exactly at the tolerance is not enough; a little more tolerance is.
    assert_eq!(run(away, &[]).outcome, Outcome::Stop);
    assert_eq!(run(ReachTask { tolerance: distance.next_up(), ..away }, &[]).outcome, Outcome::Reached);
}

fn hand_start(moves: &[Move]) -> Pose {
    moves.iter().fold(WIDOWX.home, |pose, &wanted| WIDOWX.step(pose, wanted).pose)
}

#[test]
fn a_joint_limit() {
    let summary = run(PROBLEM, &[forwards(0); 1000]);
    assert_eq!(summary.outcome, Outcome::Invalid(Invalid::JointLimit(Joint(0))));
    // (4094 − 2048) / 3 steps are possible, the next is refused and counts.
    assert_eq!((summary.actions, summary.pose), (683, Pose([4094, 2048, 2048, 2048])));
}

#[test]
fn collisions_of_every_kind() {
    let mut found = std::collections::BTreeSet::new();
    // From everywhere free on a coarse grid, one joint goes one way until it is refused.
    let coarse = || (1025..=3071_i16).step_by(127);
    for (shoulder, elbow) in coarse().flat_map(|shoulder| coarse().map(move |elbow| (shoulder, elbow))) {
        for wanted in [forwards(1), backwards(1), forwards(2), backwards(2), forwards(3), backwards(3)] {
            let problem = ReachTask { start: Pose([2048, shoulder, elbow, 2048]), ..PROBLEM };
            if let Outcome::Invalid(Invalid::Collision(collision)) = run(problem, &[wanted; 1000]).outcome {
                found.insert(collision);
            }
        }
    }
    assert_eq!(found, [Collision::Table, Collision::HandCorner, Collision::Base].into_iter().collect());
}

#[test]
fn stop() {
    let summary = run(PROBLEM, &[forwards(0), Move::STOP, forwards(0)]);
    assert_eq!((summary.outcome, summary.actions), (Outcome::Stop, 2));
}

#[test]
fn cycle() {
    let moves = [forwards(0), forwards(1), backwards(0), backwards(1), forwards(0)];
    // Back at the start, which counts as visited.
    let summary = run(PROBLEM, &moves);
    assert_eq!((summary.outcome, summary.actions, summary.pose), (Outcome::Cycle, 4, WIDOWX.home));
}

#[test]
fn cycle_found_by_brent() {
    let moves: Vec<Move> = [forwards(0), backwards(0)].into_iter().cycle().take(100).collect();
    let (summary, _) = run_with(Brent::new(), PROBLEM, &moves);
    assert_eq!(summary.outcome, Outcome::Cycle);
    assert!((2..=8).contains(&summary.actions), "{}", summary.actions);
}

#[test]
fn timeout() {
    let summary = run(ReachTask { max_actions: 5, ..PROBLEM }, &[forwards(0); 10]);
    assert_eq!((summary.outcome, summary.actions), (Outcome::Timeout, 5));
}

// Where several ends fall together: invalid, reached, stop, cycle, timeout.

#[test]
fn invalid_comes_before_everything() {
    // At the limit, at the target, and at the action limit: refused all the same.
    let start = Pose([4094, 2048, 2048, 2048]);
    let target = kinematics::hand(&WIDOWX, start);
    let problem = ReachTask { start, target, max_actions: 1, ..PROBLEM };
    assert_eq!(run(problem, &[forwards(0)]).outcome, Outcome::Invalid(Invalid::JointLimit(Joint(0))));
}

#[test]
fn reached_comes_before_stop_cycle_and_timeout() {
    let at_home = ReachTask { target: kinematics::hand(&WIDOWX, WIDOWX.home), max_actions: 1, ..PROBLEM };
    assert_eq!(run(at_home, &[Move::STOP]).outcome, Outcome::Reached);
    // Far away after the first action, back at the start with the second: a repeat and the last action.
    let leap = ReachTask { max_actions: 2, ..at_home };
    assert_eq!(run(leap, &[Move([120, 0, 0, 0]), Move([-120, 0, 0, 0])]).outcome, Outcome::Reached);
}

#[test]
fn stop_comes_before_cycle_and_timeout() {
    // Not moving repeats the pose, too, and is the last action.
    assert_eq!(run(ReachTask { max_actions: 1, ..PROBLEM }, &[Move::STOP]).outcome, Outcome::Stop);
}

#[test]
fn cycle_comes_before_timeout() {
    let problem = ReachTask { max_actions: 2, ..PROBLEM };
    assert_eq!(run(problem, &[forwards(0), backwards(0)]).outcome, Outcome::Cycle);
}

proptest! {
    #[test]
    fn every_script_ends(
        start: [i16; JOINTS],
        target: [f64; 3],
        moves in prop::collection::vec([-3..=3_i8, -3..=3, -3..=3, -3..=3], 0..100),
        max_actions in 1..50_u32,
    ) {
        let moves: Vec<Move> = moves.into_iter().map(Move).collect();
        let problem = ReachTask { start: Pose(start), target, tolerance: 3.0, max_actions };
        let (exact, poses) = run_with(Visited::<64>::new(), problem, &moves);
        prop_assert!(exact.actions <= max_actions);
        let (brent, later) = run_with(Brent::new(), problem, &moves);
        // Brent may report a cycle later, and changes nothing before.
        prop_assert!(brent.actions >= exact.actions);
        prop_assert_eq!(&later[..poses.len()], &poses[..]);
    }
}

/// The base stands 60 ticks ahead of its motor: the hand arrives 20 actions earlier, while the policy sees it elsewhere.
#[test]
fn with_play_the_hand_is_where_the_joints_put_it() {
    let moves = [forwards(0); 50];
    let problem = ReachTask { target: hand_after(&moves), ..PROBLEM };
    let rigid = run(problem, &moves);
    let script = Script { moves: &moves, next: Cell::new(0) };
    let mut episode = Episode::with_play(&WIDOWX, problem, Visited::<2048>::new(), Play([60, 0, 0, 0]));
    let mut outcome = None;
    while outcome.is_none() {
        let seen = *episode.observation();
        assert_eq!(seen.hand, kinematics::hand(&WIDOWX, seen.pose), "what a policy sees follows the motors");
        outcome = episode.advance(script.decide(&seen));
    }
    assert_eq!((rigid.outcome, outcome), (Outcome::Reached, Some(Outcome::Reached)));
    assert_eq!(episode.actions() + 20, rigid.actions);
    assert_eq!(episode.distance(), rigid.distance);
    assert!(episode.observation().distance() > 30.0);
}
