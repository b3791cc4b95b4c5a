//! Pictures of episodes: the arm from the side and from above.

use tpg_arm::kinematics::{Plane, base_direction, hand};
use tpg_arm::{Arm, JOINTS, Pose};
use tpg_picture::{Point, Svg};

/// Size of a panel in pixels; there are two panels.
const PANEL: f64 = 300.0;

/// Returns what a picture needs to know of a moment: positions in ticks, then the target in mm; centre and radius of each ball may
/// follow.
pub(crate) fn moment(pose: Pose, target: [f64; 3]) -> Vec<f64> {
    pose.0.map(f64::from).into_iter().chain(target).collect()
}

/// Draws the arm at the start (grey) and at the end (blue), the way of the hand (orange), the target (green), and balls at the end
/// with their ways (pink).
pub(crate) fn picture(arm: &Arm<f64>, moments: &[Vec<f64>]) -> String {
    let pose = |moment: &[f64]| Pose(std::array::from_fn(|joint| moment[joint] as i16));
    let poses: Vec<Pose> = moments.iter().map(|moment| pose(moment)).collect();
    let (Some(&first), Some(&last), Some(moment)) = (poses.first(), poses.last(), moments.first()) else {
        return String::new();
    };
    let view = DrawnView::new(arm);
    let mut svg = Svg::new(2.0 * PANEL, PANEL);
    svg.rect("body", view.side([-view.reach, 0.0]), [PANEL, PANEL - view.side([0.0, 0.0])[1]], "the table");
    for edge in arm.shapes.base {
        for sign in [1.0, -1.0] {
            svg.line("rule", view.side([sign * edge.x[0], edge.z[0]]), view.side([sign * edge.x[1], edge.z[1]]));
        }
    }
    let widest = arm.shapes.base.iter().flat_map(|edge| edge.x).fold(0.0, f64::max);
    svg.circle("body", view.above([0.0, 0.0]), view.scale * widest, "the base");
    for (pose, class) in [(first, "thick faint c7"), (last, "thick c0")] {
        let joints = joints(arm, pose);
        svg.polyline(class, &joints.map(|joint| view.side(joint)));
        let base = base_direction::<f64>(pose);
        // Rotated as the tip in `Plane::hand_in_world`.
        svg.polyline(class, &joints.map(|[x, _]| view.above([x * base.sin, -(x * base.cos)])));
    }
    let hands = poses.iter().map(|&pose| (Plane::at(arm, pose).tip.x, hand(arm, pose)));
    let (side, above): (Vec<Point>, Vec<Point>) =
        hands.map(|(radius, [x, y, z])| (view.side([radius, z]), view.above([x, y]))).unzip();
    svg.polyline("line c1", &side);
    svg.polyline("line c1", &above);
    let [x, y, z] = [0, 1, 2].map(|axis| moment[JOINTS + axis]);
    let base = base_direction::<f64>(last);
    svg.circle("fill c2", view.side([x * base.sin - y * base.cos, z]), 5.0, "target, in the last pose's plane");
    svg.circle("fill c2", view.above([x, y]), 5.0, "target");
    for ball in 0..(moment.len() - JOINTS - 3) / 4 {
        let at = |moment: &Vec<f64>| [0, 1, 2, 3].map(|place| moment[JOINTS + 3 + 4 * ball + place]);
        let way: Vec<Point> = moments.iter().map(|moment| view.above([at(moment)[0], at(moment)[1]])).collect();
        svg.polyline("line c3", &way);
        let [x, y, z, radius] = moments.last().map(at).unwrap_or_default();
        let title = format!("ball {ball}");
        svg.circle("faint fill c3", view.side([x * base.sin - y * base.cos, z]), view.scale * radius, &title);
        svg.circle("faint fill c3", view.above([x, y]), view.scale * radius, &title);
    }
    svg.text("note", [6.0, 14.0], "side");
    svg.text("note", [PANEL + 6.0, 14.0], "above");
    svg.finish("an episode")
}

/// Returns base, shoulder, bracket, elbow, wrist and tip in the arm's plane.
fn joints(arm: &Arm<f64>, pose: Pose) -> [Point; 6] {
    let plane = Plane::at(arm, pose);
    let [shoulder, bracket, elbow, wrist, tip] =
        [arm.shoulder(), plane.bracket, plane.elbow, plane.wrist, plane.tip].map(|p| [p.x, p.z]);
    [[0.0, 0.0], shoulder, bracket, elbow, wrist, tip]
}

/// Maps mm to positions in the picture.
struct DrawnView {
    reach: f64,
    scale: f64,
}

impl DrawnView {
    fn new(arm: &Arm<f64>) -> Self {
        let reach = 1.03 * arm.reach().max(arm.links.base);
        Self { reach, scale: PANEL / (2.0 * reach) }
    }

    /// Maps a point of the arm's plane.
    fn side(&self, [x, z]: Point) -> Point {
        // The table is below the middle: an arm reaches further up than to its sides.
        [(x + self.reach) * self.scale, PANEL * 0.93 - z * self.scale]
    }

    /// Maps a point of the table, seen from above.
    fn above(&self, [x, y]: Point) -> Point {
        [PANEL + (x + self.reach) * self.scale, (self.reach - y) * self.scale]
    }
}
