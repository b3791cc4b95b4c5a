//! Observations, and the sources of a graph that they fill.

use crate::arm::{Ready, tpg_arm_t, tpg_pose_t};
use crate::code::{self, Refusal, TPG_ARGUMENT, TPG_LENGTH};
use crate::memo::{self, tpg_memo_t};
use crate::memory;
use core::mem::{MaybeUninit, offset_of};
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_arm::{Arm, Pose};

/// The arm and its target as a policy sees them. tpg_observe makes one; fill in none by hand.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct tpg_observation_t {
    /// Motor positions.
    pub pose: tpg_pose_t,
    /// Positions of the servos that never move, ticks.
    pub fixed_servos: [i16; 2],
    /// The hand's tip, mm.
    pub hand: [f32; 3],
    /// The target, mm.
    pub target: [f32; 3],
    /// Target - hand, mm.
    pub difference: [f32; 3],
}

impl tpg_observation_t {
    pub(crate) fn get(&self) -> &Observation<f32> {
        // SAFETY: both are laid out as in C, with the same fields in the same places: see below.
        unsafe { &*core::ptr::from_ref(self).cast::<Observation<f32>>() }
    }

    pub(crate) fn get_mut(&mut self) -> &mut Observation<f32> {
        // SAFETY: as in `get`; any numbers are an observation.
        unsafe { &mut *core::ptr::from_mut(self).cast::<Observation<f32>>() }
    }
}

const _: () = {
    type Here = tpg_observation_t;
    type There = Observation<f32>;
    assert!(size_of::<Here>() == size_of::<There>() && align_of::<Here>() == align_of::<There>());
    assert!(offset_of!(Here, pose) == offset_of!(There, pose));
    assert!(offset_of!(Here, fixed_servos) == offset_of!(There, fixed_servos));
    assert!(offset_of!(Here, hand) == offset_of!(There, hand));
    assert!(offset_of!(Here, target) == offset_of!(There, target));
    assert!(offset_of!(Here, difference) == offset_of!(There, difference));
};

/// The most floats that the sources of a policy may have together.
pub const TPG_STATE_LENGTH: usize = 48;

/// The target: x, y, z in mm.
pub const TPG_SOURCE_TARGET: u8 = 0;
/// Target - hand: x, y, z in mm.
pub const TPG_SOURCE_DIFFERENCE: u8 = 1;
/// The hand's tip: x, y, z in mm.
pub const TPG_SOURCE_HAND: u8 = 2;
/// The four motor positions, ticks.
pub const TPG_SOURCE_MOTORS: u8 = 3;
/// All six servos, ticks.
pub const TPG_SOURCE_SERVOS: u8 = 4;
/// Errors in the shoulder's polar frame, 3 values in mm.
pub const TPG_SOURCE_POLAR: u8 = 5;
/// Height of the hand's lower corner, 1 value in mm.
pub const TPG_SOURCE_FLOOR: u8 = 6;
/// By how many ticks all four joints are off from a pose that reaches the target.
pub const TPG_SOURCE_STANCE: u8 = 7;

const _: () = assert!(TPG_SOURCE_STANCE as usize + 1 == Source::ALL.len(), "a source without a number");

/// The numbers above are the places in [`Source::ALL`].
pub(crate) fn source(number: u8) -> Result<Source, Refusal> {
    Source::ALL.get(usize::from(number)).copied().ok_or(Refusal(TPG_ARGUMENT))
}

/// Writes the values of sources, one after another; stops where `state` is full. All at once: they share what they are
/// made of.
pub(crate) fn fill(
    arm: &Arm<f32>,
    seen: &Observation<f32>,
    memo: &TargetMemo<f32>,
    numbers: &[u8],
    state: &mut [MaybeUninit<f32>],
) {
    let sources = numbers.iter().map_while(|&number| Source::ALL.get(usize::from(number)).copied());
    Source::fill_each(sources, arm, seen, memo, state);
}

/// Observes the arm at a pose, with the target's x, y, z in mm. It checks neither: a decision does.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_observe(
    arm: *const tpg_arm_t,
    pose: *const tpg_pose_t,
    target: *const f32,
    observation: *mut tpg_observation_t,
) -> i32 {
    // SAFETY: the header's contract.
    let (arm, pose, target, observation) = unsafe {
        let target = memory::read(target.cast::<[f32; 3]>());
        (memory::content(arm), memory::read(pose), target, memory::write(observation))
    };
    code::from_result(arm.and_then(|Ready { arm, .. }| {
        let (pose, target, observation) = (pose?, target?, observation?);
        *observation.get_mut() = Observation::at(arm, Pose(pose.ticks), *target);
        Ok(())
    }))
}

/// Hand to target, mm.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_observation_distance(observation: *const tpg_observation_t, distance: *mut f32) -> i32 {
    // SAFETY: the header's contract.
    let (seen, distance) = unsafe { (memory::read(observation), memory::write(distance)) };
    code::answer(seen.map(|seen| seen.get().distance()), distance)
}

/// Writes the values of `count` sources (TPG_SOURCE codes), one after another, into `state`: a generated policy's own
/// structure, say. TPG_LENGTH where `length` floats are too few, TPG_ARGUMENT for an unknown source.
///
/// `memo` is NULL, or keeps from call to call what depends on the target alone.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_observation_state(
    arm: *const tpg_arm_t,
    observation: *const tpg_observation_t,
    memo: *mut tpg_memo_t,
    sources: *const u8,
    count: usize,
    state: *mut f32,
    length: usize,
) -> i32 {
    // SAFETY: the header's contract.
    let (arm, seen, sources, state) = unsafe {
        (
            memory::content(arm),
            memory::read(observation),
            memory::array(sources, count),
            memory::array_mut(state.cast::<MaybeUninit<f32>>(), length),
        )
    };
    code::from_result(arm.and_then(|Ready { arm, .. }| {
        let (seen, sources, state) = (seen?.get(), sources?, state?);
        let mut wanted = 0usize;
        for &number in sources {
            wanted = wanted.saturating_add(source(number)?.length());
        }
        if state.len() < wanted || sources.len() > TPG_STATE_LENGTH {
            return Err(Refusal(TPG_LENGTH));
        }
        // SAFETY: the header's contract.
        unsafe { memo::with(memo, arm, |memo| fill(arm, seen, memo, sources, state)) }
    }))
}
