//! The codes that functions answer.

use crate::arm::tpg_move_t;
use tpg_arm::Move;
use tpg_arm::sensors::Fault;

/// All went well.
pub const TPG_OK: i32 = 0;
/// A pointer is NULL.
pub const TPG_NULL: i32 = 1;
/// A pointer is not aligned for its type.
pub const TPG_MISALIGNED: i32 = 2;
/// A buffer is too short, or longer than memory can be.
pub const TPG_LENGTH: i32 = 3;
/// A structure was not initialised, or not by this version of the library.
pub const TPG_STATE: i32 = 4;
/// A number outside the accepted range.
pub const TPG_ARGUMENT: i32 = 5;
/// The words are no model: they do not begin like one.
pub const TPG_MODEL: i32 = 6;
/// The model is damaged: its checksum is another.
pub const TPG_MODEL_CHECKSUM: i32 = 7;
/// The model was made for another problem: other inputs, or another kind of answer.
pub const TPG_MODEL_FEATURES: i32 = 8;
/// The model's layers do not fit each other, or exceed what the library takes.
pub const TPG_MODEL_LAYERS: i32 = 9;
/// The model is of another version of the format than this library's: pack it again.
pub const TPG_MODEL_VERSION: i32 = 10;

/// The target is no number, or farther from the shoulder than the stretched arm reaches. Nothing may move.
pub const TPG_BAD_TARGET: i32 = 11;
/// A motor is outside its joint's range, or hand, target and difference of an observation do not belong together. Nothing
/// may move.
pub const TPG_BAD_SENSOR: i32 = 12;
/// The motors are not where the commands led them: stuck, moved by something else, or read too late. Nothing may move.
pub const TPG_STUCK: i32 = 13;

/// The code of a reading that a control step refuses.
pub fn fault(fault: Fault) -> Refusal {
    Refusal(match fault {
        Fault::Target => TPG_BAD_TARGET,
        Fault::Sensor => TPG_BAD_SENSOR,
        Fault::Stuck => TPG_STUCK,
    })
}

/// The reason why a function did nothing: a code other than [`TPG_OK`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Refusal(pub i32);

/// Writes what a function found to where the caller wants it; returns the code.
#[inline(always)]
pub fn answer<T>(found: Result<T, Refusal>, to: Result<&mut T, Refusal>) -> i32 {
    from_result(found.and_then(|found| {
        *to? = found;
        Ok(())
    }))
}

/// Writes a move that was decided on, or zero where there is none; returns the code.
#[inline(always)]
pub(crate) fn moves(decided: Result<Move, Refusal>, to: Result<&mut tpg_move_t, Refusal>) -> i32 {
    from_result(to.and_then(|to| {
        let Move(ticks) = decided.unwrap_or(Move::STOP);
        *to = tpg_move_t { ticks };
        decided.map(|_| ())
    }))
}

/// The code of a result.
#[inline(always)]
pub fn from_result(result: Result<(), Refusal>) -> i32 {
    match result {
        Ok(()) => TPG_OK,
        Err(Refusal(code)) => code,
    }
}
