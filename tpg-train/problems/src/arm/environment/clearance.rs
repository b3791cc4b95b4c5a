//! A cheap test that the arm is far from everything, without looking at its collision shapes.

use crate::registry::Number;
use tpg_arm::Arm;
use tpg_arm::kinematics::Plane;

/// Distances from the corners of the collision shapes to their joints, and the extent of the base; mm, rounded up to
/// cover every rounding error of the kinematics.
#[derive(Clone, Copy, Debug)]
pub(super) struct Clearances<S> {
    elbow: S,
    wrist: S,
    tip: S,
    top: S,
    side: S,
}

impl<S: Number> Clearances<S> {
    /// Computes the clearances of an arm.
    pub(super) fn new(arm: &Arm<f64>) -> Self {
        let shapes = &arm.shapes;
        let widest = |edges: [f64; 2]| edges[0].abs().max(edges[1].abs());
        let (hand, forearm) = (widest(shapes.hand_edges), widest(shapes.forearm_edges));
        let most =
            |values: [[f64; 2]; 4]| values.as_flattened().iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let [elbow, wrist, tip] = [
            forearm,
            hand.max(forearm.hypot(shapes.forearm_overhang)),
            hand.hypot(shapes.hand_length - arm.links.hand),
        ]
        .map(|radius| S::from_f64(radius + 1.0));
        let [top, side] =
            [shapes.base.map(|edge| edge.z), shapes.base.map(|edge| edge.x)].map(|ends| S::from_f64(most(ends)));
        Self { elbow, wrist, tip, top, side }
    }

    /// Returns true if the arm is certainly free: high enough above the table, and above the base or
    /// to one side of it. Branch-free, for vectorisation.
    #[inline(always)]
    pub(super) fn leaves_free(&self, plane: &Plane<S>) -> bool {
        let Clearances { elbow, wrist, tip, top, side } = *self;
        let joints = [(plane.elbow, elbow), (plane.wrist, wrist), (plane.tip, tip)];
        let (mut over_table, mut above, mut before, mut behind) = (plane.bracket.z > S::ZERO, true, true, true);
        for (joint, around) in joints {
            over_table &= joint.z > around;
            above &= joint.z > top + around;
            before &= joint.x > side + around;
            behind &= joint.x < -(side + around);
        }
        over_table & (above | before | behind)
    }
}
