//! Networks with a preference for each motor of an arm: a discrete decision turns the preferences into a move.

use super::contract::Contract;
use super::integers::{Comparison, deciding_layers};
use super::network::Network;
use super::policy::NetworkPolicy;
use super::tensors::place;
use std::path::Path;
use tpg_arm::cycle::Brent;
use tpg_arm::episode::{self, Episode};
use tpg_arm::frame::Frame;
use tpg_arm::observation::Observation;
use tpg_arm::sac::fixed::{FixedDecision, quantise as quantise_features};
use tpg_arm::sac::{Actions, FEATURE_NAMES, Mask, features};
use tpg_arm::{Arm, JOINTS, Move, Pose, WIDOWX};
use tpg_codegen::policy::{Input, Output, Preferences, QuantisedPolicy, quantise as quantise_layers};
use tpg_engine::Summary;
use tpg_engine::random::{Purpose, Stream};
use tpg_graph::error::{Finding, InputError, Place};
use tpg_nn::{Mlp, Tape};
use tpg_problems::ContinuousProblem;
use tpg_problems::arm::ArmProblem;
use tpg_problems::arm::motors::{Config, Discretiser, Inputs, MOTORS};
use tpg_problems::arm::targets::{Set, Start, Task, tasks};
use tpg_problems::arm::trial::{self, Trial};
use tpg_runtime::net::Kind;
use tpg_runtime::policy::Policy;

/// A network of either kind that drives an arm.
#[derive(Clone, Debug)]
pub struct MotorNetwork {
    network: Network,
    motors: Config,
    arm: Arm<f64>,
}

impl MotorNetwork {
    /// Reads a network. With `arm` it must be for that one; without, one in integers, which names no arm, drives the
    /// WidowX.
    ///
    /// # Errors
    /// If the file is damaged, is not a network of an arm's motors, or is for another arm.
    pub fn read(path: &Path, arm: Option<&Arm<f64>>) -> Result<Self, InputError> {
        Self::new(Network::read(path)?, arm).map_err(|finding| place(path, finding))
    }

    /// Creates it from a network; for `arm` see [`read`](Self::read).
    ///
    /// # Errors
    /// If it is not a network of an arm's motors, or is for another arm.
    pub fn new(network: Network, arm: Option<&Arm<f64>>) -> Result<Self, Finding> {
        let (motors, drives) = match &network {
            Network::Float(actor) => {
                let motors = float_settings(&actor.1)?;
                let arm = motors.arm();
                (motors, arm)
            }
            Network::Fixed(policy) => (fixed_settings(policy)?, *arm.unwrap_or(&WIDOWX)),
        };
        if arm.is_some_and(|arm| drives != *arm) {
            let accepted = "one for the arm of the configuration, or of the graph";
            return Err(Finding::new("", "a network for another arm", accepted));
        }
        Ok(Self { network, motors, arm: drives })
    }

    /// Returns the network.
    pub fn network(&self) -> &Network {
        &self.network
    }

    /// Returns the arm that it drives.
    pub fn arm(&self) -> Arm<f64> {
        self.arm
    }

    /// Returns the rules of its tests that begin at that start.
    pub fn tests(&self, start: Start) -> ArmProblem {
        self.motors.tests(start)
    }

    /// The network, ready to decide by its mean.
    pub fn policy(&self) -> MotorPolicy<'_> {
        let Config { inputs, actions, mask, may_rest, .. } = self.motors;
        let decides = match &self.network {
            Network::Float(actor) => {
                let policy = NetworkPolicy::new(&actor.0, actor.1.interface(), &actor.1.actor);
                Decides::Float(Box::new(policy), Discretiser::new(&self.motors))
            }
            Network::Fixed(policy) => Decides::Fixed(policy, FixedDecision::new(actions, mask, may_rest)),
        };
        MotorPolicy { arm: self.arm.to_f32(), inputs, decides }
    }

    /// Runs one episode of each task, decided as the network does outside of training.
    pub fn trial(&self, problem: impl Into<ArmProblem>, tasks: &[Task]) -> Trial {
        let (problem, policy) = (problem.into(), self.policy());
        let episode = |(place, task)| policy.watch(&problem, place, task, |_pose| ());
        let summaries: Vec<_> = tasks.iter().enumerate().map(episode).collect();
        trial::summarise(problem, &summaries)
    }
}

/// Returns the settings of the problem that a network was trained on.
fn float_settings(contract: &Contract) -> Result<Config, Finding> {
    let problem = ContinuousProblem::from_table("metadata.tpg", &contract.problem)
        .map_err(|error| Finding::new("metadata.tpg.problem", error.found, error.accepted))?;
    let ContinuousProblem::Motors(_, motors) = problem else {
        let accepted = "a policy of the arm: fs or rs";
        return Err(Finding::new("metadata.tpg.problem.name", problem.name().name(), accepted));
    };
    let names = motors.inputs.names();
    let found: Vec<&str> = contract.inputs.iter().map(|input| input.name.as_str()).collect();
    if found != names || contract.inputs.iter().any(|input| (input.offset, input.scale) != (0.0, 1.0)) {
        let accepted = format!("{} inputs in this order, not scaled: {}", names.len(), names.join(" "));
        return Err(Finding::new("metadata.tpg.inputs", found.join(" "), accepted));
    }
    let outputs: Vec<&str> = contract.outputs.iter().map(|output| output.name.as_str()).collect();
    if outputs != MOTORS || contract.outputs.iter().any(|output| (output.min, output.max) != (-1.0, 1.0)) {
        let accepted = format!("{} from -1 to 1", MOTORS.join(" "));
        return Err(Finding::new("metadata.tpg.outputs", outputs.join(" "), accepted));
    }
    Ok(motors)
}

/// Returns the settings that decisions of a network in integers need.
fn fixed_settings(policy: &QuantisedPolicy) -> Result<Config, Finding> {
    let names: Vec<&str> = policy.inputs.iter().map(|input| input.name.as_str()).collect();
    if names != FEATURE_NAMES {
        return Err(Finding::new("$.inputs", names.join(" "), FEATURE_NAMES.join(" ")));
    }
    let Output::Preferences(preferences) = &policy.output else {
        return Err(Finding::new("$.output", "a network of another problem", "preferences of the arm's joints"));
    };
    let outputs = policy.layers.last().map_or(0, |layer| layer.outputs);
    let known = Actions::from_name(&preferences.actions).zip(Mask::from_name(&preferences.mask));
    let Some((actions, mask)) = known.filter(|_| outputs == JOINTS) else {
        let accepted = format!("{JOINTS} preferences, actions and mask that exist");
        return Err(Finding::new("$.output", format!("{outputs} outputs, {preferences:?}"), accepted));
    };
    Ok(Config { inputs: Inputs::Features, actions, mask, may_rest: preferences.may_rest, ..Config::default() })
}

/// A [`MotorNetwork`] that decides: as a [`Policy`], by its mean.
#[derive(Debug)]
pub struct MotorPolicy<'a> {
    arm: Arm<f32>,
    inputs: Inputs,
    decides: Decides<'a>,
}

#[derive(Debug)]
enum Decides<'a> {
    Float(Box<NetworkPolicy<'a>>, Discretiser),
    Fixed(&'a QuantisedPolicy, FixedDecision),
}

impl MotorPolicy<'_> {
    /// Runs the episode at that place of a list; `each` sees the pose after every action.
    pub fn watch(
        &self,
        problem: &ArmProblem,
        place: usize,
        task: &Task,
        each: impl FnMut(Pose),
    ) -> episode::Summary<f32> {
        let Decides::Float(network, discretiser) = &self.decides else {
            return trial::watch(&self.arm, self, problem, task, each);
        };
        if network.decides_by_mean() {
            return trial::watch(&self.arm, self, problem, task, each);
        }
        let mut random = Stream::new(0, place as u64, Purpose::Draws, 0);
        let mut values = Vec::new();
        let draw = |seen: &Observation<f32>| {
            network.values(&self.observed(seen), &mut random, &mut values);
            let preferences = std::array::from_fn(|joint| libm::atanhf(values[joint]));
            discretiser.decide(preferences, seen.pose, &self.arm.ranges)
        };
        trial::watch_drawn(&self.arm, draw, problem, task, each)
    }

    /// Returns what the network reads.
    fn observed(&self, seen: &Observation<f32>) -> Vec<f32> {
        let mut state = vec![0.0; self.inputs.count()];
        self.inputs.observe(&Frame::of(&self.arm, seen), &mut state);
        state
    }
}

impl Policy for MotorPolicy<'_> {
    type State = Observation<f32>;
    type Action = Move;

    fn decide(&self, seen: &Observation<f32>) -> Move {
        match &self.decides {
            Decides::Float(network, discretiser) => {
                let mut means = [0.0; JOINTS];
                network.means(&self.observed(seen), &mut means);
                discretiser.decide(means, seen.pose, &self.arm.ranges)
            }
            Decides::Fixed(network, decision) => {
                let outputs = network.outputs(&quantise_features(&features(&Frame::of(&self.arm, seen))));
                let preferences = std::array::from_fn(|joint| outputs.get(joint).copied().unwrap_or(0));
                decision.decide(preferences, seen.pose, &self.arm.ranges)
            }
        }
    }
}

/// Calibration episodes of each start: training tasks, never validation or test tasks.
const CALIBRATION: usize = 100;

/// Puts a network into integers, calibrated on the states that it visits on training tasks of `seed`.
///
/// # Errors
/// If it has other inputs than the features, LayerNorm, or numbers that do not fit; `file` is what the error names.
pub fn quantise(
    file: &str,
    of: &MotorNetwork,
    source_sha256: String,
    kind: Kind,
    seed: u64,
) -> Result<QuantisedPolicy, InputError> {
    let refuse = |found: String, accepted: &str| InputError::new(file, Place::Whole, found, accepted);
    let MotorNetwork { network: Network::Float(actor), motors, .. } = of else {
        return Err(refuse("a network in integers".to_owned(), "a policy.safetensors"));
    };
    if motors.inputs != Inputs::Features || actor.1.actor.layer_norm {
        let found = format!("inputs {:?}, layer_norm {}", motors.inputs, actor.1.actor.layer_norm);
        return Err(refuse(found, "the inputs \"features\" without LayerNorm"));
    }
    let layers = quantise_layers(&deciding_layers(&actor.0, JOINTS), &maximum_activations(of, &actor.0, seed), kind)
        .map_err(|error| refuse(error.to_string(), "a network whose numbers fit"))?;
    let preferences = Preferences {
        actions: motors.actions.name().to_owned(),
        mask: motors.mask.name().to_owned(),
        may_rest: motors.may_rest,
    };
    let inputs = FEATURE_NAMES.map(Input::plain).into();
    QuantisedPolicy::new(source_sha256, inputs, Output::Preferences(preferences), kind, layers)
}

/// Returns the maximum activation of each hidden layer over the calibration episodes.
fn maximum_activations(of: &MotorNetwork, network: &Mlp<f32>, seed: u64) -> Vec<f32> {
    let policy = of.policy();
    let mut tape = Tape::new(network.shape(), 1);
    let mut maxima = vec![0.0f32; network.shape().hidden.len()];
    for start in [Start::Fs, Start::Rs] {
        for task in tasks(&of.arm, seed, Set::Training, start, CALIBRATION) {
            let mut episode = Episode::new(&policy.arm, of.tests(start).reach(&task), Brent::new());
            loop {
                let seen = *episode.observation();
                tape.input_mut().copy_from_slice(&policy.observed(&seen));
                network.forward(&mut tape);
                for (layer, maximum) in maxima.iter_mut().enumerate() {
                    *maximum = tape.activations(layer).iter().copied().fold(*maximum, f32::max);
                }
                if episode.advance(policy.decide(&seen)).is_some() {
                    break;
                }
            }
        }
    }
    maxima
}

/// Episodes of a comparison: validation tasks, which neither training nor tests see.
const COMPARED: usize = 1000;

/// Compares a network with itself in integers on validation episodes that begin at `start`.
///
/// # Errors
/// If the integers do not drive an arm.
pub fn compare(float: &MotorNetwork, policy: &QuantisedPolicy, start: Start) -> Result<Comparison, InputError> {
    let fixed = MotorNetwork::new(Network::Fixed(Box::new(policy.clone())), Some(&float.arm))
        .map_err(|finding| place(Path::new("policy.q.json"), finding))?;
    let tasks = tasks(&float.arm, 1_000, Set::Validation, start, COMPARED);
    let [float, fixed] = [float, &fixed].map(|network| Summary::of(&network.trial(float.tests(start), &tasks).endings));
    Ok(Comparison {
        kind: policy.kind.clone(),
        bytes: policy.bytes(),
        multiplications: policy.multiplications(),
        differences: None,
        float,
        fixed,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sac::config::{Actor, Decides as ActorDecides};
    use crate::sac::contract::Provenance;
    use crate::sac::interface::Interface;
    use tpg_nn::{Shape, Spread};

    #[test]
    fn a_policy_that_draws_is_not_stopped_by_rest_and_draws_the_same_again() {
        let (spread, decides) = (Spread::Sigma, ActorDecides::ByDraw);
        let actor = Actor { scaled_inputs: false, hidden: vec![8], layer_norm: false, spread, decides };
        let motors = Config {
            inputs: Inputs::PaperFs,
            actions: Actions::Coarse,
            mask: Mask::None,
            may_rest: true,
            ..Config::default()
        };
        let shape = Shape { inputs: 13, hidden: vec![8], outputs: 2 * JOINTS, norm: false };
        let mut random = Stream::new(3, 0, Purpose::Test, 0);
        let network = Mlp::random(shape, || random.unit());
        let tasks = tasks(&WIDOWX, 3, Set::Validation, Start::Fs, 8);
        let problem = ContinuousProblem::Motors(Start::Fs, motors);
        let interface = Interface::new(&&*problem.environment(0), false).expect("motors");
        let trial = |actor: &Actor| {
            let contract = Contract::new(problem.to_table(), &interface, actor.clone(), Provenance::default());
            let network = Network::Float(Box::new((network.clone(), contract)));
            MotorNetwork::new(network, None).expect("a network of the arm").trial(Start::Fs, &tasks)
        };
        let drawn = trial(&actor);
        assert_eq!(drawn, trial(&actor));
        assert_eq!((drawn.failures.stop, drawn.failures.cycle), (0, 0));
        let by_mean = trial(&Actor { decides: ActorDecides::ByMean, ..actor });
        assert!(by_mean.failures.stop > 0, "a network that has not learned rests somewhere: {by_mean:?}");
        assert!(drawn.mean_actions > by_mean.mean_actions);
    }
}
