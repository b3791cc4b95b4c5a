//! The collision test of the paper's environment, in the arm plane (`ArmLearnWrapper.cpp`, lines 1026–1179).
//!
//! There is no link–link test and none of the upper arm, as in the artifact. The order of operations is the artifact's,
//! so that the conformance suite can run this very code on its own [`Plane`].

use super::{BaseEdge, Shapes};
use crate::kinematics::{Direction, Plane, Point};
use tpg_runtime::scalar::Scalar;

/// The obstacle that the arm hits.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Collision {
    /// A joint or the hand's tip lies below the table.
    Table,
    /// A corner of the hand lies below the table.
    HandCorner,
    /// The hand or the forearm meets the arm's own base.
    Base,
}

/// The two ends of each of four segments, mm.
pub(super) type Faces<S> = [(Point<S>, Point<S>); 4];

impl<S: Scalar> Plane<S> {
    /// The first collision, in the order of the enumeration; `None` where the arm is free.
    pub fn collision(&self, shapes: &Shapes<S>) -> Option<Collision> {
        let faces = self.faces(shapes);
        self.below_table(&faces).or_else(|| {
            let base = !clear_of_base(&faces, shapes) && meets_base(&faces, shapes);
            base.then_some(Collision::Base)
        })
    }

    /// The collision with the table, if there is one.
    #[inline(always)]
    pub(super) fn below_table(&self, [(tip_upper, tip_lower), ..]: &Faces<S>) -> Option<Collision> {
        if [self.bracket, self.elbow, self.wrist, self.tip].iter().any(|point| point.z < S::ZERO) {
            Some(Collision::Table)
        } else if tip_upper.z < S::ZERO || tip_lower.z < S::ZERO {
            Some(Collision::HandCorner)
        } else {
            None
        }
    }

    /// The parts of the arm that can meet its base, as segments: the hand's tip face and lower edge, the forearm's end
    /// face and lower edge.
    pub fn faces(&self, shapes: &Shapes<S>) -> Faces<S> {
        let [tip_upper, tip_lower] = self.tip_corners(shapes);
        let heel = across(self.wrist, self.hand_across, shapes.hand_edges[1]);
        let [end_upper, end_lower] = self.forearm_end_corners(shapes);
        let elbow_lower = across(self.elbow, self.forearm_across, shapes.forearm_edges[1]);
        [(tip_upper, tip_lower), (heel, tip_lower), (end_upper, end_lower), (elbow_lower, end_lower)]
    }

    /// The corners of the hand's tip face, upper and lower.
    pub fn tip_corners(&self, shapes: &Shapes<S>) -> [Point<S>; 2] {
        shapes.hand_edges.map(|edge| offset(self.wrist, self.hand, shapes.hand_length, self.hand_across, edge))
    }

    /// The corners of the forearm's end face, upper and lower.
    pub fn forearm_end_corners(&self, shapes: &Shapes<S>) -> [Point<S>; 2] {
        let corner = |edge| offset(self.wrist, self.forearm, shapes.forearm_overhang, self.forearm_across, edge);
        shapes.forearm_edges.map(corner)
    }
}

/// Returns true if all faces lie above the whole base, or all on the same side of it: then no segment meets an edge. This
/// saves most poses 32 tests; with a NaN among the faces it is false.
fn clear_of_base<S: Scalar>(faces: &Faces<S>, shapes: &Shapes<S>) -> bool {
    let all = |beyond: fn(Point<S>, S) -> bool, limit| faces.iter().all(|&(p, q)| beyond(p, limit) && beyond(q, limit));
    if all(|point, top| point.z > top, shapes.base_top()) {
        return true;
    }
    let side = shapes.base_side();
    all(|point, side| point.x > side, side) || all(|point, side| point.x < -side, side)
}

impl<S: Scalar> Shapes<S> {
    /// Height of the base's highest point, mm.
    pub(super) fn base_top(&self) -> S {
        self.base.iter().flat_map(|edge| edge.z).fold(S::ZERO, greater)
    }

    /// Distance of the base's outermost point from its axis, mm.
    pub(super) fn base_side(&self) -> S {
        self.base.iter().flat_map(|edge| edge.x.map(S::abs)).fold(S::ZERO, greater)
    }
}

/// Returns the greater number, or the first of equals. A NaN is passed over where it is the second.
pub(super) fn greater<S: Scalar>(a: S, b: S) -> S {
    if b > a { b } else { a }
}

impl<S: Scalar> BaseEdge<S> {
    /// The same edge on the other side of the base's axis.
    pub fn mirrored(self) -> Self {
        Self { x: self.x.map(|x| -x), z: self.z }
    }
}

/// From `origin`, `along` mm in one direction and then `aside` mm in the other.
fn offset<S: Scalar>(origin: Point<S>, axis: Direction<S>, along: S, aside: Direction<S>, by: S) -> Point<S> {
    Point { x: origin.x + axis.cos * along + aside.cos * by, z: origin.z + axis.sin * along + aside.sin * by }
}

fn across<S: Scalar>(origin: Point<S>, aside: Direction<S>, by: S) -> Point<S> {
    Point { x: origin.x + aside.cos * by, z: origin.z + aside.sin * by }
}

/// A segment with what every edge asks of it: computed once, not for each of the eight.
struct Face<S> {
    /// Its two ends, the lesser one first.
    x: [S; 2],
    z: [S; 2],
    /// The line through it. Undefined where it is upright.
    slope: S,
    intercept: S,
}

impl<S: Scalar> Face<S> {
    fn new(p: Point<S>, q: Point<S>) -> Self {
        let slope = (q.z - p.z) / (q.x - p.x);
        Self { x: sorted([p.x, q.x]), z: sorted([p.z, q.z]), slope, intercept: p.z - slope * p.x }
    }
}

/// Returns true if a face meets an edge of the base.
#[inline(never)] // once in flash
pub(super) fn meets_base<S: Scalar>(faces: &Faces<S>, shapes: &Shapes<S>) -> bool {
    let faces = faces.map(|(p, q)| Face::new(p, q));
    shapes.base.iter().any(|&edge| meets(&faces, edge) || meets(&faces, edge.mirrored()))
}

/// Returns true if a face meets an axis-aligned edge; touching counts, and so does an undefined crossing.
fn meets<S: Scalar>(faces: &[Face<S>; 4], edge: BaseEdge<S>) -> bool {
    let x = sorted(edge.x);
    let z = sorted(edge.z);
    let horizontal = z[0] == z[1];
    faces.iter().any(|face| {
        if disjoint(face.x, x) || disjoint(face.z, z) {
            return false;
        }
        if face.x[0] == face.x[1] {
            return horizontal || face.x[0] == x[0];
        }
        let Face { slope, intercept, .. } = *face;
        let (crossing, bounds) =
            if horizontal { ((z[0] - intercept) / slope, x) } else { (slope * x[0] + intercept, z) };
        // A NaN crossing (a segment along the edge) is neither above nor below: it is a hit, as in the artifact.
        !(crossing > bounds[1] || crossing < bounds[0])
    })
}

fn sorted<S: Scalar>([a, b]: [S; 2]) -> [S; 2] {
    if b < a { [b, a] } else { [a, b] }
}

fn disjoint<S: Scalar>(a: [S; 2], b: [S; 2]) -> bool {
    a[1] < b[0] || b[1] < a[0]
}
