//! The inputs of an actor on the arm.

use super::MOTORS;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tpg_arm::frame::Frame;
use tpg_arm::kinematics;
use tpg_arm::sac::{FEATURE_NAMES, FEATURES, features};

/// The values that an actor reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Inputs {
    /// The features of `tpg_arm::sac`.
    Features,
    /// The paper's 13 values: target, difference, hand, motors.
    PaperFs,
    /// The paper's 13 values: target, hand, difference, motors.
    PaperRs,
}

impl Inputs {
    /// Every set of inputs.
    pub const ALL: [Self; 3] = [Self::Features, Self::PaperFs, Self::PaperRs];

    /// The name in configurations and on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Features => "features",
            Self::PaperFs => "paper-fs",
            Self::PaperRs => "paper-rs",
        }
    }

    /// The inputs of that [`name`](Self::name).
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|inputs| inputs.name() == name)
    }

    /// The number of values.
    pub fn count(self) -> usize {
        match self {
            Self::Features => FEATURES,
            Self::PaperFs | Self::PaperRs => 13,
        }
    }

    /// The names of the values, in order.
    pub fn names(self) -> Vec<String> {
        let axes = |what: &str| ["x", "y", "z"].map(|axis| format!("{what}_{axis}"));
        let joints = MOTORS.map(str::to_owned);
        let paper = |parts: [&str; 3]| parts.into_iter().flat_map(axes).chain(joints).collect();
        match self {
            Self::Features => FEATURE_NAMES.map(str::to_owned).into(),
            Self::PaperFs => paper(["target", "difference", "hand"]),
            Self::PaperRs => paper(["target", "hand", "difference"]),
        }
    }

    /// Writes the values.
    ///
    /// # Panics
    /// If `values` has another length than [`count`](Self::count).
    pub fn observe(self, frame: &Frame<'_, f32>, values: &mut [f32]) {
        match self {
            Self::Features => values.copy_from_slice(&features(frame)),
            Self::PaperFs | Self::PaperRs => {
                let [base, others @ ..] = frame.pose().0.map(f32::from);
                let target = frame.target();
                let hand = frame.plane().hand_in_world(frame.base());
                let difference = kinematics::difference(target, hand);
                let pair = if self == Self::PaperFs { [difference, hand] } else { [hand, difference] };
                let lengths = [target, pair[0], pair[1]].into_iter().flatten().map(|mm| mm / 100.0);
                let motors = others.map(|ticks| ticks / 1024.0 - 2.0);
                let all = lengths.chain([base / 2048.0 - 1.0]).chain(motors);
                assert_eq!(values.len(), 13, "the paper's inputs");
                values.iter_mut().zip(all).for_each(|(slot, value)| *slot = value);
            }
        }
    }
}
