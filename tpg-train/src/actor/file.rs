//! An actor of the arm from its file.

use super::fixed::FixedActor;
use super::policy::ActorPolicy;
use super::version1;
use crate::files::read_text;
use crate::sac::config::Actor as ActorConfig;
use crate::sac::contract::Contract;
use crate::sac::tensors::{Tensors, place as refused};
use crate::sac::weights::{LIMIT, from_tensors};
use std::path::Path;
use tpg_arm::observation::Observation;
use tpg_arm::{Arm, Move, WIDOWX};
use tpg_codegen::policy::QuantisedPolicy;
use tpg_graph::error::{Finding, InputError, Place};
use tpg_nn::Mlp;
use tpg_problems::ContinuousProblem;
use tpg_problems::arm::ArmProblem;
use tpg_problems::arm::motors::{Config, MOTORS};
use tpg_problems::arm::targets::{Start, Task};
use tpg_problems::arm::trial::{self, Trial};
use tpg_runtime::policy::Policy;

/// A decision of an actor, in the precision it was trained in.
pub type DynPolicy<'a> = dyn Policy<State = Observation<f32>, Action = Move> + 'a;

/// An actor in floating point.
#[derive(Clone, Debug, PartialEq)]
pub struct FloatActor {
    /// The network.
    pub network: Mlp<f32>,
    /// The settings of the problem that it was trained on: its inputs, its decision.
    pub motors: Config,
    /// The settings of the actor.
    pub actor: ActorConfig,
}

impl FloatActor {
    /// Reads a `policy.safetensors` of this or an earlier version.
    ///
    /// # Errors
    /// If it is damaged, or not an actor of the arm.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let read = |tensors: Tensors| {
            let (network, contract) = from_tensors(version1::upgraded(tensors)?)?;
            Self::of_contract(network, &contract)
        };
        read(Tensors::read(path, LIMIT)?).map_err(|finding| refused(path, finding))
    }

    /// The actor of a network and its contract.
    ///
    /// # Errors
    /// If the contract is not one of the arm's motors.
    pub fn of_contract(network: Mlp<f32>, contract: &Contract) -> Result<Self, Finding> {
        let accepted = "a policy of the arm: fs or rs";
        let problem = ContinuousProblem::from_table("metadata.tpg", &contract.problem)
            .map_err(|error| Finding::new("metadata.tpg.problem", error.found, error.accepted))?;
        let ContinuousProblem::Motors(_, motors) = problem else {
            return Err(Finding::new("metadata.tpg.problem.name", problem.name().name(), accepted));
        };
        let names = motors.inputs.names();
        let plain = contract
            .inputs
            .iter()
            .zip(&names)
            .all(|(input, name)| (input.offset, input.scale) == (0.0, 1.0) && input.name == *name);
        if contract.inputs.len() != names.len() || !plain {
            let found: Vec<&str> = contract.inputs.iter().map(|input| input.name.as_str()).collect();
            let accepted = format!("{} inputs in this order, not scaled: {}", names.len(), names.join(" "));
            return Err(Finding::new("metadata.tpg.inputs", found.join(" "), accepted));
        }
        let outputs: Vec<&str> = contract.outputs.iter().map(|output| output.name.as_str()).collect();
        if outputs != MOTORS || contract.outputs.iter().any(|output| (output.min, output.max) != (-1.0, 1.0)) {
            let accepted = format!("{} from -1 to 1", MOTORS.join(" "));
            return Err(Finding::new("metadata.tpg.outputs", outputs.join(" "), accepted));
        }
        Ok(Self { network, motors, actor: contract.actor.clone() })
    }

    /// The actor, ready to decide.
    pub fn policy(&self) -> ActorPolicy<'_> {
        ActorPolicy::new(&self.network, &self.motors, &self.actor)
    }
}

/// An actor: `policy.safetensors` or `policy.q.json`.
#[derive(Debug)]
pub enum Actor {
    /// In floating point.
    Float(Box<FloatActor>),
    /// In integers, and the bytes of its constants.
    Fixed(Box<FixedActor>, usize),
}

impl Actor {
    /// Reads either file: JSON is the one in integers, which names no arm. With `arm` the actor must be for that one; without,
    /// one in integers is taken for the WidowX's.
    ///
    /// # Errors
    /// If it is neither, or for another arm.
    pub fn read(path: &Path, arm: Option<&Arm<f64>>) -> Result<Self, InputError> {
        if path.extension().is_some_and(|extension| extension == "json") {
            let file = path.display().to_string();
            let policy = QuantisedPolicy::from_json(&file, &read_text(path, "a policy.q.json")?)?;
            let bytes = policy.bytes();
            return Ok(Self::Fixed(Box::new(FixedActor::new(policy, arm.unwrap_or(&WIDOWX))?), bytes));
        }
        let float = FloatActor::read(path)?;
        if arm.is_some_and(|arm| float.motors.arm() != *arm) {
            let accepted = "one for the arm of the configuration, or of the graph";
            return Err(InputError::new(
                path.display().to_string(),
                Place::Whole,
                "a network for another arm",
                accepted,
            ));
        }
        Ok(Self::Float(Box::new(float)))
    }

    /// Bytes of the constants that decide: four a parameter in floating point, the spreads left out.
    pub fn bytes(&self) -> usize {
        match self {
            Self::Float(float) => {
                let shape = float.network.shape();
                let spreads = MOTORS.len() * (shape.hidden.last().unwrap_or(&shape.inputs) + 1);
                4 * (shape.parameters() - spreads)
            }
            Self::Fixed(_, bytes) => *bytes,
        }
    }

    /// Returns the arm that it drives.
    pub fn arm(&self) -> Arm<f64> {
        match self {
            Self::Float(float) => float.motors.arm(),
            Self::Fixed(actor, _) => *actor.arm(),
        }
    }

    /// Returns the rules of its tests that begin at that start.
    pub fn tests(&self, start: Start) -> ArmProblem {
        match self {
            Self::Float(float) => float.motors.tests(start),
            Self::Fixed(..) => start.into(),
        }
    }

    /// One episode of each task, decided as the actor does outside of training.
    pub fn trial(&self, problem: impl Into<ArmProblem>, tasks: &[Task]) -> Trial {
        match self {
            Self::Float(float) => float.policy().trial(problem, tasks),
            Self::Fixed(actor, _) => trial::run(&actor.arm().to_f32(), actor.as_ref(), problem, tasks),
        }
    }

    /// The actor, ready to decide by its mean.
    pub fn policy(&self) -> Box<DynPolicy<'_>> {
        match self {
            Self::Float(float) => Box::new(float.policy()),
            Self::Fixed(actor, _) => Box::new(actor.as_ref()),
        }
    }
}
