//! Recorded traces: the pose after each step.

use serde::Deserialize;
use std::path::Path;
use tpg_arm::Pose;
use tpg_paper::data::{ByRow, rows};
use tpg_paper::episode::EndState;
use tpg_paper::replay::Done;

#[derive(Deserialize)]
struct TraceRow {
    row: u32,
    m0: i16,
    m1: i16,
    m2: i16,
    m3: i16,
}

/// Reads the pose after each step.
pub(crate) fn traces(path: &Path) -> ByRow<Vec<Pose>> {
    let mut traces: ByRow<Vec<Pose>> = ByRow::new();
    for TraceRow { row, m0, m1, m2, m3 } in rows(path).expect("a recorded trace") {
        traces.entry(row).or_default().push(Pose([m0, m1, m2, m3]));
    }
    traces
}

/// Describes the first recorded step that differs.
#[allow(clippy::ptr_arg, reason = "compared by `replay::compare`")]
pub(crate) fn trace_difference(recorded: &Vec<Pose>, done: &Done) -> Option<String> {
    let replayed = &done.poses;
    let steps = (1..).zip(recorded.iter().zip(replayed));
    let differs = steps.into_iter().find(|(_, (recorded, replayed))| recorded != replayed);
    if let Some((step, (recorded, replayed))) = differs {
        return Some(format!("step {step}: pose {:?} instead of {:?}", replayed.0, recorded.0));
    }
    let lengths = (recorded.len(), replayed.len());
    (lengths.0 != lengths.1).then(|| format!("{} steps instead of {}", lengths.1, lengths.0))
}

#[test]
fn what_differs_in_a_trace_is_described() {
    let [a, b] = [4091, 4094].map(|base| Pose([base, 2048, 2048, 2048]));
    let end = EndState { score_x1000: -9, distance_um: 9, success: false, collision: true, actions: 2 };
    let done = Done { poses: vec![a, b], end };
    let difference = |poses: &[Pose]| trace_difference(&poses.to_vec(), &done);
    assert_eq!(difference(&[a, b]), None);
    let step = "step 2: pose [4094, 2048, 2048, 2048] instead of [4091, 2048, 2048, 2048]";
    assert_eq!(difference(&[a, a]).as_deref(), Some(step));
    assert_eq!(difference(&[a]).as_deref(), Some("2 steps instead of 1"));
}
