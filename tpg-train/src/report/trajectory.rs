//! Drawings of episodes: the arm from the side and from above.

use super::test::{OnTheArm, Walk};
use crate::picture::{Figure, Point, Svg};
use tpg_arm::kinematics::{Plane, Vector, base_direction};
use tpg_arm::{Arm, Pose};

/// Size of a panel in pixels; there are two panels.
const PANEL: f64 = 300.0;

pub(super) fn figures(of: &OnTheArm) -> Vec<Figure> {
    of.walks.iter().map(|walk| figure(&of.arm, walk)).collect()
}

fn figure(arm: &Arm<f64>, walk: &Walk) -> Figure {
    let (Some(&first), Some(&last)) = (walk.poses.first(), walk.poses.last()) else { return Figure::default() };
    let view = View::new(arm);
    let mut svg = Svg::new(2.0 * PANEL, PANEL);
    svg.rect("body", view.side([-view.reach, 0.0]), [PANEL, PANEL - view.side([0.0, 0.0])[1]], "the table");
    for edge in arm.shapes.base {
        for sign in [1.0, -1.0] {
            svg.line("rule", view.side([sign * edge.x[0], edge.z[0]]), view.side([sign * edge.x[1], edge.z[1]]));
        }
    }
    let [x, y] = view.above([0.0, 0.0]);
    svg.circle(
        "body",
        [x, y],
        view.scale * arm.shapes.base.iter().flat_map(|edge| edge.x).fold(0.0, f64::max),
        "the base",
    );
    for (pose, class) in [(first, "thick faint c7"), (last, "thick c0")] {
        let joints = joints(arm, pose);
        svg.polyline(class, &joints.map(|joint| view.side([joint[0], joint[2]])));
        let base = base_direction::<f64>(pose);
        // Rotated as the tip in `Plane::hand_in_world`.
        svg.polyline(class, &joints.map(|joint| view.above([joint[0] * base.sin, -(joint[0] * base.cos)])));
    }
    let hands: Vec<(Pose, Vector<f64>)> =
        walk.poses.iter().map(|&pose| (pose, tpg_arm::kinematics::hand(arm, pose))).collect();
    let side = hands.iter().map(|(pose, hand)| view.side([Plane::at(arm, *pose).tip.x, hand[2]]));
    svg.polyline("line c1", &side.collect::<Vec<_>>());
    svg.polyline("line c1", &hands.iter().map(|(_, hand)| view.above([hand[0], hand[1]])).collect::<Vec<_>>());
    let [x, y, z] = walk.target;
    let base = base_direction::<f64>(last);
    svg.circle("fill c2", view.side([x * base.sin - y * base.cos, z]), 5.0, "target, in the last pose's plane");
    svg.circle("fill c2", view.above([x, y]), 5.0, "target");
    svg.text("note", [6.0, 14.0], "side");
    svg.text("note", [PANEL + 6.0, 14.0], "above");
    let actions = walk.poses.len() - 1;
    let caption = format!(
        "Episode {}: {} after {actions} actions, {:.1} mm from the target (green). Grey: the arm at the start, blue: at the \
         end, orange: the way of the hand.",
        walk.number, walk.outcome, walk.distance
    );
    Figure { svg: svg.finish("an episode"), caption, ..Figure::default() }
}

/// Returns shoulder, bracket, elbow, wrist and tip in the arm's plane, as x, 0, z.
fn joints(arm: &Arm<f64>, pose: Pose) -> [[f64; 3]; 6] {
    let plane = Plane::at(arm, pose);
    let [shoulder, bracket, elbow, wrist, tip] =
        [arm.shoulder(), plane.bracket, plane.elbow, plane.wrist, plane.tip].map(|p| [p.x, 0.0, p.z]);
    [[0.0, 0.0, 0.0], shoulder, bracket, elbow, wrist, tip]
}

/// Maps mm to positions in the picture.
struct View {
    reach: f64,
    scale: f64,
}

impl View {
    fn new(arm: &Arm<f64>) -> Self {
        let reach = 1.03 * arm.reach().max(arm.links.base);
        Self { reach, scale: PANEL / (2.0 * reach) }
    }

    /// Maps a point of the arm's plane.
    fn side(&self, [x, z]: [f64; 2]) -> Point {
        // The table is below the middle: an arm reaches further up than to its sides.
        [(x + self.reach) * self.scale, PANEL * 0.93 - z * self.scale]
    }

    /// Maps a point of the table, seen from above.
    fn above(&self, [x, y]: [f64; 2]) -> Point {
        [PANEL + (x + self.reach) * self.scale, (self.reach - y) * self.scale]
    }
}
