//! The control step among balls: readings that cannot be move nothing and change nothing.

use proptest::prelude::*;
use tpg_arm::dodge::{
    BALLS, Ball, Behaviour, Body, Chooser, DodgeControl, DodgeSource, DodgerSettings, GOALS, VALUES, WIDOWX_RADII,
};
use tpg_arm::sensors::{Fault, Watch};
use tpg_arm::{Move, Pose, WIDOWX};
use tpg_runtime::policy::{ActionId, Policy};

const BODY: Body = Body::new(WIDOWX.to_f32(), WIDOWX_RADII);
const SETTINGS: DodgerSettings = DodgerSettings::DEFAULT;
const START: Pose = Pose([1536, 2048, 2048, 2048]);
const GOAL: Pose = Pose([2560, 2200, 1900, 2048]);

/// The behaviour changes with what is seen, so that a wrong state shows.
fn choose(values: &[f32; VALUES]) -> Behaviour {
    Behaviour::ALL[values.iter().fold(0u32, |sum, value| sum.rotate_left(5) ^ value.to_bits()) as usize % 15]
}

fn ball() -> impl Strategy<Value = Ball> {
    let place = (-400.0f32..400.0, -400.0f32..400.0, 0.0f32..500.0);
    let velocity = (-1.0f32..1.0, -1.0f32..1.0, -0.5f32..0.5);
    (place, velocity, 30.0f32..60.0).prop_map(|((x, y, z), (dx, dy, dz), radius)| Ball {
        at: [x, y, z],
        velocity: [dx, dy, dz],
        radius,
    })
}

/// A reading of balls that cannot be.
fn spoilt(balls: &[Ball], how: usize) -> Vec<Ball> {
    let mut balls = balls.to_vec();
    let wrong = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1.0, 0.0, 1e9][how % 6];
    let Some(first) = balls.first_mut().filter(|_| how % 4 < 3) else {
        return vec![Ball { at: [0.0, 400.0, 400.0], velocity: [0.0; 3], radius: 40.0 }; BALLS + 1];
    };
    match how % 4 {
        0 => first.radius = wrong,
        1 => first.at[how % 3] = if wrong.abs() < 2.0 { 1e9 } else { wrong },
        _ => first.velocity[how % 3] = if wrong.abs() < 2.0 { -1e9 } else { wrong },
    }
    balls
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn a_reading_that_cannot_be_changes_nothing(
        mut balls in prop::collection::vec(ball(), 0..=BALLS),
        faults in prop::collection::vec((0usize..24, 0u8..4), 60),
    ) {
        let begin = || DodgeControl::new(&BODY, SETTINGS, Watch::DEFAULT, &[GOAL], START, &balls);
        let (mut plain, mut disturbed) = (begin().expect("good"), begin().expect("good"));
        let mut motors = START;
        for (how, kind) in faults {
            let bad = match kind {
                0 => disturbed.step(&BODY, &choose, motors, &spoilt(&balls, how)),
                1 => disturbed.step(&BODY, &choose, Pose([motors.0[0], 4000, motors.0[2], motors.0[3]]), &balls),
                2 => {
                    let [base, others @ ..] = motors.0;
                    let [shoulder, elbow, wrist] = others;
                    disturbed.step(&BODY, &choose, Pose([base + 40, shoulder, elbow, wrist]), &balls)
                }
                _ => Err(Fault::Target),
            };
            let expected = [Fault::Sensor, Fault::Sensor, Fault::Stuck, Fault::Target][usize::from(kind)];
            prop_assert_eq!(bad, Err(expected));
            let step = plain.step(&BODY, &choose, motors, &balls).expect("a good reading");
            prop_assert_eq!(disturbed.step(&BODY, &choose, motors, &balls), Ok(step));
            // Nothing that is commanded is against limits, table or base.
            let after = BODY.arm.step(motors, step.wanted);
            prop_assert_eq!(after.invalid, None);
            motors = after.pose;
            balls.iter_mut().for_each(|ball| ball.at = ball.after(1.0));
        }
    }
}

#[test]
fn a_beginning_that_cannot_be_is_refused() {
    let begin = |goals: &[Pose], motors, balls: &[Ball]| {
        DodgeControl::new(&BODY, SETTINGS, Watch::DEFAULT, goals, motors, balls).map(|_| ())
    };
    let good = Ball { at: [0.0, 400.0, 400.0], velocity: [0.0; 3], radius: 40.0 };
    assert_eq!(begin(&[GOAL], START, &[good; BALLS]), Ok(()));
    assert_eq!(begin(&[GOAL; GOALS], START, &[]), Ok(()));
    let on_the_table = Pose([2048, 3000, 2048, 2048]);
    assert!(!BODY.is_free(&BODY.at(on_the_table)));
    for goals in [&[][..], &[GOAL; GOALS + 1], &[GOAL, Pose([2048, 2048, 2048, -1])], &[on_the_table]] {
        assert_eq!(begin(goals, START, &[good]), Err(Fault::Target));
    }
    assert_eq!(begin(&[GOAL], Pose([2048, 0, 2048, 2048]), &[good]), Err(Fault::Sensor));
    for how in 0..24 {
        assert_eq!(begin(&[GOAL], START, &spoilt(&[good], how)), Err(Fault::Sensor), "{how}");
    }
}

#[test]
fn motors_that_never_move_are_found_and_go_on_when_they_are_freed() {
    let mut control = DodgeControl::new(&BODY, SETTINGS, Watch::DEFAULT, &[GOAL], START, &[]).expect("good");
    let step = |control: &mut DodgeControl| control.step(&BODY, &|_: &[f32; VALUES]| Behaviour::Straight, START, &[]);
    let moved = (0..30).take_while(|_| step(&mut control).is_ok()).count();
    assert_eq!(moved, 11);
    assert_eq!(step(&mut control), Err(Fault::Stuck));
    assert_eq!(control.resume(Pose([-1; 4])), Err(Fault::Sensor));
    assert_eq!(control.resume(START), Ok(()));
    assert_eq!(step(&mut control).map(|step| step.wanted), Ok(Move([3, 3, -3, 0])));
}

/// Answers with its last value.
struct Last;

impl Policy for Last {
    type State = [f32; 3];
    type Action = ActionId;

    fn decide(&self, seen: &[f32; 3]) -> ActionId {
        ActionId(seen[2] as u16)
    }
}

#[test]
fn a_graph_sees_its_own_sources_in_its_order() {
    let mut values = [0.0; VALUES];
    values.iter_mut().enumerate().for_each(|(place, value)| *value = place as f32);
    let mut state = [0.0; 5];
    DodgeSource::gather(&[DodgeSource::Detour, DodgeSource::Ahead, DodgeSource::Second], &values, &mut state);
    assert_eq!(state, [16.0, 12.0, 13.0, 14.0, 10.0]);
    let mut whole = [0.0; VALUES];
    DodgeSource::gather(&DodgeSource::ALL, &values, &mut whole);
    assert_eq!(whole, values);
    let behaviours = Behaviour::ALL;
    let chooser = |sources| Chooser { policy: Last, sources, behaviours: &behaviours }.choose(&values);
    // The third value of each: 12 is the behaviour field_elbow_down; there is no action 16.
    assert_eq!(chooser(&[DodgeSource::Second, DodgeSource::Ahead]), behaviours[12]);
    assert_eq!(chooser(&[DodgeSource::Second, DodgeSource::Detour]), Behaviour::Hold);
    for source in DodgeSource::ALL {
        assert_eq!(DodgeSource::from_name(source.name()), Some(source));
    }
    assert_eq!(DodgeSource::from_name("polar"), None);
}
