//! Tests of this crate that need its private parts, and what its other tests share.

mod gymnasium;
pub(crate) mod lanes;
