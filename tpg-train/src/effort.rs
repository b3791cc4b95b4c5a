//! Wear of actuators.

use serde::{Deserialize, Serialize};
use tpg_engine::Output;

/// Wear of actuators, where actions are values between bounds.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Effort {
    /// The share of steps with a value at a bound, 0 to 1.
    pub saturated: f64,
    /// The mean change of a value from step to step, as a share of its range.
    pub chatter: f64,
}

/// The effort of a policy so far.
#[derive(Debug)]
pub(crate) struct Meter<'o> {
    outputs: &'o [Output],
    /// The last values of the episode; empty before its first action.
    last: Vec<f64>,
    steps: u64,
    saturated: u64,
    changes: u64,
    changed: f64,
}

impl<'o> Meter<'o> {
    /// Begins with no steps.
    pub(crate) fn new(outputs: &'o [Output]) -> Self {
        Self { outputs, last: Vec::new(), steps: 0, saturated: 0, changes: 0, changed: 0.0 }
    }

    /// Begins another episode.
    pub(crate) fn begin(&mut self) {
        self.last.clear();
    }

    /// Counts a step; values behind those of the outputs, such as memory, are not counted.
    pub(crate) fn step(&mut self, values: impl Iterator<Item = f64>) {
        let values: Vec<f64> =
            values.zip(self.outputs).map(|(value, output)| value.clamp(output.min, output.max)).collect();
        let mut bounded = values.iter().zip(self.outputs);
        self.steps += 1;
        self.saturated += u64::from(bounded.any(|(&value, output)| value == output.min || value == output.max));
        let changes = values.iter().zip(&self.last).zip(self.outputs);
        for ((value, last), output) in changes {
            self.changes += 1;
            self.changed += (value - last).abs() / (output.max - output.min);
        }
        self.last = values;
    }

    /// Returns the effort of all steps.
    pub(crate) fn effort(&self) -> Effort {
        Effort {
            saturated: self.saturated as f64 / self.steps.max(1) as f64,
            chatter: self.changed / self.changes.max(1) as f64,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Effort, Meter};
    use tpg_engine::Output;

    #[test]
    fn effort_is_saturation_and_change() {
        let output = |min, max| Output { name: "torque".to_owned(), unit: "N·m".to_owned(), min, max };
        let outputs = [output(-1.0, 1.0), output(0.0, 4.0)];
        let mut meter = Meter::new(&outputs);
        meter.step([0.5, 1.0, 9.0].into_iter());
        // Changes by 3/4 and by 1/4 of the ranges, and is at a bound.
        meter.step([-2.0, 2.0, 0.0].into_iter());
        meter.begin();
        meter.step([0.0, 3.0].into_iter());
        assert_eq!(meter.effort(), Effort { saturated: 1.0 / 3.0, chatter: 0.5 });
    }
}
