//! Pointers from C, checked for what can be checked; opaque structures.
//!
//! Every function of the interface relies on one contract, which the header states: a pointer is NULL, or misaligned, or
//! points to as much memory as its type and the length beside it say, which nobody else writes meanwhile.

use crate::code::{Refusal, TPG_LENGTH, TPG_MISALIGNED, TPG_NULL, TPG_STATE};
use core::slice;

fn check<T>(pointer: *const T) -> Result<(), Refusal> {
    if pointer.is_null() {
        Err(Refusal(TPG_NULL))
    } else if !pointer.is_aligned() {
        Err(Refusal(TPG_MISALIGNED))
    } else {
        Ok(())
    }
}

/// The structure that a pointer from C points to.
///
/// # Safety
/// The header's contract.
#[inline(always)]
pub unsafe fn read<'a, T>(pointer: *const T) -> Result<&'a T, Refusal> {
    check(pointer)?;
    // SAFETY: neither NULL nor misaligned; the rest is the contract.
    Ok(unsafe { &*pointer })
}

/// The place for a result.
///
/// # Safety
/// The header's contract.
#[inline(always)]
pub unsafe fn write<'a, T>(pointer: *mut T) -> Result<&'a mut T, Refusal> {
    check(pointer)?;
    // SAFETY: neither NULL nor misaligned; the rest is the contract.
    Ok(unsafe { &mut *pointer })
}

/// An array to read.
///
/// # Safety
/// The header's contract.
#[inline(always)]
pub unsafe fn array<'a, T>(pointer: *const T, length: usize) -> Result<&'a [T], Refusal> {
    check(pointer)?;
    if length > isize::MAX as usize / size_of::<T>() {
        return Err(Refusal(TPG_LENGTH));
    }
    // SAFETY: neither NULL nor misaligned nor longer than memory; the rest is the contract.
    Ok(unsafe { slice::from_raw_parts(pointer, length) })
}

/// An array to write.
///
/// # Safety
/// The header's contract.
#[inline(always)]
pub unsafe fn array_mut<'a, T>(pointer: *mut T, length: usize) -> Result<&'a mut [T], Refusal> {
    check(pointer)?;
    if length > isize::MAX as usize / size_of::<T>() {
        return Err(Refusal(TPG_LENGTH));
    }
    // SAFETY: neither NULL nor misaligned nor longer than memory; the rest is the contract.
    Ok(unsafe { slice::from_raw_parts_mut(pointer, length) })
}

/// A structure whose bytes are the library's, in memory that is the caller's.
///
/// # Safety
/// `Self` must have room for a [`Tagged`] content and its alignment ([`initialise`] does not compile otherwise), and accept any bytes.
pub unsafe trait Opaque: Sized {
    /// The content. Nothing is ever dropped.
    type Content;
    /// The mark of an initialised structure, in its first word; another one for every type.
    const TAG: u32;
}

/// The content of an opaque structure, with its mark.
#[repr(C)]
pub struct Tagged<T> {
    tag: u32,
    content: T,
}

/// Initialises an opaque structure.
///
/// # Safety
/// The header's contract.
#[inline(always)]
pub unsafe fn initialise<O: Opaque>(pointer: *mut O, content: O::Content) -> Result<(), Refusal> {
    const {
        assert!(size_of::<O>() >= size_of::<Tagged<O::Content>>(), "it fits");
        assert!(align_of::<O>() >= align_of::<Tagged<O::Content>>(), "it is aligned");
        assert!(!core::mem::needs_drop::<O::Content>(), "nothing is dropped");
    }
    check(pointer)?;
    // SAFETY: it fits, as was just proven.
    unsafe { pointer.cast::<Tagged<O::Content>>().write(Tagged { tag: O::TAG, content }) };
    Ok(())
}

/// The content of an initialised opaque structure.
///
/// # Safety
/// The header's contract.
#[inline(always)]
pub unsafe fn content<'a, O: Opaque>(pointer: *const O) -> Result<&'a O::Content, Refusal> {
    check(pointer)?;
    let tagged = pointer.cast::<Tagged<O::Content>>();
    // SAFETY: an opaque structure has room for the tag, and any four bytes are one; behind the right tag lies the content
    // that `initialise` wrote.
    unsafe { if (*tagged).tag == O::TAG { Ok(&(*tagged).content) } else { Err(Refusal(TPG_STATE)) } }
}

/// The content of an initialised opaque structure, to change it.
///
/// # Safety
/// The header's contract.
#[inline(always)]
pub unsafe fn content_mut<'a, O: Opaque>(pointer: *mut O) -> Result<&'a mut O::Content, Refusal> {
    check(pointer)?;
    let tagged = pointer.cast::<Tagged<O::Content>>();
    // SAFETY: as in `content`.
    unsafe { if (*tagged).tag == O::TAG { Ok(&mut (*tagged).content) } else { Err(Refusal(TPG_STATE)) } }
}
