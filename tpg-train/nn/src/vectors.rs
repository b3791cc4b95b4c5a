//! Vectors of the processor: the widest ones, chosen when the program runs.

use crate::Real;
use fearless_simd::{Level, Select, Simd, SimdBase, SimdFloatElement, dispatch};

/// A vector register of numbers of type `T`.
pub(super) type Vector<T, S> = <T as SimdFloatElement>::Native<S>;

/// Returns the number of lanes of a vector.
#[inline(always)]
pub(super) const fn lanes<T: Real, S: Simd>() -> usize {
    <Vector<T, S>>::LEN
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
pub(super) fn load<T: Real, S: Simd>(simd: S, values: &[T], index: usize) -> Vector<T, S> {
    let lanes = lanes::<T, S>();
    SimdBase::from_slice(simd, &values[index * lanes..][..lanes])
}

/// Writes a vector to the numbers from place `index` on, counted in vectors.
#[inline(always)]
pub(super) fn save<T: Real, S: Simd>(vector: Vector<T, S>, values: &mut [T], index: usize) {
    let lanes = lanes::<T, S>();
    vector.store_slice(&mut values[index * lanes..][..lanes]);
}

/// Keeps the values in the lanes where `passed` is above zero; the others become zero, those at NaN too.
#[inline(always)]
pub(super) fn where_positive<T: Real, S: Simd>(simd: S, values: Vector<T, S>, passed: Vector<T, S>) -> Vector<T, S> {
    let zero = SimdBase::splat(simd, T::zero());
    passed.simd_gt(zero).select(values, zero)
}
