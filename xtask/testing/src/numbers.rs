//! Numbers without a pattern, the same on every machine.

/// A stream of numbers without a pattern: a linear congruence in 64 bits, of which the upper ones are given.
#[derive(Clone, Debug)]
pub struct Numbers(pub u64);

impl Numbers {
    /// Returns the next number, of 31 bits.
    pub fn next_u32(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as u32
    }

    /// Returns a number from -`bound` to `bound`.
    pub fn within(&mut self, bound: i32) -> i32 {
        (self.next_u32() % (2 * bound as u32 + 1)) as i32 - bound
    }
}
