//! The control step among balls through the C interface: the same bits as in Rust, with the shipped graph.

use core::mem::MaybeUninit;
use core::ptr::null;
use tpg_arm::dodge::{Ball, Behaviour, Body, Chooser, DodgeControl, DodgeSource, DodgerSettings, VALUES, WIDOWX_RADII};
use tpg_arm::sensors::Watch;
use tpg_arm::{Pose, WIDOWX};
use tpg_generated::dodge::Dodge;
use tpg_runtime::policy::{ActionId, Policy};
use tpg_runtime_capi::arm::*;
use tpg_runtime_capi::code::*;
use tpg_runtime_capi::dodge::*;
use tpg_testing::numbers::Numbers;

const BODY: Body = Body::new(WIDOWX.to_f32(), WIDOWX_RADII);
const SOURCES: [u8; 6] =
    [TPG_SOURCE_LEFT, TPG_SOURCE_NEAR, TPG_SOURCE_SECOND, TPG_SOURCE_AHEAD, TPG_SOURCE_PROGRESS, TPG_SOURCE_DETOUR];

/// The shipped graph, as C calls it.
unsafe extern "C" fn infer(state: *const core::ffi::c_void) -> u16 {
    // SAFETY: the library hands in the values of all sources.
    let ActionId(action) = Dodge.decide(unsafe { &*state.cast::<[f32; VALUES]>() });
    action
}

/// Takes each behaviour in turn, by the progress: it sees the detour and then the progress.
unsafe extern "C" fn turns(state: *const core::ffi::c_void) -> u16 {
    // SAFETY: the library hands in two values.
    let [_, progress] = unsafe { *state.cast::<[f32; 2]>() };
    progress as u16 % 17
}

/// The same in Rust.
struct Turns;

impl Policy for Turns {
    type State = [f32; 2];
    type Action = ActionId;

    fn decide(&self, &[_, progress]: &[f32; 2]) -> ActionId {
        ActionId(progress as u16 % 17)
    }
}

fn between(numbers: &mut Numbers, low: f32, high: f32) -> f32 {
    low + (high - low) * (numbers.next_u32() >> 8) as f32 / 16_777_216.0
}

/// A pose without a collision.
fn pose(numbers: &mut Numbers) -> Pose {
    loop {
        let pose = Pose([(); 4].map(|()| between(numbers, 1100.0, 3000.0) as i16));
        if BODY.is_free(&BODY.at(pose)) {
            return pose;
        }
    }
}

fn ball(numbers: &mut Numbers) -> Ball {
    let still = numbers.next_u32().is_multiple_of(4);
    let mut axis = |size: f32| if still { 0.0 } else { between(numbers, -size, size) };
    let velocity = [axis(1.0), axis(1.0), axis(0.5)];
    let at = [(-350.0, 350.0), (-350.0, 350.0), (30.0, 400.0)].map(|(low, high)| between(numbers, low, high));
    Ball { at, velocity, radius: between(numbers, 30.0, 60.0) }
}

fn in_c(balls: &[Ball]) -> Vec<tpg_ball_t> {
    balls.iter().map(|&Ball { at, velocity, radius }| tpg_ball_t { at, velocity, radius }).collect()
}

fn made<T>() -> Box<T> {
    // SAFETY: all of the interface's structures are plain data.
    Box::new(unsafe { MaybeUninit::zeroed().assume_init() })
}

/// Lets both walk through drawn scenes; how many steps were refused and done.
fn walk(policy: &tpg_dodge_policy_t, choose: impl Fn(&[f32; VALUES]) -> Behaviour, seed: u64) -> [u32; 2] {
    let mut numbers = Numbers(seed);
    let (mut arm, mut body, mut dodger) = (made::<tpg_arm_t>(), made::<tpg_body_t>(), made::<tpg_dodger_t>());
    let mut counts = [0; 2];
    // SAFETY: every pointer points to its structure.
    unsafe {
        assert_eq!(tpg_arm_init_widowx(&mut *arm), TPG_OK);
        assert_eq!(tpg_body_init(&mut *body, &*arm, null()), TPG_OK);
        for scene in 0..tpg_testing::amount(30, 1_000) {
            let mut motors = pose(&mut numbers);
            let goals: Vec<Pose> = (0..=scene % 4).map(|_| pose(&mut numbers)).collect();
            let mut balls: Vec<Ball> = (0..scene / 4 % 4).map(|_| ball(&mut numbers)).collect();
            let settings = DodgerSettings::DEFAULT;
            let mut control =
                DodgeControl::new(&BODY, settings, Watch::DEFAULT, &goals, motors, &balls).expect("a good reading");
            let poses: Vec<tpg_pose_t> = goals.iter().map(|goal| tpg_pose_t { ticks: goal.0 }).collect();
            let reading = tpg_pose_t { ticks: motors.0 };
            let seen = in_c(&balls);
            let (goals, count) = (poses.as_ptr(), poses.len());
            let begun = tpg_dodger_init(
                &mut *dodger,
                &*body,
                policy,
                null(),
                null(),
                goals,
                count,
                &reading,
                seen.as_ptr(),
                seen.len(),
            );
            assert_eq!(begun, TPG_OK);
            for _ in 0..200 {
                let (mut reading, mut seen) = (motors, balls.clone());
                // Some readings cannot be, or jump.
                match numbers.next_u32() % 16 {
                    0 => reading.0[(numbers.next_u32() % 4) as usize] += 100,
                    1 => seen.iter_mut().for_each(|ball| ball.radius = -ball.radius),
                    2 => seen.resize(4, Ball { at: [0.0; 3], velocity: [0.0; 3], radius: 1.0 }),
                    3 => seen.iter_mut().for_each(|ball| ball.at[1] = f32::NAN),
                    _ => {}
                }
                let expected = control.step(&BODY, &choose, reading, &seen);
                let (pose, list) = (tpg_pose_t { ticks: reading.0 }, in_c(&seen));
                let mut chosen = tpg_dodge_t { wanted: tpg_move_t { ticks: [9; 4] }, behaviour: 99 };
                let code = tpg_dodger_step(&mut *dodger, &pose, list.as_ptr(), list.len(), &mut chosen);
                match expected {
                    Ok(step) => {
                        counts[1] += 1;
                        assert_eq!(code, TPG_OK);
                        assert_eq!(chosen.wanted.ticks, step.wanted.0);
                        assert_eq!(Behaviour::ALL[usize::from(chosen.behaviour)], step.behaviour);
                        motors = BODY.arm.step(motors, step.wanted).pose;
                    }
                    Err(fault) => {
                        counts[0] += 1;
                        let nothing =
                            tpg_dodge_t { wanted: tpg_move_t { ticks: [0; 4] }, behaviour: TPG_BEHAVIOUR_HOLD };
                        assert_eq!((Refusal(code), chosen), (tpg_runtime_capi::code::fault(fault), nothing));
                        // Cleared by the caller, in both.
                        assert_eq!(control.resume(motors), Ok(()));
                        assert_eq!(tpg_dodger_resume(&mut *dodger, &tpg_pose_t { ticks: motors.0 }), TPG_OK);
                    }
                }
                balls.iter_mut().for_each(|ball| ball.at = ball.after(1.0));
            }
        }
    }
    counts
}

#[test]
fn every_step_is_as_in_rust() {
    let behaviours: Vec<u8> = (0..TPG_BEHAVIOURS).collect();
    let all = Behaviour::ALL;
    let policy = |infer, sources: &'static [u8]| tpg_dodge_policy_t {
        infer: Some(infer),
        sources: sources.as_ptr(),
        source_count: sources.len(),
        behaviours: behaviours.as_ptr(),
        behaviour_count: behaviours.len(),
    };
    let shipped = Chooser { policy: Dodge, sources: &DodgeSource::ALL, behaviours: &all };
    let [refused, done] = walk(&policy(infer, &SOURCES), |values| shipped.choose(values), 1);
    assert!(refused > 200 && done > 3 * refused, "{refused} {done}");
    let turning = Chooser { policy: Turns, sources: &[DodgeSource::Detour, DodgeSource::Progress], behaviours: &all };
    walk(&policy(turns, &[TPG_SOURCE_DETOUR, TPG_SOURCE_PROGRESS]), |values| turning.choose(values), 2);
}

#[test]
fn what_cannot_begin_is_refused_by_its_code() {
    let (mut arm, mut body, mut dodger) = (made::<tpg_arm_t>(), made::<tpg_body_t>(), made::<tpg_dodger_t>());
    let behaviours = [TPG_BEHAVIOUR_PLAN, TPG_BEHAVIOUR_FIELD];
    let good = tpg_dodge_policy_t {
        infer: Some(infer),
        sources: SOURCES.as_ptr(),
        source_count: SOURCES.len(),
        behaviours: behaviours.as_ptr(),
        behaviour_count: behaviours.len(),
    };
    let home = tpg_pose_t { ticks: WIDOWX.home.0 };
    let (arm, body, dodger) = (&raw mut *arm, &raw mut *body, &raw mut *dodger);
    // SAFETY: every pointer is NULL or points to its structure.
    unsafe {
        assert_eq!(tpg_body_init(body, arm, null()), TPG_STATE);
        assert_eq!(tpg_arm_init_widowx(arm), TPG_OK);
        for radius in [0.0, -1.0, f32::NAN, f32::INFINITY] {
            assert_eq!(tpg_body_init(body, arm, [28.0, radius, 24.0, 32.0].as_ptr()), TPG_ARGUMENT);
        }
        let mut chosen = made::<tpg_dodge_t>();
        assert_eq!(tpg_dodger_step(dodger, &home, null(), 0, &mut *chosen), TPG_STATE);
        let begin = |policy: &tpg_dodge_policy_t, settings: *const tpg_dodger_settings_t, goals: &[tpg_pose_t]| {
            let (goals, count) = (goals.as_ptr(), goals.len());
            tpg_dodger_init(dodger, body, policy, settings, null(), goals, count, &home, null(), 0)
        };
        assert_eq!(begin(&good, null(), &[home]), TPG_STATE, "no body yet");
        assert_eq!(tpg_body_init(body, arm, null()), TPG_OK);
        assert_eq!(begin(&good, null(), &[home]), TPG_OK);
        for goals in [vec![], vec![home; 5], vec![tpg_pose_t { ticks: [2048, 3000, 2048, 2048] }]] {
            assert_eq!(begin(&good, null(), &goals), TPG_BAD_TARGET);
        }
        for (effort, guard) in [(3999, 1), (60_001, 1), (6000, 2)] {
            assert_eq!(begin(&good, &tpg_dodger_settings_t { effort, guard }, &[home]), TPG_ARGUMENT);
        }
        assert_eq!(begin(&good, &tpg_dodger_settings_t { effort: 6000, guard: 0 }, &[home]), TPG_OK);
        let other = [TPG_SOURCE_LEFT - 1];
        assert_eq!(
            begin(&tpg_dodge_policy_t { sources: other.as_ptr(), source_count: 1, ..good }, null(), &[home]),
            TPG_ARGUMENT
        );
        let many = [TPG_SOURCE_NEAR; 3];
        assert_eq!(
            begin(&tpg_dodge_policy_t { sources: many.as_ptr(), source_count: 3, ..good }, null(), &[home]),
            TPG_LENGTH
        );
        let unknown = [TPG_BEHAVIOURS];
        let policy = tpg_dodge_policy_t { behaviours: unknown.as_ptr(), behaviour_count: 1, ..good };
        assert_eq!(begin(&policy, null(), &[home]), TPG_ARGUMENT);
        assert_eq!(begin(&tpg_dodge_policy_t { infer: None, ..good }, null(), &[home]), TPG_NULL);
    }
}
