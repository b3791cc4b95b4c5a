//! Action spaces, and the actions that policies take in them.

use crate::policy::Limits;
use serde::{Deserialize, Serialize};
use tpg_graph::{ActionDocument, ScalarType};
use tpg_runtime::policy::ActionId;

/// The name by which a graph asks the network beside it.
const NETWORK: &str = "network";

/// The actions that a policy can take.
#[derive(Clone, Debug, PartialEq)]
pub enum ActionSpace {
    /// A choice among named actions.
    Discrete(Vec<ActionDocument>),
    /// A value for each output.
    Box(Vec<Output>),
}

/// A continuous output: a torque, a speed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Output {
    /// Its name.
    pub name: String,
    /// Its unit, for human readers.
    pub unit: String,
    /// Lowest value, finite.
    pub min: f64,
    /// Highest value, finite and above the lowest.
    pub max: f64,
}

impl Output {
    /// Returns the limits of a policy's output in a scalar type: the output's range, rounded inwards. NaN becomes 0, or the
    /// nearest value of the range.
    pub fn limits(&self, scalar: ScalarType) -> Limits {
        let inwards = |value: f64, towards: fn(f32) -> f32, is_outside: fn(&f64, &f64) -> bool| match scalar {
            ScalarType::F64 => value,
            ScalarType::F32 => {
                let near = value as f32;
                f64::from(if is_outside(&f64::from(near), &value) { towards(near) } else { near })
            }
        };
        let min = inwards(self.min, f32::next_up, f64::lt);
        let max = inwards(self.max, f32::next_down, f64::gt);
        Limits { min, max, nan: 0.0_f64.clamp(min, max) }
    }
}

impl ActionSpace {
    /// Creates a discrete space of named actions without effects.
    ///
    /// ```
    /// use tpg_engine::ActionSpace;
    ///
    /// assert_eq!(ActionSpace::discrete(["left", "right"]).count(), Some(2));
    /// ```
    pub fn discrete<'a>(names: impl IntoIterator<Item = &'a str>) -> Self {
        let action = |(id, name): (u32, &str)| ActionDocument { id, name: name.to_owned(), effect: None, ask: None };
        Self::Discrete((0..).zip(names).map(action).collect())
    }

    /// Adds to a discrete space an action `ask`, which asks the network; any other space stays as it is.
    ///
    /// ```
    /// use tpg_engine::ActionSpace;
    ///
    /// let space = ActionSpace::discrete(["left", "right"]).with_ask();
    /// assert_eq!(space.asking().map(|action| action.0), Some(2));
    /// ```
    #[must_use]
    pub fn with_ask(mut self) -> Self {
        if let Self::Discrete(actions) = &mut self {
            let (id, name) = (actions.len() as u32, "ask".to_owned());
            actions.push(ActionDocument { id, name, effect: None, ask: Some(NETWORK.to_owned()) });
        }
        self
    }

    /// Returns the action that asks the network, if there is one.
    pub fn asking(&self) -> Option<ActionId> {
        let Self::Discrete(actions) = self else { return None };
        actions.iter().position(|action| action.ask.as_deref() == Some(NETWORK)).map(|place| ActionId(place as u16))
    }

    /// Returns the outputs of a box; empty for any other space.
    pub fn outputs(&self) -> &[Output] {
        match self {
            Self::Box(outputs) => outputs,
            Self::Discrete(_) => &[],
        }
    }

    /// Iterates over the names of the actions, or of the outputs.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        let (actions, outputs) = match self {
            Self::Discrete(actions) => (&actions[..], &[][..]),
            Self::Box(outputs) => (&[][..], &outputs[..]),
        };
        actions.iter().map(|action| action.name.as_str()).chain(outputs.iter().map(|output| output.name.as_str()))
    }

    /// Returns the number of named actions; `None` unless the space is discrete.
    pub fn count(&self) -> Option<usize> {
        match self {
            Self::Discrete(actions) => Some(actions.len()),
            Self::Box(_) => None,
        }
    }
}

/// An action taken by a policy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Act<'a, S> {
    /// In a [`Discrete`](ActionSpace::Discrete) space: the action's number.
    Choice(ActionId),
    /// In a [`Box`](ActionSpace::Box): a value for each output, within its range.
    Values(&'a [S]),
}

/// The actions of a policy in all lanes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Acts<'a, S> {
    /// An action for each lane.
    Choices(&'a [ActionId]),
    /// A value for each output, lane after lane.
    Values {
        /// The values.
        values: &'a [S],
        /// The number of outputs.
        outputs: usize,
    },
}

impl<'a, S> Acts<'a, S> {
    /// Returns the actions of the lanes, in order.
    pub fn iter(self) -> impl Iterator<Item = Act<'a, S>> {
        let (actions, values, outputs) = match self {
            Self::Choices(actions) => (actions, &[][..], 1),
            Self::Values { values, outputs } => (&[][..], values, outputs),
        };
        let choices = actions.iter().map(|&action| Act::Choice(action));
        choices.chain(values.chunks_exact(outputs).map(Act::Values))
    }

    /// Returns the actions of a policy that chooses among them.
    ///
    /// # Panics
    /// If the policy has outputs: the environment declared named actions.
    pub fn choices(self) -> &'a [ActionId] {
        match self {
            Self::Choices(actions) => actions,
            Self::Values { .. } => panic!("a discrete environment is given choices"),
        }
    }
}

impl<'a, S> Act<'a, S> {
    /// Returns the number of the action in a discrete space.
    ///
    /// # Panics
    /// In any other space: the environment declared named actions.
    pub fn choice(self) -> usize {
        match self {
            Self::Choice(ActionId(id)) => usize::from(id),
            Self::Values(_) => panic!("a discrete environment is given choices"),
        }
    }

    /// Returns the values in a box space.
    ///
    /// # Panics
    /// In any other space: the environment declared outputs.
    pub fn values(self) -> &'a [S] {
        match self {
            Self::Values(values) => values,
            Self::Choice(_) => panic!("an environment with outputs is given values"),
        }
    }
}
