//! The sensor contract: readings that a control step refuses, and that it refuses no others.

use proptest::prelude::*;
use std::cell::Cell;
use tpg_arm::cycle::Brent;
use tpg_arm::hybrid::{Chosen, Control, Guard, Hybrid, Settings, Switch};
use tpg_arm::observation::{Observation, Source, Straight, TargetMemo};
use tpg_arm::sensors::{Fault, Limits, Watch, Watchdog};
use tpg_arm::{Arm, ArmError, BaseEdge, Joint, JointRange, Links, Move, Pose, Shapes, WIDOWX};
use tpg_runtime::policy::Policy;

const ARM: Arm<f32> = WIDOWX.to_f32();
const TARGET: [f32; 3] = [-250.0, 239.0, 267.0];
const SETTINGS: Settings<f32> = Settings { hand_back_after: 5, separation: 20.0, guard: Guard::Both };

/// The rule as the documentation says it, in plain integers.
struct Plain {
    watch: Watch,
    expected: [i32; 4],
    left: u16,
}

impl Plain {
    fn new(watch: Watch, motors: Pose) -> Self {
        Self { watch, expected: motors.0.map(i32::from), left: watch.patience }
    }

    fn check(&self, motors: Pose) -> Result<(), Fault> {
        let held = motors.0.iter().zip(ARM.ranges).all(|(&ticks, range)| range.contains(ticks));
        let near = motors
            .0
            .iter()
            .zip(self.expected)
            .all(|(&ticks, expected)| (i32::from(ticks) - expected).abs() <= i32::from(self.watch.threshold));
        match (held, near) {
            (false, _) => Err(Fault::Sensor),
            (true, false) => Err(Fault::Stuck),
            (true, true) => Ok(()),
        }
    }

    fn commanded(&mut self, motors: Pose, wanted: Move) {
        self.left -= 1;
        if self.left == 0 {
            *self = Self::new(self.watch, motors);
        }
        for (expected, delta) in self.expected.iter_mut().zip(wanted.0) {
            *expected += i32::from(delta);
        }
    }
}

fn position() -> impl Strategy<Value = i16> {
    prop_oneof![4 => 1020i16..3076, 1 => any::<i16>(), 1 => prop_oneof![Just(-1i16), Just(i16::MIN), Just(i16::MAX)]]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2_000))]

    /// Two positions at a time in a word judge as four comparisons do, whatever is read.
    #[test]
    fn lanes_judge_as_plain_integers(
        start in (2i16..=4094, 1025i16..=3071, 1025i16..=3071, 1025i16..=3071),
        threshold in prop_oneof![0u16..50, Just(4096u16)],
        patience in 1u16..20,
        // What is read at each step: where the motors are, or that; and the move that is wanted.
        steps in prop::collection::vec(
            (prop_oneof![3 => Just(None), 1 => prop::array::uniform4(position()).prop_map(Some)],
             prop::array::uniform4(prop_oneof![9 => -3i8..=3, 1 => any::<i8>()]), prop::bool::weighted(0.7)),
            1..60,
        ),
    ) {
        let watch = Watch { threshold, patience };
        let (mut motors, wanted_target) = (Pose([start.0, start.1, start.2, start.3]), TARGET);
        let mut watchdog = Watchdog::new(Limits::new(&ARM), watch, motors).expect("motors in their ranges");
        let mut plain = Plain::new(watch, motors);
        for (read, wanted, obeys) in steps {
            let reading = read.map_or(motors, Pose);
            let checked = watchdog.check(reading, &wanted_target);
            prop_assert_eq!(checked, plain.check(reading));
            if checked.is_ok() {
                watchdog.commanded(reading, Move(wanted));
                plain.commanded(reading, Move(wanted));
                if obeys {
                    motors = ARM.step(motors, Move(wanted)).pose;
                }
            }
        }
    }

    /// The arm's own hand is always within its reach, and what is far beyond never is.
    #[test]
    fn the_hand_is_in_reach(pose in (2i16..=4094, 1025i16..=3071, 1025i16..=3071, 1025i16..=3071), far in 1.01f32..1e30) {
        let pose = Pose([pose.0, pose.1, pose.2, pose.3]);
        let (limits, seen) = (Limits::new(&ARM), Observation::at(&ARM, pose, TARGET));
        prop_assert!(limits.reaches(&seen.hand) && limits.hold(pose) && seen.is_consistent());
        prop_assert!(!limits.reaches(&[0.0, (ARM.reach() + 1.0) * far, ARM.links.base]));
        let wide = Limits::new(&WIDOWX);
        prop_assert!(wide.reaches(&Observation::at(&WIDOWX, pose, [0.0; 3]).hand));
    }
}

#[test]
fn only_numbers_in_reach_are_targets() {
    let limits = Limits::new(&ARM);
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e38, -1e38, 500.0] {
        for place in 0..3 {
            let mut target = TARGET;
            target[place] = bad;
            assert!(!limits.reaches(&target), "{target:?}");
        }
    }
    assert!(limits.reaches(&TARGET) && limits.reaches(&[0.0, 447.0, 125.0]) && !limits.reaches(&[0.0, 449.0, 125.0]));
}

#[test]
fn an_observation_of_another_hand_is_refused() {
    let limits = Limits::new(&ARM);
    let seen = Observation::at(&ARM, ARM.home, TARGET);
    assert_eq!(limits.check(&seen), Ok(()));
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, 1e38, 0.5] {
        for place in 0..3 {
            let (mut hand, mut difference, mut both) = (seen, seen, seen);
            hand.hand[place] = bad;
            difference.difference[place] = bad;
            both.hand[place] = bad;
            both.difference[place] = both.target[place] - bad;
            assert_eq!(limits.check(&hand), Err(Fault::Sensor), "{hand:?}");
            assert_eq!(limits.check(&difference), Err(Fault::Sensor), "{difference:?}");
            // Finite and consistent: the documentation says that it is believed.
            assert_eq!(limits.check(&both).is_ok(), bad.is_finite(), "{both:?}");
        }
    }
    assert_eq!(limits.check(&Observation::at(&ARM, Pose([1; 4]), TARGET)), Err(Fault::Sensor));
    assert_eq!(limits.check(&Observation::at(&ARM, Pose([1; 4]), [f32::NAN; 3])), Err(Fault::Target));
}

/// Counts how often it is asked.
struct Counting<'a>(Straight<'a, f32>, Cell<u32>);

impl Policy for Counting<'_> {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        self.1.set(self.1.get() + 1);
        self.0.decide(seen)
    }
}

/// Between good steps, bad ones of every kind change nothing: the moves and counts are those of an undisturbed run.
#[test]
fn bad_readings_leave_no_trace() {
    let hybrid = |guard| {
        let settings = Settings { guard, ..SETTINGS };
        let policy = || Counting(Straight::new(&ARM), Cell::new(0));
        Hybrid { arm: &ARM, tpg: policy(), sac: policy(), settings }
    };
    for guard in Guard::ALL {
        let (plain, hybrid) = (hybrid(guard), hybrid(guard));
        let first = Observation::at(&ARM, ARM.home, TARGET);
        let mut switch = Switch::new(plain.settings, Brent::new(), &first);
        let mut control =
            Control::new(Limits::new(&ARM), hybrid.settings, Watch::DEFAULT, Brent::new(), &first).expect("a good one");
        let (mut motors, mut executed) = (ARM.home, None);
        for step in 0..300 {
            let seen = Observation::at(&ARM, motors, TARGET);
            if let Some(executed) = executed {
                switch.acted(executed, &seen);
            }
            let chosen: Chosen = plain.decide(&mut switch, &seen);
            executed = Some(chosen);

            let bad = [
                (Pose([-1; 4]), TARGET, Fault::Sensor),
                (motors, [f32::NAN, 0.0, 0.0], Fault::Target),
                (Pose([motors.0[0] ^ 0x100, motors.0[1], motors.0[2], motors.0[3]]), TARGET, Fault::Stuck),
            ];
            let asked = hybrid.tpg.1.get() + hybrid.sac.1.get();
            for (motors, target, fault) in bad {
                let before = *control.switch().counts();
                assert_eq!(hybrid.step(&mut control, motors, target).map(|_| ()), Err(fault), "step {step}");
                assert_eq!(*control.switch().counts(), before);
            }
            assert_eq!(asked, hybrid.tpg.1.get() + hybrid.sac.1.get(), "no policy was asked");
            let (observation, same) = hybrid.step(&mut control, motors, TARGET).expect("a good reading");
            assert_eq!((observation, same), (seen, chosen));
            assert_eq!(control.switch().counts(), switch.counts());
            motors = ARM.step(motors, chosen.wanted).pose;
        }
        assert!(switch.counts().tpg_actions > 100);
    }
}

#[test]
fn stuck_motors_are_found_and_a_caller_can_go_on() {
    let policy = || Straight::new(&ARM);
    let hybrid = Hybrid { arm: &ARM, tpg: policy(), sac: policy(), settings: SETTINGS };
    let first = Observation::at(&ARM, ARM.home, TARGET);
    let mut control =
        Control::new(Limits::new(&ARM), SETTINGS, Watch::DEFAULT, Brent::new(), &first).expect("a good one");
    let found = (0..100).find_map(|step| hybrid.step(&mut control, ARM.home, TARGET).err().map(|fault| (step, fault)));
    assert_eq!(found, Some((11, Fault::Stuck)));
    assert_eq!(hybrid.step(&mut control, ARM.home, TARGET).map(|_| ()), Err(Fault::Stuck), "it stays so");
    assert_eq!(control.resume(Pose([0; 4])), Err(Fault::Sensor));
    assert_eq!(
        hybrid.step(&mut control, ARM.home, TARGET).map(|_| ()),
        Err(Fault::Stuck),
        "a bad place changes nothing"
    );
    assert_eq!(control.resume(ARM.home), Ok(()));
    let (_, chosen) = hybrid.step(&mut control, ARM.home, TARGET).expect("a good reading");
    assert_ne!(chosen.wanted, Move::STOP);
    // Switched off.
    let never = Watch { threshold: 4096, ..Watch::DEFAULT };
    let mut control = Control::new(Limits::new(&ARM), SETTINGS, never, Brent::new(), &first).expect("a good one");
    assert!((0..1000).all(|_| hybrid.step(&mut control, ARM.home, TARGET).is_ok()));
}

#[test]
fn a_loop_does_not_begin_on_a_bad_reading() {
    let begin = |motors, target| {
        let seen = Observation::at(&ARM, motors, target);
        Control::new(Limits::new(&ARM), SETTINGS, Watch::DEFAULT, Brent::new(), &seen).err()
    };
    assert_eq!(begin(ARM.home, TARGET), None);
    assert_eq!(begin(Pose([0; 4]), TARGET), Some(Fault::Sensor));
    assert_eq!(begin(ARM.home, [0.0, f32::INFINITY, 0.0]), Some(Fault::Target));
}

#[test]
fn impossible_arms_are_refused() {
    let range = |min, max| {
        let mut arm = ARM;
        arm.ranges[1] = JointRange { min, max };
        arm.check()
    };
    assert_eq!(range(3071, 1025), Err(ArmError::Range(Joint(1))));
    assert_eq!(range(-1, 3071), Err(ArmError::Range(Joint(1))));
    assert_eq!(range(1025, 4096), Err(ArmError::Range(Joint(1))));
    assert_eq!(range(2049, 3071), Err(ArmError::Home(Joint(1))));
    assert_eq!(range(2048, 2048), Ok(()));
    let links = |change: fn(&mut Links<f32>)| {
        let mut arm = ARM;
        change(&mut arm.links);
        arm.check()
    };
    assert_eq!(links(|links| links.hand = f32::NAN), Err(ArmError::Link));
    assert_eq!(links(|links| links.forearm = 0.0), Err(ArmError::Link));
    assert_eq!(links(|links| links.upper_arm = -1.0), Err(ArmError::Link));
    assert_eq!(links(|links| links.base = f32::INFINITY), Err(ArmError::Link));
    assert_eq!(links(|links| links.elbow_offset = 1e9), Err(ArmError::Link));
    assert_eq!(links(|links| links.elbow_offset = 0.0), Ok(()));
    assert_eq!(links(|links| links.shoulder_radial = -1.0), Err(ArmError::Link));
    let shapes = |change: fn(&mut Shapes<f32>)| {
        let mut arm = ARM;
        change(&mut arm.shapes);
        arm.check()
    };
    assert_eq!(shapes(|shapes| shapes.hand_edges[1] = f32::NAN), Err(ArmError::Shape));
    assert_eq!(shapes(|shapes| shapes.forearm_overhang = f32::INFINITY), Err(ArmError::Shape));
    assert_eq!(shapes(|shapes| shapes.base[3] = BaseEdge { x: [0.0, 1.0], z: [0.0, 1.0] }), Err(ArmError::Shape));
    assert_eq!(ARM.check(), Ok(()));
    assert_eq!(WIDOWX.check(), Ok(()));
}

proptest! {
    /// What an impossible arm answers means nothing, but it panics in no build: this one has overflow checks.
    #[test]
    fn impossible_arms_panic_nowhere(
        home in prop::array::uniform4(any::<i16>()),
        ranges in prop::array::uniform4((any::<i16>(), any::<i16>())),
        lengths in prop::array::uniform6(any::<f32>()),
        pose in prop::array::uniform4(any::<i16>()),
        target in prop::array::uniform3(any::<f32>()),
        wanted in prop::array::uniform4(any::<i8>()),
    ) {
        let [base, upper_arm, elbow_offset, forearm, hand, shoulder_radial] = lengths;
        let arm = Arm {
            home: Pose(home),
            ranges: ranges.map(|(min, max)| JointRange { min, max }),
            links: Links { base, upper_arm, elbow_offset, forearm, hand, shoulder_radial },
            ..ARM
        };
        let (seen, mut state) = (Observation::at(&arm, Pose(pose), target), [0f32; 48]);
        for source in Source::ALL {
            Source::fill(&[source], &arm, &seen, &TargetMemo::new(), &mut state);
        }
        arm.step(Pose(pose), Move(wanted));
        let _ = arm.check();
        let _ = Limits::new(&arm).check(&seen);
        if let Ok(mut watchdog) = Watchdog::new(Limits::new(&arm), Watch { threshold: u16::MAX, patience: 0 }, Pose(pose)) {
            let _ = watchdog.check(Pose(pose), &target);
            watchdog.commanded(Pose(pose), Move(wanted));
            let _ = watchdog.check(Pose(pose), &target);
        }
    }
}
