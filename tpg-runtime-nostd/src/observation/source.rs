//! The named parts of an observation that a graph can read.

/// A data source of a graph: a named part of the observation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Source {
    /// The target: x, y, z in mm.
    Target,
    /// Target − hand: x, y, z in mm.
    Difference,
    /// The hand's tip: x, y, z in mm.
    Hand,
    /// The four motor positions, ticks.
    Motors,
    /// The positions of all six servos, ticks: the four motors, wrist rotation and gripper. The paper's graphs read it.
    Servos,
}

impl Source {
    /// Every source, in the order of the enumeration.
    pub const ALL: [Self; 5] = [Self::Target, Self::Difference, Self::Hand, Self::Motors, Self::Servos];

    /// The name in `graph.json`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Target => "target",
            Self::Difference => "difference",
            Self::Hand => "hand",
            Self::Motors => "motors",
            Self::Servos => "servos",
        }
    }

    /// The source of that [`name`](Self::name).
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|source| source.name() == name)
    }

    /// How many values it has.
    pub const fn length(self) -> usize {
        match self {
            Self::Target | Self::Difference | Self::Hand => 3,
            Self::Motors => 4,
            Self::Servos => 6,
        }
    }

    /// The unit of its values.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Target | Self::Difference | Self::Hand => "mm",
            Self::Motors | Self::Servos => "ticks",
        }
    }
}
