//! Clearance: the distance of an arm from a change of its collision result.
//!
//! Two ways of computing the same pose can disagree about a collision only if the arm almost touches something; this
//! module measures that.

use tpg_arm::kinematics::{Plane, Point};
use tpg_arm::{BaseEdge, Shapes};

type LinkSegment = (Point<f64>, Point<f64>);

/// Returns the smallest distance, mm, among everything that the collision test compares: joints and hand corners with
/// the table's height, and the arm's faces with the base's edges, at the ends of either.
///
/// A collision result can change only in a pose where this is 0.
pub(crate) fn clearance(plane: &Plane<f64>, shapes: &Shapes<f64>) -> f64 {
    let faces = plane.faces(shapes);
    let [(tip_upper, tip_lower), ..] = faces;
    let joints = [plane.bracket, plane.elbow, plane.wrist, plane.tip];
    let heights = joints.iter().chain([&tip_upper, &tip_lower]).map(|point| point.z.abs());
    let edges = shapes.base.iter().flat_map(|&edge| [edge, BaseEdge { x: edge.x.map(|x| -x), ..edge }]).map(|edge| {
        let [from, to] = [0, 1].map(|end| Point { x: edge.x[end], z: edge.z[end] });
        (from, to)
    });
    let distances = edges.flat_map(|edge| faces.map(|face| between_ends(face, edge)));
    heights.chain(distances).fold(f64::INFINITY, f64::min)
}

/// Returns the smallest distance from an end of either segment to the other segment.
fn between_ends(a: LinkSegment, b: LinkSegment) -> f64 {
    let ends = [to_segment(a.0, b), to_segment(a.1, b), to_segment(b.0, a), to_segment(b.1, a)];
    ends.into_iter().fold(f64::INFINITY, f64::min)
}

fn to_segment(point: Point<f64>, (from, to): LinkSegment) -> f64 {
    let (along_x, along_z) = (to.x - from.x, to.z - from.z);
    let (x, z) = (point.x - from.x, point.z - from.z);
    let length_squared = along_x * along_x + along_z * along_z;
    let part = if length_squared > 0.0 { (x * along_x + z * along_z) / length_squared } else { 0.0 };
    let part = part.clamp(0.0, 1.0);
    (x - part * along_x).hypot(z - part * along_z)
}

#[cfg(test)]
mod tests {
    use super::{clearance, to_segment};
    use tpg_arm::WIDOWX;
    use tpg_arm::kinematics::Point;
    use tpg_paper::plane;

    #[test]
    fn distances_are_to_the_segment_not_to_its_line() {
        let point = |x, z| Point { x, z };
        let segment = (point(0.0, 0.0), point(10.0, 0.0));
        assert_eq!(to_segment(point(5.0, 3.0), segment), 3.0);
        assert_eq!(to_segment(point(13.0, 4.0), segment), 5.0);
        assert_eq!(to_segment(point(3.0, 4.0), (point(0.0, 0.0), point(0.0, 0.0))), 5.0);
    }

    #[test]
    fn the_arm_at_home_is_far_from_everything() {
        assert!(clearance(&plane::at(&WIDOWX, WIDOWX.home), &WIDOWX.shapes) > 50.0);
    }
}
