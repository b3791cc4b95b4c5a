//! An arm at a pose: points and axes, and what follows from them.

use crate::kinematics::{Lattice, Vector, difference, distance};

/// An arm of `N` joints at a pose, in the world, mm.
///
/// Link *i* reaches from joint *i* to the next one, the last to the tip; joints 0 to *i* move it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed<S, const N: usize> {
    /// A point of each joint's axis.
    pub points: [Vector<S>; N],
    /// The direction of each axis, of length 1: a rising position turns as the right hand's fingers whose thumb it is.
    pub axes: [Vector<S>; N],
    /// The tip.
    pub tip: Vector<S>,
}

/// The place where a ball is nearest to an arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Near<S> {
    /// Distance between the two surfaces, mm; negative where they overlap.
    pub clearance: S,
    /// Index of the link.
    pub link: usize,
    /// The nearest point of the line along the link.
    pub point: Vector<S>,
    /// Unit vector from the ball's centre towards that point; zero where they are one.
    pub away: Vector<S>,
}

impl<S: Lattice, const N: usize> Placed<S, N> {
    /// Returns how each joint moves the tip, mm a radian.
    pub fn jacobian(&self) -> [Vector<S>; N] {
        core::array::from_fn(|joint| self.turning(joint, self.tip))
    }

    /// Returns where a ball is nearest to the links, which are capsules of these radii, mm. An arm without joints is infinitely
    /// far away.
    pub fn near(&self, radii: &[S; N], centre: Vector<S>, radius: S) -> Near<S> {
        let far = S::from_f64(f64::INFINITY);
        let mut near = Near { clearance: far, link: 0, point: self.tip, away: [S::ZERO; 3] };
        let ends = self.points.iter().skip(1).chain([&self.tip]);
        for (link, ((start, end), own)) in self.points.iter().zip(ends).zip(radii).enumerate() {
            let point = foot(*start, *end, centre);
            let off = distance(point, centre);
            if off - *own - radius < near.clearance {
                let inverse = if off > S::from_f64(1e-3) { S::ONE / off } else { S::ZERO };
                let away = difference(point, centre).map(|value| value * inverse);
                near = Near { clearance: off - *own - radius, link, point, away };
            }
        }
        near
    }

    /// Returns how each joint changes the clearance of a ball that stays, mm a radian.
    pub fn gradient(&self, near: &Near<S>) -> [S; N] {
        core::array::from_fn(|joint| {
            // A joint moves only what lies beyond it.
            if joint <= near.link { dot(self.turning(joint, near.point), near.away) } else { S::ZERO }
        })
    }

    /// Returns the speed at which a joint moves a point behind it, mm a radian; 0 for a joint that does not exist.
    fn turning(&self, joint: usize, point: Vector<S>) -> Vector<S> {
        let axis = self.points.get(joint).zip(self.axes.get(joint));
        axis.map_or([S::ZERO; 3], |(at, axis)| cross(*axis, difference(point, *at)))
    }
}

/// The point of the line from `start` to `end` that is nearest to another.
fn foot<S: Lattice>(start: Vector<S>, end: Vector<S>, other: Vector<S>) -> Vector<S> {
    let line = difference(end, start);
    let square = dot(line, line);
    let place = if square > S::ZERO { dot(difference(other, start), line) / square } else { S::ZERO };
    let place = if place < S::ZERO {
        S::ZERO
    } else if place > S::ONE {
        S::ONE
    } else {
        place
    };
    let [x, y, z] = start;
    [x + line[0] * place, y + line[1] * place, z + line[2] * place]
}

fn dot<S: Lattice>(a: Vector<S>, b: Vector<S>) -> S {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross<S: Lattice>(a: Vector<S>, b: Vector<S>) -> Vector<S> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
