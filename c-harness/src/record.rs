//! Records of episodes, as the firmware writes them, too: the outcome as `tpg_runtime.h` numbers it, and a hash of
//! every motor position.

use tpg_arm::episode::Outcome;
use tpg_arm::{Collision, Invalid, Pose};

/// As `tpg_runtime.h` numbers them.
pub(crate) fn code(outcome: Outcome) -> i32 {
    match outcome {
        Outcome::Reached => 1,
        Outcome::Stop => 2,
        Outcome::Cycle => 3,
        Outcome::Timeout => 4,
        Outcome::Invalid(Invalid::JointLimit(joint)) => 17 + i32::from(joint.0),
        Outcome::Invalid(Invalid::Collision(Collision::Table)) => 21,
        Outcome::Invalid(Invalid::Collision(Collision::HandCorner)) => 22,
        Outcome::Invalid(Invalid::Collision(Collision::Base)) => 23,
    }
}

/// FNV-1a.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hash(pub(crate) u64);

impl Hash {
    /// Of nothing.
    pub(crate) const fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    /// Adds a number.
    pub(crate) fn add(&mut self, number: u64) {
        self.0 = (self.0 ^ number).wrapping_mul(0x0000_0100_0000_01b3);
    }

    /// Adds motor positions, byte by byte.
    pub(crate) fn add_pose(&mut self, Pose(ticks): Pose) {
        ticks.into_iter().flat_map(i16::to_le_bytes).for_each(|byte| self.add(u64::from(byte)));
    }

    /// Adds a word, byte by byte.
    pub(crate) fn add_bits(&mut self, bits: u32) {
        bits.to_le_bytes().into_iter().for_each(|byte| self.add(u64::from(byte)));
    }
}
