//! The past as a first policy can know it: by these values the rules of a [`Switch`](crate::switch::Switch) judge.
//!
//! A policy decides by the present state alone. With these values among its sources it can learn when to ask, as the rules
//! know when to hand over.
//!
//! ```
//! use tpg_runtime::recall::Recall;
//!
//! let mut recall = Recall::new(9.0f32);
//! recall.acted(false, 7.0);
//! recall.acted(true, 7.5);
//! recall.acted(false, 8.0);
//! // One unit farther than at the least; two actions since then, one since the second policy decided.
//! assert_eq!(recall.values(), [1.0, 2.0, 1.0]);
//! ```

use crate::scalar::Scalar;

/// The names of the values as a graph's sources, in their order.
pub const NAMES: [&str; 3] = ["drift", "since_progress", "since_asked"];

/// The memory of an episode. Counts are exact up to 2²⁴ in `f32`, and stay there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recall<S> {
    /// The least distance so far.
    pub least: S,
    /// The distance beyond the least; 0 where it is no number.
    pub drift: S,
    /// Actions since the least distance was reached.
    pub since_progress: S,
    /// Actions since the second policy decided, or since the start.
    pub since_asked: S,
}

impl<S: Scalar> Recall<S> {
    /// The memory at the start of an episode. A distance that is not known yet is infinite.
    pub fn new(distance: S) -> Self {
        Self { least: distance, drift: S::ZERO, since_progress: S::ZERO, since_asked: S::ZERO }
    }

    /// Notes an action, the second policy's where `asked`, and the distance behind it.
    #[inline]
    pub fn acted(&mut self, asked: bool, distance: S) {
        self.since_asked = if asked { S::ZERO } else { self.since_asked + S::ONE };
        if distance < self.least {
            self.least = distance;
            self.drift = S::ZERO;
            self.since_progress = S::ZERO;
            return;
        }
        let drift = distance - self.least;
        // NaN compares as false: distances that are infinite or no numbers are no drift.
        self.drift = if drift > S::ZERO { drift } else { S::ZERO };
        self.since_progress = self.since_progress + S::ONE;
    }

    /// The values of the sources, in the order of [`NAMES`].
    #[inline]
    pub fn values(&self) -> [S; NAMES.len()] {
        [self.drift, self.since_progress, self.since_asked]
    }
}

#[cfg(test)]
mod tests {
    use super::Recall;

    #[test]
    fn an_unknown_or_broken_distance_is_no_drift() {
        let mut recall = Recall::new(f32::INFINITY);
        for (distance, values) in [
            (f32::INFINITY, [0.0, 1.0, 1.0]),
            (4.0, [0.0, 0.0, 2.0]),
            (f32::NAN, [0.0, 1.0, 3.0]),
            (6.5, [2.5, 2.0, 4.0]),
            (4.0, [0.0, 3.0, 5.0]),
        ] {
            recall.acted(false, distance);
            assert_eq!(recall.values(), values, "after {distance}");
        }
        let mut late = Recall { since_progress: 16_777_216.0f32, since_asked: 16_777_216.0, ..recall };
        late.acted(false, 5.0);
        assert_eq!(late.values(), [1.0, 16_777_216.0, 16_777_216.0], "counts stay at their end");
    }
}
