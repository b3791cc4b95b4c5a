//! The arms that no robot can be.

use super::{Arm, Joint, JointRange, Links, Shapes, TICKS_PER_TURN};
use crate::kinematics::Lattice;
use core::fmt;
use tpg_runtime::scalar::Scalar;

/// The longest length that is accepted, mm: 100 m. Squares and products of such lengths are far from overflow.
const LONGEST: f64 = 100_000.0;

/// The reason why a description is not an arm's.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ArmError {
    /// The joint's range is empty, or goes beyond 0..=4095.
    Range(Joint),
    /// The home position of the joint lies outside its range.
    Home(Joint),
    /// The length of a link is no number, or not in its range: above 0 mm for upper arm, forearm and hand, from 0 mm for the
    /// base's height, the elbow's offset and the shoulder's distance from the axis, up to 100 m for all.
    Link,
    /// A collision shape has a number that is not within ±100 m, or an edge of the base that is neither horizontal nor
    /// vertical.
    Shape,
}

impl fmt::Display for ArmError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Range(Joint(joint)) => write!(f, "the range of joint {joint} is empty, or goes beyond 0..=4095"),
            Self::Home(Joint(joint)) => write!(f, "the home position of joint {joint} is outside its range"),
            Self::Link => f.write_str("the length of a link is no number, not positive, or above 100 m"),
            Self::Shape => {
                f.write_str("a collision shape is no number, beyond 100 m, or an edge neither horizontal nor vertical")
            }
        }
    }
}

impl core::error::Error for ArmError {}

impl<S: Lattice> Arm<S> {
    /// Checks that this describes an arm that can be.
    ///
    /// Functions of the arm never panic, whatever it holds; what they answer about an impossible one means nothing.
    ///
    /// ```
    /// use tpg_arm::{Arm, ArmError, Joint, Links, Pose, WIDOWX};
    ///
    /// assert_eq!(WIDOWX.check(), Ok(()));
    /// assert_eq!(Arm { home: Pose([0; 4]), ..WIDOWX }.check(), Err(ArmError::Home(Joint(0))));
    /// let links = Links { hand: f64::NAN, ..WIDOWX.links };
    /// assert_eq!(Arm { links, ..WIDOWX }.check(), Err(ArmError::Link));
    /// ```
    ///
    /// # Errors
    /// The first [`ArmError`], in the order of the enumeration.
    pub fn check(&self) -> Result<(), ArmError> {
        let joints = || (0u8..).map(Joint).zip(self.ranges.iter().zip(self.home.0));
        let possible =
            |range: &JointRange| 0 <= range.min && range.min <= range.max && i32::from(range.max) < TICKS_PER_TURN;
        if let Some((joint, _)) = joints().find(|(_, (range, _))| !possible(range)) {
            return Err(ArmError::Range(joint));
        }
        if let Some((joint, _)) = joints().find(|(_, (range, home))| !range.contains(*home)) {
            return Err(ArmError::Home(joint));
        }
        let Links { base, upper_arm, elbow_offset, forearm, hand, shoulder_radial } = self.links;
        if [upper_arm, forearm, hand].iter().any(|&length| !(length > S::ZERO && finite(length)))
            || [base, elbow_offset, shoulder_radial].iter().any(|&length| !(length >= S::ZERO && finite(length)))
        {
            return Err(ArmError::Link);
        }
        let Shapes { hand_length, hand_edges, forearm_overhang, forearm_edges, base } = &self.shapes;
        let edges = [hand_edges, forearm_edges].into_iter().chain(base.iter().flat_map(|edge| [&edge.x, &edge.z]));
        let upright = |[from, to]: [S; 2]| from == to;
        if ![*hand_length, *forearm_overhang].into_iter().all(finite)
            || !edges.flatten().copied().all(finite)
            || !base.iter().all(|edge| upright(edge.x) || upright(edge.z))
        {
            return Err(ArmError::Shape);
        }
        Ok(())
    }
}

/// False for a NaN.
fn finite<S: Scalar>(length: S) -> bool {
    length.abs() <= S::from_f64(LONGEST)
}
