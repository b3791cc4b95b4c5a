//! The driver, the reasons for changes, and the ends of episodes of two policies.

use proptest::prelude::*;
use std::cell::Cell;
use tpg_arm::cycle::{Brent, CycleDetector, Visited};
use tpg_arm::episode::{Episode, Outcome, ReachTask};
use tpg_arm::hybrid::{Cause, Chosen, Driver, Guard, Hybrid, HybridEpisode, HybridSummary, NEVER, Settings, Switch};
use tpg_arm::kinematics;
use tpg_arm::observation::Observation;
use tpg_arm::{Invalid, Joint, Move, Pose, WIDOWX};
use tpg_runtime::policy::Policy;

/// Does what it is told, move by move, and then stops.
struct Script<'a> {
    moves: &'a [Move],
    next: Cell<usize>,
}

impl<'a> Script<'a> {
    fn new(moves: &'a [Move]) -> Self {
        Self { moves, next: Cell::new(0) }
    }
}

impl Policy for Script<'_> {
    type State = Observation<f64>;
    type Action = Move;

    fn decide(&self, _seen: &Observation<f64>) -> Move {
        let next = self.next.replace(self.next.get() + 1);
        self.moves.get(next).copied().unwrap_or(Move::STOP)
    }
}

/// A memoryless policy: the move is a function of the pose.
struct Scrambled {
    seed: u64,
    /// Ticks of a move on one joint.
    step: i8,
}

impl Policy for Scrambled {
    type State = Observation<f64>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f64>) -> Move {
        let hash = (seen.pose.packed() ^ self.seed).wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let joint = Joint((hash >> 62) as u8);
        match hash >> 40 & 31 {
            0 => Move::STOP,
            n if n % 2 == 0 => Move::single(joint, self.step),
            _ => Move::single(joint, -self.step),
        }
    }
}

const FAR: [f64; 3] = [0.0, 0.0, 1000.0];
const PROBLEM: ReachTask<f64> = ReachTask { start: WIDOWX.home, target: FAR, tolerance: 3.0, max_actions: 1707 };
const PAPER: Settings<f64> = Settings { hand_back_after: 3, separation: 20.0, guard: Guard::None };

fn forwards(joint: u8) -> Move {
    Move::single(Joint(joint), 3)
}

fn backwards(joint: u8) -> Move {
    Move::single(Joint(joint), -3)
}

/// An episode of two scripts: how it ended, and who acted ('t' or 's') in order.
fn run(settings: Settings<f64>, problem: ReachTask<f64>, tpg: &[Move], sac: &[Move]) -> (HybridSummary<f64>, String) {
    let hybrid = Hybrid { arm: &WIDOWX, tpg: Script::new(tpg), sac: Script::new(sac), settings };
    let mut drivers = String::new();
    let summary = HybridEpisode::new(&hybrid, problem, Visited::<4096>::new())
        .run(|driver, _pose| drivers.push(if driver == Driver::Tpg { 't' } else { 's' }));
    assert_eq!(summary.summary.actions as usize, drivers.len());
    assert_eq!(summary.counts.tpg_actions as usize, drivers.matches('t').count());
    assert_eq!(summary.counts.sac_actions as usize, drivers.matches('s').count());
    (summary, drivers)
}

#[test]
fn a_stop_hands_over_and_the_network_hands_back() {
    let tpg = [forwards(0), Move::STOP, forwards(0), Move::STOP];
    let sac = [forwards(1), backwards(1), forwards(2), forwards(2), backwards(2), forwards(2)];
    let (summary, drivers) = run(PAPER, ReachTask { max_actions: 10, ..PROBLEM }, &tpg, &sac);
    assert_eq!(drivers, "ttsssttsss");
    assert_eq!(summary.summary.outcome, Outcome::Timeout);
    assert_eq!((summary.counts.hand_overs, summary.counts.hand_backs), ([0, 0, 2, 0], 2));
}

#[test]
fn a_repeated_pose_hands_over_at_once_and_the_memory_is_kept() {
    // Forwards, back to the start: known. After the network's turn the first pose of all is known still.
    let tpg = [forwards(0), backwards(0), forwards(0), forwards(0)];
    let sac = [forwards(1), backwards(1), Move::STOP, forwards(1), forwards(1), forwards(1)];
    let (summary, drivers) = run(PAPER, ReachTask { max_actions: 9, ..PROBLEM }, &tpg, &sac);
    assert_eq!(drivers, "ttssstsss");
    assert_eq!(summary.counts.hand_overs, [0, 0, 0, 2]);
}

#[test]
fn drift_is_measured_from_the_best_distance_and_comes_before_a_cycle() {
    // A step of the shoulder forwards lowers the hand: further from a point high above it.
    let tpg = [forwards(1); 100];
    let settings = Settings { separation: 5.0, hand_back_after: 2, ..PAPER };
    let away = |steps: usize| {
        let pose = tpg[..steps].iter().fold(WIDOWX.home, |pose, &wanted| WIDOWX.step(pose, wanted).pose);
        kinematics::distance(FAR, kinematics::hand(&WIDOWX, pose))
    };
    let expected = (1..100).find(|&steps| away(steps) > away(0) + 5.0).expect("it drifts");
    let (summary, drivers) = run(settings, ReachTask { max_actions: 40, ..PROBLEM }, &tpg, &[forwards(2); 100]);
    assert_eq!(drivers.find('s'), Some(expected));
    assert_eq!(&drivers[expected..expected + 3], "sst", "the best distance starts anew after the network's turn");
    assert!(summary.counts.hand_overs[Cause::Drift as usize] >= 1);
    let never = Settings { separation: f64::INFINITY, ..settings };
    assert!(!run(never, ReachTask { max_actions: 40, ..PROBLEM }, &tpg, &[]).1.contains('s'));

    // Drifting onto a known pose counts as drift.
    let mut switch = Switch::new(settings, Visited::<16>::new(), &Observation::at(&WIDOWX, WIDOWX.home, FAR));
    let far = Observation::at(&WIDOWX, WIDOWX.home, [0.0, 0.0, 2000.0]);
    let chosen = Chosen { driver: Driver::Tpg, wanted: forwards(0) };
    assert_eq!(switch.acted(chosen, &far), Some(Cause::Drift));
}

#[test]
fn an_invalid_action_ends_the_episode_whoever_chose_it() {
    let limit = |moves: usize| vec![forwards(0); moves];
    let (summary, drivers) = run(PAPER, PROBLEM, &limit(700), &[]);
    assert_eq!((summary.summary.outcome, drivers.len()), (Outcome::Invalid(Invalid::JointLimit(Joint(0))), 683));
    let (summary, drivers) = run(Settings { hand_back_after: 1000, ..PAPER }, PROBLEM, &[], &limit(700));
    assert_eq!((summary.summary.outcome, drivers.len()), (Outcome::Invalid(Invalid::JointLimit(Joint(0))), 684));
    assert_eq!((summary.counts.tpg_actions, summary.counts.sac_actions), (1, 683));
}

#[test]
fn guards_hand_over_instead_of_doing_it() {
    let end = |guard, joint, max_actions| {
        let settings = Settings { guard, separation: f64::INFINITY, ..PAPER };
        let tpg = [forwards(joint); 700];
        let (summary, drivers) = run(settings, ReachTask { max_actions, ..PROBLEM }, &tpg, &[forwards(2)]);
        (summary.summary.outcome, summary.counts.hand_overs[Cause::Guard as usize], drivers)
    };
    // 682 steps of the base, and the next is refused.
    assert_eq!(end(Guard::None, 0, 700).0, Outcome::Invalid(Invalid::JointLimit(Joint(0))));
    for guard in [Guard::JointLimits, Guard::Collisions, Guard::Both] {
        let (outcome, guarded, drivers) = end(guard, 0, 687);
        assert_eq!((outcome, guarded, &drivers[681..]), (Outcome::Timeout, 2, "tsssss"));
    }
    // The shoulder leaning forwards brings the hand to the table before its limit.
    let lean = |guard| end(guard, 1, 400);
    assert!(matches!(lean(Guard::JointLimits).0, Outcome::Invalid(Invalid::Collision(_))));
    let (outcome, guarded, _) = lean(Guard::Collisions);
    assert!(outcome == Outcome::Timeout && guarded > 1, "{outcome:?}, {guarded}");
}

#[test]
fn the_network_holds_joints_rather_than_collide() {
    let end = |guard, sac: Move| {
        let settings = Settings { guard, separation: f64::INFINITY, hand_back_after: NEVER };
        run(settings, ReachTask { max_actions: 600, ..PROBLEM }, &[], &[sac; 600]).0.summary
    };
    let (lean, lean_and_turn) = (forwards(1), Move([3, 3, 0, 0]));
    assert!(matches!(end(Guard::Collisions, lean_and_turn).outcome, Outcome::Invalid(Invalid::Collision(_))));
    // The base goes on turning where the shoulder can lean no further.
    let summary = end(Guard::Both, lean_and_turn);
    assert_eq!((summary.outcome, summary.pose.0[0]), (Outcome::Timeout, 2048 + 3 * 599));
    // There is nothing else to do: the network rests, and that for ever.
    assert_eq!(end(Guard::Both, lean).outcome, Outcome::Cycle);
}

#[test]
fn for_good_ends_where_the_network_cycles() {
    let settings = Settings { hand_back_after: NEVER, ..PAPER };
    let there_and_back: Vec<Move> = [forwards(0), backwards(0)].repeat(900);
    let (summary, drivers) = run(settings, PROBLEM, &[forwards(1)], &there_and_back);
    assert_eq!(summary.summary.outcome, Outcome::Cycle);
    assert!(drivers.len() < 10 && summary.counts.hand_backs == 0, "{drivers}");
    let bounded = Settings { hand_back_after: 1000, ..PAPER };
    assert_eq!(run(bounded, PROBLEM, &[forwards(1)], &there_and_back).1.len(), 1707);
}

#[test]
fn reaching_the_target_ends_it() {
    let moves = [forwards(0); 100];
    let pose = moves.iter().fold(WIDOWX.home, |pose, &wanted| WIDOWX.step(pose, wanted).pose);
    let problem = ReachTask { target: kinematics::hand(&WIDOWX, pose), ..PROBLEM };
    let (summary, drivers) = run(PAPER, problem, &moves, &[]);
    assert_eq!((summary.summary.outcome, drivers.len()), (Outcome::Reached, 99));
    let (summary, _) = run(Settings { hand_back_after: NEVER, ..PAPER }, problem, &[], &moves);
    assert_eq!((summary.summary.outcome, summary.counts.sac_actions), (Outcome::Reached, 99));
}

proptest! {
    /// Until the graph gives up, a hybrid is the graph alone.
    #[test]
    fn before_the_first_hand_over_it_is_the_graph_alone(seed: u64, guard in 0usize..4) {
        let tpg = Scrambled { seed, step: 3 };
        let mut alone = Vec::new();
        let summary = Episode::new(&WIDOWX, PROBLEM, Visited::<4096>::new()).run(&tpg, |pose| alone.push(pose));
        let settings = Settings { separation: f64::INFINITY, guard: Guard::ALL[guard], ..PAPER };
        let hybrid = Hybrid { arm: &WIDOWX, tpg, sac: Scrambled { seed: !seed, step: 2 }, settings };
        let mut both = Vec::new();
        HybridEpisode::new(&hybrid, PROBLEM, Visited::<4096>::new()).run(|driver, pose| both.push((driver, pose)));
        let first = both.iter().position(|&(driver, _)| driver == Driver::Sac).unwrap_or(both.len());
        let poses: Vec<Pose> = both[..first].iter().map(|&(_, pose)| pose).collect();
        let refused = matches!(summary.outcome, Outcome::Invalid(_)) && settings.guard != Guard::None;
        prop_assert_eq!(&poses[..], &alone[..alone.len() - usize::from(refused && first < alone.len())]);
    }

    /// With the guard for both no action is invalid, whatever the two want.
    #[test]
    fn nothing_invalid_is_executed(seed: u64, hand_back_after in 1u32..100, joint in 0u8..4, up: bool) {
        let settings = Settings { hand_back_after, guard: Guard::Both, ..PAPER };
        // One that mostly goes straight on, into whatever comes.
        let straight = [if up { forwards(joint) } else { backwards(joint) }; 3000];
        let sac = Scrambled { seed, step: 3 };
        let hybrid = Hybrid { arm: &WIDOWX, tpg: Script::new(&straight), sac, settings };
        let summary = HybridEpisode::new(&hybrid, PROBLEM, Brent::new()).run(|_, _| ()).summary;
        prop_assert!(!matches!(summary.outcome, Outcome::Invalid(_)), "{:?}", summary.outcome);
        let hybrid = Hybrid { arm: &WIDOWX, tpg: Scrambled { seed, step: 3 }, sac: Script::new(&straight), settings };
        let summary = HybridEpisode::new(&hybrid, PROBLEM, Brent::new()).run(|_, _| ()).summary;
        prop_assert!(!matches!(summary.outcome, Outcome::Invalid(_)), "{:?}", summary.outcome);
    }

    /// The counts tell the whole episode, with either detector, and Brent never hands over before the exact set.
    #[test]
    fn counts_add_up_and_brent_is_never_early(seed: u64, hand_back_after in 1u32..50) {
        let settings = Settings { hand_back_after, ..PAPER };
        let hybrid = Hybrid {
            arm: &WIDOWX, tpg: Scrambled { seed, step: 3 }, sac: Scrambled { seed: !seed, step: 2 }, settings
        };
        let problem = ReachTask { max_actions: 300, ..PROBLEM };
        fn first<D: CycleDetector<Pose>>(
            hybrid: &Hybrid<'_, f64, Scrambled, Scrambled>, problem: ReachTask<f64>, detector: D
        ) -> (HybridSummary<f64>, u32) {
            let (mut acted, mut first) = (0, u32::MAX);
            let summary = HybridEpisode::new(hybrid, problem, detector).run(|driver, _| {
                if driver == Driver::Sac { first = first.min(acted); }
                acted += 1;
            });
            (summary, first)
        }
        let (exact, at_repeat) = first(&hybrid, problem, Visited::<512>::new());
        let (brent, later) = first(&hybrid, problem, Brent::new());
        prop_assert!(later >= at_repeat);
        for HybridSummary { summary, counts } in [exact, brent] {
            prop_assert_eq!(counts.tpg_actions + counts.sac_actions, summary.actions);
            let turns: u32 = counts.hand_overs.iter().sum();
            prop_assert!(turns == counts.hand_backs || turns == counts.hand_backs + 1);
            prop_assert!(counts.sac_actions <= turns * hand_back_after);
            prop_assert!(counts.sac_actions >= counts.hand_backs * hand_back_after);
        }
    }
}

#[test]
fn names_go_both_ways() {
    for guard in Guard::ALL {
        assert_eq!(Guard::from_name(guard.name()), Some(guard));
    }
    assert_eq!(Guard::from_name("everything"), None);
    assert_eq!([Cause::Guard, Cause::Drift, Cause::Stop, Cause::Cycle].map(|cause| cause as usize), [0, 1, 2, 3]);
}
