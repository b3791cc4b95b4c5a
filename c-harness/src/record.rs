//! Hashes of what firmwares do: of every motor position, or of every answer.

use tpg_arm::Pose;

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
