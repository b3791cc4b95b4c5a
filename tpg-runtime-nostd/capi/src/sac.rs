//! The arm's network in integers: a preference for each joint.

use crate::arm::{Ready, tpg_arm_t, tpg_move_t};
use crate::code::{self, Refusal, TPG_LENGTH};
use crate::memory::{self, Opaque};
use crate::network::model_code;
use crate::observation::tpg_observation_t;
use tpg_arm::sac::packed::Model;

/// Words of a tpg_sac_t.
pub const TPG_SAC_WORDS: usize = 30;

/// The arm's network in integers, checked. Opaque; initialised by tpg_sac_init, constant from then on.
#[repr(C)]
pub struct tpg_sac_t {
    /// The library's.
    pub opaque: [u64; TPG_SAC_WORDS],
}

// SAFETY: any bytes are an array of integers; `initialise` proves that the content fits.
unsafe impl Opaque for tpg_sac_t {
    type Content = Model<'static>;
    const TAG: u32 = 0x5341_4301;
}

/// Checks a model of `words` 32-bit words and borrows it: it must stay where it is and as it is, in flash say, for as long
/// as `sac` is used.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_sac_init(sac: *mut tpg_sac_t, model: *const u32, words: usize) -> i32 {
    // SAFETY: the header's contract; the caller keeps the words for as long as `sac` lives.
    code::from_result(unsafe { memory::array::<'static, u32>(model, words) }.and_then(|words| {
        let model = Model::parse(words).map_err(model_code)?;
        // SAFETY: the header's contract.
        unsafe { memory::initialise(sac, model) }
    }))
}

/// Gives the 32-bit words of scratch memory that tpg_sac_decide needs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_sac_scratch(sac: *const tpg_sac_t, words: *mut usize) -> i32 {
    // SAFETY: the header's contract.
    let (model, words) = unsafe { (memory::content(sac), memory::write(words)) };
    code::answer(model.map(Model::scratch), words)
}

/// The move that a network decides for. `scratch` is overwritten; TPG_LENGTH where `words` are too few. TPG_BAD_TARGET or
/// TPG_BAD_SENSOR, and a move of zero, for an observation that cannot be; docs/sensors.md has the contract.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_sac_decide(
    sac: *const tpg_sac_t,
    arm: *const tpg_arm_t,
    observation: *const tpg_observation_t,
    scratch: *mut u32,
    words: usize,
    wanted: *mut tpg_move_t,
) -> i32 {
    // SAFETY: the header's contract.
    let (model, arm, seen, scratch, wanted) = unsafe {
        (
            memory::content(sac),
            memory::content(arm),
            memory::read(observation),
            memory::array_mut(scratch, words),
            memory::write(wanted),
        )
    };
    let decided = model.and_then(|model| {
        let (Ready { arm, limits }, seen, scratch) = (arm?, seen?.get(), scratch?);
        limits.check(seen).map_err(code::fault)?;
        if scratch.len() < model.scratch() {
            return Err(Refusal(TPG_LENGTH));
        }
        Ok(model.decide(arm, seen, scratch))
    });
    code::moves(decided, wanted)
}
