//! The way between an environment's values and a network's.

use serde::{Deserialize, Serialize};
use tpg_engine::{ActionSpace, Environment, Output, Sample};
use tpg_graph::SourceDocument;
use tpg_graph::error::Finding;

/// An input of the network: (value − offset)·scale of one value of the flat state.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Input {
    /// The name of the value's source, with its place in the source where there are several.
    pub name: String,
    /// The unit of the value, for people.
    pub unit: String,
    /// Subtracted first.
    pub offset: f32,
    /// Multiplied with then.
    pub scale: f32,
}

/// An input that changes less stays as it is.
pub(crate) const LEAST_DEVIATION: f32 = 1e-3;

/// The names of a network's inputs: one for each value of the flat state of these sources.
pub(crate) fn input_names(sources: &[SourceDocument]) -> Vec<String> {
    sources.iter().flat_map(|source| inputs(source, false)).map(|input| input.name).collect()
}

/// A network's inputs and outputs in terms of an environment.
#[derive(Clone, Debug, PartialEq)]
pub struct Interface {
    /// One for each value of the flat state.
    pub inputs: Vec<Input>,
    /// One for each component of an action.
    pub outputs: Vec<Output>,
}

impl Interface {
    /// The interface to an environment. Where `scaled`, a finite range becomes −1..1.
    ///
    /// # Errors
    /// If the environment's actions are not outputs.
    pub fn new(environment: &impl Environment<f32>, scaled: bool) -> Result<Self, Finding> {
        let inputs = environment.sources().iter().flat_map(|source| inputs(source, scaled)).collect();
        Ok(Self { inputs, outputs: outputs(environment.actions())? })
    }

    /// Makes the network read inputs less their mean, divided by their standard deviation; both are of what it has read so far. An
    /// input that hardly changes, by less than a thousandth of its unit, stays as it is.
    pub fn measure(&mut self, seen: &[Sample]) {
        for (input, seen) in self.inputs.iter_mut().zip(seen) {
            let deviation = seen.deviation() as f32;
            if deviation > LEAST_DEVIATION {
                input.offset += seen.mean as f32 / input.scale;
                input.scale /= deviation;
            }
        }
    }

    /// Turns a flat state into what the network reads.
    pub fn scale(&self, state: &mut [f32]) {
        for (value, input) in state.iter_mut().zip(&self.inputs) {
            *value = (*value - input.offset) * input.scale;
        }
    }

    /// The environment's values of an action whose components lie in −1..1.
    pub fn values(&self, action: impl Iterator<Item = f32>) -> Vec<f32> {
        let value = |(output, component): (&Output, f32)| {
            let middle = (0.5 * (output.min + output.max)) as f32;
            let half = (0.5 * (output.max - output.min)) as f32;
            middle + half * component
        };
        self.outputs.iter().zip(action).map(value).collect()
    }
}

fn inputs(source: &SourceDocument, scaled: bool) -> impl Iterator<Item = Input> {
    source.ranges.iter().enumerate().map(move |(place, &[low, high])| {
        let name = if source.length == 1 { source.name.clone() } else { format!("{}_{place}", source.name) };
        let known = scaled && low.is_finite() && high.is_finite() && low < high;
        let (offset, scale) = if known { (0.5 * (low + high), 2.0 / (high - low)) } else { (0.0, 1.0) };
        Input { name, unit: source.unit.clone(), offset: offset as f32, scale: scale as f32 }
    })
}

fn outputs(actions: ActionSpace) -> Result<Vec<Output>, Finding> {
    match actions {
        ActionSpace::Box(outputs) => Ok(outputs),
        ActionSpace::Discrete(actions) => {
            let found = format!("{} named actions", actions.len());
            Err(Finding::new("problem.actions", found, "outputs: a soft actor-critic answers a value for each"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Interface;
    use tpg_problems::{CartPole, Pendulum};

    #[test]
    fn finite_ranges_become_minus_one_to_one_and_actions_fill_their_range() {
        let interface = Interface::new(&Pendulum, true).expect("a torque");
        let mut state = [0.5, -1.0, 4.0];
        interface.scale(&mut state);
        assert_eq!(state, [0.5, -1.0, 0.5]);
        for (action, expected) in [(-1.0, -2.0), (0.0, 0.0), (0.25, 0.5), (1.0, 2.0)] {
            assert_eq!(interface.values([action].into_iter()), [expected]);
        }
    }

    #[test]
    fn named_actions_are_refused_with_their_number() {
        let finding = Interface::new(&CartPole, true).expect_err("left and right");
        assert!(finding.found == "2 named actions" && finding.accepted.starts_with("outputs"), "{finding}");
    }
}
