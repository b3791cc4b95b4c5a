//! Poses that are free because one near them is: most collision tests of a control step saved.
//!
//! A tick of a joint moves no point of the arm farther than the arm is long, times the angle of a tick. So where every part of
//! the arm is some distance from all that it can hit, as many ticks are free as would take it there, whichever joints turn.

use super::{Arm, Collision, Pose, TICKS_PER_TURN};
use crate::kinematics::{Lattice, Plane};
use core::cell::Cell;
use tpg_runtime::ops::max;

/// A pose that is free of collisions, and how far around it every pose is.
///
/// It belongs to one arm. What it knows changes no answer: [`collision`](Self::collision) is [`Plane::collision`].
#[derive(Clone, Debug)]
pub(crate) struct Leeway {
    free: Cell<Pose>,
    /// Ticks that shoulder, elbow and wrist together may be away from there; negative where nothing is known.
    ticks: Cell<i32>,
}

impl Leeway {
    /// Knows nothing yet.
    pub(crate) const fn new() -> Self {
        Self { free: Cell::new(Pose([0; 4])), ticks: Cell::new(-1) }
    }

    /// The first collision of an arm at a pose.
    #[inline(always)]
    pub(crate) fn collision<S: Lattice>(&self, arm: &Arm<S>, pose: Pose) -> Option<Collision> {
        if self.holds(pose) { None } else { self.look(arm, pose) }
    }

    #[inline(always)]
    fn holds(&self, Pose([_, here @ ..]): Pose) -> bool {
        let Pose([_, there @ ..]) = self.free.get();
        let apart = here.into_iter().zip(there).map(|(here, there)| (i32::from(here) - i32::from(there)).abs());
        apart.sum::<i32>() <= self.ticks.get()
    }

    #[inline(never)] // once in flash
    fn look<S: Lattice>(&self, arm: &Arm<S>, pose: Pose) -> Option<Collision> {
        let room = match Plane::at(arm, pose).room(&arm.shapes) {
            Ok(room) => room,
            Err(collision) => return Some(collision),
        };
        if room > S::ZERO {
            self.free.set(pose);
            self.ticks.set(ticks(arm, room));
        }
        None
    }
}

/// Ticks after which a free arm has not moved farther than `room`, in mm.
fn ticks<S: Lattice>(arm: &Arm<S>, room: S) -> i32 {
    let (links, shapes) = (&arm.links, &arm.shapes);
    let widest = |[a, b]: [S; 2]| max(b.abs(), a.abs());
    let hand = max(shapes.hand_length.abs(), links.hand) + widest(shapes.hand_edges);
    let end = shapes.forearm_overhang.abs() + widest(shapes.forearm_edges);
    let length = links.upper_arm + links.elbow_offset + links.forearm + max(end, hand);
    // Sums of lengths are rounded, by much less than this.
    let error = (length + links.base + links.shoulder_radial) * S::from_f64(1.0 / 16384.0);
    let tick = length * S::from_f64(1.001 * core::f64::consts::TAU / TICKS_PER_TURN as f64);
    ((room - error) / tick).to_i32()
}

#[cfg(test)]
mod tests {
    use super::Leeway;
    use crate::arm::{Arm, Collision, Links, Pose, WIDOWX};
    use crate::kinematics::{Lattice, Plane};
    use proptest::prelude::*;

    /// Its shoulder is in front of the base's axis.
    const RADIAL: Arm<f64> = Arm { links: Links { shoulder_radial: 30.4, ..WIDOWX.links }, ..WIDOWX };

    fn plainly<S: Lattice>(arm: &Arm<S>, pose: Pose) -> Option<Collision> {
        Plane::at(arm, pose).collision(&arm.shapes)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2_000))]

        /// Along walks of single joints through the whole range, table and base included.
        #[test]
        fn a_walk_collides_where_it_does_without_memory(
            start in prop::array::uniform3(1025i16..3072),
            walk in prop::collection::vec((0usize..3, -1i16..=1, 1i16..40, 1i16..30), 1..20),
        ) {
            let single = WIDOWX.to_f32();
            let leeways = [(); 3].map(|()| Leeway::new());
            let mut plane = start.map(i32::from);
            for (joint, way, ticks, steps) in walk {
                for _ in 0..steps {
                    plane[joint] = (plane[joint] + i32::from(way * ticks)).clamp(1025, 3071);
                    let [shoulder, elbow, wrist] = plane.map(|ticks| ticks as i16);
                    let pose = Pose([0, shoulder, elbow, wrist]);
                    prop_assert_eq!(leeways[0].collision(&single, pose), plainly(&single, pose), "f32 {:?}", pose);
                    prop_assert_eq!(leeways[1].collision(&WIDOWX, pose), plainly(&WIDOWX, pose), "f64 {:?}", pose);
                    prop_assert_eq!(leeways[2].collision(&RADIAL, pose), plainly(&RADIAL, pose), "radial {:?}", pose);
                }
            }
        }
    }

    #[test]
    fn near_home_nothing_is_looked_up() {
        let leeway = Leeway::new();
        assert!(!leeway.holds(WIDOWX.home));
        assert_eq!(leeway.collision(&WIDOWX, WIDOWX.home), None);
        assert!(leeway.holds(Pose([9, 2048 + 10, 2048 - 10, 2048 + 10])));
        assert!(!leeway.holds(Pose([2048, 1025, 2048, 2048])));
    }

    #[test]
    fn of_an_arm_that_is_not_a_number_nothing_is_known() {
        let [mut hand, mut corner, mut link] = [WIDOWX; 3];
        hand.shapes.hand_edges[1] = f64::NAN;
        corner.shapes.forearm_edges[0] = f64::NAN;
        link.links.forearm = f64::NAN;
        for arm in [hand, corner, link] {
            let leeway = Leeway::new();
            assert_eq!(leeway.collision(&arm, arm.home), plainly(&arm, arm.home));
            assert!(!leeway.holds(arm.home));
        }
    }
}
