//! `tpg-train import`: actors that other trainers made.
//!
//! Known are the names of Stable-Baselines3 and of CleanRL. The whole export, in Python:
//!
//! | trainer | line |
//! | --- | --- |
//! | Stable-Baselines3 | `save_file({k: v.contiguous() for k, v in model.policy.actor.state_dict().items()}, "actor.safetensors")` |
//! | CleanRL | `save_file({k: v.contiguous() for k, v in actor.state_dict().items()}, "actor.safetensors")` |
//!
//! with `from safetensors.torch import save_file`. Such a file says neither what the network reads nor what its outputs
//! mean, so the command line must; sizes that do not fit it are refused.

use super::config::{Actor, Decides};
use super::contract::{Contract, Provenance};
use super::foreign::from_tensors;
use super::interface::Interface;
use super::tensors::{Tensors, place};
use super::weights::{LIMIT, to_tensors};
use crate::run_args::command_line;
use clap::Args;
use std::path::{Path, PathBuf};
use tpg_arm::sac::{Actions, Mask};
use tpg_graph::error::InputError;
use tpg_nn::Spread;
use tpg_problems::arm::motors::{Config, Inputs};
use tpg_problems::arm::targets::Start;
use tpg_problems::{ContinuousProblem, ProblemName};

/// Turn an actor of Stable-Baselines3 or CleanRL into a policy.safetensors.
#[derive(Clone, Debug, Args)]
pub struct ImportArgs {
    /// The other trainer's actor
    pub actor: PathBuf,
    /// The policy.safetensors to write
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// The problem that it acts in; the arm's, fs and rs, need --inputs and --actions too
    #[arg(long, value_enum, default_value = "rs")]
    pub problem: ProblemName,
    /// The arm: the values that the network reads, features, paper-fs or paper-rs
    #[arg(long, value_name = "NAME", value_parser = inputs)]
    pub inputs: Option<Inputs>,
    /// The arm: the meaning of the outputs, fine or coarse
    #[arg(long, value_name = "NAME", value_parser = actions)]
    pub actions: Option<Actions>,
    /// The arm: the moves that the policy refuses by itself, none or joint-limits
    #[arg(long, value_name = "NAME", default_value = "none", value_parser = mask)]
    pub mask: Mask,
    /// The arm: let it rest where no output reaches a threshold
    #[arg(long)]
    pub may_rest: bool,
}

fn inputs(name: &str) -> Result<Inputs, String> {
    Inputs::from_name(name).ok_or_else(|| format!("accepted: {}", Inputs::ALL.map(Inputs::name).join(", ")))
}

fn actions(name: &str) -> Result<Actions, String> {
    Actions::from_name(name).ok_or_else(|| "accepted: fine, coarse".to_owned())
}

fn mask(name: &str) -> Result<Mask, String> {
    Mask::from_name(name).ok_or_else(|| "accepted: none, joint-limits".to_owned())
}

/// Reads the actor, checks it, writes the policy.
///
/// # Errors
/// If the file is damaged, is neither trainer's, or does not fit what the arguments say.
pub fn import(args: &ImportArgs) -> Result<(), InputError> {
    let problem = match args.problem.start() {
        Some(start) => of_the_arm(args, start)?,
        None => ContinuousProblem::usual(args.problem),
    };
    // The values go to the network as they are.
    let interface = Interface::new(&&*problem.environment(0), false).map_err(|finding| {
        command_line(format!("--problem {}: {}", problem.name().name(), finding.found), finding.accepted)
    })?;
    let file = Tensors::read(&args.actor, LIMIT)?;
    let (network, trainer) = from_tensors(file, interface.inputs.len(), &interface.outputs)
        .map_err(|finding| place(&args.actor, finding))?;
    let actor = Actor {
        scaled_inputs: false,
        hidden: network.shape().hidden.clone(),
        layer_norm: false,
        spread: Spread::LogSigma,
        decides: Decides::ByMean,
    };
    let provenance = Provenance {
        tool: format!("{trainer}, imported by tpg-train {}", env!("CARGO_PKG_VERSION")),
        problem: args.problem.name().to_owned(),
        ..Provenance::default()
    };
    let contract = Contract::new(problem.to_table(), &interface, actor, provenance);
    to_tensors(&network, &contract).write(Path::new(&args.out))
}

/// The arm by its motors, as the arguments say.
fn of_the_arm(args: &ImportArgs, start: Start) -> Result<ContinuousProblem, InputError> {
    let (Some(inputs), Some(actions)) = (args.inputs, args.actions) else {
        return Err(command_line("an actor of the arm without --inputs or --actions", "both of them"));
    };
    let (mask, may_rest) = (args.mask, args.may_rest);
    let motors = Config { inputs, actions, mask, may_rest, ..Config::default() };
    Ok(ContinuousProblem::Motors(start, motors))
}
