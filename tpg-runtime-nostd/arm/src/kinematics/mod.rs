//! Forward kinematics: from motor positions to points, in millimetres.
//!
//! Base, shoulder, elbow and wrist turn about parallel axes but for the base, so the arm lives in one vertical plane
//! ([`Plane`]) which the base swings round. The angles of its links are sums of motor ticks: whole numbers. So their
//! sines come exactly from a quarter-wave table ([`Angle`]), in a handful of instructions that never vary.
//!
//! Distance of the hand from the place where other definitions put it, mm, at poses inside the WidowX's limits:
//!
//! | the lattice path in | against the `f64` matrix chain of the paper's artifact | against libm's sines |
//! | --- | --- | --- |
//! | `f64` | 5e-13 | 6e-13 |
//! | `f32` | 1.1e-4 | 3e-4 |
//!
//! The first column is measured in `tpg-train` (`tests/kinematics.rs`; 20 million poses gave 4.2e-13 and 1.002e-4), the
//! second in this crate's `tests/kinematics.rs`. At such distances a collision answer can differ only where the arm all
//! but touches something: over the 318,611,987 poses that actions of 3 ticks reach from home, none does in `f64`, and 10
//! do in `f32`, all of them within 1.7e-5 mm of touching.

mod lattice;

pub use lattice::Lattice;

use crate::arm::{Arm, JOINTS, Joint, Pose, TICKS_PER_TURN};
use tpg_runtime::scalar::Scalar;

/// A point or vector in the world, mm: x, y in the table, z upwards.
pub type Vector<S> = [S; 3];

/// The Euclidean distance of two points, mm, summed in the order x, y, z.
#[inline]
pub fn distance<S: Lattice>(a: Vector<S>, b: Vector<S>) -> S {
    let [x, y, z] = difference(a, b);
    (x * x + y * y + z * z).sqrt()
}

/// `a − b`, component by component.
#[inline]
pub fn difference<S: Scalar>(a: Vector<S>, b: Vector<S>) -> Vector<S> {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// An angle in motor ticks, 4,096 a turn; any number of turns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Angle(pub i32);

impl Angle {
    const QUARTER: i32 = TICKS_PER_TURN / 4;

    /// The direction of this angle, exact to the last bit of the table: no rounding depends on the turn.
    #[inline]
    pub fn direction<S: Lattice>(self) -> Direction<S> {
        // Sine and cosine change places from quarter to quarter. The sine is negative in the lower half of the turn, the cosine
        // a quarter before.
        let within_quarter = self.0 & (Self::QUARTER - 1);
        let place = if self.0 & Self::QUARTER != 0 { Self::QUARTER - within_quarter } else { within_quarter };
        let [cos, sin] = [Self::QUARTER - place, place].map(|place| S::quarter_sine(place as usize));
        let lower = |angle: i32| angle & (2 * Self::QUARTER) != 0;
        Direction { cos: cos.negated_if(lower(self.0.wrapping_add(Self::QUARTER))), sin: sin.negated_if(lower(self.0)) }
    }
}

/// A unit vector in a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction<S> {
    /// Its first component: in the arm plane, along the table.
    pub cos: S,
    /// Its second component: in the arm plane, upwards.
    pub sin: S,
}

impl<S: Scalar> Direction<S> {
    /// Turned by a quarter, the way angles grow.
    pub fn quarter_ahead(self) -> Self {
        Self { cos: -self.sin, sin: self.cos }
    }

    /// Turned by a quarter, against the way angles grow.
    pub fn quarter_behind(self) -> Self {
        Self { cos: self.sin, sin: -self.cos }
    }
}

/// A point of the arm plane, mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point<S> {
    /// Signed distance from the base's axis. The arm at home stretches to negative x.
    pub x: S,
    /// Height over the table.
    pub z: S,
}

impl<S: Scalar> Point<S> {
    /// This point moved `by` mm in a direction.
    #[inline(always)]
    pub fn along(self, direction: Direction<S>, by: S) -> Self {
        Self { x: self.x + direction.cos * by, z: self.z + direction.sin * by }
    }
}

/// The directions of the arm's parts in the arm plane, from which a [`Plane`] is built.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Directions<S> {
    /// Of the upper arm.
    pub upper_arm: Direction<S>,
    /// Of the elbow's bracket, a quarter turn ahead of the upper arm.
    pub bracket: Direction<S>,
    /// Of the forearm.
    pub forearm: Direction<S>,
    /// A quarter turn behind the forearm.
    pub forearm_across: Direction<S>,
    /// Of the hand.
    pub hand: Direction<S>,
    /// A quarter turn behind the hand.
    pub hand_across: Direction<S>,
}

impl<S: Scalar> Directions<S> {
    /// At a pose of the motor lattice.
    #[inline]
    pub fn at(pose: Pose) -> Self
    where
        S: Lattice,
    {
        let [upper_arm, forearm, hand] = link_angles(pose).map(Angle::direction);
        Self::of_links(upper_arm, forearm, hand)
    }

    /// From the three links' own directions.
    #[inline]
    pub fn of_links(upper_arm: Direction<S>, forearm: Direction<S>, hand: Direction<S>) -> Self {
        Self {
            upper_arm,
            bracket: upper_arm.quarter_ahead(),
            forearm,
            forearm_across: forearm.quarter_behind(),
            hand,
            hand_across: hand.quarter_behind(),
        }
    }
}

/// The arm seen from its side: where its joints are in the arm plane, and how its last two links point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane<S> {
    /// End of the upper arm.
    pub bracket: Point<S>,
    /// The elbow.
    pub elbow: Point<S>,
    /// The wrist.
    pub wrist: Point<S>,
    /// The hand's tip.
    pub tip: Point<S>,
    /// Direction of the forearm.
    pub forearm: Direction<S>,
    /// A quarter turn behind the forearm.
    pub forearm_across: Direction<S>,
    /// Direction of the hand.
    pub hand: Direction<S>,
    /// A quarter turn behind the hand.
    pub hand_across: Direction<S>,
}

impl<S: Scalar> Plane<S> {
    /// Adds up the links, from the shoulder outwards.
    #[inline]
    pub fn new(arm: &Arm<S>, directions: Directions<S>) -> Self {
        let Directions { upper_arm, bracket, forearm, forearm_across, hand, hand_across } = directions;
        let links = &arm.links;
        // The artifact adds the base's height after the first product: the order decides the last bit. What is taken away
        // changes no bit where it is 0, whatever the sign of the product.
        let bracket_end = Point {
            x: upper_arm.cos * links.upper_arm - links.shoulder_radial,
            z: upper_arm.sin * links.upper_arm + links.base,
        };
        let elbow = bracket_end.along(bracket, links.elbow_offset);
        let wrist = elbow.along(forearm, links.forearm);
        let tip = wrist.along(hand, links.hand);
        Self { bracket: bracket_end, elbow, wrist, tip, forearm, forearm_across, hand, hand_across }
    }

    /// The tip in the world, with the arm plane turned to the base's direction.
    #[inline]
    pub fn hand_in_world(&self, base: Direction<S>) -> Vector<S> {
        [self.tip.x * base.sin, -(self.tip.x * base.cos), self.tip.z]
    }
}

impl<S: Lattice> Plane<S> {
    /// At a pose of the motor lattice.
    #[inline(never)] // once in flash
    pub fn at(arm: &Arm<S>, pose: Pose) -> Self {
        Self::new(arm, Directions::at(pose))
    }
}

/// The angles of upper arm, forearm and hand over the table, in whole ticks.
#[inline]
pub fn link_angles(pose: Pose) -> [Angle; 3] {
    let [_, shoulder, elbow, wrist] = pose.0.map(i32::from);
    let quarter = TICKS_PER_TURN / 4;
    let upper_arm = shoulder - quarter;
    let forearm = upper_arm + 3 * quarter - elbow;
    let hand = forearm + 2 * quarter - wrist;
    [upper_arm, forearm, hand].map(Angle)
}

/// The direction of the base joint; 0 at motor position 2048.
pub fn base_direction<S: Lattice>(pose: Pose) -> Direction<S> {
    let [base, ..] = pose.0;
    Angle(i32::from(base) - TICKS_PER_TURN / 2).direction()
}

/// The place of the hand's tip at a pose, mm.
#[inline(never)] // once in flash
pub fn hand<S: Lattice>(arm: &Arm<S>, pose: Pose) -> Vector<S> {
    // `Plane::at`, of which only the tip is left here.
    Plane::new(arm, Directions::at(pose)).hand_in_world(base_direction(pose))
}

/// The place of the hand's tip at any joint angles (rad, 0 = motor position 2048), by libm: the reference.
pub fn hand_from_radians<S: Lattice>(arm: &Arm<S>, [base, shoulder, elbow, wrist]: [S; JOINTS]) -> Vector<S> {
    let direction = |radians: S| {
        let [cos, sin] = [libm::cos, libm::sin].map(|function| S::from_f64(function(radians.to_f64())));
        Direction { cos, sin }
    };
    let right = S::from_f64(core::f64::consts::FRAC_PI_2);
    let upper_arm = right + shoulder;
    let forearm = upper_arm + right - elbow;
    let [upper_arm, forearm, hand] = [upper_arm, forearm, forearm - wrist].map(direction);
    Plane::new(arm, Directions::of_links(upper_arm, forearm, hand)).hand_in_world(direction(base))
}

/// The angle of a joint at a pose, rad: 0 at motor position 2048. A joint that does not exist has angle 0.
pub fn radians<S: Scalar>(pose: Pose, joint: Joint) -> S {
    let ticks = pose.0.get(usize::from(joint.0)).map_or(0, |&ticks| i32::from(ticks) - TICKS_PER_TURN / 2);
    S::from_i32(ticks) * S::from_f64(core::f64::consts::TAU / TICKS_PER_TURN as f64)
}
