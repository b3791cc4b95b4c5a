//! Any action space as a list of named actions, for policies that choose among actions.

use crate::action::{Act, ActionSpace, Output};
use crate::environment::Environment;
use crate::episode_result::Step;
use crate::episodes::Episodes;
use crate::mapped::Mapped;
use tpg_graph::error::Finding;
use tpg_graph::{ActionDocument, Effect};
use tpg_runtime::scalar::Scalar;

/// An environment whose actions are named. Each output of a box takes one of a few evenly spaced levels; every
/// combination of outputs is one action. An action of the inner environment is
/// passed on as it is, so that a network and a graph can share an episode.
///
/// ```
/// use tpg_engine::{ActionSpace, Choices, Environment};
/// # use tpg_engine::random::Stream;
/// # use tpg_engine::{Act, Output, SourceSet, Step};
/// # use tpg_graph::SourceDocument;
/// # struct Motor;
/// # impl Environment<f32> for Motor {
/// #     type Task = f32;
/// #     type Episode = f32;
/// #     fn sources(&self) -> Vec<SourceDocument> { Vec::new() }
/// #     fn actions(&self) -> ActionSpace {
/// #         let torque = Output { name: "torque".into(), unit: "N·m".into(), min: -2.0, max: 2.0 };
/// #         ActionSpace::Box(vec![torque])
/// #     }
/// #     fn time_limit(&self) -> u32 { 1 }
/// #     fn draw(&self, _: &mut Stream) -> f32 { 0.0 }
/// #     fn start(&self, task: &f32) -> f32 { *task }
/// #     fn observe(&self, _: &mut f32, _: SourceSet, _: &mut [f32]) {}
/// #     fn step(&self, speed: &mut f32, act: Act<'_, f32>) -> Step {
/// #         *speed += act.values()[0];
/// #         Step::reward(0.0)
/// #     }
/// # }
/// // `Motor` has one output, a torque of -2 to 2 N·m.
/// let ActionSpace::Discrete(actions) = Choices::new(Motor, Some(3))?.actions() else { panic!("named actions") };
/// let names: Vec<&str> = actions.iter().map(|action| action.name.as_str()).collect();
/// assert_eq!(names, ["torque -2", "torque 0", "torque 2"]);
/// # Ok::<(), tpg_graph::error::Finding>(())
/// ```
#[derive(Clone, Debug)]
pub struct Choices<S, E> {
    environment: E,
    actions: ActionSpace,
    /// The values of the outputs for each named action; `None` if actions are passed on as they are.
    levels: Option<Vec<Vec<S>>>,
}

/// Name of the effect that a graph carries for the levels of a box: the value of each output.
const VALUES: &str = "values";

/// Maximum number of actions: they are numbered in 16 bits.
const MOST: u128 = 1 << 16;

impl<S: Scalar, E: Environment<S>> Choices<S, E> {
    /// Names the actions of `environment`; each output of a box takes `levels` evenly spaced values, both ends included.
    /// Without `levels`, a box stays as it is.
    ///
    /// # Errors
    /// If there are more than 65,536 combinations.
    ///
    /// # Panics
    /// If `levels` is below 2.
    pub fn new(environment: E, levels: Option<u16>) -> Result<Self, Finding> {
        let space = environment.actions();
        let (ActionSpace::Box(outputs), Some(levels)) = (&space, levels) else {
            return Ok(Self { environment, actions: space, levels: None });
        };
        assert!(levels >= 2, "an output has at least its lowest and its highest value");
        let action = |(id, places): (u32, &Vec<u16>)| {
            let values: Vec<f64> = outputs.iter().zip(places).map(|(output, &at)| level(output, at, levels)).collect();
            let parts = outputs.iter().zip(&values).map(|(output, value)| format!("{} {value}", output.name));
            let name = parts.collect::<Vec<_>>().join(", ");
            let values = values.into_iter().map(|value| S::from_f64(value).to_f64()).collect();
            ActionDocument { id, name, effect: Some(Effect { name: VALUES.to_owned(), values }), ask: None }
        };
        let actions: Vec<ActionDocument> = (0..).zip(&combinations(levels, outputs.len())?).map(action).collect();
        let values = |action: &ActionDocument| {
            action.effect.iter().flat_map(|effect| &effect.values).map(|&value| S::from_f64(value)).collect()
        };
        let levels = Some(actions.iter().map(values).collect());
        Ok(Self { environment, actions: ActionSpace::Discrete(actions), levels })
    }

    /// Returns the inner environment.
    pub fn inner(&self) -> &E {
        &self.environment
    }
}

/// Returns the value of one of `levels` evenly spaced levels.
fn level(output: &Output, at: u16, levels: u16) -> f64 {
    let share = f64::from(at) / f64::from(levels - 1);
    (output.min + share * (output.max - output.min)).clamp(output.min, output.max)
}

/// Returns every combination of the levels of some outputs; the last position varies fastest.
fn combinations(levels: u16, outputs: usize) -> Result<Vec<Vec<u16>>, Finding> {
    let found = u128::from(levels).checked_pow(outputs as u32).unwrap_or(u128::MAX);
    if found > MOST {
        let found = format!("{levels}: {found} combinations of actions");
        return Err(Finding::new("problem.levels", found, format!("fewer, for up to {MOST} combinations")));
    }
    let mut all = vec![Vec::new()];
    for _ in 0..outputs {
        all = all.iter().flat_map(|start: &Vec<u16>| (0..levels).map(move |at| [&start[..], &[at]].concat())).collect();
    }
    Ok(all)
}

impl<S: Scalar, E: Environment<S>> Environment<S> for Choices<S, E> {
    type Task = E::Task;
    type Episode = E::Episode;

    crate::forward!(this => this.environment;
        sources time_limit draw start observe outcomes timeout measure preference accepts key cycle training
        task_from guarded moment distance);

    fn actions(&self) -> ActionSpace {
        self.actions.clone()
    }
    fn step(&self, episode: &mut E::Episode, act: Act<'_, S>) -> Step {
        let inner = match (&self.levels, act) {
            (Some(levels), Act::Choice(action)) => Act::Values(&levels[usize::from(action.0)]),
            (_, act) => act,
        };
        self.environment.step(episode, inner)
    }
    fn lanes(&self) -> Box<dyn Episodes<S, E::Task> + '_> {
        match &self.levels {
            None => self.environment.lanes(),
            Some(levels) => Box::new(Mapped::new(self.environment.lanes(), |task| task).with_levels(levels)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::combinations;

    #[test]
    fn combinations_count_like_an_odometer() {
        assert_eq!(combinations(2, 2).expect("few"), [[0, 0], [0, 1], [1, 0], [1, 1]]);
        assert_eq!(combinations(256, 2).expect("just as many as allowed").len(), 65_536);
        let refused = combinations(257, 2).expect_err("too many");
        assert!(refused.to_string().starts_with("problem.levels = 257: 66049 combinations of actions"), "{refused}");
        assert!(combinations(u16::MAX, 20).is_err());
    }
}
