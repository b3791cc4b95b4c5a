//! A policy's view of the balls, the goal and the search.

use super::behaviour::View;
use super::body::Nearest;
use super::scout::{HORIZON, Scout};
use crate::arm::JOINTS;
use tpg_runtime::named;

/// Number of values of all sources.
pub const VALUES: usize = 17;

named! {
    /// A source of the arm among balls.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum DodgeSource {
        /// Goal less pose of base, shoulder, elbow and wrist, ticks.
        Left = "left",
        /// Of the nearest ball: clearance, mm; its change in a step if the arm holds, mm; by how much each joint changes it, mm a
        /// radian.
        Near = "near",
        /// Of the second nearest ball: clearance, mm; its change in a step if the arm holds, mm. 500 and 0 without one.
        Second = "second",
        /// Steps until the straight walk and the plan meet something, at most 160, and until the plan arrives.
        Ahead = "ahead",
        /// Steps since the arm was nearer to its goal than ever, at most 255.
        Progress = "progress",
        /// Steps of the plan less those of the straight walk, and those that the plan still waits.
        Detour = "detour",
    }
}

impl DodgeSource {
    /// Returns the places of its values among those of all sources: the first, and their number.
    const fn place(self) -> (usize, usize) {
        match self {
            Self::Left => (0, 4),
            Self::Near => (4, 6),
            Self::Second => (10, 2),
            Self::Ahead => (12, 3),
            Self::Progress => (15, 1),
            Self::Detour => (16, 1),
        }
    }

    /// Copies the values of some sources, in their order, out of the values of all. What does not fit is left away.
    #[inline]
    pub fn gather(sources: &[Self], values: &[f32; VALUES], state: &mut [f32]) {
        if sources == Self::ALL && state.len() == VALUES {
            state.copy_from_slice(values);
            return;
        }
        let mut slots = state.iter_mut();
        for source in sources {
            let (first, length) = source.place();
            for (value, slot) in values.iter().skip(first).take(length).zip(&mut slots) {
                *slot = *value;
            }
        }
    }

    /// Returns the unit of its values.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Left => "ticks",
            Self::Near => "mm, mm/step, mm/rad",
            Self::Second => "mm, mm/step",
            Self::Ahead | Self::Progress | Self::Detour => "steps",
        }
    }

    /// Returns the range of each value.
    pub const fn ranges(self) -> &'static [[f32; 2]] {
        const LEFT: [f32; 2] = [-4096.0, 4096.0];
        const CLEARANCE: [f32; 2] = [-100.0, 1000.0];
        const CHANGE: [f32; 2] = [-4.0, 4.0];
        const SLOPE: [f32; 2] = [-700.0, 700.0];
        const FREE: [f32; 2] = [0.0, HORIZON as f32];
        match self {
            Self::Left => &[LEFT; JOINTS],
            Self::Near => &[CLEARANCE, CHANGE, SLOPE, SLOPE, SLOPE, SLOPE],
            Self::Second => &[CLEARANCE, CHANGE],
            Self::Ahead => &[FREE, FREE, [0.0, 1000.0]],
            Self::Progress => &[[0.0, 255.0]],
            Self::Detour => &[[0.0, 1000.0]],
        }
    }
}

/// Returns the values of all sources; `progress` in steps.
pub(super) fn values(view: &View<'_>, scout: &Scout, progress: u8) -> [f32; VALUES] {
    let mut nearest: Option<(&Nearest, f32)> = None;
    let mut second = (500.0, 0.0);
    for (ball, near) in view.nearest() {
        let [along, across, up] = view.posture.in_frame(ball.velocity);
        let [x, y, z] = near.away;
        let change = -(along * x + across * y + up * z);
        match nearest {
            Some((best, of_best)) if near.clearance < best.clearance => {
                second = (best.clearance, of_best);
                nearest = Some((near, change));
            }
            Some(_) if near.clearance < second.0 => second = (near.clearance, change),
            Some(_) => {}
            None => nearest = Some((near, change)),
        }
    }
    let [base, shoulder, elbow, wrist] = left(view);
    let (clearance, change, slopes) = match nearest {
        Some((near, change)) => (near.clearance, change, view.body.gradient(&view.posture, near)),
        None => (500.0, 0.0, [0.0; JOINTS]),
    };
    let arrival = scout.plan().arrival(view.pose) as f32;
    let direct = super::plan::steps(view.pose, view.goal()) as f32;
    let ahead = [f32::from(scout.straight().free_steps()), f32::from(scout.fate().free_steps()), arrival];
    let [a, b, c, d] = slopes;
    [
        base,
        shoulder,
        elbow,
        wrist,
        clearance,
        change,
        a,
        b,
        c,
        d,
        second.0,
        second.1,
        ahead[0],
        ahead[1],
        ahead[2],
        f32::from(progress),
        if arrival > direct { arrival - direct } else { 0.0 },
    ]
}

/// Goal less pose, ticks.
fn left(view: &View<'_>) -> [f32; JOINTS] {
    let mut left = [0.0; JOINTS];
    for ((left, goal), pose) in left.iter_mut().zip(view.goal().0).zip(view.pose.0) {
        *left = f32::from(goal.saturating_sub(pose));
    }
    left
}
