//! The arm as data: joints, links, limits and collision shapes; above them the collision test and the rule of one step.
//!
//! Everything else in the project is generic over an [`Arm`]; the paper's is [`WIDOWX`]. Positions are integers, in
//! motor ticks of 1/4096 turn, so that a trajectory is a list of integers on every machine.

pub(crate) mod collision;
mod error;
mod leeway;
mod play;
mod pose;
mod step;
mod widowx;

pub use collision::Collision;
pub use error::ArmError;
pub(crate) use leeway::Leeway;
pub use play::Play;
pub use pose::{JOINTS, Joint, Move, Pose, TICKS_PER_TURN};
pub use step::{Invalid, Step};
pub use widowx::WIDOWX;

use crate::kinematics::{Lattice, Point};

/// The positions that a joint may take, both ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JointRange {
    /// Lowest position, ticks.
    pub min: i16,
    /// Highest position, ticks.
    pub max: i16,
}

impl JointRange {
    /// Returns true if `ticks` lies in the range.
    pub const fn contains(self, ticks: i16) -> bool {
        self.min <= ticks && ticks <= self.max
    }
}

/// The lengths between the joints, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Links<S> {
    /// Height of the shoulder over the table.
    pub base: S,
    /// Shoulder to the elbow's bracket.
    pub upper_arm: S,
    /// Bracket to the elbow, at a right angle to the upper arm.
    pub elbow_offset: S,
    /// Elbow to wrist.
    pub forearm: S,
    /// Wrist to the tip of the hand: the point that must reach the target.
    pub hand: S,
    /// Distance of the shoulder in front of the base's axis, at which the base turns it round.
    pub shoulder_radial: S,
}

/// A horizontal or vertical edge of the arm's base in the arm plane, mm; the base has its mirror image at −x too.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BaseEdge<S> {
    /// The two ends' distances from the base's axis.
    pub x: [S; 2],
    /// The two ends' heights over the table.
    pub z: [S; 2],
}

/// The shapes of the collision test, in the arm plane, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shapes<S> {
    /// Wrist to the face of the hand's tip.
    pub hand_length: S,
    /// From the hand's axis to its two long edges, measured across, positive upwards with the arm stretched forwards.
    pub hand_edges: [S; 2],
    /// Distance of the forearm's end face beyond the wrist.
    pub forearm_overhang: S,
    /// From the forearm's axis to its two long edges, measured as [`hand_edges`](Self::hand_edges).
    pub forearm_edges: [S; 2],
    /// The outline of the base, one side.
    pub base: [BaseEdge<S>; 4],
}

/// A four-joint arm: a base that turns, and shoulder, elbow and wrist in one vertical plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Arm<S> {
    /// The pose in which a fixed-start episode begins.
    pub home: Pose,
    /// Positions of the servos that never move (wrist rotation, gripper), ticks.
    pub fixed_servos: [i16; 2],
    /// Joint limits.
    pub ranges: [JointRange; JOINTS],
    /// Lengths.
    pub links: Links<S>,
    /// Collision shapes.
    pub shapes: Shapes<S>,
}

impl<S: Lattice> Arm<S> {
    /// Returns the greatest distance of the hand's tip from the base's axis, at the shoulder's height: the arm stretched
    /// forwards, mm.
    pub fn reach(&self) -> S {
        let Links { upper_arm, elbow_offset, forearm, hand, shoulder_radial, .. } = self.links;
        (upper_arm * upper_arm + elbow_offset * elbow_offset).sqrt() + forearm + hand + shoulder_radial
    }

    /// Returns the place of the shoulder in the arm plane.
    #[inline]
    pub fn shoulder(&self) -> Point<S> {
        // The arm at home stretches to negative x. A difference, as the negative of 0 has another sign.
        Point { x: S::ZERO - self.links.shoulder_radial, z: self.links.base }
    }
}

impl Arm<f64> {
    /// The same arm in `f32`: every length rounded to nearest.
    pub const fn to_f32(&self) -> Arm<f32> {
        const fn pair(v: [f64; 2]) -> [f32; 2] {
            [v[0] as f32, v[1] as f32]
        }
        const fn edge(e: BaseEdge<f64>) -> BaseEdge<f32> {
            BaseEdge { x: pair(e.x), z: pair(e.z) }
        }
        let Links { base, upper_arm, elbow_offset, forearm, hand, shoulder_radial } = self.links;
        let shapes = &self.shapes;
        Arm {
            home: self.home,
            fixed_servos: self.fixed_servos,
            ranges: self.ranges,
            links: Links {
                base: base as f32,
                upper_arm: upper_arm as f32,
                elbow_offset: elbow_offset as f32,
                forearm: forearm as f32,
                hand: hand as f32,
                shoulder_radial: shoulder_radial as f32,
            },
            shapes: Shapes {
                hand_length: shapes.hand_length as f32,
                hand_edges: pair(shapes.hand_edges),
                forearm_overhang: shapes.forearm_overhang as f32,
                forearm_edges: pair(shapes.forearm_edges),
                base: [edge(shapes.base[0]), edge(shapes.base[1]), edge(shapes.base[2]), edge(shapes.base[3])],
            },
        }
    }
}
