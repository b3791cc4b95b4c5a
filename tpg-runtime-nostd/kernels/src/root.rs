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
pub fn sqrt(value: f32) -> f32 {
    /// A function of its own: inline assembly cannot name the FPU's registers on this target, and core has no square root.
    #[unsafe(naked)]
    extern "C" fn root(value: f32) -> f32 {
        core::arch::naked_asm!(".fpu fpv4-sp-d16", "vsqrt.f32 s0, s0", "bx lr")
    }
    root(value)
}
