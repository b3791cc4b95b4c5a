//! Wear of actuators.

use serde::{Deserialize, Serialize};
use tpg_engine::{Act, Output};
use tpg_runtime::scalar::Scalar;

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
pub(crate) struct Meter {
    /// The outputs; none where actions are named.
    outputs: Vec<Output>,
    /// The last values of each episode; empty before its first action.
    last: Vec<Vec<f64>>,
    steps: u64,
    saturated: u64,
    changes: u64,
    changed: f64,
}

impl Meter {
    /// Begins with no steps of `episodes` episodes.
    pub(crate) fn new(outputs: &[Output], episodes: usize) -> Self {
        let last = vec![Vec::new(); episodes];
        Self { outputs: outputs.to_vec(), last, steps: 0, saturated: 0, changes: 0, changed: 0.0 }
    }

    /// Counts an action of an episode; values behind those of the outputs, such as memory, are not counted.
    pub(crate) fn act<S: Scalar>(&mut self, episode: usize, act: Act<'_, S>) {
        let Act::Values(values) = act else { return };
        let values = values.iter().zip(&self.outputs);
        let values: Vec<f64> = values.map(|(value, output)| value.to_f64().clamp(output.min, output.max)).collect();
        let mut bounded = values.iter().zip(&self.outputs);
        self.steps += 1;
        self.saturated += u64::from(bounded.any(|(&value, output)| value == output.min || value == output.max));
        for ((value, last), output) in values.iter().zip(&self.last[episode]).zip(&self.outputs) {
            self.changes += 1;
            self.changed += (value - last).abs() / (output.max - output.min);
        }
        self.last[episode] = values;
    }

    /// Returns the effort of all steps; `None` where actions are named.
    pub(crate) fn effort(&self) -> Option<Effort> {
        (!self.outputs.is_empty()).then(|| Effort {
            saturated: self.saturated as f64 / self.steps.max(1) as f64,
            chatter: self.changed / self.changes.max(1) as f64,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::{Effort, Meter};
    use tpg_engine::{Act, Output};

    #[test]
    fn effort_is_saturation_and_change() {
        let output = |min, max| Output { name: "torque".to_owned(), unit: "N·m".to_owned(), min, max };
        let outputs = [output(-1.0, 1.0), output(0.0, 4.0)];
        let mut meter = Meter::new(&outputs, 2);
        meter.act(0, Act::Values(&[0.5, 1.0, 9.0]));
        meter.act(1, Act::Values(&[0.0, 3.0]));
        // Changes by 3/4 and by 1/4 of the ranges, and is at a bound.
        meter.act(0, Act::Values(&[-2.0, 2.0, 0.0]));
        assert_eq!(meter.effort(), Some(Effort { saturated: 1.0 / 3.0, chatter: 0.5 }));
        assert_eq!(Meter::new(&[], 1).effort(), None, "actions by name");
    }
}
