//! The kernels for Arm cores with the first Thumb instructions: Cortex-M0, -M0+, -M23.
//!
//! Such a core multiplies in one cycle (or 32), adds in another, and has eight registers for both. So accumulators are in r8–r11,
//! where only additions reach them, and the low registers hold four inputs, a word of weights and one of them. Eight columns a turn:
//! 133 instructions for `i8` weights, 118 for `i16` weights, for 32 multiplications each. A compiler spills.
#![expect(unsafe_code, reason = "a compiler keeps no accumulators in the upper registers")]

use crate::{Kind, ROWS};
use core::arch::naked_asm;

/// Four columns of `i8` weights.
macro_rules! w8a16 {
    () => {
        "
        ldmia r1!, {{r4, r6}}
        asrs r5, r4, #16
        sxth r4, r4
        asrs r7, r6, #16
        sxth r6, r6
        ldmia r0!, {{r2}}
        sxtb r3, r2
        muls r3, r4, r3
        add r8, r3
        lsrs r3, r2, #8
        sxtb r3, r3
        muls r3, r6, r3
        add r8, r3
        lsrs r3, r2, #16
        sxtb r3, r3
        muls r3, r5, r3
        add r8, r3
        asrs r2, r2, #24
        muls r2, r7, r2
        add r8, r2
        ldmia r0!, {{r2}}
        sxtb r3, r2
        muls r3, r4, r3
        add r9, r3
        lsrs r3, r2, #8
        sxtb r3, r3
        muls r3, r6, r3
        add r9, r3
        lsrs r3, r2, #16
        sxtb r3, r3
        muls r3, r5, r3
        add r9, r3
        asrs r2, r2, #24
        muls r2, r7, r2
        add r9, r2
        ldmia r0!, {{r2}}
        sxtb r3, r2
        muls r3, r4, r3
        add r10, r3
        lsrs r3, r2, #8
        sxtb r3, r3
        muls r3, r6, r3
        add r10, r3
        lsrs r3, r2, #16
        sxtb r3, r3
        muls r3, r5, r3
        add r10, r3
        asrs r2, r2, #24
        muls r2, r7, r2
        add r10, r2
        ldmia r0!, {{r2}}
        sxtb r3, r2
        muls r3, r4, r3
        add r11, r3
        lsrs r3, r2, #8
        sxtb r3, r3
        muls r3, r6, r3
        add r11, r3
        lsrs r3, r2, #16
        sxtb r3, r3
        muls r3, r5, r3
        add r11, r3
        asrs r2, r2, #24
        muls r2, r7, r2
        add r11, r2
        "
    };
}

/// Four columns of `i16` weights.
macro_rules! w16a16 {
    () => {
        "
        ldmia r1!, {{r4}}
        asrs r5, r4, #16
        sxth r4, r4
        ldmia r0!, {{r2, r6}}
        sxth r3, r2
        muls r3, r4, r3
        add r8, r3
        asrs r2, r2, #16
        muls r2, r5, r2
        add r8, r2
        sxth r3, r6
        muls r3, r4, r3
        add r9, r3
        asrs r6, r6, #16
        muls r6, r5, r6
        add r9, r6
        ldmia r0!, {{r2, r6}}
        sxth r3, r2
        muls r3, r4, r3
        add r10, r3
        asrs r2, r2, #16
        muls r2, r5, r2
        add r10, r2
        sxth r3, r6
        muls r3, r4, r3
        add r11, r3
        asrs r6, r6, #16
        muls r6, r5, r6
        add r11, r6
        ldmia r1!, {{r4}}
        asrs r5, r4, #16
        sxth r4, r4
        ldmia r0!, {{r2, r6}}
        sxth r3, r2
        muls r3, r4, r3
        add r8, r3
        asrs r2, r2, #16
        muls r2, r5, r2
        add r8, r2
        sxth r3, r6
        muls r3, r4, r3
        add r9, r3
        asrs r6, r6, #16
        muls r6, r5, r6
        add r9, r6
        ldmia r0!, {{r2, r6}}
        sxth r3, r2
        muls r3, r4, r3
        add r10, r3
        asrs r2, r2, #16
        muls r2, r5, r2
        add r10, r2
        sxth r3, r6
        muls r3, r4, r3
        add r11, r3
        asrs r6, r6, #16
        muls r6, r5, r6
        add r11, r6
        "
    };
}

/// The accumulators of a block: its weights, their inputs, the end of these (whole turns of eight columns, at least one), and the place
/// of four words. Last the branch to the next turn.
macro_rules! block {
    ($name:ident: $columns:ident, $again:literal) => {
        #[unsafe(naked)]
        unsafe extern "C" fn $name(block: *const u32, inputs: *const u32, end: *const u32, result: *mut u32) {
            naked_asm!(
                "push {{r3-r7, lr}}",
                "mov r4, r8",
                "mov r5, r9",
                "mov r6, r10",
                "mov r7, r11",
                "push {{r4-r7}}",
                "mov r12, r2",
                "ldmia r0!, {{r4-r7}}",
                "mov r8, r4",
                "mov r9, r5",
                "mov r10, r6",
                "mov r11, r7",
                "2:",
                $columns!(),
                $columns!(),
                "cmp r1, r12",
                $again,
                "mov r4, r8",
                "mov r5, r9",
                "mov r6, r10",
                "mov r7, r11",
                "ldr r3, [sp, #16]",
                "stmia r3!, {{r4-r7}}",
                "pop {{r4-r7}}",
                "mov r8, r4",
                "mov r9, r5",
                "mov r10, r6",
                "mov r11, r7",
                "pop {{r3-r7, pc}}",
            )
        }
    };
}

// Too far for a conditional branch of this core.
block!(w8a16_raw: w8a16, "beq 3f\nb 2b\n3:");
block!(w16a16_raw: w16a16, "bne 2b");

/// The accumulators of a whole block's rows, or zeros.
#[inline]
pub(crate) fn accumulate(kind: Kind, block: &[u32], inputs: &[u32]) -> [i32; ROWS] {
    let mut result = [0; ROWS];
    if !crate::whole(inputs) || block.len() < kind.block(inputs.len()) {
        return result;
    }
    let (block, inputs, to) = (block.as_ptr(), inputs.as_ptr_range(), result.as_mut_ptr().cast());
    // SAFETY: the block is whole, and so are the turns; each of these functions writes four words and keeps the registers that the
    // procedure call standard says are its caller's. (Called by name: a static bound does not follow pointers.)
    unsafe {
        match kind {
            Kind::W8A16 => w8a16_raw(block, inputs.start, inputs.end, to),
            Kind::W16A16 => w16a16_raw(block, inputs.start, inputs.end, to),
        }
    }
    result
}
