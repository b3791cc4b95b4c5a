//! Arms that need not be planar: any number of joints, each of which turns about an axis of its own.
//!
//! [`Kinematics`] is what every arm says about a pose: where its joints are, and about what they turn. The tip's Jacobian, the
//! clearance from a ball and its gradient follow from that alone ([`Placed`]), for a [`Chain`] as for the planar
//! [`Arm`]. The planar arm's own paths, [`Plane`] and [`Body`](crate::dodge::Body), cost less.
//!
//! ```
//! use tpg_arm::chain::{Axis, Chain, Kinematics, Link};
//! use tpg_arm::{JointRange, WIDOWX};
//!
//! // A post of 100 mm that turns, and a bar of 200 mm that its second joint lowers.
//! const POST: Link<f64> = Link {
//!     origin: [0.0; 3],
//!     turned: Link::STRAIGHT,
//!     axis: Axis::Z,
//!     reversed: false,
//!     zero: 2048,
//!     range: JointRange { min: 0, max: 4095 },
//! };
//! const BAR: Link<f64> = Link { origin: [0.0, 0.0, 100.0], axis: Axis::Y, ..POST };
//! const ARM: Chain<f64, 2> = Chain { links: [POST, BAR], tip: [200.0, 0.0, 0.0] };
//!
//! let placed = ARM.place([2048, 2048 + 1024]);
//! assert_eq!(placed.tip, [0.0, 0.0, -100.0]);
//! // Lowered further the bar's end moves to negative x, 200 mm a radian.
//! assert_eq!(placed.jacobian()[1], [-200.0, 0.0, 0.0]);
//! // A ball of 5 mm, 50 mm beside the bar, of which 10 mm are the bar's own.
//! let near = placed.near(&[20.0, 10.0], [50.0, 0.0, -50.0], 5.0);
//! assert_eq!((near.link, near.clearance), (1, 35.0));
//!
//! assert_eq!(WIDOWX.place(WIDOWX.home.0).tip, [0.0, 346.0, 267.0]);
//! ```

mod placed;

pub use placed::{Near, Placed};

use crate::arm::{Arm, JOINTS, JointRange, Pose};
use crate::kinematics::{Angle, Direction, Lattice, Plane, Point, Vector, base_direction};
use tpg_runtime::scalar::Scalar;

/// An arm of `N` joints as geometry.
pub trait Kinematics<S, const N: usize> {
    /// Places the arm at the joints' positions, ticks.
    fn place(&self, pose: [i16; N]) -> Placed<S, N>;
}

/// A direction of a joint's own frame about which it turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The first.
    X,
    /// The second.
    Y,
    /// The third.
    Z,
}

/// A joint and the link that it turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link<S> {
    /// The joint in the frame of the link before, mm.
    pub origin: Vector<S>,
    /// The rotation of its frame there at [`zero`](Self::zero): times a vector of its own frame, one of the frame before.
    pub turned: [Vector<S>; 3],
    /// The axis.
    pub axis: Axis,
    /// True where rising positions turn against the right hand's fingers whose thumb is the axis.
    pub reversed: bool,
    /// The position at which the joint adds nothing to [`turned`](Self::turned), ticks.
    pub zero: i16,
    /// The positions that it may take.
    pub range: JointRange,
}

/// An arm of `N` joints, one behind the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chain<S, const N: usize> {
    /// The joints, from the base outwards; the first in the frame of the world.
    pub links: [Link<S>; N],
    /// The tip in the frame of the last link, mm.
    pub tip: Vector<S>,
}

impl<S: Scalar> Link<S> {
    /// The rotation that turns nothing.
    pub const STRAIGHT: [Vector<S>; 3] =
        [[S::ONE, S::ZERO, S::ZERO], [S::ZERO, S::ONE, S::ZERO], [S::ZERO, S::ZERO, S::ONE]];
}

impl<S: Lattice> Link<S> {
    /// The rotation of the link at a position, in the frame before.
    fn rotation(&self, ticks: i16) -> [Vector<S>; 3] {
        let ahead = i32::from(ticks) - i32::from(self.zero);
        let Direction { cos, sin } = Angle(if self.reversed { -ahead } else { ahead }).direction::<S>();
        // The axis' column stays, the other two turn.
        self.turned.map(|[x, y, z]| match self.axis {
            Axis::X => [x, y * cos + z * sin, z * cos - y * sin],
            Axis::Y => [x * cos - z * sin, y, z * cos + x * sin],
            Axis::Z => [x * cos + y * sin, y * cos - x * sin, z],
        })
    }
}

impl<S, const N: usize> Chain<S, N> {
    /// Returns true if every position lies in its joint's range.
    pub fn allows(&self, pose: [i16; N]) -> bool {
        self.links.iter().zip(pose).all(|(link, ticks)| link.range.contains(ticks))
    }
}

impl<S: Lattice, const N: usize> Kinematics<S, N> for Chain<S, N> {
    fn place(&self, pose: [i16; N]) -> Placed<S, N> {
        let (mut at, mut frame) = ([S::ZERO; 3], Link::<S>::STRAIGHT);
        let mut placed = Placed { points: [at; N], axes: [at; N], tip: at };
        let places = placed.points.iter_mut().zip(&mut placed.axes);
        for ((link, ticks), (point, axis)) in self.links.iter().zip(pose).zip(places) {
            at = moved(at, &frame, link.origin);
            frame = product(&frame, &link.rotation(ticks));
            *point = at;
            *axis = frame.map(|[x, y, z]| {
                let along = match link.axis {
                    Axis::X => x,
                    Axis::Y => y,
                    Axis::Z => z,
                };
                if link.reversed { -along } else { along }
            });
        }
        placed.tip = moved(at, &frame, self.tip);
        placed
    }
}

/// Base, shoulder, elbow and wrist. The base's point is that of its axis on the table; the upper arm and its bracket are one
/// link.
impl<S: Lattice> Kinematics<S, JOINTS> for Arm<S> {
    fn place(&self, pose: [i16; JOINTS]) -> Placed<S, JOINTS> {
        let pose = Pose(pose);
        let (plane, base) = (Plane::at(self, pose), base_direction::<S>(pose));
        let world = |Point { x, z }: Point<S>| [x * base.sin, -(x * base.cos), z];
        // Across the plane: the shoulder lowers what is ahead, elbow and wrist raise it.
        let (down, up) = ([-base.cos, -base.sin, S::ZERO], [base.cos, base.sin, S::ZERO]);
        Placed {
            points: [[S::ZERO; 3], world(self.shoulder()), world(plane.elbow), world(plane.wrist)],
            axes: [[S::ZERO, S::ZERO, S::ONE], down, up, up],
            tip: plane.hand_in_world(base),
        }
    }
}

/// A point of a frame that is placed at `at`, in the outer frame.
fn moved<S: Scalar>(at: Vector<S>, frame: &[Vector<S>; 3], point: Vector<S>) -> Vector<S> {
    let [[a, b, c], [d, e, f], [g, h, i]] = *frame;
    let [x, y, z] = point;
    [at[0] + a * x + b * y + c * z, at[1] + d * x + e * y + f * z, at[2] + g * x + h * y + i * z]
}

/// The product of two rotations.
fn product<S: Scalar>(left: &[Vector<S>; 3], [x, y, z]: &[Vector<S>; 3]) -> [Vector<S>; 3] {
    left.map(|[a, b, c]| {
        [a * x[0] + b * y[0] + c * z[0], a * x[1] + b * y[1] + c * z[1], a * x[2] + b * y[2] + c * z[2]]
    })
}
