//! The geometry of an arm that need not be planar: where its joints are, how they move the tip, how near a ball is.

use crate::code::{self, Refusal, TPG_ARGUMENT, TPG_LENGTH};
use crate::memory;
use tpg_arm::JointRange;
use tpg_arm::chain::{Axis, Chain, Kinematics as _, Link, Placed};

/// The most joints of a chain.
pub const TPG_CHAIN_JOINTS: usize = 8;

/// A joint turns about the first direction of its frame.
pub const TPG_AXIS_X: u8 = 0;
/// A joint turns about the second direction of its frame.
pub const TPG_AXIS_Y: u8 = 1;
/// A joint turns about the third direction of its frame.
pub const TPG_AXIS_Z: u8 = 2;

/// A joint of a chain and the link that it turns. Lengths in mm, positions in ticks of 1/4096 turn.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct tpg_link_t {
    /// The joint in the frame of the link before; the first in that of the world.
    pub origin: [f32; 3],
    /// The rotation of its frame there at `zero`, row by row: times a vector of its own frame, one of the frame before.
    pub turned: [[f32; 3]; 3],
    /// A code of TPG_AXIS.
    pub axis: u8,
    /// Not 0 where rising positions turn against the right hand's fingers whose thumb is the axis.
    pub reversed: u8,
    /// The position at which the joint adds nothing to `turned`.
    pub zero: i16,
}

/// A chain at a pose, in the world, mm. Link i reaches from joint i to the next one, the last to the tip.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct tpg_placed_t {
    /// Joints that it has; 1 to TPG_CHAIN_JOINTS.
    pub joints: u32,
    /// A point of each joint's axis.
    pub points: [[f32; 3]; TPG_CHAIN_JOINTS],
    /// The direction of each axis, of length 1: a rising position turns as the right hand's fingers whose thumb it is.
    pub axes: [[f32; 3]; TPG_CHAIN_JOINTS],
    /// The tip.
    pub tip: [f32; 3],
}

/// The place where a ball is nearest to a chain.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct tpg_near_t {
    /// Distance between the two surfaces, mm; negative where they overlap.
    pub clearance: f32,
    /// Index of the link.
    pub link: u32,
    /// The nearest point of the line along the link, mm.
    pub point: [f32; 3],
    /// The change of the clearance of a ball that stays by each joint, mm a radian; 0 beyond the last joint.
    pub gradient: [f32; TPG_CHAIN_JOINTS],
}

impl tpg_link_t {
    fn get(&self) -> Result<Link<f32>, Refusal> {
        let axis = match self.axis {
            TPG_AXIS_X => Axis::X,
            TPG_AXIS_Y => Axis::Y,
            TPG_AXIS_Z => Axis::Z,
            _ => return Err(Refusal(TPG_ARGUMENT)),
        };
        // The geometry asks for no range.
        let range = JointRange { min: i16::MIN, max: i16::MAX };
        let Self { origin, turned, zero, .. } = *self;
        Ok(Link { origin, turned, axis, reversed: self.reversed != 0, zero, range })
    }
}

/// Calls a function for a number of joints: the library's are made for each.
macro_rules! for_joints {
    ($joints:expr, $function:ident ( $($argument:expr),* )) => {
        match $joints {
            1 => $function::<1>($($argument),*),
            2 => $function::<2>($($argument),*),
            3 => $function::<3>($($argument),*),
            4 => $function::<4>($($argument),*),
            5 => $function::<5>($($argument),*),
            6 => $function::<6>($($argument),*),
            7 => $function::<7>($($argument),*),
            TPG_CHAIN_JOINTS => $function::<TPG_CHAIN_JOINTS>($($argument),*),
            _ => Err(Refusal(TPG_LENGTH)),
        }
    };
}

fn place<const N: usize>(links: &[tpg_link_t], tip: [f32; 3], ticks: &[i16]) -> Result<tpg_placed_t, Refusal> {
    let straight = Link {
        origin: [0.0; 3],
        turned: Link::<f32>::STRAIGHT,
        axis: Axis::Z,
        reversed: false,
        zero: 0,
        range: JointRange { min: 0, max: 0 },
    };
    let (mut own, mut pose) = ([straight; N], [0; N]);
    for (((link, ticks), own), pose) in links.iter().zip(ticks).zip(&mut own).zip(&mut pose) {
        (*own, *pose) = (link.get()?, *ticks);
    }
    let Placed { points, axes, tip } = Chain { links: own, tip }.place(pose);
    let mut placed = tpg_placed_t {
        joints: N as u32,
        points: [[0.0; 3]; TPG_CHAIN_JOINTS],
        axes: [[0.0; 3]; TPG_CHAIN_JOINTS],
        tip,
    };
    placed.points.iter_mut().zip(points).for_each(|(to, point)| *to = point);
    placed.axes.iter_mut().zip(axes).for_each(|(to, axis)| *to = axis);
    Ok(placed)
}

impl tpg_placed_t {
    fn get<const N: usize>(&self) -> Placed<f32, N> {
        let (mut points, mut axes) = ([[0.0; 3]; N], [[0.0; 3]; N]);
        points.iter_mut().zip(self.points).for_each(|(to, point)| *to = point);
        axes.iter_mut().zip(self.axes).for_each(|(to, axis)| *to = axis);
        Placed { points, axes, tip: self.tip }
    }
}

fn jacobian_into<const N: usize>(placed: &tpg_placed_t, to: &mut [[f32; 3]]) -> Result<(), Refusal> {
    to.iter_mut().zip(placed.get::<N>().jacobian()).for_each(|(to, moved)| *to = moved);
    Ok(())
}

fn nearest<const N: usize>(
    placed: &tpg_placed_t,
    radii: &[f32],
    centre: [f32; 3],
    radius: f32,
) -> Result<tpg_near_t, Refusal> {
    let mut own = [0.0; N];
    own.iter_mut().zip(radii).for_each(|(to, radius)| *to = *radius);
    let placed = placed.get::<N>();
    let near = placed.near(&own, centre, radius);
    let mut gradient = [0.0; TPG_CHAIN_JOINTS];
    gradient.iter_mut().zip(placed.gradient(&near)).for_each(|(to, slope)| *to = slope);
    Ok(tpg_near_t { clearance: near.clearance, link: near.link as u32, point: near.point, gradient })
}

/// Places a chain of `joints` links at a pose, `joints` positions; `tip` is x, y, z in the frame of the last link, mm. Limits are
/// the caller's. TPG_LENGTH for no joint or more than TPG_CHAIN_JOINTS, TPG_ARGUMENT for an unknown axis.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_chain_place(
    links: *const tpg_link_t,
    joints: usize,
    tip: *const f32,
    ticks: *const i16,
    placed: *mut tpg_placed_t,
) -> i32 {
    // SAFETY: the header's contract.
    let (links, tip, ticks, placed) = unsafe {
        (
            memory::array(links, joints),
            memory::read(tip.cast::<[f32; 3]>()),
            memory::array(ticks, joints),
            memory::write(placed),
        )
    };
    let locate = |links: &[tpg_link_t]| {
        let (tip, ticks) = (*tip?, ticks?);
        for_joints!(joints, place(links, tip, ticks))
    };
    code::answer(links.and_then(locate), placed)
}

/// Writes the motion of a placed chain's tip by each joint, x, y, z in mm a radian, into `jacobian` of `length` floats.
/// TPG_LENGTH where they are too few, or for a chain that tpg_chain_place did not place.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_chain_jacobian(placed: *const tpg_placed_t, jacobian: *mut f32, length: usize) -> i32 {
    // SAFETY: the header's contract.
    let (placed, to) = unsafe { (memory::read(placed), memory::array_mut(jacobian.cast::<[f32; 3]>(), length / 3)) };
    code::from_result(placed.and_then(|placed| {
        let (to, joints) = (to?, placed.joints as usize);
        if to.len() < joints {
            return Err(Refusal(TPG_LENGTH));
        }
        for_joints!(joints, jacobian_into(placed, to))
    }))
}

/// Finds where a ball is nearest to a placed chain, whose links are capsules of `radii`, mm for each joint. `ball` is its
/// centre's x, y, z and its radius, mm. TPG_LENGTH for a chain that tpg_chain_place did not place.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_chain_near(
    placed: *const tpg_placed_t,
    radii: *const f32,
    ball: *const f32,
    near: *mut tpg_near_t,
) -> i32 {
    // SAFETY: the header's contract.
    let (placed, ball, near) =
        unsafe { (memory::read(placed), memory::read(ball.cast::<[f32; 4]>()), memory::write(near)) };
    let measure = |placed: &tpg_placed_t| {
        let joints = placed.joints as usize;
        // SAFETY: the header's contract: one for each joint.
        let radii = unsafe { memory::array(radii, joints.min(TPG_CHAIN_JOINTS)) }?;
        let [x, y, z, radius] = *ball?;
        for_joints!(joints, nearest(placed, radii, [x, y, z], radius))
    };
    code::answer(placed.and_then(measure), near)
}
