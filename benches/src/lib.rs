//! Building blocks of the benchmarks: policies with states to decide, programs that time these decisions, and a table
//! of the results.
//!
//! | module | subject |
//! | --- | --- |
//! | [`subject`] | a graph, and the states of its own episodes |
//! | [`variant`] | a way to run a graph: interpreter, C, Rust, by profile |
//! | [`program`] | a variant as a program that times itself |
//! | [`callgrind`] | instructions of such a program |
//! | [`table`] | ratios by graph, and their geometric mean |

pub mod callgrind;
pub mod program;
pub mod subject;
pub mod table;
pub mod variant;

use rustix::time::{ClockId, clock_gettime};

/// Returns the CPU time of this process so far, in seconds.
pub fn cpu_seconds() -> f64 {
    let now = clock_gettime(ClockId::ProcessCPUTime);
    now.tv_sec as f64 + now.tv_nsec as f64 * 1e-9
}
