//! A policy in `f32` for an arm in any precision.

use std::marker::PhantomData;
use tpg_arm::Move;
use tpg_arm::kinematics::Lattice;
use tpg_arm::observation::Observation;
use tpg_runtime::policy::Policy;

/// A policy in `f32` that is shown an arm in another precision: every value is rounded to nearest.
#[derive(Debug)]
pub struct Narrowed<'a, S, P: ?Sized> {
    policy: &'a P,
    precision: PhantomData<S>,
}

impl<'a, S, P: ?Sized> Narrowed<'a, S, P> {
    /// The policy, narrowed.
    pub fn new(policy: &'a P) -> Self {
        Self { policy, precision: PhantomData }
    }
}

impl<S: Lattice, P> Policy for Narrowed<'_, S, P>
where
    P: Policy<State = Observation<f32>, Action = Move> + ?Sized,
{
    type State = Observation<S>;
    type Action = Move;

    fn decide(&self, seen: &Observation<S>) -> Move {
        let narrow = |values: [S; 3]| values.map(|value| value.to_f64() as f32);
        self.policy.decide(&Observation {
            pose: seen.pose,
            fixed_servos: seen.fixed_servos,
            hand: narrow(seen.hand),
            target: narrow(seen.target),
            difference: narrow(seen.difference),
        })
    }
}
