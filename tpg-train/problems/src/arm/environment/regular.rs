//! The regular step of many arms, computed by the same functions as any step, vectorised over lanes.

use super::lanes::Group;
use super::{ArmEnvironment, base_angle, look_up};
use crate::registry::Number;
use tpg_arm::kinematics::{Direction, Directions, Plane, difference, link_angles};
use tpg_arm::{JOINTS, Pose};
use tpg_engine::{BLOCK, Block};
use tpg_runtime::policy::ActionId;

/// Takes an action in every lane, as if it were a regular step. `moves` are those of each action, followed by the move used for
/// actions that do not exist.
#[inline(always)]
pub(super) fn take<S: Number>(
    environment: &ArmEnvironment<S>,
    moves: &[[i32; JOINTS]],
    groups: &mut [Group<S>],
    keys: &mut [Block<u64>],
    actions: &[ActionId],
) {
    let nothing = moves.len() - 1;
    for ((group, keys), actions) in groups.iter_mut().zip(keys).zip(actions.chunks(BLOCK)) {
        let mut steps = [[0; BLOCK]; JOINTS];
        for (lane, action) in actions.iter().enumerate() {
            let step = moves[usize::from(action.0).min(nothing)];
            for (steps, step) in steps.iter_mut().zip(step) {
                steps[lane] = step;
            }
        }
        regular(environment, group, keys, &steps);
    }
}

/// Each loop has a branch-free body that reads single array elements, so that it can be vectorised.
#[inline(always)]
#[allow(
    clippy::needless_range_loop,
    reason = "several arrays at the same place, and copies of arrays would stay copies"
)]
fn regular<S: Number>(
    environment: &ArmEnvironment<S>,
    group: &mut Group<S>,
    keys: &mut Block<u64>,
    steps: &[Block<i32>; JOINTS],
) {
    let mut ticks = group.ticks;
    let (mut inside, mut moved) = ([true; BLOCK], [0; BLOCK]);
    for joint in 0..JOINTS {
        let range = environment.arm.ranges[joint];
        for lane in 0..BLOCK {
            let to = ticks[joint][lane] + steps[joint][lane];
            ticks[joint][lane] = to;
            inside[lane] &= (to >= i32::from(range.min)) & (to <= i32::from(range.max));
            // Not by the steps: for these, LLVM spreads a mask of AVX-512 lane by lane.
            moved[lane] |= to ^ group.ticks[joint][lane];
        }
    }
    // Not by `map`: an array's is not inlined here, and would be a call for each lane.
    let [base, shoulder, elbow, wrist] = &ticks;
    let pose = |lane: usize| Pose([base[lane] as i16, shoulder[lane] as i16, elbow[lane] as i16, wrist[lane] as i16]);
    let (mut cosines, mut sines) = ([[S::ZERO; BLOCK]; JOINTS], [[S::ZERO; BLOCK]; JOINTS]);
    for lane in 0..BLOCK {
        let [upper_arm, forearm, hand] = link_angles(pose(lane));
        let angles = [base_angle(pose(lane)), upper_arm, forearm, hand];
        for part in 0..JOINTS {
            let Direction { cos, sin } = look_up(&environment.sines, angles[part]);
            cosines[part][lane] = cos;
            sines[part][lane] = sin;
        }
    }
    let mut hands = group.hand;
    for lane in 0..BLOCK {
        let part = |part: usize| Direction { cos: cosines[part][lane], sin: sines[part][lane] };
        let plane = Plane::new(&environment.arm, Directions::of_links(part(1), part(2), part(3)));
        let hand = plane.hand_in_world(part(0));
        let target = [group.target[0][lane], group.target[1][lane], group.target[2][lane]];
        let [x, y, z] = difference(target, hand);
        let far = x * x + y * y + z * z > group.far[lane];
        for axis in 0..3 {
            hands[axis][lane] = hand[axis];
        }
        let clear = environment.clearances.leaves_free(&plane);
        group.other[lane] = !(inside[lane] & (moved[lane] != 0) & far & clear & (group.left[lane] > 0));
    }
    for lane in 0..BLOCK {
        keys[lane] = pose(lane).packed();
        group.left[lane] -= 1;
    }
    (group.before, group.ticks, group.hand) = (group.ticks, ticks, hands);
}
