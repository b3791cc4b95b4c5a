//! The arm among balls: distances against sampling, gradients against differences, plans, behaviours, search and guard.

use proptest::prelude::*;
use std::collections::BTreeSet;
use std::f32::consts::TAU;
use tpg_arm::dodge::plan::Plan;
use tpg_arm::dodge::plan::{STEP, steps, straight};
use tpg_arm::dodge::{
    Ball, Behaviour, Body, CAPSULES, DodgeSource, Dodger, DodgerSettings, FIELD, Fate, Field, HORIZON, Scout, VALUES,
    View, WIDOWX_RADII, away, guarded, permitted,
};
use tpg_arm::kinematics::Vector;
use tpg_arm::{JOINTS, Move, Pose, WIDOWX};

const BODY: Body = Body::new(WIDOWX.to_f32(), WIDOWX_RADII);
const SETTINGS: DodgerSettings = DodgerSettings::DEFAULT;

fn pose() -> impl Strategy<Value = Pose> {
    let [base, shoulder, elbow, wrist] = WIDOWX.ranges.map(|range| range.min..=range.max);
    (base, shoulder, elbow, wrist).prop_map(|(a, b, c, d)| Pose([a, b, c, d]))
}

fn free_pose() -> impl Strategy<Value = Pose> {
    pose().prop_filter("free", |&pose| BODY.is_free(&BODY.at(pose)))
}

fn ball() -> impl Strategy<Value = Ball> {
    let place = (-450.0f32..450.0, -450.0f32..450.0, 0.0f32..600.0);
    let velocity = (-2.0f32..2.0, -2.0f32..2.0, -1.0f32..1.0);
    (place, velocity, 30.0f32..60.0).prop_map(|((x, y, z), (dx, dy, dz), radius)| Ball {
        at: [x, y, z],
        velocity: [dx, dy, dz],
        radius,
    })
}

fn balls() -> impl Strategy<Value = Vec<Ball>> {
    prop::collection::vec(ball(), 0..4)
}

fn moved(pose: Pose, by: Move) -> Pose {
    let mut moved = pose;
    for ((ticks, by), range) in moved.0.iter_mut().zip(by.0).zip(&WIDOWX.ranges) {
        let to = *ticks + i16::from(by);
        *ticks = if range.contains(to) { to } else { *ticks };
    }
    moved
}

/// The clearance by 2,000 points on the axis of every capsule, in double precision.
fn sampled(pose: Pose, centre: Vector<f32>, radius: f32) -> f64 {
    let posture = BODY.at(pose);
    let mut least = f64::INFINITY;
    for (capsule, width) in WIDOWX_RADII.into_iter().enumerate() {
        for part in 0..=2000 {
            let point = posture.on_axis(capsule, part as f32 / 2000.0);
            let square: f64 = point.iter().zip(centre).map(|(a, b)| (f64::from(*a) - f64::from(b)).powi(2)).sum();
            least = least.min(square.sqrt() - f64::from(width));
        }
    }
    least - f64::from(radius)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn the_clearance_is_that_of_many_points(pose in pose(), ball in ball()) {
        let posture = BODY.at(pose);
        let clearance = f64::from(BODY.clearance(&posture, ball.at, ball.radius));
        let sampled = sampled(pose, ball.at, ball.radius);
        // Points are 0.08 mm apart at most: the nearest of them is nearly the nearest.
        prop_assert!(clearance <= sampled + 2e-3 && clearance >= sampled - 0.05, "{clearance} {sampled}");
    }

    #[test]
    fn the_nearest_point_has_the_clearance_and_a_bound_is_below_it(pose in pose(), ball in ball()) {
        let posture = BODY.at(pose);
        let clearance = BODY.clearance(&posture, ball.at, ball.radius);
        let nearest = BODY.nearest(&posture, ball.at, ball.radius);
        prop_assert_eq!(nearest.clearance.to_bits(), clearance.to_bits());
        prop_assert!(nearest.capsule < CAPSULES);
        let length: f32 = nearest.away.iter().map(|value| value * value).sum();
        prop_assert!((length - 1.0).abs() < 1e-4, "{}", length);
        let bound = BODY.clearance_bound(&posture, &posture.outline(), ball.at, ball.radius);
        prop_assert!(bound <= clearance + 1e-3, "{} {}", bound, clearance);
    }

    #[test]
    fn the_gradient_is_that_of_small_steps(pose in free_pose(), ball in ball()) {
        const TICKS: i16 = 4;
        let posture = BODY.at(pose);
        let nearest = BODY.nearest(&posture, ball.at, ball.radius);
        prop_assume!(nearest.clearance > -20.0);
        let gradient = BODY.gradient(&posture, &nearest);
        for (joint, slope) in gradient.into_iter().enumerate() {
            let beside = |ticks: i16| {
                let mut pose = pose;
                pose.0[joint] += ticks;
                BODY.nearest(&BODY.at(pose), ball.at, ball.radius)
            };
            let (before, after) = (beside(-TICKS), beside(TICKS));
            // Where another capsule becomes the nearest the clearance has a kink.
            if before.capsule == nearest.capsule && after.capsule == nearest.capsule {
                let difference = (after.clearance - before.clearance) / (2.0 * f32::from(TICKS) * TAU / 4096.0);
                prop_assert!((difference - slope).abs() < 1.5 + 0.01 * slope.abs(), "{joint}: {difference} {slope}");
            }
        }
    }

    #[test]
    fn what_stands_clearly_stands(pose in pose()) {
        let posture = BODY.at(pose);
        prop_assert!(!BODY.is_clearly_free(&posture) || BODY.is_free(&posture), "{:?}", pose);
    }

    /// The sooner test is the exact one, also of a base whose edges are given backwards and on the other side.
    #[test]
    fn what_stands_has_no_collision(pose in pose(), backwards: bool, side in 0.2f32..1.5) {
        let mut arm = BODY.arm;
        for edge in &mut arm.shapes.base {
            edge.x = edge.x.map(|x| side * if backwards { -x } else { x });
        }
        let body = Body::new(arm, WIDOWX_RADII);
        let posture = body.at(pose);
        prop_assert_eq!(body.is_free(&posture), posture.plane().collision(&arm.shapes).is_none(), "{:?}", pose);
    }

    #[test]
    fn a_plan_arrives_when_it_says(from in pose(), via in pose(), goal in pose(), wait in 0u16..200, direct: bool) {
        let mut plan = Plan { via: (!direct).then_some((via, wait)), goal };
        let arrival = plan.arrival(from);
        let mut at = from;
        for _ in 0..arrival {
            let step = plan.advance(at);
            prop_assert!(step.0.iter().all(|ticks| i16::from(*ticks).abs() <= STEP));
            at = moved(at, step);
        }
        prop_assert_eq!(at, goal);
        prop_assert_eq!(plan.arrival(at), 0);
        prop_assert_eq!(Plan::straight(goal).arrival(from), steps(from, goal));
    }

    #[test]
    fn every_behaviour_takes_a_step_that_the_joints_can_make(pose in free_pose(), goal in pose(), balls in balls()) {
        let goals = [goal];
        let view = View::new(&BODY, pose, &goals, &balls);
        for behaviour in Behaviour::ALL {
            let step = behaviour.step(&view, &mut Plan::straight(goal));
            prop_assert!(step.0.iter().all(|ticks| i16::from(*ticks).abs() <= STEP), "{:?}: {:?}", behaviour, step);
        }
        prop_assert_eq!(Behaviour::Straight.step(&view, &mut Plan::straight(pose)), straight(pose, goal));
        prop_assert_eq!(Behaviour::Plan.step(&view, &mut Plan::straight(goal)), straight(pose, goal));
        prop_assert_eq!(Behaviour::Hold.step(&view, &mut Plan::straight(goal)), Move::STOP);
        let alone = View::new(&BODY, pose, &goals, &[]);
        prop_assert_eq!(FIELD.step(&alone, goal), straight(pose, goal));
        prop_assert_eq!(away(&alone), Move::STOP);
    }

    #[test]
    fn fleeing_gains_clearance(pose in free_pose(), mut ball in ball()) {
        ball.velocity = [0.0; 3];
        let (goals, balls) = ([pose], [ball]);
        let view = View::new(&BODY, pose, &goals, &balls);
        let (_, nearest) = view.nearest().next().expect("a ball");
        let steep = BODY.gradient(&view.posture, nearest).iter().any(|slope| slope.abs() > 50.0);
        prop_assume!(steep && nearest.clearance > -20.0);
        let after = BODY.at(moved(pose, away(&view)));
        let then = BODY.nearest(&after, ball.at, ball.radius);
        // Three ticks turn a joint by 0.0046 rad: curvature and limits may cost a little. Another part, about as near, may come
        // nearer.
        prop_assert!(then.capsule != nearest.capsule || then.clearance > nearest.clearance - 0.02);
    }

    #[test]
    fn the_guard_leaves_what_is_safe_and_betters_what_is_not(
        pose in free_pose(),
        goal in free_pose(),
        mut balls in balls(),
        stays: bool,
        walked: bool,
    ) {
        if let (Some(ball), true) = (balls.first_mut(), stays) {
            ball.velocity = [0.0; 3];
        }
        let goals = [goal];
        let view = View::new(&BODY, pose, &goals, &balls);
        let wanted = straight(pose, goal);
        let allowed = permitted(&view, wanted).step;
        let answer = guarded(&view, wanted, walked);
        let after = BODY.at(moved(pose, allowed));
        let clear = |ball: &Ball| {
            BODY.clearance(&after, ball.after(2.0), ball.radius) >= if ball.stays() { 0.5 } else { 3.0 }
        };
        prop_assert_eq!(answer.threatened, !balls.iter().all(clear));
        prop_assert!(answer.threatened || answer.step == allowed);
        let later = |step: Move| {
            let mut at = pose;
            for ((ticks, by), range) in at.0.iter_mut().zip(step.0).zip(&WIDOWX.ranges) {
                *ticks = (*ticks + 2 * i16::from(by)).clamp(range.min, range.max);
            }
            BODY.clearance_of_all(&BODY.at(at), &balls, 4.0)
        };
        if answer.threatened {
            prop_assert!(later(answer.step) >= later(allowed) && later(answer.step) >= later(Move::STOP));
        }
        // The arm's own rule refuses nothing that is permitted.
        for step in [allowed, answer.step] {
            prop_assert_eq!(BODY.arm.step(pose, step).invalid, None);
        }
    }

    #[test]
    fn what_stands_whatever_the_next_step_does(pose in free_pose(), step in prop::array::uniform4(-3i8..=3)) {
        let after = BODY.at(moved(pose, Move(step)));
        prop_assert!(!BODY.is_free_next(&BODY.at(pose)) || BODY.is_free(&after), "{:?}", pose);
    }

    #[test]
    fn no_step_changes_a_clearance_by_more_than_the_arm_moves(
        pose in free_pose(),
        step in prop::array::uniform4(-3i8..=3),
        ball in ball(),
    ) {
        let clearance = |pose| BODY.clearance(&BODY.at(pose), ball.at, ball.radius);
        let change = clearance(moved(pose, Move(step))) - clearance(pose);
        prop_assert!(change.abs() <= BODY.motion() + 1e-3, "{} {}", change, BODY.motion());
    }

    /// No pose, ball or goal makes anything panic: overflows are checked in tests.
    #[test]
    fn nothing_panics(
        pose: [i16; JOINTS],
        goals in prop::collection::vec(any::<[i16; JOINTS]>(), 0..6),
        balls in prop::collection::vec((any::<[f32; 3]>(), any::<[f32; 3]>(), any::<f32>()), 0..5),
        choice in 0usize..15,
    ) {
        let goals: Vec<Pose> = goals.into_iter().map(Pose).collect();
        let balls: Vec<Ball> = balls.into_iter().map(|(at, velocity, radius)| Ball { at, velocity, radius }).collect();
        let view = View::new(&BODY, Pose(pose), &goals, &balls);
        let mut dodger = Dodger::new(SETTINGS, &view);
        for _ in 0..20 {
            prop_assert_eq!(dodger.observe(&view).len(), VALUES);
            let step = dodger.act(&view, Behaviour::ALL[choice]);
            prop_assert!(step.0.iter().all(|ticks| i16::from(*ticks).abs() <= STEP));
        }
    }
}

#[test]
fn behaviours_and_sources_have_names_of_their_own() {
    let names: BTreeSet<&str> = Behaviour::ALL.iter().map(|behaviour| behaviour.name()).collect();
    assert_eq!(names.len(), Behaviour::ALL.len());
    for behaviour in Behaviour::ALL {
        let name = behaviour.name();
        assert_eq!(Behaviour::from_name(name), Some(behaviour));
    }
    assert_eq!(Behaviour::from_name("left"), None);
    assert_eq!(DodgeSource::ALL.iter().map(|source| source.ranges().len()).sum::<usize>(), VALUES);
}

/// A quarter turn of the stretched arm, with a ball that stays in the middle of the way of its hand.
fn in_the_way() -> (Pose, Pose, Ball) {
    let [start, middle, goal] = [1536, 2048, 2560].map(|base| Pose([base, 2048, 2048, 2048]));
    let at = BODY.at(middle).on_axis(3, 0.7);
    (start, goal, Ball { at, velocity: [0.0; 3], radius: 40.0 })
}

#[test]
fn the_search_finds_a_way_around_a_ball_that_stays() {
    let (start, goal, ball) = in_the_way();
    let (goals, balls) = ([goal], [ball]);
    let walk = |step: &mut dyn FnMut(&View<'_>) -> Move| {
        let (mut at, mut least) = (start, f32::INFINITY);
        for count in 0..1000 {
            let view = View::new(&BODY, at, &goals, &balls);
            at = moved(at, step(&view));
            least = least.min(BODY.clearance(&BODY.at(at), ball.at, ball.radius));
            if at == goal {
                return (count, least);
            }
        }
        (1000, least)
    };
    let (_, hit) = walk(&mut |view| Behaviour::Straight.step(view, &mut Plan::straight(goal)));
    assert!(hit < 0.0, "the straight walk must meet the ball: {hit}");
    let (stuck, _) = walk(&mut |view| Field { swirl: 0.0, ..FIELD }.step(view, goal));
    let run = || {
        let mut dodger: Option<Dodger> = None;
        walk(&mut |view| {
            let dodger = dodger.get_or_insert_with(|| Dodger::new(SETTINGS, view));
            dodger.act(view, Behaviour::Plan)
        })
    };
    let (steps, clearance) = run();
    assert!(clearance > 0.0 && steps < 700, "{steps} steps, {clearance} mm; the field takes {stuck}");
    assert_eq!(run(), (steps, clearance), "the same search twice");
}

#[test]
fn a_way_that_is_free_stays_the_straight_walk() {
    let (start, goal, _) = in_the_way();
    let (goals, balls) = ([goal], [Ball { at: [0.0, -900.0, 900.0], velocity: [0.0; 3], radius: 30.0 }]);
    let mut at = start;
    let mut dodger = Dodger::new(SETTINGS, &View::new(&BODY, at, &goals, &balls));
    for _ in 0..steps(start, goal) {
        let view = View::new(&BODY, at, &goals, &balls);
        at = moved(at, dodger.act(&view, Behaviour::Plan));
    }
    assert_eq!(at, goal);
    assert_eq!((dodger.scout().fate(), Fate::Free.free_steps()), (Fate::Free, HORIZON as u16));
}

/// The end of the way is further than the horizon, and what stays there is known all the same.
#[test]
fn a_goal_behind_a_ball_that_stays_is_not_free_however_far_it_is() {
    let [start, goal] = [100, 3100].map(|base| Pose([base, 2048, 2048, 2048]));
    let ball = |velocity| Ball { at: BODY.at(goal).on_axis(3, 0.7), velocity, radius: 40.0 };
    let fate = |velocity| {
        let (goals, balls) = ([goal], [ball(velocity)]);
        let view = View::new(&BODY, start, &goals, &balls);
        let mut scout = Scout::new(SETTINGS.effort, &view);
        (0..100).for_each(|_| scout.step(&view, 0));
        scout.straight()
    };
    assert!(steps(start, goal) > 5 * HORIZON);
    assert!(matches!(fate([0.0; 3]), Fate::Meets(steps) if steps > 5 * HORIZON as u16));
    assert_eq!(fate([0.0, 0.0, 1.0]), Fate::Free);
}

#[test]
fn a_larger_effort_searches_no_less() {
    let (start, goal, ball) = in_the_way();
    let (goals, balls) = ([goal], [ball]);
    let view = View::new(&BODY, start, &goals, &balls);
    let after = |effort| {
        let mut scout = Scout::new(effort, &view);
        (1..2000).find(|_| {
            scout.step(&view, 0);
            scout.plan().via.is_some() && scout.fate() == Fate::Free
        })
    };
    let (little, much) = (after(4000).expect("found"), after(40_000).expect("found"));
    assert!(much <= little, "{much} steps instead of {little}");
    // No effort, no search.
    let mut idle = Scout::new(SETTINGS.effort, &view);
    let before = idle;
    idle.step(&view, u16::MAX);
    assert_eq!((idle.plan(), idle.fate()), (before.plan(), before.fate()));
}
