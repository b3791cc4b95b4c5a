//! Named actions as outputs, for policies that compute values.

use crate::action::{Act, ActionSpace, Output};
use crate::ending::Step;
use crate::environment::Environment;
use tpg_graph::ActionDocument;
use tpg_runtime::policy::ActionId;
use tpg_runtime::scalar::Scalar;

/// An environment with an output of −1 to 1 for each named action of the environment inside: its preference. The action with
/// the greatest acts, of equals the first. Any other action space stays as it is.
///
/// ```
/// use tpg_engine::{Act, Environment, Preferring};
/// # use tpg_engine::random::Stream;
/// # use tpg_engine::{ActionSpace, SourceSet, Step};
/// # use tpg_graph::SourceDocument;
/// # struct Lift;
/// # impl Environment<f32> for Lift {
/// #     type Task = i32;
/// #     type Episode = i32;
/// #     fn sources(&self) -> Vec<SourceDocument> { Vec::new() }
/// #     fn actions(&self) -> ActionSpace { ActionSpace::discrete(["down", "stay", "up"]) }
/// #     fn time_limit(&self) -> u32 { 5 }
/// #     fn draw(&self, _: &mut Stream) -> i32 { 0 }
/// #     fn start(&self, task: &i32) -> i32 { *task }
/// #     fn observe(&self, _: &mut i32, _: SourceSet, _: &mut [f32]) {}
/// #     fn step(&self, floor: &mut i32, act: Act<'_, f32>) -> Step {
/// #         *floor += act.choice() as i32 - 1;
/// #         Step::reward(0.0)
/// #     }
/// # }
/// // `Lift` has the actions down, stay and up.
/// let lift = Preferring::new::<f32>(Lift);
/// let mut floor = lift.start(&0);
/// lift.step(&mut floor, Act::Values(&[-0.5, 0.1, 0.9]));
/// assert_eq!(floor, 1);
/// assert_eq!(lift.actions().outputs()[2].name, "up");
/// ```
#[derive(Clone, Debug)]
pub struct Preferring<E> {
    environment: E,
    chooses: bool,
}

impl<E> Preferring<E> {
    /// Turns named actions into outputs.
    pub fn new<S: Scalar>(environment: E) -> Self
    where
        E: Environment<S>,
    {
        let chooses = environment.actions().count().is_some();
        Self { environment, chooses }
    }
}

/// Returns the action with the greatest preference, of equals the first; NaN is preferred least.
///
/// ```
/// use tpg_engine::preferred;
/// use tpg_runtime::policy::ActionId;
///
/// assert_eq!(preferred(&[0.5, 0.7, 0.7]), ActionId(1));
/// assert_eq!(preferred(&[f32::NAN, -1.0]), ActionId(1));
/// ```
pub fn preferred<S: Scalar>(values: &[S]) -> ActionId {
    let mut best = 0;
    for (place, &value) in values.iter().enumerate() {
        if value > values[best] || values[best].is_nan() {
            best = place;
        }
    }
    ActionId(best as u16)
}

impl<S: Scalar, E: Environment<S>> Environment<S> for Preferring<E> {
    type Task = E::Task;
    type Episode = E::Episode;

    crate::forward!(this => this.environment;
        sources time_limit draw start observe outcomes timeout measure preference constants accepts key cycle training
        guarded drawn distance);

    fn actions(&self) -> ActionSpace {
        let output = |action: ActionDocument| Output { name: action.name, unit: String::new(), min: -1.0, max: 1.0 };
        match self.environment.actions() {
            ActionSpace::Discrete(actions) => ActionSpace::Box(actions.into_iter().map(output).collect()),
            space => space,
        }
    }

    fn chooses(&self) -> bool {
        self.chooses || self.environment.chooses()
    }

    fn step(&self, episode: &mut E::Episode, act: Act<'_, S>) -> Step {
        let chosen = match act {
            Act::Values(values) if self.chooses => Act::Choice(preferred(values)),
            act => act,
        };
        self.environment.step(episode, chosen)
    }
}
