//! Motor positions and changes of them: whole numbers.

/// Joints that a policy moves: base, shoulder, elbow, wrist.
pub const JOINTS: usize = 4;

/// Motor ticks in a full turn.
pub const TICKS_PER_TURN: i32 = 4096;

/// A joint's place in a [`Pose`]: 0 base, 1 shoulder, 2 elbow, 3 wrist.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Joint(pub u8);

/// The motor positions of the four joints, in ticks (0..=4095; 2048 is the middle of a joint's travel, 0 rad).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[repr(transparent)]
pub struct Pose(pub [i16; JOINTS]);

/// By the [`packed`](Pose::packed) number: one word for the hasher instead of four and a length.
impl core::hash::Hash for Pose {
    fn hash<H: core::hash::Hasher>(&self, state: &mut H) {
        state.write_u64(self.packed());
    }
}

impl Pose {
    /// The pose of a [`packed`](Self::packed) number.
    pub const fn from_packed(packed: u64) -> Self {
        Self([packed as i16, (packed >> 16) as i16, (packed >> 32) as i16, (packed >> 48) as i16])
    }

    /// The four positions in one number, 16 bits each: equal exactly when the poses are.
    pub const fn packed(self) -> u64 {
        let [a, b, c, d] = self.0;
        // Through u16, so that a negative position does not spill into its neighbours.
        (a as u16 as u64) | ((b as u16 as u64) << 16) | ((c as u16 as u64) << 32) | ((d as u16 as u64) << 48)
    }
}

/// A change of the motor positions, which an action asks for: ticks for each joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Move(pub [i8; JOINTS]);

impl Move {
    /// The move that asks for nothing: it ends an episode.
    pub const STOP: Self = Self([0; JOINTS]);

    /// `ticks` on one joint, nothing on the others; [`STOP`](Self::STOP) for a joint that does not exist.
    pub const fn single(joint: Joint, ticks: i8) -> Self {
        let mut deltas = [0; JOINTS];
        if (joint.0 as usize) < JOINTS {
            deltas[joint.0 as usize] = ticks;
        }
        Self(deltas)
    }
}
