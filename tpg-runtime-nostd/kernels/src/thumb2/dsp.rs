//! By the DSP extension: two products an instruction. Eight columns a turn: 38 instructions for `i8` weights, 24 for
//! `i16` weights, for 32 multiplications each.

/// Four columns of `i8` weights. Uses r3.
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

/// Times the multipliers, rounded.
macro_rules! rescale {
    () => {
        "
        ldmia r0!, {{r4-r7}}
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
        "
    };
}
