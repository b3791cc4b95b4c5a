//! The past as a graph that asks can know it, in the caller's memory.

use crate::code;
use crate::memory;
use tpg_runtime::recall::Recall;

/// The memory of an episode, for the sources of a graph that was trained with it: copy each value to the field of its name.
/// Begun by tpg_recall_init; tpg_recall_acted follows every action. Counts stay at 16,777,216.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct tpg_recall_t {
    /// The least distance so far.
    pub least: f32,
    /// The distance beyond the least; 0 where it is no number.
    pub drift: f32,
    /// Actions since the least distance was reached.
    pub since_progress: f32,
    /// Actions since the network decided, or since the start.
    pub since_asked: f32,
}

impl From<Recall<f32>> for tpg_recall_t {
    fn from(Recall { least, drift, since_progress, since_asked }: Recall<f32>) -> Self {
        Self { least, drift, since_progress, since_asked }
    }
}

impl From<tpg_recall_t> for Recall<f32> {
    fn from(tpg_recall_t { least, drift, since_progress, since_asked }: tpg_recall_t) -> Self {
        Self { least, drift, since_progress, since_asked }
    }
}

/// Begins an episode at a distance to the goal. INFINITY where it is not known before the first action.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_recall_init(recall: *mut tpg_recall_t, distance: f32) -> i32 {
    // SAFETY: the header's contract.
    code::answer(Ok(Recall::new(distance).into()), unsafe { memory::write(recall) })
}

/// Notes an action, and the distance to the goal behind it. `asked` is 0 for the graph's own action, anything else for the
/// network's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_recall_acted(recall: *mut tpg_recall_t, asked: i32, distance: f32) -> i32 {
    // SAFETY: the header's contract.
    code::of(unsafe { memory::write(recall) }.map(|kept| {
        let mut recall = Recall::from(*kept);
        recall.acted(asked != 0, distance);
        *kept = recall.into();
    }))
}
