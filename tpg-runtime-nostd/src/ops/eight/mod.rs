//! Functions of eight numbers at once, with the bits of [`own`](super::own), in a form that compilers turn into vectors: without
//! tables. Numbers of a size that would need one are computed one by one.

pub(super) mod f32;
pub(super) mod f64;
