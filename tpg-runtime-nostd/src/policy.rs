//! Policies: pure functions from a state to an action.

/// The number of an action, as a graph declares it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ActionId(pub u16);

/// A stateless decision: the same state always gives the same action.
///
/// Generated code implements it over its flat state (`[f64; 15]` say, the sources one after another). A problem lifts such
/// a policy to its own terms: on the arm of `tpg-arm` the state is an observation, and the action a move of the motors.
pub trait Policy {
    /// The state that the policy sees.
    type State: ?Sized;
    /// The action that the policy answers.
    type Action;

    /// Decides. Never panics, whatever the state holds: NaN and infinities are legal values.
    fn decide(&self, state: &Self::State) -> Self::Action;
}

impl<P: Policy + ?Sized> Policy for &P {
    type State = P::State;
    type Action = P::Action;

    fn decide(&self, state: &Self::State) -> Self::Action {
        (**self).decide(state)
    }
}
