//! The collision test of the paper's environment, in the arm plane (`ArmLearnWrapper.cpp`, lines 1026–1179).
//!
//! There is no link–link test and none of the upper arm, as in the artifact. The order of operations is the artifact's,
//! so that the conformance suite can run this very code on its own [`Plane`].

use super::{BaseEdge, Shapes};
use crate::kinematics::{Plane, Point};
use tpg_runtime::ops::{max, min};
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
type Faces<S> = [(Point<S>, Point<S>); 4];

impl<S: Scalar> Plane<S> {
    /// The first collision, in the order of the enumeration; `None` where the arm is free.
    pub fn collision(&self, shapes: &Shapes<S>) -> Option<Collision> {
        self.room(shapes).err()
    }

    /// A distance that every part of the arm can move without a collision, mm. It is less than the greatest one, and 0 or
    /// negative where the arm may be free all the same; NaN where one of its points is.
    ///
    /// # Errors
    /// The first collision.
    #[inline(never)] // once in flash
    pub(super) fn room(&self, shapes: &Shapes<S>) -> Result<S, Collision> {
        let faces = self.faces(shapes);
        if let Some(collision) = self.below_table(&faces) {
            return Err(collision);
        }
        let room = min(self.over_table(&faces), beyond_base(&faces, shapes));
        // Most poses have room, which saves the tests of each face with each edge.
        if room > S::ZERO || !meets_base(&faces, shapes) { Ok(room) } else { Err(Collision::Base) }
    }

    /// Returns true where there is no [collision](Self::collision), and the number of faces, at most 4, that had to be compared with
    /// the base's edges: most poses need none.
    #[inline(never)] // once in flash
    pub(crate) fn is_free(&self, shapes: &Shapes<S>, base: &Base<S>) -> (bool, u16) {
        let faces = self.faces(shapes);
        if self.below_table(&faces).is_some() {
            return (false, 0);
        }
        let mut compared = 0;
        for (p, q) in faces {
            let (x, z) = (sorted([p.x, q.x]), sorted([p.z, q.z]));
            if z[0] > base.top || x[0] > base.side || x[1] < -base.side {
                continue;
            }
            compared += 1;
            let face = Face::new(p, q);
            if base.edges.iter().any(|edge| face.meets(edge)) {
                return (false, compared);
            }
        }
        (true, compared)
    }

    /// The collision with the table, if there is one.
    #[inline(always)]
    fn below_table(&self, [(tip_upper, tip_lower), ..]: &Faces<S>) -> Option<Collision> {
        if [self.bracket, self.elbow, self.wrist, self.tip].iter().any(|point| point.z < S::ZERO) {
            Some(Collision::Table)
        } else if tip_upper.z < S::ZERO || tip_lower.z < S::ZERO {
            Some(Collision::HandCorner)
        } else {
            None
        }
    }

    /// Height of the lowest of the points that the table stops, mm.
    #[inline(always)]
    fn over_table(&self, [(tip_upper, tip_lower), ..]: &Faces<S>) -> S {
        let points = [self.bracket, self.elbow, self.wrist, self.tip, *tip_upper, *tip_lower];
        points.into_iter().fold(S::from_f64(f64::INFINITY), |height, point| min(height, point.z))
    }

    /// The parts of the arm that can meet its base, as segments: the hand's tip face and lower edge, the forearm's end
    /// face and lower edge.
    pub fn faces(&self, shapes: &Shapes<S>) -> Faces<S> {
        let [tip_upper, tip_lower] = self.tip_corners(shapes);
        let heel = self.wrist.along(self.hand_across, shapes.hand_edges[1]);
        let [end_upper, end_lower] = self.forearm_end_corners(shapes);
        let elbow_lower = self.elbow.along(self.forearm_across, shapes.forearm_edges[1]);
        [(tip_upper, tip_lower), (heel, tip_lower), (end_upper, end_lower), (elbow_lower, end_lower)]
    }

    /// The corners of the hand's tip face, upper and lower.
    pub fn tip_corners(&self, shapes: &Shapes<S>) -> [Point<S>; 2] {
        let face = self.wrist.along(self.hand, shapes.hand_length);
        shapes.hand_edges.map(|edge| face.along(self.hand_across, edge))
    }

    /// The corners of the forearm's end face, upper and lower.
    pub fn forearm_end_corners(&self, shapes: &Shapes<S>) -> [Point<S>; 2] {
        let face = self.wrist.along(self.forearm, shapes.forearm_overhang);
        shapes.forearm_edges.map(|edge| face.along(self.forearm_across, edge))
    }
}

/// Least distance by which a face lies above the whole base or beside it, mm; 0 or negative where one does neither, and NaN
/// where a point of one is.
#[inline(always)]
fn beyond_base<S: Scalar>(faces: &Faces<S>, shapes: &Shapes<S>) -> S {
    // Comparisons may pass a NaN over; a sum does not.
    let known = faces.iter().fold(S::ZERO, |sum, (p, q)| sum + p.x + p.z + q.x + q.z);
    if known.is_nan() {
        return known;
    }
    let (top, side) = (shapes.base_top(), shapes.base_side());
    faces.iter().fold(S::from_f64(f64::INFINITY), |room, (p, q)| {
        let beside = max(-max(q.x, p.x), min(p.x, q.x)) - side;
        min(room, max(beside, min(p.z, q.z) - top))
    })
}

/// The arm's own base, made ready for [`Plane::is_free`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Base<S> {
    /// Its edges, the lesser numbers first.
    edges: [BaseEdge<S>; 4],
    /// Height of its highest point, and distance of its outermost one from its axis, mm.
    pub(crate) top: S,
    pub(crate) side: S,
}

impl Base<f32> {
    /// Makes a base ready.
    pub(crate) const fn new(shapes: &Shapes<f32>) -> Self {
        const fn order([a, b]: [f32; 2]) -> [f32; 2] {
            if b < a { [b, a] } else { [a, b] }
        }
        const fn larger(a: f32, b: f32) -> f32 {
            if b > a { b } else { a }
        }
        let (mut edges, mut top, mut side, mut place) = (shapes.base, 0.0, 0.0, 0);
        while place < edges.len() {
            let edge = &mut edges[place];
            *edge = BaseEdge { x: order(edge.x), z: order(edge.z) };
            top = larger(top, edge.z[1]);
            side = larger(side, larger(-edge.x[0], edge.x[1]));
            place += 1;
        }
        Self { edges, top, side }
    }
}

impl<S: Scalar> Shapes<S> {
    /// Height of the base's highest point, mm.
    fn base_top(&self) -> S {
        self.base.iter().flat_map(|edge| edge.z).fold(S::ZERO, |top, z| max(z, top))
    }

    /// Distance of the base's outermost point from its axis, mm.
    fn base_side(&self) -> S {
        self.base.iter().flat_map(|edge| edge.x.map(S::abs)).fold(S::ZERO, |side, x| max(x, side))
    }
}

/// A segment with what every edge asks of it: computed once, not for each of them.
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
fn meets_base<S: Scalar>(faces: &Faces<S>, shapes: &Shapes<S>) -> bool {
    let edges = shapes.base.map(|edge| BaseEdge { x: sorted(edge.x), z: sorted(edge.z) });
    faces.iter().any(|&(p, q)| {
        let face = Face::new(p, q);
        edges.iter().any(|edge| face.meets(edge))
    })
}

impl<S: Scalar> Face<S> {
    /// Returns true if the face meets an axis-aligned edge, whose lesser numbers come first, or its mirror image; touching
    /// counts, and so does an undefined crossing.
    fn meets(&self, &BaseEdge { x: [near, far], z }: &BaseEdge<S>) -> bool {
        if disjoint(self.z, z) {
            return false;
        }
        let Self { slope, intercept, .. } = *self;
        let upright = self.x[0] == self.x[1];
        // A NaN crossing (a segment along the edge) is neither above nor below: it is a hit, as in the artifact.
        let outside = |crossing: S, [from, to]: [S; 2]| crossing > to || crossing < from;
        let mut both = [[near, far], [-far, -near]].into_iter().filter(|&x| !disjoint(self.x, x));
        if z[0] == z[1] {
            let crossing = (z[0] - intercept) / slope;
            both.any(|x| upright || !outside(crossing, x))
        } else {
            both.any(|[x, _]| if upright { self.x[0] == x } else { !outside(slope * x + intercept, z) })
        }
    }
}

fn sorted<S: Scalar>([a, b]: [S; 2]) -> [S; 2] {
    if b < a { [b, a] } else { [a, b] }
}

fn disjoint<S: Scalar>(a: [S; 2], b: [S; 2]) -> bool {
    a[1] < b[0] || b[1] < a[0]
}
