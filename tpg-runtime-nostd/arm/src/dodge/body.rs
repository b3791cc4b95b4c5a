//! An arm with a volume: four capsules along its links, their distance from balls, and how the joints change it.

use super::ball::Ball;
use super::plan::STEP;
use crate::arm::collision::Base;
use crate::arm::{Arm, JOINTS, Links, Pose, TICKS_PER_TURN};
use crate::kinematics::{Direction, Directions, Lattice, Plane, Point, Vector, base_direction};

/// Number of capsules: shoulder to bracket, bracket to elbow, forearm, hand.
pub const CAPSULES: usize = 4;

/// Radii of the WidowX's capsules, mm: shoulder to bracket, bracket to elbow, forearm, hand.
pub const WIDOWX_RADII: [f32; CAPSULES] = [28.0, 28.0, 24.0, 32.0];

/// An arm whose links are capsules.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// The arm.
    pub arm: Arm<f32>,
    /// Radii of the capsules, mm.
    radii: [f32; CAPSULES],
    /// 1 / length², mm⁻²; 0 for a link without length, which is a ball then.
    inverse_squares: [f32; CAPSULES],
    /// The greatest of the radii, mm.
    widest: f32,
    /// The base, and the furthest that a corner of forearm or hand lies from the joints' points, mm.
    base: Base<f32>,
    width: f32,
    /// The most that a step moves a point of the arm, mm: within the arm plane, and in space.
    motion: [f32; 2],
}

/// The larger magnitude.
const fn larger(a: f32, b: f32) -> f32 {
    let (a, b) = (a.abs(), b.abs());
    if b > a { b } else { a }
}

/// The most that a step of every joint moves a point of an arm, mm: within the arm plane, and in space.
const fn motion(arm: &Arm<f32>) -> [f32; 2] {
    let (links, shapes) = (&arm.links, &arm.shapes);
    // Points that lie furthest beyond wrist, elbow and shoulder. Sums of lengths are rounded, by much less than a thousandth.
    let hand = larger(links.hand, shapes.hand_length) + larger(shapes.hand_edges[0], shapes.hand_edges[1]);
    let end = shapes.forearm_overhang.abs() + larger(shapes.forearm_edges[0], shapes.forearm_edges[1]);
    let wrist = larger(hand, end);
    let elbow = links.forearm + wrist;
    let shoulder = links.upper_arm + links.elbow_offset.abs() + elbow;
    let angle = STEP as f32 * (1.001 * core::f32::consts::TAU / TICKS_PER_TURN as f32);
    let plane = angle * (shoulder + elbow + wrist);
    [plane, plane + angle * (shoulder + links.shoulder_radial.abs())]
}

/// The furthest that a corner of forearm or hand lies from the joints' points, mm.
const fn width(arm: &Arm<f32>) -> f32 {
    let shapes = &arm.shapes;
    let edges = larger(
        larger(shapes.hand_edges[0], shapes.hand_edges[1]),
        larger(shapes.forearm_edges[0], shapes.forearm_edges[1]),
    );
    // Beyond the points lie the ends of hand and forearm.
    edges + larger(shapes.hand_length - arm.links.hand, shapes.forearm_overhang)
}

/// The body at a pose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Posture {
    /// Direction of the base joint.
    pub base: Direction<f32>,
    /// Shoulder, bracket, elbow, wrist and tip in the arm plane.
    points: [Point<f32>; CAPSULES + 1],
    /// Directions of forearm and hand.
    forearm: Direction<f32>,
    hand: Direction<f32>,
}

/// The box around the capsules' axes in the arm plane: its least and greatest distance from the base's axis, and heights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Outline {
    x: [f32; 2],
    z: [f32; 2],
}

/// The place where a ball is nearest to the body. Vectors are in the arm's frame: along the arm plane, across it, up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Nearest {
    /// Distance between the two surfaces, mm; negative where they overlap.
    pub clearance: f32,
    /// Index of the capsule.
    pub capsule: usize,
    /// The nearest point of the capsule's axis.
    pub point: Point<f32>,
    /// Unit vector from the ball's centre towards that point.
    pub away: Vector<f32>,
}

impl Body {
    /// Gives an arm capsules of these radii, mm: shoulder to bracket, bracket to elbow, forearm, hand.
    pub const fn new(arm: Arm<f32>, radii: [f32; CAPSULES]) -> Self {
        const fn inverse_square(length: f32) -> f32 {
            if length > 0.0 { 1.0 / (length * length) } else { 0.0 }
        }
        let Links { upper_arm, elbow_offset, forearm, hand, .. } = arm.links;
        let inverse_squares =
            [inverse_square(upper_arm), inverse_square(elbow_offset), inverse_square(forearm), inverse_square(hand)];
        let widest = larger(larger(radii[0], radii[1]), larger(radii[2], radii[3]));
        Self {
            arm,
            radii,
            inverse_squares,
            widest,
            base: Base::new(&arm.shapes),
            width: width(&arm),
            motion: motion(&arm),
        }
    }

    /// Places the body at a pose.
    #[inline(never)] // once in flash
    pub fn at(&self, pose: Pose) -> Posture {
        let Plane { bracket, elbow, wrist, tip, forearm, hand, .. } = Plane::new(&self.arm, Directions::at(pose));
        Posture { base: base_direction(pose), points: [self.arm.shoulder(), bracket, elbow, wrist, tip], forearm, hand }
    }

    /// Returns the distance between the surfaces of the body and of a ball, mm; negative where they overlap.
    #[inline]
    pub fn clearance(&self, posture: &Posture, centre: Vector<f32>, radius: f32) -> f32 {
        let ball = posture.in_frame(centre);
        let mut least = f32::INFINITY;
        for capsule in 0..CAPSULES {
            let clearance = distance(self.foot(posture, capsule, ball), ball) - self.radii[capsule];
            if clearance < least {
                least = clearance;
            }
        }
        least - radius
    }

    /// Returns the least clearance of several balls after a number of steps at their velocities, mm; infinite without balls.
    #[inline]
    pub fn clearance_of_all(&self, posture: &Posture, balls: &[Ball], steps: f32) -> f32 {
        let clearances = balls.iter().map(|ball| self.clearance(posture, ball.after(steps), ball.radius));
        clearances.fold(f32::INFINITY, |least, clearance| if clearance < least { clearance } else { least })
    }

    /// Returns where a ball is nearest.
    pub fn nearest(&self, posture: &Posture, centre: Vector<f32>, radius: f32) -> Nearest {
        let ball = posture.in_frame(centre);
        let (mut least, mut far) = (f32::INFINITY, 1.0);
        let (mut capsule, mut point) = (0, posture.points[0]);
        for index in 0..CAPSULES {
            let foot = self.foot(posture, index, ball);
            let distance = distance(foot, ball);
            let clearance = distance - self.radii[index];
            if clearance < least {
                (least, far, capsule, point) = (clearance, distance, index, foot);
            }
        }
        // A ball whose centre lies on the axis has no direction: the zero vector.
        let inverse = if far > 1e-3 { 1.0 / far } else { 0.0 };
        let [along, across, up] = ball;
        let away = [(point.x - along) * inverse, -across * inverse, (point.z - up) * inverse];
        Nearest { clearance: least - radius, capsule, point, away }
    }

    /// Returns by how much each joint changes the clearance, mm a radian: base, shoulder, elbow, wrist.
    pub fn gradient(&self, posture: &Posture, nearest: &Nearest) -> [f32; JOINTS] {
        let Nearest { capsule, point, away: [along, across, up], .. } = *nearest;
        let [shoulder, _, elbow, wrist, _] = posture.points;
        let about = |joint: Point<f32>| (point.x - joint.x) * up - (point.z - joint.z) * along;
        // Elbow and wrist turn their links against the way angles grow; a joint moves only what lies beyond it.
        [
            point.x * across,
            about(shoulder),
            if capsule >= 2 { -about(elbow) } else { 0.0 },
            if capsule >= 3 { -about(wrist) } else { 0.0 },
        ]
    }

    /// Returns true if the arm touches neither the table nor its own base.
    #[inline]
    pub fn is_free(&self, posture: &Posture) -> bool {
        self.is_free_after(posture).0
    }

    /// The answer of [`is_free`](Self::is_free), and the number of faces of the arm, at most 4, that were compared with the base.
    #[inline]
    pub(super) fn is_free_after(&self, posture: &Posture) -> (bool, u16) {
        posture.plane().is_free(&self.arm.shapes, &self.base)
    }

    /// Returns true only if the arm touches neither table nor base, at a tenth of the price of [`is_free`](Self::is_free):
    /// false near them says nothing.
    #[inline]
    pub fn is_clearly_free(&self, posture: &Posture) -> bool {
        self.keeps_clear(posture, 0.0)
    }

    /// Returns true only if the arm touches neither table nor base after any step from here.
    #[inline]
    pub fn is_free_next(&self, posture: &Posture) -> bool {
        self.keeps_clear(posture, self.motion[0])
    }

    /// Returns the most that a step moves a point of the arm, mm.
    #[inline]
    pub fn motion(&self) -> f32 {
        self.motion[1]
    }

    /// True only if nothing is touched wherever the points are up to `room` mm away.
    #[inline(always)]
    fn keeps_clear(&self, posture: &Posture, room: f32) -> bool {
        let [_, bracket, elbow, wrist, tip] = &posture.points;
        let (mut x, mut z) = ([elbow.x; 2], elbow.z);
        for point in [wrist, tip] {
            widen(&mut x, point.x);
            z = if point.z < z { point.z } else { z };
        }
        let width = self.width + room;
        let (top, side) = (self.base.top + width, self.base.side + width);
        z > width && bracket.z > width && (z > top || x[0] > side || x[1] < -side)
    }

    /// Returns a lower bound of [`clearance`](Self::clearance), mm, at a fifth of its price.
    #[inline]
    pub fn clearance_bound(&self, posture: &Posture, outline: &Outline, centre: Vector<f32>, radius: f32) -> f32 {
        let [along, across, up] = posture.in_frame(centre);
        let (x, z) = (beyond(outline.x, along), beyond(outline.z, up));
        Lattice::sqrt(x * x + z * z + across * across) - self.widest - radius
    }

    /// The point of a capsule's axis that is nearest to a ball.
    #[inline(always)]
    fn foot(&self, posture: &Posture, capsule: usize, [along, _, up]: Vector<f32>) -> Point<f32> {
        let (start, end) = (posture.points[capsule], posture.points[capsule + 1]);
        let (dx, dz) = (end.x - start.x, end.z - start.z);
        let place = ((along - start.x) * dx + (up - start.z) * dz) * self.inverse_squares[capsule];
        #[expect(clippy::manual_clamp, reason = "the instructions of these two comparisons are counted")]
        let place = if place < 0.0 {
            0.0
        } else if place > 1.0 {
            1.0
        } else {
            place
        };
        Point { x: start.x + dx * place, z: start.z + dz * place }
    }
}

impl Posture {
    /// Returns the arm seen from its side.
    #[inline]
    pub fn plane(&self) -> Plane<f32> {
        let Self { points: [_, bracket, elbow, wrist, tip], forearm, hand, .. } = *self;
        let (forearm_across, hand_across) = (forearm.quarter_behind(), hand.quarter_behind());
        Plane { bracket, elbow, wrist, tip, forearm, forearm_across, hand, hand_across }
    }

    /// Turns a vector of the world into the arm's frame: along the arm plane, across it, up.
    #[inline]
    pub fn in_frame(&self, [x, y, z]: Vector<f32>) -> Vector<f32> {
        let Direction { cos, sin } = self.base;
        [x * sin - y * cos, x * cos + y * sin, z]
    }

    /// Returns the box around the capsules' axes.
    #[inline]
    pub fn outline(&self) -> Outline {
        let [first, others @ ..] = &self.points;
        let mut outline = Outline { x: [first.x; 2], z: [first.z; 2] };
        for point in others {
            widen(&mut outline.x, point.x);
            widen(&mut outline.z, point.z);
        }
        outline
    }

    /// Returns the place of the hand's tip in the world, mm.
    #[inline]
    pub fn hand(&self) -> Vector<f32> {
        self.plane().hand_in_world(self.base)
    }

    /// Returns the point at a fraction, 0 to 1, of a capsule's axis in the world, mm; of the last capsule beyond it.
    pub fn on_axis(&self, capsule: usize, place: f32) -> Vector<f32> {
        let capsule = capsule.min(CAPSULES - 1);
        let (start, end) = (self.points[capsule], self.points[capsule + 1]);
        let (x, z) = (start.x + (end.x - start.x) * place, start.z + (end.z - start.z) * place);
        [x * self.base.sin, -(x * self.base.cos), z]
    }
}

/// The distance of a point of the arm plane from a point of space.
#[inline(always)]
fn distance(point: Point<f32>, [along, across, up]: Vector<f32>) -> f32 {
    let (x, z) = (point.x - along, point.z - up);
    Lattice::sqrt(x * x + z * z + across * across)
}

/// Widens a range so that it holds a value.
#[inline(always)]
fn widen([low, high]: &mut [f32; 2], value: f32) {
    if value < *low {
        *low = value;
    }
    if value > *high {
        *high = value;
    }
}

/// The distance of a value from a range; 0 inside.
#[inline(always)]
fn beyond([low, high]: [f32; 2], value: f32) -> f32 {
    if value < low {
        low - value
    } else if value > high {
        value - high
    } else {
        0.0
    }
}
