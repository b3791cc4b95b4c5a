//! By multiplications of one pair, which also add. Eight columns a turn: 76 instructions for `i8` weights, 78 for `i16` ones, for
//! 32 multiplications each.
//!
//! Words of weights are loaded four at a time and extended in registers: that takes one instruction more for four columns than loads
//! of single bytes, and fewer cycles by the manual, where a load of one number takes two.

/// Four columns of `i8` weights. Uses r3.
macro_rules! w8a16 {
    () => {
        "
        ldmia r0!, {{r4-r7}}
        ldrsh r12, [r1], #8
        ldrsh lr, [r1, #-6]
        sxtb r3, r4
        mla r8, r3, r12, r8
        sxtb.w r3, r4, ror #16
        mla r8, r3, lr, r8
        sxtb r3, r5
        mla r9, r3, r12, r9
        sxtb.w r3, r5, ror #16
        mla r9, r3, lr, r9
        sxtb r3, r6
        mla r10, r3, r12, r10
        sxtb.w r3, r6, ror #16
        mla r10, r3, lr, r10
        sxtb r3, r7
        mla r11, r3, r12, r11
        sxtb.w r3, r7, ror #16
        mla r11, r3, lr, r11
        ldrsh r12, [r1, #-4]
        ldrsh lr, [r1, #-2]
        sxtb.w r3, r4, ror #8
        mla r8, r3, r12, r8
        asrs r4, r4, #24
        mla r8, r4, lr, r8
        sxtb.w r3, r5, ror #8
        mla r9, r3, r12, r9
        asrs r5, r5, #24
        mla r9, r5, lr, r9
        sxtb.w r3, r6, ror #8
        mla r10, r3, r12, r10
        asrs r6, r6, #24
        mla r10, r6, lr, r10
        sxtb.w r3, r7, ror #8
        mla r11, r3, r12, r11
        asrs r7, r7, #24
        mla r11, r7, lr, r11
        "
    };
}

/// Four columns of `i16` weights. Uses r3.
macro_rules! w16a16 {
    () => {
        "
        ldmia r0!, {{r4-r7}}
        ldrsh r12, [r1], #8
        ldrsh lr, [r1, #-6]
        sxth r3, r4
        mla r8, r3, r12, r8
        asrs r4, r4, #16
        mla r8, r4, lr, r8
        sxth r3, r5
        mla r9, r3, r12, r9
        asrs r5, r5, #16
        mla r9, r5, lr, r9
        sxth r3, r6
        mla r10, r3, r12, r10
        asrs r6, r6, #16
        mla r10, r6, lr, r10
        sxth r3, r7
        mla r11, r3, r12, r11
        asrs r7, r7, #16
        mla r11, r7, lr, r11
        ldmia r0!, {{r4-r7}}
        ldrsh r12, [r1, #-4]
        ldrsh lr, [r1, #-2]
        sxth r3, r4
        mla r8, r3, r12, r8
        asrs r4, r4, #16
        mla r8, r4, lr, r8
        sxth r3, r5
        mla r9, r3, r12, r9
        asrs r5, r5, #16
        mla r9, r5, lr, r9
        sxth r3, r6
        mla r10, r3, r12, r10
        asrs r6, r6, #16
        mla r10, r6, lr, r10
        sxth r3, r7
        mla r11, r3, r12, r11
        asrs r7, r7, #16
        mla r11, r7, lr, r11
        "
    };
}

/// Times the multipliers, rounded. Uses r3.
macro_rules! rescale {
    () => {
        "
        ldmia r0!, {{r4-r7}}
        smull r3, r8, r8, r4
        add r8, r8, r3, lsr #31
        smull r3, r9, r9, r5
        add r9, r9, r3, lsr #31
        smull r3, r10, r10, r6
        add r10, r10, r3, lsr #31
        smull r3, r11, r11, r7
        add r11, r11, r3, lsr #31
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
        bfi r8, r9, #16, #16
        bfi r10, r11, #16, #16
        mov r9, r10
        "
    };
}
