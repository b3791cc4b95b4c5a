//! An arm as a section of a configuration: `[problem.arm]`, `[problem.arm.links]` and `[problem.arm.shapes]`. By
//! default the arm is the WidowX.
//!
//! `tpg-train config widowx` prints the WidowX's own section, commented, as a starting point. [`ARMS`](super::arms::ARMS) has
//! others.

use crate::arm::targets::stands_free;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tpg_arm::kinematics::Plane;
use tpg_arm::{Arm, BaseEdge, JOINTS, JointRange, Links, Pose, Shapes, TICKS_PER_TURN};
use tpg_graph::error::Finding;

/// Positions tried for each joint of the plane when checking that an arm has a free pose.
const TRIED: i32 = 16;

/// An arm as written in a configuration.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ArmDescription {
    /// Start of a fixed-start episode, ticks.
    pub home: [i16; JOINTS],
    /// Positions of the servos that never move, ticks.
    pub fixed_servos: [i16; 2],
    /// The first and last position of each joint, ticks.
    pub ranges: [[i16; 2]; JOINTS],
    /// Lengths.
    pub links: LinksDescription,
    /// Collision shapes.
    pub shapes: ShapesDescription,
}

/// Lengths, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinksDescription {
    /// Height of the shoulder above the table.
    pub base: f64,
    /// Shoulder to the elbow's bracket.
    pub upper_arm: f64,
    /// Bracket to the elbow.
    pub elbow_offset: f64,
    /// Elbow to wrist.
    pub forearm: f64,
    /// Wrist to the tip of the hand.
    pub hand: f64,
    /// Distance of the shoulder in front of the base's axis.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub shoulder_radial: f64,
}

/// Returns true for a length that need not be written.
fn is_zero(length: &f64) -> bool {
    *length == 0.0
}

/// Collision shapes, mm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShapesDescription {
    /// Wrist to the face of the hand's tip.
    pub hand_length: f64,
    /// Distances from the hand's axis to its two long edges.
    pub hand_edges: [f64; 2],
    /// Distance from the wrist to the forearm's end face beyond it.
    pub forearm_overhang: f64,
    /// Distances from the forearm's axis to its two long edges.
    pub forearm_edges: [f64; 2],
    /// Outline of the base: for each edge the first and last distance from the axis, then the first and last height.
    pub base: [[f64; 4]; 4],
}

impl From<&ArmDescription> for Arm<f64> {
    fn from(text: &ArmDescription) -> Self {
        let LinksDescription { base, upper_arm, elbow_offset, forearm, hand, shoulder_radial } = text.links;
        let shapes = &text.shapes;
        Self {
            home: Pose(text.home),
            fixed_servos: text.fixed_servos,
            ranges: text.ranges.map(|[min, max]| JointRange { min, max }),
            links: Links { base, upper_arm, elbow_offset, forearm, hand, shoulder_radial },
            shapes: Shapes {
                hand_length: shapes.hand_length,
                hand_edges: shapes.hand_edges,
                forearm_overhang: shapes.forearm_overhang,
                forearm_edges: shapes.forearm_edges,
                base: shapes.base.map(|[x0, x1, z0, z1]| BaseEdge { x: [x0, x1], z: [z0, z1] }),
            },
        }
    }
}

impl ArmDescription {
    /// Checks what the types cannot express.
    ///
    /// # Errors
    /// A value out of range, or values that contradict each other.
    pub fn check(&self) -> Result<(), Finding> {
        let ticks = 0..TICKS_PER_TURN as i16;
        let last = TICKS_PER_TURN - 1;
        if let Some(range) =
            self.ranges.iter().find(|[min, max]| min >= max || !ticks.contains(min) || !ticks.contains(max))
        {
            let accepted =
                format!("two whole numbers of ticks for each joint, 0 to {last}, the first below the second");
            return Err(Finding::new("problem.arm.ranges", format!("{range:?}"), accepted));
        }
        if let Some(servo) = self.fixed_servos.iter().find(|servo| !ticks.contains(servo)) {
            return Err(Finding::new("problem.arm.fixed_servos", servo.to_string(), format!("0 to {last}")));
        }
        if self.home.iter().zip(&self.ranges).any(|(home, [min, max])| home < min || home > max) {
            let accepted = format!("positions in arm.ranges, {:?}", self.ranges);
            return Err(Finding::new("problem.arm.home", format!("{:?}", self.home), accepted));
        }
        self.check_lengths()?;
        let arm = Arm::from(self);
        if !stands_free(&arm, &Plane::at(&arm, arm.home)) {
            let accepted = "a pose that touches neither table nor base".to_owned();
            return Err(Finding::new("problem.arm.home", format!("{:?}, which collides", self.home), accepted));
        }
        if !self.stands_anywhere(&arm) {
            let found = format!("{:?}, where every pose of a grid of {} collides", self.ranges, TRIED.pow(3));
            return Err(Finding::new("problem.arm.ranges", found, "an arm with room to move".to_owned()));
        }
        Ok(())
    }

    fn check_lengths(&self) -> Result<(), Finding> {
        let (links, shapes) = (&self.links, &self.shapes);
        for (key, length, least) in [
            ("problem.arm.links.base", links.base, 0.0),
            ("problem.arm.links.upper_arm", links.upper_arm, 1.0),
            ("problem.arm.links.elbow_offset", links.elbow_offset, 0.0),
            ("problem.arm.links.forearm", links.forearm, 1.0),
            ("problem.arm.links.hand", links.hand, 1.0),
            ("problem.arm.links.shoulder_radial", links.shoulder_radial, 0.0),
            ("problem.arm.shapes.hand_length", shapes.hand_length, 0.0),
            ("problem.arm.shapes.forearm_overhang", shapes.forearm_overhang, 0.0),
        ] {
            if !(least..=LONGEST).contains(&length) {
                return Err(Finding::new(key, length, format!("{least} to {LONGEST} mm")));
            }
        }
        for (key, edges) in [
            ("problem.arm.shapes.hand_edges", shapes.hand_edges),
            ("problem.arm.shapes.forearm_edges", shapes.forearm_edges),
        ] {
            if edges.iter().any(|edge| edge.abs() > LONGEST) || edges.iter().any(|edge| edge.is_nan()) {
                return Err(Finding::new(key, format!("{edges:?}"), format!("-{LONGEST} to {LONGEST} mm")));
            }
        }
        for [x0, x1, z0, z1] in shapes.base {
            let inside = [x0, x1, z0, z1].iter().all(|value| (0.0..=LONGEST).contains(value));
            // The collision test supports only horizontal and vertical edges.
            if !inside || (x0 != x1 && z0 != z1) {
                let found = format!("{:?}", [x0, x1, z0, z1]);
                let accepted = format!("0 to {LONGEST} mm, horizontal (equal heights) or vertical (equal distances)");
                return Err(Finding::new("problem.arm.shapes.base", found, accepted));
            }
        }
        Ok(())
    }

    fn stands_anywhere(&self, arm: &Arm<f64>) -> bool {
        let [_, planar @ ..] = self.ranges;
        (0..TRIED.pow(3)).any(|index| {
            let [a, b, c] = [index / (TRIED * TRIED), index / TRIED % TRIED, index % TRIED];
            let mut pose = arm.home;
            for ((ticks, [min, max]), step) in pose.0[1..].iter_mut().zip(planar).zip([a, b, c]) {
                *ticks = (i32::from(min) + (i32::from(max) - i32::from(min)) * step / (TRIED - 1)) as i16;
            }
            pose != arm.home && stands_free(arm, &Plane::at(arm, pose))
        })
    }
}

/// Maximum length, mm: the sample of the reachable space must fit into memory.
const LONGEST: f64 = 1000.0;

#[cfg(test)]
mod tests {
    use super::ArmDescription;
    use crate::arm::arms::ARMS;
    use serde::Deserialize;
    use tpg_arm::{Arm, WIDOWX};

    #[derive(Deserialize)]
    struct Text {
        problem: Section,
    }

    #[derive(Deserialize)]
    struct Section {
        arm: ArmDescription,
    }

    fn read(text: &str) -> ArmDescription {
        toml::from_str::<Text>(text).expect("a description").problem.arm
    }

    #[test]
    fn the_printed_section_is_the_widowx() {
        let described = read(ARMS[0].text);
        assert_eq!(described.check(), Ok(()));
        assert_eq!(Arm::from(&described), WIDOWX);
    }

    #[test]
    fn an_arm_that_cannot_be_is_refused_by_the_key_that_is_wrong() {
        for (from, to, key) in [
            ("home = [2048", "home = [0", "problem.arm.home"),
            ("home = [2048, 2048, 2048, 2048]", "home = [2048, 1100, 1100, 1100]", "problem.arm.home"),
            ("[2, 4094]", "[2, 4096]", "problem.arm.ranges"),
            ("[2, 4094]", "[9, 9]", "problem.arm.ranges"),
            ("fixed_servos = [512", "fixed_servos = [-1", "problem.arm.fixed_servos"),
            ("forearm = 142.0", "forearm = 0.0", "problem.arm.links.forearm"),
            ("hand_edges = [24.0", "hand_edges = [nan", "problem.arm.shapes.hand_edges"),
            ("[68.0, 90.0, 9.0, 9.0]", "[68.0, 90.0, 9.0, 10.0]", "problem.arm.shapes.base"),
        ] {
            let text = ARMS[0].text.replacen(from, to, 1);
            assert_ne!(text, ARMS[0].text, "{from} is in the text");
            assert_eq!(read(&text).check().map_err(|finding| finding.key), Err(key.to_owned()), "{to}");
        }
    }
}
