//! The kernels for Arm cores with Thumb-2 instructions: Cortex-M4 and -M7 by SMLAD, Cortex-M3 and -M33 by MLA.
//!
//! A hidden layer is one call of assembly, and so is a block of the last one: four accumulators in r8–r11, four words of
//! weights in r4–r7, inputs in r12 and lr. Plain inline assembly could not have so many registers (r6 and r7 are the compiler's),
//! so these are naked functions. `dsp` and `plain` have what differs between the cores.
#![expect(
    unsafe_code,
    reason = "packed multiplications have no name in stable Rust, and its plain loops run out of registers"
)]

#[cfg(tpg_dsp)]
#[macro_use]
mod dsp;
#[cfg(not(tpg_dsp))]
#[macro_use]
mod plain;

use crate::{Kind, ROWS, TURN};
use core::arch::naked_asm;

/// A hidden layer: its blocks, their inputs, a number of turns of eight columns, the place of two words for each block, and its
/// end. Turns and blocks are at least 1.
macro_rules! layer {
    ($name:ident: $columns:ident $(, $then:ident)*) => {
        #[unsafe(naked)]
        unsafe extern "C" fn $name(
            blocks: *const u32, inputs: *const u32, turns: usize, results: *mut u32, end: *const u32,
        ) {
            naked_asm!(
                "push {{r4-r11, lr}}",
                "ldr r12, [sp, #36]",
                "push {{r1-r3, r12}}",
                "2:",
                "ldmia r0!, {{r8-r11}}",
                "ldrd r1, r2, [sp]",
                "3:",
                $columns!(),
                $columns!(),
                "subs r2, r2, #1",
                "bne 3b",
                $($then!(),)*
                "ldrd r3, r12, [sp, #8]",
                "strd r8, r9, [r3], #8",
                "cmp r3, r12",
                "str r3, [sp, #8]",
                "bne 2b",
                "add sp, #16",
                "pop {{r4-r11, pc}}",
            )
        }
    };
}

/// The accumulators of a block: its weights, their inputs, a number of turns of eight columns (at least 1), and the place of four
/// words.
macro_rules! block {
    ($name:ident: $columns:ident) => {
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
                "ldr r3, [sp]",
                "stmia r3, {{r8-r11}}",
                "pop {{r3-r11, pc}}",
            )
        }
    };
}

layer!(w8a16_layer: w8a16, rescale, pairs);
layer!(w16a16_layer: w16a16, rescale, pairs);
block!(w8a16_raw: w8a16);
block!(w16a16_raw: w16a16);

/// A hidden layer of whole turns.
#[inline]
pub(crate) fn layer(kind: Kind, blocks: &[u32], inputs: &[u32], outputs: &mut [u32]) {
    let count = (blocks.len() / kind.block(inputs.len())).min(outputs.len() / 2);
    let (Some(turns), Some(outputs)) = (turns(inputs), outputs.get_mut(..2 * count)) else { return };
    if outputs.is_empty() {
        return;
    }
    let (blocks, inputs, to) = (blocks.as_ptr(), inputs.as_ptr(), outputs.as_mut_ptr_range());
    // SAFETY: there are `count` blocks for these inputs, and as many pairs of words; each of these functions keeps the registers
    // that the procedure call standard says are its caller's. (Called by name: a static bound does not follow pointers.)
    unsafe {
        match kind {
            Kind::W8A16 => w8a16_layer(blocks, inputs, turns, to.start, to.end),
            Kind::W16A16 => w16a16_layer(blocks, inputs, turns, to.start, to.end),
        }
    }
}

/// The accumulators of a whole block's rows, or zeros.
#[inline]
pub(crate) fn accumulate(kind: Kind, block: &[u32], inputs: &[u32]) -> [i32; ROWS] {
    let mut result = [0; ROWS];
    let Some(turns) = turns(inputs).filter(|_| block.len() >= kind.block(inputs.len())) else { return result };
    let (block, inputs, to) = (block.as_ptr(), inputs.as_ptr(), result.as_mut_ptr().cast());
    // SAFETY: as in `layer`; the block is whole, and these functions write four words.
    unsafe {
        match kind {
            Kind::W8A16 => w8a16_raw(block, inputs, turns, to),
            Kind::W16A16 => w16a16_raw(block, inputs, turns, to),
        }
    }
    result
}

/// Number of turns that a kernel makes: [`TURN`] words of inputs each. `None` where there is none, or not a whole one.
#[inline(always)]
fn turns(inputs: &[u32]) -> Option<usize> {
    crate::whole(inputs).then_some(inputs.len() / TURN)
}
