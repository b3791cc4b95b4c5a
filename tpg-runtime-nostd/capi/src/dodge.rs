//! The control step of an arm among moving balls.

use crate::arm::{Ready, tpg_arm_t, tpg_move_t, tpg_pose_t};
use crate::code::{self, Refusal, TPG_ARGUMENT, TPG_BAD_SENSOR, TPG_LENGTH, TPG_NULL};
use crate::memory::{self, Opaque};
use crate::policy::tpg_infer_t;
use crate::sensors::tpg_watch_t;
use core::cell::Cell;
use core::mem::offset_of;
use tpg_arm::dodge::{
    BALLS, Ball, Behaviour, Body, CAPSULES, DodgeControl, DodgeSource, DodgeStep, DodgerSettings, GOALS, VALUES,
    WIDOWX_RADII,
};
use tpg_arm::{Move, Pose};

/// Most balls that are seen.
pub const TPG_BALLS: usize = 3;
/// Most poses that solve a task.
pub const TPG_GOALS: usize = 4;
/// Parts of a body: shoulder to bracket, bracket to elbow, forearm, hand.
pub const TPG_CAPSULES: usize = 4;

const _: () = assert!(TPG_BALLS == BALLS && TPG_GOALS == GOALS && TPG_CAPSULES == CAPSULES);

/// Goal less pose of base, shoulder, elbow and wrist, ticks.
pub const TPG_SOURCE_LEFT: u8 = 32;
/// Of the nearest ball: clearance, its change in a step, by how much each joint changes it: 6 values in mm, mm/step, mm/rad.
pub const TPG_SOURCE_NEAR: u8 = 33;
/// Of the second nearest ball: clearance and its change in a step.
pub const TPG_SOURCE_SECOND: u8 = 34;
/// Steps until the straight walk and the plan meet something, and until the plan arrives.
pub const TPG_SOURCE_AHEAD: u8 = 35;
/// Steps since the arm was nearer to its goal than ever.
pub const TPG_SOURCE_PROGRESS: u8 = 36;
/// Steps of the plan less those of the straight walk.
pub const TPG_SOURCE_DETOUR: u8 = 37;

const _: () =
    assert!((TPG_SOURCE_DETOUR - TPG_SOURCE_LEFT) as usize + 1 == DodgeSource::ALL.len(), "a source without a number");

/// Follows the plan that the search has found.
pub const TPG_BEHAVIOUR_PLAN: u8 = 0;
/// Walks straight to the goal.
pub const TPG_BEHAVIOUR_STRAIGHT: u8 = 1;
/// Stays.
pub const TPG_BEHAVIOUR_HOLD: u8 = 2;
/// Flees from the nearest ball.
pub const TPG_BEHAVIOUR_AWAY: u8 = 3;
/// Walks to the goal in the potential field.
pub const TPG_BEHAVIOUR_FIELD: u8 = 4;
/// Follows the plan in the potential field.
pub const TPG_BEHAVIOUR_FIELD_PLAN: u8 = 5;
/// Stretches upwards in the potential field.
pub const TPG_BEHAVIOUR_UPRIGHT: u8 = 6;
/// Goes in the field to the goal with the base moved 200 ticks up from where it is. The seven after it: base down, shoulder up
/// and down, elbow up and down, wrist up and down.
pub const TPG_BEHAVIOUR_FIELD_BASE_UP: u8 = 7;
/// Number of behaviours.
pub const TPG_BEHAVIOURS: u8 = 15;

const _: () = assert!(TPG_BEHAVIOURS as usize == Behaviour::ALL.len(), "a behaviour without a number");

/// A ball as it is seen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct tpg_ball_t {
    /// Its centre: x, y, z in mm; at most 100 m away.
    pub at: [f32; 3],
    /// Its displacement in the last step, mm; at most 1 m.
    pub velocity: [f32; 3],
    /// Its radius, mm; above 0, at most 1 m.
    pub radius: f32,
}

/// Words of a tpg_body_t.
pub const TPG_BODY_WORDS: usize = 38;

/// An arm whose links are capsules. Opaque; initialised by tpg_body_init, constant from then on.
#[repr(C)]
pub struct tpg_body_t {
    /// The library's.
    pub opaque: [u64; TPG_BODY_WORDS],
}

// SAFETY: any bytes are an array of integers; `initialise` proves that the content fits.
unsafe impl Opaque for tpg_body_t {
    type Content = Body;
    const TAG: u32 = 0x424f_4401;
}

/// A policy that tpg-codegen compiled, in f32, whose actions are behaviours. Constant: it can lie in flash.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tpg_dodge_policy_t {
    /// The decision. Its argument points to the sources' values, aligned for the generated structure.
    pub infer: tpg_infer_t,
    /// TPG_SOURCE codes from TPG_SOURCE_LEFT to TPG_SOURCE_DETOUR, in order; 17 values at most.
    pub sources: *const u8,
    /// Number of sources.
    pub source_count: usize,
    /// A TPG_BEHAVIOUR code for each action. An action past the end holds.
    pub behaviours: *const u8,
    /// Number of behaviours.
    pub behaviour_count: usize,
}

/// Settings of search and guard.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct tpg_dodger_settings_t {
    /// The cost that a whole step may have, in instructions of a Cortex-M4, about: 4000 to 60000.
    pub effort: u16,
    /// 1 if steps that would soon be hit are replaced, 0 if not.
    pub guard: u8,
}

impl tpg_dodger_settings_t {
    /// The settings behind a pointer, or the default ones for NULL.
    unsafe fn get(pointer: *const Self) -> Result<DodgerSettings, Refusal> {
        if pointer.is_null() {
            return Ok(DodgerSettings::DEFAULT);
        }
        // SAFETY: the header's contract.
        let &Self { effort, guard } = unsafe { memory::read(pointer) }?;
        if !(4000..=60_000).contains(&effort) || guard > 1 {
            return Err(Refusal(TPG_ARGUMENT));
        }
        Ok(DodgerSettings { effort, guard: guard == 1 })
    }
}

/// A step of a control loop among balls.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct tpg_dodge_t {
    /// The move that goes to the motors: never against limits, table or base.
    pub wanted: tpg_move_t,
    /// The TPG_BEHAVIOUR that the policy chose.
    pub behaviour: u8,
}

/// A policy's parts, checked.
struct DodgeChooser {
    infer: unsafe extern "C" fn(state: *const core::ffi::c_void) -> u16,
    sources: &'static [u8],
    behaviours: &'static [u8],
    /// True if the sources are all there are, in order: the values are the state.
    whole: bool,
}

impl DodgeChooser {
    /// Checks a policy.
    ///
    /// # Safety
    /// The header's contract; the policy's arrays live as long as the result.
    unsafe fn new(policy: &tpg_dodge_policy_t) -> Result<Self, Refusal> {
        let infer = policy.infer.ok_or(Refusal(TPG_NULL))?;
        // SAFETY: the header's contract.
        let sources = unsafe { memory::array::<'static, u8>(policy.sources, policy.source_count) }?;
        // SAFETY: the header's contract.
        let behaviours = unsafe { memory::array::<'static, u8>(policy.behaviours, policy.behaviour_count) }?;
        let mut length = 0usize;
        for &number in sources {
            length = length.saturating_add(source(number).ok_or(Refusal(TPG_ARGUMENT))?.ranges().len());
        }
        if length > VALUES {
            return Err(Refusal(TPG_LENGTH));
        }
        if behaviours.iter().any(|&number| number >= TPG_BEHAVIOURS) {
            return Err(Refusal(TPG_ARGUMENT));
        }
        let whole = sources.iter().map(|&number| source(number)).eq(DodgeSource::ALL.map(Some));
        Ok(Self { infer, sources, behaviours, whole })
    }

    /// Returns the TPG_BEHAVIOUR of the policy's action.
    fn choose(&self, values: &[f32; VALUES]) -> u8 {
        let mut other: [f32; VALUES];
        let mut state = values;
        if !self.whole {
            other = [0.0; VALUES];
            let mut slots = other.as_mut_slice();
            for source in self.sources.iter().filter_map(|&number| source(number)) {
                let Some((own, rest)) = slots.split_at_mut_checked(source.ranges().len()) else { break };
                DodgeSource::gather(&[source], values, own);
                slots = rest;
            }
            state = &other;
        }
        // SAFETY: the header asks for the function of these sources: it reads no more than their values, and `new` has found
        // that there are no more than there is room for.
        let action = unsafe { (self.infer)(state.as_ptr().cast()) };
        self.behaviours.get(usize::from(action)).copied().unwrap_or(TPG_BEHAVIOUR_HOLD)
    }
}

/// The source of a number.
fn source(number: u8) -> Option<DodgeSource> {
    DodgeSource::ALL.get(usize::from(number.checked_sub(TPG_SOURCE_LEFT)?)).copied()
}

/// The behaviour of a number, which is its place in [`Behaviour::ALL`].
fn behaviour(number: u8) -> Behaviour {
    Behaviour::ALL.get(usize::from(number)).copied().unwrap_or(Behaviour::Hold)
}

/// Words of a tpg_dodger_t.
pub const TPG_DODGER_WORDS: usize = 42;

/// The state of a control loop among balls towards one target: the search, the places where the motors should be, the goals.
/// Opaque; initialised by tpg_dodger_init for every target. It belongs to one task.
#[repr(C)]
pub struct tpg_dodger_t {
    /// The library's.
    pub opaque: [u64; TPG_DODGER_WORDS],
}

/// The content of a tpg_dodger_t.
pub struct Loop {
    control: DodgeControl,
    body: &'static Body,
    chooser: DodgeChooser,
}

// SAFETY: any bytes are an array of integers; `initialise` proves that the content fits.
unsafe impl Opaque for tpg_dodger_t {
    type Content = Loop;
    const TAG: u32 = 0x444f_4401;
}

/// Gives an arm a body: a capsule around each of its links. `radii` are TPG_CAPSULES numbers, mm, or NULL: those of the WidowX.
/// TPG_ARGUMENT for a radius that is not above 0 and at most 1 m.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_body_init(body: *mut tpg_body_t, arm: *const tpg_arm_t, radii: *const f32) -> i32 {
    // SAFETY: the header's contract.
    let arm = unsafe { memory::content(arm) };
    code::from_result(arm.and_then(|Ready { arm, .. }| {
        let mut widths = WIDOWX_RADII;
        if !radii.is_null() {
            // SAFETY: the header's contract.
            widths = *unsafe { memory::read(radii.cast::<[f32; CAPSULES]>()) }?;
        }
        if !widths.iter().all(|&width| width > 0.0 && width <= 1000.0) {
            return Err(Refusal(TPG_ARGUMENT));
        }
        // SAFETY: the header's contract.
        unsafe { memory::initialise(body, Body::new(*arm, widths)) }
    }))
}

const _: () = assert!(
    size_of::<tpg_ball_t>() == size_of::<Ball>()
        && align_of::<tpg_ball_t>() == align_of::<Ball>()
        && offset_of!(tpg_ball_t, velocity) == offset_of!(Ball, velocity)
        && offset_of!(tpg_ball_t, radius) == offset_of!(Ball, radius),
    "a ball lies otherwise in C"
);

/// The balls that are seen; more than there may be are a reading that cannot be.
unsafe fn seen<'a>(balls: *const tpg_ball_t, count: usize) -> Result<&'a [Ball], Refusal> {
    if count == 0 {
        return Ok(&[]);
    }
    if count > BALLS {
        return Err(Refusal(TPG_BAD_SENSOR));
    }
    // SAFETY: the header's contract; the same numbers lie in the same order, as is asserted above.
    unsafe { memory::array(balls.cast::<Ball>(), count) }
}

/// Begins a control loop towards a target, which is given by the poses that solve it: one to TPG_GOALS `goals`, the nearest first.
/// `body` and `policy` must stay where they are for as long as the loop is used. `settings` and `watch` may be NULL: the defaults.
///
/// TPG_BAD_TARGET for no goal, too many, or one that is outside the joints' ranges or touches table or base. TPG_BAD_SENSOR as
/// tpg_dodger_step. TPG_ARGUMENT for settings, sources or behaviours that are not accepted.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_dodger_init(
    dodger: *mut tpg_dodger_t,
    body: *const tpg_body_t,
    policy: *const tpg_dodge_policy_t,
    settings: *const tpg_dodger_settings_t,
    watch: *const tpg_watch_t,
    goals: *const tpg_pose_t,
    goal_count: usize,
    motors: *const tpg_pose_t,
    balls: *const tpg_ball_t,
    ball_count: usize,
) -> i32 {
    let begin = || {
        // SAFETY: the header's contract; the caller keeps body and policy for as long as the loop lives.
        let (body, policy, settings, watch, motors) = unsafe {
            (
                memory::content::<'static, tpg_body_t>(body)?,
                memory::read(policy)?,
                tpg_dodger_settings_t::get(settings)?,
                tpg_watch_t::get(watch)?,
                memory::read(motors)?,
            )
        };
        // SAFETY: as above.
        let chooser = unsafe { DodgeChooser::new(policy) }?;
        let mut poses = [Pose([0; 4]); GOALS];
        // No more than there is room for are looked at; one more is refused below.
        // SAFETY: the header's contract.
        let wanted = unsafe { memory::array(goals, goal_count) }?;
        poses.iter_mut().zip(wanted).for_each(|(pose, goal)| *pose = Pose(goal.ticks));
        let poses = poses.get(..wanted.len()).unwrap_or(&[]);
        // SAFETY: the header's contract.
        let balls = unsafe { seen(balls, ball_count) }?;
        let control =
            DodgeControl::new(body, settings, watch, poses, Pose(motors.ticks), balls).map_err(code::fault)?;
        // SAFETY: the header's contract.
        unsafe { memory::initialise(dodger, Loop { control, body, chooser }) }
    };
    code::from_result(begin())
}

/// One step of a control loop: takes a reading of the motors and of up to TPG_BALLS `balls`, answers the move that goes to the motors
/// before the next step. `balls` may be NULL where there are none.
///
/// TPG_BAD_SENSOR for a motor outside its joint's range, more balls, or one that cannot be (see tpg_ball_t); TPG_STUCK for
/// motors that are not where the moves led them; docs/sensors.md has the contract. With any other code than TPG_OK the move is
/// zero, and the loop is as before: the next step with a good reading goes on. After TPG_STUCK it does once the motors are where
/// the moves led them, or after tpg_dodger_resume.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_dodger_step(
    dodger: *mut tpg_dodger_t,
    motors: *const tpg_pose_t,
    balls: *const tpg_ball_t,
    count: usize,
    chosen: *mut tpg_dodge_t,
) -> i32 {
    // SAFETY: the header's contract.
    let chosen = match unsafe { memory::write(chosen) } {
        Ok(chosen) => chosen,
        Err(refusal) => return code::from_result(Err(refusal)),
    };
    *chosen = tpg_dodge_t { wanted: tpg_move_t { ticks: Move::STOP.0 }, behaviour: TPG_BEHAVIOUR_HOLD };
    let mut step = || {
        // SAFETY: the header's contract.
        let (Loop { control, body, chooser }, motors) =
            unsafe { (memory::content_mut(dodger)?, memory::read(motors)?) };
        // SAFETY: the header's contract.
        let balls = unsafe { seen(balls, count) }?;
        let number = Cell::new(TPG_BEHAVIOUR_HOLD);
        let choose = |values: &[f32; VALUES]| {
            number.set(chooser.choose(values));
            behaviour(number.get())
        };
        let DodgeStep { wanted, .. } = control.step(body, &choose, Pose(motors.ticks), balls).map_err(code::fault)?;
        *chosen = tpg_dodge_t { wanted: tpg_move_t { ticks: wanted.0 }, behaviour: number.get() };
        Ok(())
    };
    code::from_result(step())
}

/// Starts to compare commanded with observed motion anew, from where the motors are: the way out of TPG_STUCK once its cause
/// is removed. The search goes on as it is. TPG_BAD_SENSOR for a motor outside its joint's range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_dodger_resume(dodger: *mut tpg_dodger_t, motors: *const tpg_pose_t) -> i32 {
    // SAFETY: the header's contract.
    let (content, motors) = unsafe { (memory::content_mut(dodger), memory::read(motors)) };
    code::from_result(content.and_then(|Loop { control, .. }| control.resume(Pose(motors?.ticks)).map_err(code::fault)))
}
