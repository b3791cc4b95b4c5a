//! Vectors of the processor: the widest ones, chosen when the program runs.

use fearless_simd::{Level, Select, Simd, SimdBase, dispatch};

/// A vector register of numbers.
pub(super) type Vector<S> = <S as Simd>::f32s;

/// Returns the number of lanes of a vector.
#[inline(always)]
pub(super) const fn lanes<S: Simd>() -> usize {
    <Vector<S>>::LEN
}

/// Returns true if the processor has 32 vector registers, not 16.
#[inline(always)]
pub(super) fn many_registers<S: Simd>() -> bool {
    // AVX-512 doubles number and width of the registers; AArch64 has 32 of 16 bytes.
    cfg!(target_arch = "aarch64") || S::u8s::LEN == 64
}

/// Runs `work`, compiled for the widest vectors of the processor. A closure has to be `#[inline(always)]` for that.
#[inline(always)]
pub(super) fn vectorised(work: impl FnOnce()) {
    dispatch!(Level::new(), _ => work());
}

/// Returns the vector of the numbers from place `index` on, counted in vectors.
#[inline(always)]
pub(super) fn load<S: Simd>(simd: S, values: &[f32], index: usize) -> Vector<S> {
    let lanes = lanes::<S>();
    SimdBase::from_slice(simd, &values[index * lanes..][..lanes])
}

/// Writes a vector to the numbers from place `index` on, counted in vectors.
#[inline(always)]
pub(super) fn save<S: Simd>(vector: Vector<S>, values: &mut [f32], index: usize) {
    let lanes = lanes::<S>();
    vector.store_slice(&mut values[index * lanes..][..lanes]);
}

/// Keeps the values in the lanes where `passed` is above zero; the others become zero, those at NaN too.
#[inline(always)]
pub(super) fn where_positive<S: Simd>(simd: S, values: Vector<S>, passed: Vector<S>) -> Vector<S> {
    let zero = SimdBase::splat(simd, 0.0);
    passed.simd_gt(zero).select(values, zero)
}
