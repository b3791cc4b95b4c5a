//! Action spaces, and the actions that policies take in them.

use tpg_graph::ActionDocument;
use tpg_runtime::policy::ActionId;

/// The actions that a policy can take.
#[derive(Clone, Debug, PartialEq)]
pub enum ActionSpace {
    /// One of several named actions.
    Discrete(Vec<ActionDocument>),
    /// A value for each of several outputs.
    Box(Vec<Output>),
    /// One option of each of several choices.
    MultiDiscrete(Vec<Choice>),
}

/// A continuous output: a torque, a speed.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Its name.
    pub name: String,
    /// Its unit, for people.
    pub unit: String,
    /// The lowest value, finite.
    pub min: f64,
    /// The highest value, finite and above the lowest.
    pub max: f64,
}

/// One of several simultaneous choices.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// Its name.
    pub name: String,
    /// Its options by name, at least one.
    pub options: Vec<String>,
}

impl ActionSpace {
    /// Named actions without an effect that a graph would have to carry.
    ///
    /// ```
    /// use tpg_engine::ActionSpace;
    ///
    /// assert_eq!(ActionSpace::discrete(["left", "right"]).count(), Some(2));
    /// ```
    pub fn discrete<'a>(names: impl IntoIterator<Item = &'a str>) -> Self {
        let action = |(id, name): (u32, &str)| ActionDocument { id, name: name.to_owned(), effect: None };
        Self::Discrete((0..).zip(names).map(action).collect())
    }

    /// The number of named actions; `None` where actions are not a list of names.
    pub fn count(&self) -> Option<usize> {
        match self {
            Self::Discrete(actions) => Some(actions.len()),
            Self::Box(_) | Self::MultiDiscrete(_) => None,
        }
    }
}

/// An action, as a policy takes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Act<'a, S> {
    /// In a [`Discrete`](ActionSpace::Discrete) space: the action's number.
    Choice(ActionId),
    /// In a [`Box`](ActionSpace::Box): a value for each output, within its range.
    Values(&'a [S]),
    /// In a [`MultiDiscrete`](ActionSpace::MultiDiscrete) space: an option of each choice.
    Choices(&'a [u16]),
}

impl<'a, S> Act<'a, S> {
    /// The number of the action in a discrete space.
    ///
    /// # Panics
    /// In any other space: the environment said that its actions are named.
    pub fn choice(self) -> usize {
        match self {
            Self::Choice(ActionId(id)) => usize::from(id),
            _ => panic!("a discrete environment is given choices"),
        }
    }

    /// The values in a box.
    ///
    /// # Panics
    /// In any other space: the environment said that its actions are values.
    pub fn values(self) -> &'a [S] {
        match self {
            Self::Values(values) => values,
            _ => panic!("an environment with outputs is given values"),
        }
    }

    /// The options in a space of several choices.
    ///
    /// # Panics
    /// In any other space: the environment said that its actions are several choices.
    pub fn choices(self) -> &'a [u16] {
        match self {
            Self::Choices(options) => options,
            _ => panic!("an environment of several choices is given an option for each"),
        }
    }
}
