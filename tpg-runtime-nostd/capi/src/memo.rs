//! The parts of sources that depend on the target alone, kept in the caller's memory.

use crate::code::{self, Refusal};
use crate::memory::{self, Opaque};
use core::ptr;
use tpg_arm::Arm;
use tpg_arm::observation::TargetMemo;

/// Words of a tpg_memo_t.
pub const TPG_MEMO_WORDS: usize = 12;

/// Values about a target, kept while decisions ask for the same one. It changes no result and saves most of the
/// cost of sources that take inverse tangents or collision tests. Opaque; initialised by tpg_memo_init. For one task at a
/// time.
#[repr(C)]
pub struct tpg_memo_t {
    /// The library's.
    pub opaque: [u64; TPG_MEMO_WORDS],
}

/// A memo and the arm that it is about.
pub struct Kept {
    arm: *const Arm<f32>,
    memo: TargetMemo<f32>,
}

// SAFETY: any bytes are an array of integers; `initialise` proves that the content fits.
unsafe impl Opaque for tpg_memo_t {
    type Content = Kept;
    const TAG: u32 = 0x4d45_4d01;
}

/// Empties a memo: before its first use, and after the arm that it was used with was initialised anew.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_memo_init(memo: *mut tpg_memo_t) -> i32 {
    // SAFETY: the header's contract.
    code::from_result(unsafe { memory::initialise(memo, Kept { arm: ptr::null(), memo: TargetMemo::new() }) })
}

/// Lets `work` use the caller's memo; an empty one where that is NULL. Another arm than the last time empties it.
///
/// # Safety
/// The header's contract.
#[inline(always)]
pub(crate) unsafe fn with<T>(
    pointer: *mut tpg_memo_t,
    arm: &Arm<f32>,
    work: impl FnOnce(&TargetMemo<f32>) -> T,
) -> Result<T, Refusal> {
    if pointer.is_null() {
        return Ok(work(&TargetMemo::new()));
    }
    // SAFETY: the header's contract.
    let kept = unsafe { memory::content_mut(pointer) }?;
    if !ptr::eq(kept.arm, arm) {
        *kept = Kept { arm, memo: TargetMemo::new() };
    }
    Ok(work(&kept.memo))
}
