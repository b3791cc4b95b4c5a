//! The arm: its description, forward kinematics, collisions, one step.

use crate::code::{self, Refusal, TPG_ARGUMENT};
use crate::memory::{self, Opaque};
use tpg_arm::kinematics::{self, Plane};
use tpg_arm::sensors::Limits;
use tpg_arm::{Arm, BaseEdge, Collision, Invalid, JointRange, Links, Move, Pose, Shapes, Step, WIDOWX};

/// Joints: base, shoulder, elbow, wrist.
pub const TPG_JOINTS: usize = 4;

/// Motor positions, ticks of 1/4096 turn; 2048 is the middle of a joint's travel, 0 rad.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct tpg_pose_t {
    /// Base, shoulder, elbow, wrist.
    pub ticks: [i16; TPG_JOINTS],
}

/// A change of the motor positions, which an action asks for.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct tpg_move_t {
    /// A change for each joint, ticks.
    pub ticks: [i8; TPG_JOINTS],
}

/// A horizontal or vertical edge of the base's outline in the arm plane, mm.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct tpg_edge_t {
    /// The two ends' distances from the base's axis.
    pub x: [f32; 2],
    /// The two ends' heights over the table.
    pub z: [f32; 2],
}

/// An arm as data: a base that turns, and shoulder, elbow and wrist in one vertical plane. Lengths in mm.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct tpg_arm_description_t {
    /// The pose in which a fixed-start episode begins.
    pub home: tpg_pose_t,
    /// Positions of the servos that never move (wrist rotation, gripper), ticks.
    pub fixed_servos: [i16; 2],
    /// Lowest positions of the joints, ticks.
    pub min: [i16; TPG_JOINTS],
    /// Highest positions of the joints, ticks.
    pub max: [i16; TPG_JOINTS],
    /// Height of the shoulder over the table.
    pub base: f32,
    /// Shoulder to the elbow's bracket.
    pub upper_arm: f32,
    /// Bracket to the elbow, at a right angle to the upper arm.
    pub elbow_offset: f32,
    /// Elbow to wrist.
    pub forearm: f32,
    /// Wrist to the hand's tip.
    pub hand: f32,
    /// Wrist to the face of the hand's tip.
    pub hand_length: f32,
    /// From the hand's axis to its long edges, positive upwards with the arm stretched forwards.
    pub hand_edges: [f32; 2],
    /// Distance of the forearm's end face beyond the wrist.
    pub forearm_overhang: f32,
    /// From the forearm's axis to its long edges.
    pub forearm_edges: [f32; 2],
    /// The outline of the base, one side.
    pub base_edges: [tpg_edge_t; 4],
    /// Distance of the shoulder in front of the base's axis, at which the base turns it round. 0 in many arms.
    pub shoulder_radial: f32,
}

/// Words of a tpg_arm_t.
pub const TPG_ARM_WORDS: usize = 22;

/// An arm, ready for use. Opaque; initialised by tpg_arm_init or tpg_arm_init_widowx, constant from then on.
#[repr(C)]
pub struct tpg_arm_t {
    /// The library's.
    pub opaque: [u64; TPG_ARM_WORDS],
}

/// The content of a tpg_arm_t.
pub struct Ready {
    pub(crate) arm: Arm<f32>,
    pub(crate) limits: Limits<f32>,
}

impl Ready {
    fn new(arm: Arm<f32>) -> Self {
        Self { limits: Limits::new(&arm), arm }
    }
}

// SAFETY: any bytes are an array of integers; `initialise` proves that the content fits.
unsafe impl Opaque for tpg_arm_t {
    type Content = Ready;
    const TAG: u32 = 0x4150_4702;
}

/// The step was done.
pub const TPG_VALID: i32 = 0;
/// The base would have left its range; the other joints moved.
pub const TPG_LIMIT_BASE: i32 = 1;
/// The shoulder would have left its range; the other joints moved.
pub const TPG_LIMIT_SHOULDER: i32 = 2;
/// The elbow would have left its range; the other joints moved.
pub const TPG_LIMIT_ELBOW: i32 = 3;
/// The wrist would have left its range; the other joints moved.
pub const TPG_LIMIT_WRIST: i32 = 4;
/// A joint or the hand's tip would be below the table; nothing moved.
pub const TPG_COLLISION_TABLE: i32 = 5;
/// A corner of the hand would be below the table; nothing moved.
pub const TPG_COLLISION_CORNER: i32 = 6;
/// Hand or forearm would meet the arm's own base; nothing moved.
pub const TPG_COLLISION_BASE: i32 = 7;

fn collision_code(collision: Option<Collision>) -> i32 {
    match collision {
        None => TPG_VALID,
        Some(Collision::Table) => TPG_COLLISION_TABLE,
        Some(Collision::HandCorner) => TPG_COLLISION_CORNER,
        Some(Collision::Base) => TPG_COLLISION_BASE,
    }
}

pub(crate) fn validity(invalid: Option<Invalid>) -> i32 {
    match invalid {
        None => TPG_VALID,
        Some(Invalid::JointLimit(joint)) => TPG_LIMIT_BASE + i32::from(joint.0),
        Some(Invalid::Collision(collision)) => collision_code(Some(collision)),
    }
}

/// Makes the paper's arm, a WidowX with four joints.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_arm_init_widowx(arm: *mut tpg_arm_t) -> i32 {
    const ARM: Arm<f32> = WIDOWX.to_f32();
    // SAFETY: the header's contract.
    code::from_result(unsafe { memory::initialise(arm, Ready::new(ARM)) })
}

/// Makes an arm of your own. TPG_ARGUMENT for one that cannot be:
///
/// - a joint's range that is empty or goes beyond 0 to 4095, or a home position outside it;
/// - a length that is not finite, or above 100 m: all of them. Not above 0: upper arm, forearm and hand. Below 0: the
///   base's height, the elbow's offset and the shoulder's distance from the base's axis;
/// - an edge of the base that is neither horizontal nor vertical.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_arm_init(arm: *mut tpg_arm_t, description: *const tpg_arm_description_t) -> i32 {
    // SAFETY: the header's contract.
    let done = unsafe { memory::read(description) }.and_then(|it| {
        let range = |joint: usize| JointRange { min: it.min[joint], max: it.max[joint] };
        let ranges = [range(0), range(1), range(2), range(3)];
        let made = Arm {
            home: Pose(it.home.ticks),
            fixed_servos: it.fixed_servos,
            ranges,
            links: Links {
                base: it.base,
                upper_arm: it.upper_arm,
                elbow_offset: it.elbow_offset,
                forearm: it.forearm,
                hand: it.hand,
                shoulder_radial: it.shoulder_radial,
            },
            shapes: Shapes {
                hand_length: it.hand_length,
                hand_edges: it.hand_edges,
                forearm_overhang: it.forearm_overhang,
                forearm_edges: it.forearm_edges,
                base: it.base_edges.map(|edge| BaseEdge { x: edge.x, z: edge.z }),
            },
        };
        made.check().map_err(|_| Refusal(TPG_ARGUMENT))?;
        // SAFETY: the header's contract.
        unsafe { memory::initialise(arm, Ready::new(made)) }
    });
    code::from_result(done)
}

/// The pose in which a fixed-start episode begins.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_arm_home(arm: *const tpg_arm_t, pose: *mut tpg_pose_t) -> i32 {
    // SAFETY: the header's contract.
    let (arm, pose) = unsafe { (memory::content(arm), memory::write(pose)) };
    code::answer(arm.map(|Ready { arm, .. }| tpg_pose_t { ticks: arm.home.0 }), pose)
}

/// Forward kinematics: the place of the hand's tip at a pose; x, y, z in mm.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_arm_hand(arm: *const tpg_arm_t, pose: *const tpg_pose_t, hand: *mut f32) -> i32 {
    // SAFETY: the header's contract.
    let (arm, pose, hand) =
        unsafe { (memory::content(arm), memory::read(pose), memory::write(hand.cast::<[f32; 3]>())) };
    code::answer(arm.and_then(|Ready { arm, .. }| Ok(kinematics::hand(arm, Pose(pose?.ticks)))), hand)
}

/// Tests whether the arm collides at a pose: TPG_VALID or a code of TPG_COLLISION.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_arm_collision(arm: *const tpg_arm_t, pose: *const tpg_pose_t, collision: *mut i32) -> i32 {
    // SAFETY: the header's contract.
    let (arm, pose, collision) = unsafe { (memory::content(arm), memory::read(pose), memory::write(collision)) };
    let found = |Ready { arm, .. }: &Ready| Ok(Plane::at(arm, Pose(pose?.ticks)).collision(&arm.shapes));
    code::answer(arm.and_then(found).map(collision_code), collision)
}

/// Tries a move: the pose afterwards, and TPG_VALID, or a code of TPG_LIMIT or TPG_COLLISION.
///
/// A joint that would leave its range stays, the others still move; if the arm then collides, the whole move is taken
/// back. `pose` and `after` may be the same.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_arm_step(
    arm: *const tpg_arm_t,
    pose: *const tpg_pose_t,
    wanted: *const tpg_move_t,
    after: *mut tpg_pose_t,
    validity: *mut i32,
) -> i32 {
    // SAFETY: the header's contract. The pose is copied before `after` is written.
    let (arm, pose, wanted) =
        unsafe { (memory::content(arm), memory::read(pose).copied(), memory::read(wanted).copied()) };
    code::from_result(arm.and_then(|Ready { arm, .. }| {
        let (pose, wanted) = (pose?, wanted?);
        // SAFETY: the header's contract.
        let (after, validity) = unsafe { (memory::write(after)?, memory::write(validity)?) };
        let Step { pose, invalid } = arm.step(Pose(pose.ticks), Move(wanted.ticks));
        *after = tpg_pose_t { ticks: pose.0 };
        *validity = self::validity(invalid);
        Ok(())
    }))
}
