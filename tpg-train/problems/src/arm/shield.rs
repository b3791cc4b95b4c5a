//! Shields: masks for the actions of a graph.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tpg_arm::observation::Source;

/// Actions that are masked. The shield is part of the graph: without it, the graph is a different policy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Shield {
    /// None.
    #[default]
    None,
    /// Those that leave a joint's range.
    Limits,
    /// Also those that collide.
    LimitsAndCollision,
}

impl Shield {
    /// Returns the source that holds the bounds of the bids.
    pub fn source(self) -> Option<Source> {
        match self {
            Self::None => None,
            Self::Limits => Some(Source::ShieldLimits),
            Self::LimitsAndCollision => Some(Source::ShieldCollision),
        }
    }

    /// Returns the name used in configurations and reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Limits => "limits",
            Self::LimitsAndCollision => "limits-and-collision",
        }
    }
}
