//! One episode.

use crate::arm::{Ready, TPG_VALID, tpg_arm_t, tpg_move_t, tpg_pose_t, validity};
use crate::code::{self, Refusal, TPG_BAD_SENSOR, TPG_BAD_TARGET, TPG_STATE};
use crate::memory::{self, Opaque};
use crate::observation::tpg_observation_t;
use tpg_arm::cycle::Brent;
use tpg_arm::episode::{Episode, Outcome, ReachTask};
use tpg_arm::sensors::Limits;
use tpg_arm::{Move, Pose};

/// The episode goes on.
pub const TPG_RUNNING: i32 = 0;
/// The hand is at its target: the only success.
pub const TPG_REACHED: i32 = 1;
/// The policy chose not to move.
pub const TPG_STOP: i32 = 2;
/// A pose repeats: a memoryless policy will never leave the cycle.
pub const TPG_CYCLE: i32 = 3;
/// The action limit was reached.
pub const TPG_TIMEOUT: i32 = 4;
/// The policy asked for something impossible; a TPG_LIMIT or TPG_COLLISION code is added.
pub const TPG_INVALID: i32 = 16;

/// A task for the arm.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct tpg_problem_t {
    /// The pose in which the arm starts.
    pub start: tpg_pose_t,
    /// The place where the hand's tip shall go, mm.
    pub target: [f32; 3],
    /// The episode succeeds when hand and target are less than this apart, mm.
    pub tolerance: f32,
    /// After this many actions it is over.
    pub max_actions: u32,
}

impl tpg_problem_t {
    /// The problem, if an arm of these limits can be at its start and reach its target.
    pub(crate) fn get(&self, limits: &Limits<f32>) -> Result<ReachTask<f32>, Refusal> {
        let Self { start, target, tolerance, max_actions } = *self;
        let start = Pose(start.ticks);
        if !limits.reaches(&target) {
            Err(Refusal(TPG_BAD_TARGET))
        } else if !limits.hold(start) {
            Err(Refusal(TPG_BAD_SENSOR))
        } else {
            Ok(ReachTask { start, target, tolerance, max_actions })
        }
    }
}

/// Words of a tpg_episode_t.
pub const TPG_EPISODE_WORDS: usize = 16;

/// An episode under way. Opaque; initialised by tpg_episode_init.
#[repr(C)]
pub struct tpg_episode_t {
    /// The library's.
    pub opaque: [u64; TPG_EPISODE_WORDS],
}

/// An episode, and a note that it is over.
pub struct Running<E> {
    pub(crate) episode: E,
    over: bool,
}

impl<E> Running<E> {
    /// At its start.
    pub(crate) fn new(episode: E) -> Self {
        Self { episode, over: false }
    }

    /// Does an action; returns how that ends the episode, as a code.
    #[inline(always)]
    pub(crate) fn act(&mut self, action: impl FnOnce(&mut E) -> Option<Outcome>) -> Result<i32, Refusal> {
        if self.over {
            return Err(Refusal(TPG_STATE));
        }
        let end = action(&mut self.episode);
        self.over = end.is_some();
        Ok(outcome_code(end))
    }
}

// SAFETY: any bytes are an array of integers; `initialise` proves that the content fits.
unsafe impl Opaque for tpg_episode_t {
    type Content = Running<Episode<'static, f32, Brent>>;
    const TAG: u32 = 0x4550_4901;
}

fn outcome_code(outcome: Option<Outcome>) -> i32 {
    match outcome {
        None => TPG_RUNNING,
        Some(Outcome::Reached) => TPG_REACHED,
        Some(Outcome::Stop) => TPG_STOP,
        Some(Outcome::Cycle) => TPG_CYCLE,
        Some(Outcome::Timeout) => TPG_TIMEOUT,
        Some(Outcome::Invalid(invalid)) => (TPG_INVALID - TPG_VALID) + validity(Some(invalid)),
    }
}

/// Puts an arm at a problem's start. `arm` must stay where it is for as long as the episode is used. TPG_BAD_TARGET for a
/// target out of reach, TPG_BAD_SENSOR for a start outside the joints' ranges.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_episode_init(
    episode: *mut tpg_episode_t,
    arm: *const tpg_arm_t,
    problem: *const tpg_problem_t,
) -> i32 {
    // SAFETY: the header's contract; the caller keeps the arm for as long as the episode lives.
    let (arm, problem) = unsafe { (memory::content::<'static, _>(arm), memory::read(problem)) };
    code::from_result(arm.and_then(|Ready { arm, limits }: &'static Ready| {
        let running = Running::new(Episode::new(arm, problem?.get(limits)?, Brent::new()));
        // SAFETY: the header's contract.
        unsafe { memory::initialise(episode, running) }
    }))
}

/// Gives what a policy sees now.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_episode_observation(
    episode: *const tpg_episode_t,
    observation: *mut tpg_observation_t,
) -> i32 {
    // SAFETY: the header's contract.
    let (content, observation) = unsafe { (memory::content(episode), memory::write(observation)) };
    code::answer(content.map(|content| tpg_observation_t::new(content.episode.observation())), observation)
}

/// Actions done so far.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_episode_actions(episode: *const tpg_episode_t, actions: *mut u32) -> i32 {
    // SAFETY: the header's contract.
    let (content, actions) = unsafe { (memory::content(episode), memory::write(actions)) };
    code::answer(content.map(|content| content.episode.actions()), actions)
}

/// Does one action. `outcome` is TPG_RUNNING, or how the episode ended: TPG_REACHED, TPG_STOP, TPG_CYCLE, TPG_TIMEOUT, or
/// TPG_INVALID + a code of TPG_LIMIT or TPG_COLLISION. An episode that is over answers TPG_STATE.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_episode_advance(
    episode: *mut tpg_episode_t,
    wanted: *const tpg_move_t,
    outcome: *mut i32,
) -> i32 {
    // SAFETY: the header's contract.
    let (content, wanted, outcome) =
        unsafe { (memory::content_mut(episode), memory::read(wanted), memory::write(outcome)) };
    code::from_result(content.and_then(|content| {
        // Nothing is done where its result has no place.
        let (wanted, outcome) = (wanted?, outcome?);
        *outcome = content.act(|episode| episode.advance(Move(wanted.ticks)))?;
        Ok(())
    }))
}
