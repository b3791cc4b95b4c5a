//! Shields: actions that a graph of the arm cannot choose.

use serde::{Deserialize, Serialize};
use tpg_arm::observation::Source;

/// The actions that no policy can choose. A part of the graph: without it, it is another policy.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Shield {
    /// None is refused.
    #[default]
    None,
    /// Actions that would bring a joint out of its range.
    Limits,
    /// These, and actions after which the arm would collide.
    LimitsAndCollision,
}

impl Shield {
    /// The source that holds the bounds of the bids.
    pub fn source(self) -> Option<Source> {
        match self {
            Self::None => None,
            Self::Limits => Some(Source::ShieldLimits),
            Self::LimitsAndCollision => Some(Source::ShieldCollision),
        }
    }

    /// The shield of a graph with these sources.
    pub fn of<'a>(mut names: impl Iterator<Item = &'a str>) -> Self {
        let shields = [Self::Limits, Self::LimitsAndCollision];
        let named = |name: &str| shields.into_iter().find(|shield| shield.source().is_some_and(|s| s.name() == name));
        names.find_map(named).unwrap_or_default()
    }

    /// Its name in configurations and reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Limits => "limits",
            Self::LimitsAndCollision => "limits-and-collision",
        }
    }
}
