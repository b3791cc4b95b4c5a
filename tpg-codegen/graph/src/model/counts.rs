//! Counts: the integers that a sensor gives and an actuator takes, with what they are worth.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// The integers that a value comes in. Programs see the count; the value is `(count - offset) * scale`.
///
/// ```
/// use tpg_graph::Counts;
///
/// // A gyroscope with 16.4 counts for each degree per second.
/// let gyro = Counts { bits: 16, scale: 1.0 / 16.4, offset: 0.0 };
/// assert_eq!(gyro.count(-90.0), -1476.0);
/// assert_eq!(gyro.count(9000.0), 32767.0, "clipped");
/// assert_eq!(gyro.count(f64::NAN), 0.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Counts {
    /// Bits of the integer, with its sign.
    #[schemars(range(min = 2, max = 16))]
    pub bits: u32,
    /// The worth of a count, above 0.
    pub scale: f64,
    /// The count of the value 0.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub offset: f64,
}

fn is_zero(offset: &f64) -> bool {
    *offset == 0.0
}

impl Counts {
    /// The numbers of bits that a count can have.
    pub const BITS: std::ops::RangeInclusive<u32> = 2..=16;

    /// Returns the lowest count and the highest.
    pub fn limits(self) -> [f64; 2] {
        let half = f64::from(1_u32 << (self.bits - 1));
        [-half, half - 1.0]
    }

    /// Returns the bits of the integer type that holds each of some counts: one type for an array.
    pub fn container_of(counts: &[Self]) -> u32 {
        counts.iter().map(|counts| counts.container()).max().unwrap_or(16)
    }

    /// Returns the bits of the integer type that holds a count: 8 or 16.
    pub const fn container(&self) -> u32 {
        if self.bits <= 8 { 8 } else { 16 }
    }

    /// Returns the count of a value: the nearest, halves away from zero, clipped to the lowest and the highest; 0 for NaN.
    pub fn count(self, value: f64) -> f64 {
        let [low, high] = self.limits();
        let count = (value / self.scale + self.offset).round();
        // Not −0.
        if count.is_nan() { 0.0 } else { count.clamp(low, high) + 0.0 }
    }

    /// Returns the value of a count.
    pub fn value(self, count: f64) -> f64 {
        (count - self.offset) * self.scale
    }
}

#[cfg(test)]
mod tests {
    use super::Counts;

    #[test]
    fn halves_are_rounded_away_from_zero_and_ends_are_kept() {
        let counts = Counts { bits: 8, scale: 0.5, offset: 3.0 };
        let found = [0.0, 0.25, -0.25, -1.75, 1e9, f64::NEG_INFINITY, f64::NAN].map(|value| counts.count(value));
        assert_eq!(found, [3.0, 4.0, 3.0, -1.0, 127.0, -128.0, 0.0]);
        assert_eq!(counts.value(127.0), 62.0);
        assert_eq!(counts.count(-1.5).to_bits(), 0, "no −0");
    }
}
