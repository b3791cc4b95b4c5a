//! The sensor contract: the watch over motors, for control loops without a hybrid.

use crate::arm::{Ready, tpg_arm_t, tpg_move_t, tpg_pose_t};
use crate::code::{self, Refusal, TPG_ARGUMENT};
use crate::memory::{self, Opaque};
use tpg_arm::sensors::{Watch, Watchdog};
use tpg_arm::{Move, Pose};

/// Default threshold of a tpg_watch_t, ticks: 2.8 degrees.
pub const TPG_WATCH_THRESHOLD: u16 = 32;

/// Default patience of a tpg_watch_t, steps.
pub const TPG_WATCH_PATIENCE: u16 = 64;

/// A threshold that never finds a motor stuck, ticks.
pub const TPG_WATCH_NEVER: u16 = 4096;

const _: () = assert!(TPG_WATCH_THRESHOLD == Watch::DEFAULT.threshold && TPG_WATCH_PATIENCE == Watch::DEFAULT.patience);

/// The difference that commanded and observed motion may have.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct tpg_watch_t {
    /// Ticks that a motor may be away from where the commands led it, up to TPG_WATCH_NEVER.
    pub threshold: u16,
    /// Steps over which differences add up, from 1; then the comparison starts anew from where the motors are. With a
    /// patience greater than the threshold a motor is found that is asked for a tick a step and does not move.
    pub patience: u16,
}

impl tpg_watch_t {
    /// The settings behind a pointer, or the default ones for NULL.
    ///
    /// # Safety
    /// The header's contract.
    pub(crate) unsafe fn get(pointer: *const Self) -> Result<Watch, Refusal> {
        if pointer.is_null() {
            return Ok(Watch::DEFAULT);
        }
        // SAFETY: the header's contract.
        let &Self { threshold, patience } = unsafe { memory::read(pointer) }?;
        if threshold > TPG_WATCH_NEVER || patience == 0 {
            return Err(Refusal(TPG_ARGUMENT));
        }
        Ok(Watch { threshold, patience })
    }
}

/// Words of a tpg_watchdog_t.
pub const TPG_WATCHDOG_WORDS: usize = 6;

/// The watch over an arm's motors, for control loops without a hybrid: tpg_watchdog_check before every decision,
/// tpg_watchdog_commanded after it. A tpg_switch_t holds one of its own. Opaque; initialised by tpg_watchdog_init.
#[repr(C)]
pub struct tpg_watchdog_t {
    /// The library's.
    pub opaque: [u64; TPG_WATCHDOG_WORDS],
}

// SAFETY: any bytes are an array of integers; `initialise` proves that the content fits.
unsafe impl Opaque for tpg_watchdog_t {
    type Content = Watchdog<f32>;
    const TAG: u32 = 0x5744_4701;
}

/// Starts to watch an arm whose motors are at `motors`. `watch` may be NULL: the defaults. TPG_BAD_SENSOR for a motor outside its
/// joint's range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_watchdog_init(
    watchdog: *mut tpg_watchdog_t,
    arm: *const tpg_arm_t,
    watch: *const tpg_watch_t,
    motors: *const tpg_pose_t,
) -> i32 {
    // SAFETY: the header's contract.
    let (arm, watch, motors) = unsafe { (memory::content(arm), tpg_watch_t::get(watch), memory::read(motors)) };
    code::from_result(arm.and_then(|Ready { limits, .. }| {
        let watching = Watchdog::new(*limits, watch?, Pose(motors?.ticks)).map_err(code::fault)?;
        // SAFETY: the header's contract.
        unsafe { memory::initialise(watchdog, watching) }
    }))
}

/// Checks a reading of the motors and a target, x, y, z in mm: TPG_BAD_TARGET, TPG_BAD_SENSOR or TPG_STUCK where nothing may
/// move.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_watchdog_check(
    watchdog: *const tpg_watchdog_t,
    motors: *const tpg_pose_t,
    target: *const f32,
) -> i32 {
    // SAFETY: the header's contract.
    let (watchdog, motors, target) =
        unsafe { (memory::content(watchdog), memory::read(motors), memory::read(target.cast::<[f32; 3]>())) };
    code::from_result(watchdog.and_then(|watchdog| watchdog.check(Pose(motors?.ticks), target?).map_err(code::fault)))
}

/// Notes a move that goes to the motors, and the positions at which it was decided on.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_watchdog_commanded(
    watchdog: *mut tpg_watchdog_t,
    motors: *const tpg_pose_t,
    wanted: *const tpg_move_t,
) -> i32 {
    // SAFETY: the header's contract.
    let (watchdog, motors, wanted) =
        unsafe { (memory::content_mut(watchdog), memory::read(motors), memory::read(wanted)) };
    code::from_result(watchdog.and_then(|watchdog| {
        let (motors, wanted) = (Pose(motors?.ticks), Move(wanted?.ticks));
        watchdog.commanded(motors, wanted);
        Ok(())
    }))
}

/// Starts to compare anew, from where the motors are: the way out of TPG_STUCK once its cause is removed. TPG_BAD_SENSOR for
/// a motor outside its joint's range.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_watchdog_resume(watchdog: *mut tpg_watchdog_t, motors: *const tpg_pose_t) -> i32 {
    // SAFETY: the header's contract.
    let (watchdog, motors) = unsafe { (memory::content_mut(watchdog), memory::read(motors)) };
    code::from_result(watchdog.and_then(|watchdog| watchdog.resume(Pose(motors?.ticks)).map_err(code::fault)))
}
