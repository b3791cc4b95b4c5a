//! Action limits of the recorded episodes, which differ from the project's own problems.

use tpg_problems::arm::targets::Start;

/// The most actions of a recorded episode of a TPG.
pub const fn max_actions(start: Start) -> u32 {
    match start {
        // The paper says 1707; its artifact was run with 1710.
        Start::Fs => 1710,
        Start::Rs => 3414,
    }
}
