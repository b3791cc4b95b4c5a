//! The square root.

/// The correctly rounded square root of an `f32`; NaN for negative numbers.
#[inline(always)]
#[cfg(not(tpg_fpu))]
pub fn sqrt(value: f32) -> f32 {
    libm::sqrtf(value)
}

/// The correctly rounded square root of an `f32`; NaN for negative numbers.
#[inline(always)]
#[cfg(tpg_fpu)]
#[expect(unsafe_code, reason = "one instruction that stable Rust has no name for in core")]
pub fn sqrt(value: f32) -> f32 {
    let root;
    // SAFETY: the instruction is there (every thumbv7em core of the hard-float ABI has an FPU), reads one register, writes
    // one, and touches neither memory nor the condition flags.
    unsafe {
        core::arch::asm!("vsqrt.f32 {root}, {value}", root = lateout(sreg) root, value = in(sreg) value,
            options(pure, nomem, nostack, preserves_flags));
    }
    root
}
