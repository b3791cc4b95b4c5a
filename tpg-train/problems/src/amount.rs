//! A constant of a problem: one value, or a range from which each episode draws.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use tpg_engine::random::Stream;
use tpg_graph::error::Finding;

/// A constant of a problem's rules.
///
/// In TOML it is a number, or two: `mass = 1.0`, or `mass = [0.8, 1.2]`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged, expecting = "a number, or [lowest, highest]")]
pub enum Amount {
    /// The same value in every episode.
    Fixed(f64),
    /// A value that each episode draws uniformly.
    Between([f64; 2]),
}

impl From<f64> for Amount {
    fn from(value: f64) -> Self {
        Self::Fixed(value)
    }
}

impl Amount {
    /// Draws the value of an episode; nothing is drawn for a fixed one.
    pub fn draw(self, stream: &mut Stream) -> f64 {
        match self {
            Self::Fixed(value) => value,
            Self::Between([low, high]) => low + (high - low) * stream.unit(),
        }
    }

    /// Checks that every value lies between `least` and `most`.
    ///
    /// # Errors
    /// If one does not, or a range is empty.
    pub fn check(self, key: &str, least: f64, most: f64) -> Result<(), Finding> {
        match self {
            Self::Fixed(value) => Finding::range(key, value, least, most),
            Self::Between([low, high]) if least <= low && low <= high && high <= most => Ok(()),
            Self::Between(range) => {
                Err(Finding::new(key, format!("{range:?}"), format!("two numbers of {least} to {most}, ascending")))
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Amount;
    use tpg_engine::random::{Purpose, Stream};

    #[test]
    fn a_range_is_drawn_from_and_a_number_is_not() {
        let mut stream = Stream::new(1, 0, Purpose::Test, 0);
        let before = stream.clone().bits();
        assert_eq!(Amount::Fixed(3.0).draw(&mut stream), 3.0);
        assert_eq!(stream.clone().bits(), before);
        let drawn: Vec<f64> = (0..100).map(|_| Amount::Between([2.0, 4.0]).draw(&mut stream)).collect();
        assert!(drawn.iter().all(|value| (2.0..4.0).contains(value)));
        assert!(drawn.iter().any(|&value| value < 2.5) && drawn.iter().any(|&value| value > 3.5));
    }

    #[test]
    fn ranges_are_checked_at_both_ends() {
        assert!(Amount::Between([0.5, 1.0]).check("k", 0.0, 1.0).is_ok());
        for wrong in [[1.0, 0.5], [-1.0, 0.5], [0.5, 2.0], [f64::NAN, 1.0]] {
            let finding = Amount::Between(wrong).check("k", 0.0, 1.0).expect_err("a wrong range");
            assert_eq!(finding.key, "k");
        }
        assert!(Amount::Fixed(f64::NAN).check("k", 0.0, 1.0).is_err());
    }
}
