//! The hook for policies that `tpg-codegen` compiled.

use crate::arm::{Ready, tpg_arm_t, tpg_move_t};
use crate::code::{self, Refusal, TPG_LENGTH, TPG_NULL};
use crate::memo::{self, tpg_memo_t};
use crate::memory;
use crate::observation::{TPG_STATE_LENGTH, fill, source, tpg_observation_t};
use core::mem::MaybeUninit;
use tpg_arm::observation::{Observation, TargetMemo};
use tpg_arm::{Arm, Move};

/// A generated `PREFIX_infer` behind a pointer of one type for all: `return (uint16_t)PREFIX_infer(state);`.
pub type tpg_infer_t = Option<unsafe extern "C" fn(state: *const core::ffi::c_void) -> u16>;

/// A policy that tpg-codegen compiled, in f32. Constant: it can lie in flash.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct tpg_policy_t {
    /// The decision. Its argument points to the sources' values, aligned for the generated structure.
    pub infer: tpg_infer_t,
    /// TPG_SOURCE codes, in order: PREFIX_SOURCES of the generated header.
    pub sources: *const u8,
    /// Number of sources.
    pub source_count: usize,
    /// The move of each action: PREFIX_MOVES of the generated header. An action past the end moves nothing.
    pub moves: *const tpg_move_t,
    /// Number of moves.
    pub move_count: usize,
}

/// A policy's parts, checked: its function, sources and moves.
pub(crate) struct Checked<'a> {
    infer: unsafe extern "C" fn(state: *const core::ffi::c_void) -> u16,
    sources: &'a [u8],
    moves: &'a [tpg_move_t],
}

impl<'a> Checked<'a> {
    /// Checks a policy.
    ///
    /// # Safety
    /// The header's contract; the policy's arrays live as long as the result.
    pub(crate) unsafe fn new(policy: &tpg_policy_t) -> Result<Self, Refusal> {
        let infer = policy.infer.ok_or(Refusal(TPG_NULL))?;
        // SAFETY: the header's contract.
        let sources = unsafe { memory::array(policy.sources, policy.source_count) }?;
        // SAFETY: the header's contract.
        let moves = unsafe { memory::array(policy.moves, policy.move_count) }?;
        let mut length = 0usize;
        for &number in sources {
            length = length.saturating_add(source(number)?.length());
        }
        if length > TPG_STATE_LENGTH { Err(Refusal(TPG_LENGTH)) } else { Ok(Self { infer, sources, moves }) }
    }

    /// The move.
    pub(crate) fn decide(&self, arm: &Arm<f32>, seen: &Observation<f32>, memo: &TargetMemo<f32>) -> Move {
        let mut state = [const { MaybeUninit::<f32>::uninit() }; TPG_STATE_LENGTH];
        fill(arm, seen, memo, self.sources, &mut state);
        // SAFETY: the header asks for the function of these sources: it reads no more than they have written, which
        // `Checked::new` has found to be no more than there is room for.
        let action = unsafe { (self.infer)(state.as_ptr().cast()) };
        self.moves.get(usize::from(action)).map_or(Move::STOP, |moved| Move(moved.ticks))
    }
}

/// The move that a generated policy decides for. TPG_BAD_TARGET or TPG_BAD_SENSOR, and a move of zero, for an observation
/// that cannot be; docs/sensors.md has the contract. Stuck motors it cannot see: see tpg_watchdog_t.
///
/// `memo` is NULL, or keeps from call to call what depends on the target alone.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_policy_decide(
    policy: *const tpg_policy_t,
    arm: *const tpg_arm_t,
    observation: *const tpg_observation_t,
    memo: *mut tpg_memo_t,
    wanted: *mut tpg_move_t,
) -> i32 {
    // SAFETY: the header's contract.
    let (policy, arm, seen, wanted) =
        unsafe { (memory::read(policy), memory::content(arm), memory::read(observation), memory::write(wanted)) };
    let decided = policy.and_then(|policy| {
        // SAFETY: the header's contract.
        let policy = unsafe { Checked::new(policy) }?;
        let (Ready { arm, limits }, seen) = (arm?, seen?.get());
        limits.check(seen).map_err(code::fault)?;
        // SAFETY: the header's contract.
        unsafe { memo::with(memo, arm, |memo| policy.decide(arm, seen, memo)) }
    });
    code::moves(decided, wanted)
}
