//! The shipped policies as compiled by users: the generated Rust, with this program's own options.

use super::timing::{self, Time};
use crate::actor::RecordedActor;
use tpg_arm::binding;
use tpg_arm::cycle::CycleDetector;
use tpg_arm::hybrid::{Hybrid, Settings};
use tpg_arm::observation::{ArmPolicy, Observation};
use tpg_arm::sac::packed::{Model, PackedPolicy};
use tpg_arm::{Arm, Move, Pose, WIDOWX};
use tpg_generated::widowx_fs::WidowxFs;
use tpg_generated::widowx_fs_fast::WidowxFsFast;
use tpg_generated::widowx_rs::WidowxRs;
use tpg_generated::widowx_rs_fast::WidowxRsFast;
use tpg_generated::{widowx_fs_hybrid, widowx_rs_hybrid, widowx_sac};
use tpg_problems::arm::targets::{Start, Task};
use tpg_runtime::policy::Policy;

/// The arm that they were trained for, in the precision that they run in.
const ARM: Arm<f32> = WIDOWX.to_f32();

/// Times of a shipped hybrid and its parts, and of what the paper compares with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// The graph alone, profile `fast`.
    pub tpg: Time,
    /// The graph alone, profile `constant-time`.
    pub tpg_constant_time: Time,
    /// The network alone, in integers.
    pub sac: Time,
    /// Both, as shipped.
    pub hybrid: Time,
    /// The paper's network alone, 13-256-256-4 in `f32`.
    pub reference: Time,
}

/// The policy of a generated graph.
macro_rules! arm_policy {
    ($graph:ident) => {{
        let (sources, moves) = const { (&binding::sources($graph::SOURCES), &binding::moves($graph::MOVES)) };
        ArmPolicy::new($graph, &ARM, sources, moves)
    }};
}

fn network() -> impl Policy<State = Observation<f32>, Action = Move> + Copy {
    let model = Model::parse(&widowx_sac::MODEL).expect("a committed model");
    PackedPolicy::<{ widowx_sac::SCRATCH }>::new(&ARM, model).expect("its own scratch memory")
}

/// Measures the times on the given tasks.
pub fn times(start: Start, tasks: &[Task]) -> Times {
    use {widowx_fs_hybrid as of_fs, widowx_rs_hybrid as of_rs};
    match start {
        Start::Fs => parts(start, tasks, arm_policy!(WidowxFsFast), of_fs::SETTINGS, &of_fs::Detector::new()),
        Start::Rs => parts(start, tasks, arm_policy!(WidowxRsFast), of_rs::SETTINGS, &of_rs::Detector::new()),
    }
}

fn parts<T, D>(start: Start, tasks: &[Task], tpg: T, settings: Settings<f32>, detector: &D) -> Times
where
    T: Policy<State = Observation<f32>, Action = Move> + Clone,
    D: CycleDetector<Pose> + Clone,
{
    Times {
        tpg: timing::of_policy(&ARM, &tpg, start, tasks),
        tpg_constant_time: match start {
            Start::Fs => timing::of_policy(&ARM, &arm_policy!(WidowxFs), start, tasks),
            Start::Rs => timing::of_policy(&ARM, &arm_policy!(WidowxRs), start, tasks),
        },
        sac: timing::of_policy(&ARM, &network(), start, tasks),
        hybrid: timing::of_hybrid(&Hybrid { arm: &ARM, tpg, sac: network(), settings }, detector, start, tasks),
        reference: timing::of_policy_along(&ARM, &RecordedActor::random(1), &network(), start, tasks),
    }
}
