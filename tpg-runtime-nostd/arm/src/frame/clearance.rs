//! Clearance of the hand and the forearm from the arm's own base, in the arm plane.

use crate::arm::Shapes;
use crate::kinematics::{Direction, Lattice, Plane, Point};
use tpg_runtime::ops::{clamp, max, min};

/// Distances from the base as a solid, mm: what the collision test refuses is about to reach 0 here.
///
/// The solid is the base's outline filled: a staircase, one box under each edge's outer, upper end. (The collision
/// test knows the outline only, which is open at its top: it lets a hand enter the column from above. Here that hand
/// has no clearance.) Meant for free poses; where a side lies across the solid with both ends outside, the value is
/// that of its nearest end or corner, not a depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clearance<S> {
    /// From the hand's tip face and its lower edge.
    pub hand: S,
    /// From the forearm's end face and its lower edge.
    pub forearm: S,
}

/// One straight side of a part of the arm.
struct Side<S> {
    start: Point<S>,
    direction: Direction<S>,
    length: S,
}

impl<S: Lattice> Clearance<S> {
    /// Of an arm in its plane.
    ///
    /// The sides are those of the collision test. Their directions and lengths are known, so that no division is
    /// needed; about 600 additions and multiplications and two square roots.
    pub fn new(plane: &Plane<S>, shapes: &Shapes<S>) -> Self {
        Self::up_to(plane, shapes, S::from_f64(f64::INFINITY))
    }

    /// The same where it is less than `horizon`, mm; any number from there on where it is not.
    ///
    /// Boxes that a part is clear of by more than the horizon are left out, with a millimetre for what rounds: four
    /// comparisons instead of some 150 operations each. Most poses are far from most of the base.
    pub fn up_to(plane: &Plane<S>, shapes: &Shapes<S>, horizon: S) -> Self {
        let [hand_upper, hand_lower] = shapes.hand_edges;
        let hand = [
            Side {
                start: plane.wrist.along(plane.hand_across, hand_lower),
                direction: plane.hand,
                length: shapes.hand_length,
            },
            Side { start: plane.tip_corners(shapes)[1], direction: plane.hand_across, length: hand_upper - hand_lower },
        ];
        let [forearm_upper, forearm_lower] = shapes.forearm_edges;
        let elbow_lower = plane.elbow.along(plane.forearm_across, forearm_lower);
        let end_lower = plane.forearm_end_corners(shapes)[1];
        let forearm = [
            Side { start: elbow_lower, direction: plane.forearm, length: dot(plane.forearm, elbow_lower, end_lower) },
            Side { start: end_lower, direction: plane.forearm_across, length: forearm_upper - forearm_lower },
        ];
        Self { hand: nearest(&hand, shapes, horizon), forearm: nearest(&forearm, shapes, horizon) }
    }
}

/// The distance between a part's sides and the base, both mirror images; not less than `horizon` where it is more.
fn nearest<S: Lattice>(sides: &[Side<S>; 2], shapes: &Shapes<S>, horizon: S) -> S {
    let ends = sides.each_ref().map(|side| side.start.along(side.direction, side.length));
    let [first, second] = sides;
    let points = [first.start, ends[0], second.start, ends[1]];
    let beyond = horizon + S::ONE;
    let mut square = S::from_f64(f64::INFINITY);
    for edge in &shapes.base {
        let corner = Point { x: max(edge.x[1], edge.x[0]), z: max(edge.z[1], edge.z[0]) };
        let (top, side) = (corner.z + beyond, corner.x + beyond);
        let clear = points.iter().all(|point| point.z > top)
            || points.iter().all(|point| point.x > side)
            || points.iter().all(|point| point.x < -side);
        if clear {
            continue;
        }
        for (side, &end) in sides.iter().zip(&ends) {
            // A segment and a box that do not meet are nearest at an end of the one or a corner of the other.
            square = min(to_box(side.start, corner), square);
            square = min(to_box(end, corner), square);
            square = min(to_side(corner, side), square);
            square = min(to_side(Point { x: -corner.x, z: corner.z }, side), square);
        }
    }
    square.sqrt()
}

/// The square of a point's distance to the box that reaches from −`corner.x` to `corner.x` and up to `corner.z`.
fn to_box<S: Lattice>(point: Point<S>, corner: Point<S>) -> S {
    let dx = max(S::ZERO, point.x.abs() - corner.x);
    let dz = max(S::ZERO, point.z - corner.z);
    dx * dx + dz * dz
}

/// The square of a point's distance to a side.
fn to_side<S: Lattice>(point: Point<S>, side: &Side<S>) -> S {
    let along = dot(side.direction, side.start, point);
    let along = clamp(along, S::ZERO, side.length, along);
    let foot = side.start.along(side.direction, along);
    let (dx, dz) = (point.x - foot.x, point.z - foot.z);
    dx * dx + dz * dz
}

/// Distance of `to` from `from` along a direction.
fn dot<S: Lattice>(direction: Direction<S>, from: Point<S>, to: Point<S>) -> S {
    (to.x - from.x) * direction.cos + (to.z - from.z) * direction.sin
}
