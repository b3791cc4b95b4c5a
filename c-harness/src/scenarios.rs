//! The table of sensor faults: readings, and the codes that the contract asks for. Host, C and firmwares run the same one.
#![allow(dead_code, reason = "each of the programs that include this file uses a part")]

use Reading::*;

/// The reading in a phase, made from where the simulated motors really are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Reading {
    /// The motors do as they are told, and say so.
    Good,
    /// No motor moves.
    Stuck,
    /// This joint's motor does not move.
    JointStuck,
    /// The reading is `amount` steps old.
    Late,
    /// This joint reads `amount` ticks too much.
    Jump,
    /// This joint always reads `amount`.
    Fixed,
    /// Good at every other step; this joint reads `amount` in between, first of all.
    Flicker,
    /// Observed by the caller, with a hand that is NaN.
    HandNan,
    /// With an infinite difference.
    DifferenceInfinite,
    /// With a hand that is 50 mm off, but not its difference.
    HandOff,
    /// With an infinite hand, and the difference that belongs to it.
    HandInfinite,
}

/// The target in a phase.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Target {
    /// One that the arm reaches.
    Good,
    /// One coordinate is NaN.
    Nan,
    /// One coordinate is infinite.
    Infinite,
    /// One coordinate is 10³⁸ mm.
    Huge,
    /// Some millimetres farther than the arm is long.
    Far,
}

/// The codes of `tpg_runtime.h`.
pub(crate) const OK: i32 = 0;
pub(crate) const BAD_TARGET: i32 = 11;
pub(crate) const BAD_SENSOR: i32 = 12;
pub(crate) const STUCK: i32 = 13;

/// Some steps of a scenario.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Phase {
    pub(crate) steps: u16,
    pub(crate) reading: Reading,
    /// The subject of the reading.
    pub(crate) joint: u8,
    pub(crate) amount: i16,
    pub(crate) target: Target,
    /// True where the caller says first that it removed the cause.
    pub(crate) resume: bool,
    /// The code of every step from `within` on; before that, OK and the code of the phase before are right, too.
    pub(crate) code: i32,
    pub(crate) within: u16,
}

/// A run from home towards one target.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scenario {
    pub(crate) name: &'static str,
    /// Threshold and patience.
    pub(crate) watch: (u16, u16),
    pub(crate) phases: &'static [Phase],
}

/// The reachable target, mm.
pub(crate) const GOOD_TARGET: [f32; 3] = [-250.0, 239.0, 267.0];
/// The target out of reach, mm: the arm is 447.2 mm long from a shoulder at a height of 125 mm.
pub(crate) const FAR_TARGET: [f32; 3] = [0.0, 450.0, 125.0];

const fn phase(steps: u16, reading: Reading, code: i32, within: u16) -> Phase {
    Phase { steps, reading, joint: 0, amount: 0, target: Target::Good, resume: false, code, within }
}

const fn resumed(steps: u16, reading: Reading, code: i32, within: u16) -> Phase {
    Phase { resume: true, ..phase(steps, reading, code, within) }
}

const fn joint_phase(steps: u16, reading: Reading, joint: u8, amount: i16, code: i32) -> Phase {
    Phase { joint, amount, ..phase(steps, reading, code, 0) }
}

const fn late(steps: u16, amount: i16, code: i32) -> Phase {
    joint_phase(steps, Late, 0, amount, code)
}

const fn aimed(steps: u16, target: Target) -> Phase {
    Phase { target, ..phase(steps, Good, BAD_TARGET, 0) }
}

const fn good(steps: u16) -> Phase {
    phase(steps, Good, OK, 0)
}

const fn scenario(name: &'static str, phases: &'static [Phase]) -> Scenario {
    Scenario { name, watch: (32, 64), phases }
}

/// The table.
pub(crate) static SCENARIOS: [Scenario; 24] = [
    scenario("healthy", &[good(150)]),
    // Stuck.
    scenario("stuck-from-the-start", &[phase(60, Stuck, STUCK, 45)]),
    scenario("stuck-on-the-way", &[good(40), phase(60, Stuck, STUCK, 45)]),
    scenario("one-joint-stuck", &[good(20), phase(80, JointStuck, STUCK, 60)]),
    scenario("stuck-and-freed", &[good(20), phase(60, Stuck, STUCK, 45), resumed(60, Good, OK, 0)]),
    scenario(
        "stuck-and-not-freed",
        &[phase(60, Stuck, STUCK, 45), resumed(60, Stuck, STUCK, 45), resumed(9, Good, OK, 0)],
    ),
    Scenario {
        name: "stuck-by-a-strict-watch",
        watch: (4, 8),
        phases: &[good(30), phase(20, Stuck, STUCK, 8), resumed(30, Good, OK, 0)],
    },
    // Jumping.
    scenario("a-reading-jumps", &[good(30), joint_phase(1, Jump, 1, 500, STUCK), good(30)]),
    scenario("a-small-jump-is-borne", &[good(30), joint_phase(3, Jump, 2, 20, OK), good(30)]),
    scenario(
        "a-jump-that-stays",
        &[
            good(30),
            joint_phase(20, Jump, 3, -200, STUCK),
            Phase { resume: true, ..joint_phase(20, Jump, 3, -200, OK) },
        ],
    ),
    scenario(
        "readings-flicker",
        &[good(10), Phase { within: 40, ..joint_phase(40, Flicker, 0, -1, BAD_SENSOR) }, good(10)],
    ),
    // Motors outside their ranges: what a bus says when a servo does not answer.
    scenario("all-ones", &[good(10), joint_phase(10, Fixed, 2, -1, BAD_SENSOR), good(30)]),
    scenario("the-greatest-number", &[good(10), joint_phase(10, Fixed, 0, i16::MAX, BAD_SENSOR), good(30)]),
    scenario("the-least-number", &[good(10), joint_phase(10, Fixed, 3, i16::MIN, BAD_SENSOR), good(30)]),
    scenario("a-tick-too-far", &[good(10), joint_phase(10, Fixed, 1, 3072, BAD_SENSOR), good(30)]),
    scenario("bad-from-the-start", &[joint_phase(10, Fixed, 1, 0, BAD_SENSOR), good(30)]),
    // Late.
    scenario("a-step-late", &[good(10), late(80, 1, OK), good(30)]),
    scenario("five-steps-late", &[good(10), late(80, 5, OK), good(30)]),
    // It is found out, the arm waits, the readings come, and it goes on by itself.
    scenario("late-until-it-comes", &[good(10), late(1, 30, OK), late(20, 30, STUCK), late(10, 30, OK), good(40)]),
    // No numbers.
    scenario("target-nan", &[good(10), aimed(10, Target::Nan), good(30)]),
    scenario("target-infinite", &[good(10), aimed(10, Target::Infinite), aimed(10, Target::Huge), good(30)]),
    scenario("target-out-of-reach", &[aimed(10, Target::Far), good(30)]),
    scenario(
        "hand-no-number",
        &[good(10), phase(5, HandNan, BAD_SENSOR, 0), phase(5, HandInfinite, BAD_SENSOR, 0), good(20)],
    ),
    scenario(
        "difference-of-another-hand",
        &[good(10), phase(5, DifferenceInfinite, BAD_SENSOR, 0), phase(5, HandOff, BAD_SENSOR, 0), good(20)],
    ),
];
