//! Tests of this crate that need its private parts.

mod gymnasium;
