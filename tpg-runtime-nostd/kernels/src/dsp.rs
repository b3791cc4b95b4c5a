//! The kernels for Arm cores with the DSP extension (Cortex-M4, -M7).
//!
//! A block is one call of assembly: four accumulators in r8–r11, four words of weights in r4–r7, two words of inputs in
//! r12 and lr. Plain inline assembly could not have so many registers (r6 and r7 are the compiler's), so these are naked
//! functions. Eight columns a turn: 38 instructions for `i8` weights with `i16` activations, 24 for `i16` weights, 30 for
//! `i8` with `i8`, for 32 multiplications each.
#![expect(unsafe_code, reason = "packed multiplications have no name in stable Rust")]

use crate::{Form, Kind, ROWS};
use core::arch::naked_asm;
use core::mem::MaybeUninit;

// Every function takes a block of weights, its inputs, a number of turns of eight columns (at least 1), and where the
// result goes: two words, or four of a `raw` one.

/// Four columns of `i8` weights with `i16` activations. Uses r3.
macro_rules! w8a16 {
    () => {
        "
        ldmia r0!, {{r4-r7}}
        ldrd r12, lr, [r1], #8
        sxtb16 r3, r4
        sxtb16 r4, r4, ror #8
        smlad r8, r3, r12, r8
        smlad r8, r4, lr, r8
        sxtb16 r3, r5
        sxtb16 r5, r5, ror #8
        smlad r9, r3, r12, r9
        smlad r9, r5, lr, r9
        sxtb16 r3, r6
        sxtb16 r6, r6, ror #8
        smlad r10, r3, r12, r10
        smlad r10, r6, lr, r10
        sxtb16 r3, r7
        sxtb16 r7, r7, ror #8
        smlad r11, r3, r12, r11
        smlad r11, r7, lr, r11
        "
    };
}

/// Four columns of `i16` weights.
macro_rules! w16a16 {
    () => {
        "
        ldmia r0!, {{r4-r7}}
        ldrd r12, lr, [r1], #8
        smlad r8, r4, r12, r8
        smlad r9, r5, r12, r9
        smlad r10, r6, r12, r10
        smlad r11, r7, r12, r11
        ldmia r0!, {{r4-r7}}
        smlad r8, r4, lr, r8
        smlad r9, r5, lr, r9
        smlad r10, r6, lr, r10
        smlad r11, r7, lr, r11
        "
    };
}

/// Four columns of `i8` weights with `i8` activations.
macro_rules! w8a8 {
    () => {
        "
        ldmia r0!, {{r4-r7}}
        ldrd r12, lr, [r1], #8
        smlad r8, r4, lr, r8
        sxtb16 r4, r4
        smlad r9, r5, lr, r9
        sxtb16 r5, r5
        smlad r10, r6, lr, r10
        sxtb16 r6, r6
        smlad r11, r7, lr, r11
        sxtb16 r7, r7
        smlad r8, r4, r12, r8
        smlad r9, r5, r12, r9
        smlad r10, r6, r12, r10
        smlad r11, r7, r12, r11
        "
    };
}

/// Accumulators of `i8` activations are 256 times too great.
macro_rules! unscale {
    () => {
        "
        asr r8, r8, #8
        asr r9, r9, #8
        asr r10, r10, #8
        asr r11, r11, #8
        "
    };
}

/// Times the multipliers, rounded.
macro_rules! rescale {
    () => {
        "
        ldmia r0, {{r4-r7}}
        smmulr r8, r8, r4
        smmulr r9, r9, r5
        smmulr r10, r10, r6
        smmulr r11, r11, r7
        "
    };
}

/// The ReLU, and four outputs as two words of `i16` neighbours.
macro_rules! pairs {
    () => {
        "
        usat r8, #15, r8
        usat r9, #15, r9
        usat r10, #15, r10
        usat r11, #15, r11
        pkhbt r8, r8, r9, lsl #16
        pkhbt r9, r10, r11, lsl #16
        ldr r3, [sp]
        strd r8, r9, [r3]
        "
    };
}

/// The ReLU, and four outputs as the two words of [`Form::Split`].
macro_rules! split {
    () => {
        "
        usat r8, #7, r8
        usat r9, #7, r9
        usat r10, #7, r10
        usat r11, #7, r11
        rsb r8, r10, r8, lsl #8
        rsb r9, r11, r9, lsl #8
        pkhbt r8, r8, r9, lsl #16
        pkhbt r9, r10, r11, lsl #16
        ldr r3, [sp]
        strd r8, r9, [r3]
        "
    };
}

/// The accumulators themselves.
macro_rules! raw {
    () => {
        "
        ldr r3, [sp]
        stmia r3, {{r8-r11}}
        "
    };
}

macro_rules! block {
    ($name:ident: $columns:ident $(, $then:ident)*) => {
        #[unsafe(naked)]
        unsafe extern "C" fn $name(block: *const u32, inputs: *const u32, turns: usize, result: *mut u32) {
            naked_asm!(
                "push {{r3-r11, lr}}",
                "ldmia r0!, {{r8-r11}}",
                "2:",
                $columns!(),
                $columns!(),
                "subs r2, r2, #1",
                "bne 2b",
                $($then!(),)*
                "pop {{r3-r11, pc}}",
            )
        }
    };
}

block!(w8a16_pairs: w8a16, rescale, pairs);
block!(w8a16_split: w8a16, rescale, split);
block!(w8a16_raw: w8a16, raw);
block!(w16a16_pairs: w16a16, rescale, pairs);
block!(w16a16_split: w16a16, rescale, split);
block!(w16a16_raw: w16a16, raw);
block!(w8a8_pairs: w8a8, unscale, rescale, pairs);
block!(w8a8_split: w8a8, unscale, rescale, split);
block!(w8a8_raw: w8a8, raw);

/// One block of a hidden layer.
#[inline]
pub(crate) fn hidden(kind: Kind, form: Form, block: &[u32], inputs: &[u32]) -> [u32; 2] {
    let Some(turns) = turns(kind, block, inputs) else { return crate::portable::hidden(kind, form, block, inputs) };
    let mut result = MaybeUninit::<[u32; 2]>::uninit();
    let (block, inputs, to) = (block.as_ptr(), inputs.as_ptr(), result.as_mut_ptr().cast());
    // SAFETY: `turns` has checked what is read; each of these functions writes two words and keeps the registers that the
    // procedure call standard says are its caller's. (Called by name: a static bound does not follow pointers.)
    unsafe {
        match (kind, form) {
            (Kind::W8A16, Form::Pairs) => w8a16_pairs(block, inputs, turns, to),
            (Kind::W8A16, Form::Split) => w8a16_split(block, inputs, turns, to),
            (Kind::W16A16, Form::Pairs) => w16a16_pairs(block, inputs, turns, to),
            (Kind::W16A16, Form::Split) => w16a16_split(block, inputs, turns, to),
            (Kind::W8A8, Form::Pairs) => w8a8_pairs(block, inputs, turns, to),
            (Kind::W8A8, Form::Split) => w8a8_split(block, inputs, turns, to),
        }
        result.assume_init()
    }
}

/// The accumulators of a block's rows.
#[inline]
pub(crate) fn accumulate(kind: Kind, block: &[u32], inputs: &[u32]) -> [i32; ROWS] {
    let Some(turns) = turns(kind, block, inputs) else { return crate::portable::accumulate(kind, block, inputs) };
    let mut result = MaybeUninit::<[i32; ROWS]>::uninit();
    let (block, inputs, to) = (block.as_ptr(), inputs.as_ptr(), result.as_mut_ptr().cast());
    // SAFETY: as in `hidden`; these functions write four words.
    unsafe {
        match kind {
            Kind::W8A16 => w8a16_raw(block, inputs, turns, to),
            Kind::W16A16 => w16a16_raw(block, inputs, turns, to),
            Kind::W8A8 => w8a8_raw(block, inputs, turns, to),
        }
        result.assume_init()
    }
}

/// Number of turns that a kernel makes, if block and inputs are as long as it will read: 4 words of inputs and their weights a
/// turn, biases before them and multipliers behind.
#[inline(always)]
fn turns(kind: Kind, block: &[u32], inputs: &[u32]) -> Option<usize> {
    let whole = !inputs.is_empty() && inputs.len().is_multiple_of(4) && block.len() >= kind.block(inputs.len());
    whole.then_some(inputs.len() / 4)
}
