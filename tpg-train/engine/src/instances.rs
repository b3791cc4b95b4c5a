//! Evaluation for environments of any type, compiled in this crate.
//!
//! Builds for tests share generic functions among crates (rustc does so below level 2 of optimisation). What is named
//! here is compiled and optimised once: the trainer, its tests and examples link it.

use crate::erased::{AnyEpisode, AnyTask};
use crate::{Environment, Evaluator, LocalThreads, Remembering};
use tpg_runtime::ops::Own;

/// Evaluation as the trainer uses it.
type Threads<'a, S> =
    LocalThreads<'a, S, Own, Remembering<&'a dyn Environment<S, Task = AnyTask, Episode = AnyEpisode>>>;

/// Names an evaluator's functions.
type Named<T> = fn(&T) -> &dyn Evaluator<AnyTask>;

#[expect(dead_code, reason = "named, so that it is compiled")]
static IN_F32: Named<Threads<'static, f32>> = |threads| threads;
#[expect(dead_code, reason = "named, so that it is compiled")]
static IN_F64: Named<Threads<'static, f64>> = |threads| threads;
