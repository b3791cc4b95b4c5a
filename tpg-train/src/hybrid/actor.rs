//! Actors read from files, for arms in any precision.

use crate::files::read_text;
use crate::sac::config::Actor as ActorConfig;
use crate::sac::fixed::FixedActor;
use crate::sac::lanes::ARM;
use crate::sac::policy::ActorPolicy;
use crate::sac::weights;
use std::path::Path;
use tpg_arm::Move;
use tpg_arm::kinematics::Lattice;
use tpg_arm::observation::Observation;
use tpg_codegen::policy::QuantisedPolicy;
use tpg_graph::error::InputError;
use tpg_nn::Mlp;
use tpg_problems::arm::targets::{Start, Task};
use tpg_problems::arm::trial::{self, Trial};
use tpg_runtime::policy::Policy;

/// A policy that decides in the precision it was trained in.
pub type DynPolicy<'a> = dyn Policy<State = Observation<f32>, Action = Move> + 'a;

/// An actor: `policy.safetensors` or `policy.q.json`.
#[derive(Debug)]
pub enum Actor {
    /// Floating-point actor.
    Float(Box<(Mlp<f32>, ActorConfig)>),
    /// Integer actor, with the size of its constants in bytes.
    Fixed(Box<FixedActor>, usize),
}

impl Actor {
    /// Reads either file: JSON contains the integer actor.
    ///
    /// # Errors
    /// If it is neither kind of file.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        if path.extension().is_some_and(|extension| extension == "json") {
            let file = path.display().to_string();
            let policy = QuantisedPolicy::from_json(&file, &read_text(path, "a policy.q.json")?)?;
            let bytes = policy.bytes();
            return Ok(Self::Fixed(Box::new(FixedActor::new(policy)?), bytes));
        }
        let (network, contract) = weights::read(path)?;
        Ok(Self::Float(Box::new((network, contract.actor))))
    }

    /// Returns the size of the constants that decide, in bytes: four per parameter in floating point, without the
    /// spreads.
    pub fn bytes(&self) -> usize {
        match self {
            Self::Float(actor) => {
                let (network, config) = actor.as_ref();
                let spreads = 4 * (config.hidden.last().copied().unwrap_or(config.inputs.count()) + 1);
                4 * (network.shape().parameters() - spreads)
            }
            Self::Fixed(_, bytes) => *bytes,
        }
    }

    /// Runs one episode of each task with the actor's mean actions, as outside of training.
    pub fn trial(&self, start: Start, tasks: &[Task]) -> Trial {
        match self {
            Self::Float(actor) => ActorPolicy::new(&actor.0, &actor.1).trial(start, tasks),
            Self::Fixed(actor, _) => trial::run(&ARM, actor.as_ref(), start, tasks),
        }
    }

    /// Returns the policy that acts by the actor's mean.
    pub fn policy(&self) -> Box<DynPolicy<'_>> {
        match self {
            Self::Float(actor) => Box::new(ActorPolicy::new(&actor.0, &actor.1)),
            Self::Fixed(actor, _) => Box::new(actor.as_ref()),
        }
    }
}

/// An `f32` policy for an arm in another precision: every value is rounded to nearest.
#[derive(Debug)]
pub struct Narrowed<'a, S, P: ?Sized> {
    policy: &'a P,
    precision: std::marker::PhantomData<S>,
}

impl<'a, S, P: ?Sized> Narrowed<'a, S, P> {
    /// Wraps a policy.
    pub fn new(policy: &'a P) -> Self {
        Self { policy, precision: std::marker::PhantomData }
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
