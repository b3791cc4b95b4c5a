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
    /// The four motor positions less 2048, ticks: 0 is the middle of a joint's travel.
    MotorsCentred,
    /// Errors in the shoulder's polar frame, mm: lateral, tangential, radial. They suit an arm that stays on its front
    /// side. The frame's origin is the point of the base's axis at the shoulder's height, as of
    /// [`Bearing`](Self::Bearing).
    Polar,
    /// Errors as seen from the shoulder: azimuth (half ticks, not wrapped), elevation (1/250 rad), radial (mm). They also
    /// suit an arm that reaches over its back.
    Bearing,
    /// By how many ticks base, shoulder and elbow are off, if the wrist stays: the closed-form inverse kinematics of
    /// the other three joints.
    Reach,
    /// Excess of [`Reach`](Self::Reach): ticks by which the shoulder's and the elbow's goal lie outside their
    /// range, and mm by which the target is too far away or too near.
    ReachExcess,
    /// The hand's pitch at that goal, ticks below the horizontal.
    ReachPitch,
    /// The target as seen from the wrist: distance less the hand's length (mm), and by how many ticks the wrist is off
    /// that would point the hand at it.
    Wrist,
    /// Height of the lower corner of the hand's tip over the table, mm.
    Floor,
    /// Ticks by which base, shoulder, elbow and wrist are off from a pose that solves the task: the closed-form inverse
    /// kinematics of the whole arm, for the first of four wrist positions that limits and shapes allow.
    Stance,
}

impl Source {
    /// Every source, in the order of the enumeration.
    pub const ALL: [Self; 14] = [
        Self::Target,
        Self::Difference,
        Self::Hand,
        Self::Motors,
        Self::Servos,
        Self::MotorsCentred,
        Self::Polar,
        Self::Bearing,
        Self::Reach,
        Self::ReachExcess,
        Self::ReachPitch,
        Self::Wrist,
        Self::Floor,
        Self::Stance,
    ];

    /// The name in `graph.json`.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Target => "target",
            Self::Difference => "difference",
            Self::Hand => "hand",
            Self::Motors => "motors",
            Self::Servos => "servos",
            Self::MotorsCentred => "motors_centred",
            Self::Polar => "polar",
            Self::Bearing => "bearing",
            Self::Reach => "reach",
            Self::ReachExcess => "reach_excess",
            Self::ReachPitch => "reach_pitch",
            Self::Wrist => "wrist",
            Self::Floor => "floor",
            Self::Stance => "stance",
        }
    }

    /// The source of that [`name`](Self::name).
    pub const fn from_name(name: &str) -> Option<Self> {
        let mut place = 0;
        while place < Self::ALL.len() {
            if same(Self::ALL[place].name().as_bytes(), name.as_bytes()) {
                return Some(Self::ALL[place]);
            }
            place += 1;
        }
        None
    }

    /// Number of its values.
    pub const fn length(self) -> usize {
        match self {
            Self::ReachPitch | Self::Floor => 1,
            Self::Wrist => 2,
            Self::Target | Self::Difference | Self::Hand => 3,
            Self::Polar | Self::Bearing | Self::Reach | Self::ReachExcess => 3,
            Self::Motors | Self::MotorsCentred | Self::Stance => 4,
            Self::Servos => 6,
        }
    }

    /// The unit of its values.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Target | Self::Difference | Self::Hand | Self::Polar | Self::Floor => "mm",
            Self::Motors | Self::Servos | Self::MotorsCentred | Self::Reach | Self::ReachPitch => "ticks",
            Self::Stance => "ticks",
            Self::Bearing => "half ticks, 1/250 rad, mm",
            Self::ReachExcess => "ticks, ticks, mm",
            Self::Wrist => "mm, ticks",
        }
    }
}

/// Returns true if both are the same bytes: `==` for constants.
pub(crate) const fn same(a: &[u8], b: &[u8]) -> bool {
    match (a.split_first(), b.split_first()) {
        (Some((first, rest)), Some((other, others))) => *first == *other && same(rest, others),
        (None, None) => true,
        _ => false,
    }
}
