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

use super::config::Actor;
use super::contract::{Contract, NetworkOrigin};
use super::foreign::from_tensors;
use super::interface::Interface;
use super::tensors::Tensors;
use super::weights::{LIMIT, to_tensors};
use crate::run_args::{command_line, place};
use clap::Args;
use std::path::PathBuf;
use tpg_graph::error::InputError;
use tpg_graph::files::read_text;
use tpg_problems::{PolicyKind, Problem, ProblemName};

/// Turn an actor of Stable-Baselines3 or CleanRL into a policy.safetensors.
#[derive(Clone, Debug, Args)]
pub(crate) struct ImportArgs {
    /// The other trainer's actor
    pub actor: PathBuf,
    /// The policy.safetensors to write
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// The problem that it acts in
    #[arg(long, value_enum, required_unless_present = "config")]
    pub problem: Option<ProblemName>,
    /// A section [problem] instead; the arm's, fs and rs, says `actions` and `mask`
    #[arg(long, value_name = "FILE", conflicts_with = "problem")]
    pub config: Option<PathBuf>,
}

/// Reads the actor, checks it, writes the policy.
///
/// # Errors
/// If the file is damaged, is neither trainer's, or does not fit what the arguments say.
pub(crate) fn import(args: &ImportArgs) -> Result<(), InputError> {
    let problem = match (&args.config, args.problem) {
        (None, None | Some(ProblemName::Fs | ProblemName::Rs)) => {
            let accepted = "--config FILE, whose [problem] says actions, fine or coarse, and mask";
            return Err(command_line("an actor of the arm without --config", accepted));
        }
        (None, Some(name)) => Problem::new_for(name, PolicyKind::Network),
        (Some(path), _) => {
            let text = read_text(path, "settings with a section [problem]")?;
            Problem::read(&path.display().to_string(), &text, PolicyKind::Network)?
        }
    };
    // The values go to the network as they are.
    let interface = Interface::new(&&*problem.network_environment(0), false).map_err(|finding| {
        command_line(format!("--problem {}: {}", problem.name().name(), finding.found), finding.accepted)
    })?;
    let file = Tensors::read(&args.actor, LIMIT)?;
    let (network, trainer) = from_tensors(file, interface.inputs.len(), &interface.outputs)
        .map_err(|finding| place(&args.actor, finding))?;
    let actor = Actor { scaled_inputs: false, hidden: network.shape().hidden.clone() };
    let provenance = NetworkOrigin {
        tool: format!("{trainer}, imported by tpg-train {}", env!("CARGO_PKG_VERSION")),
        problem: problem.name().name().to_owned(),
        ..NetworkOrigin::default()
    };
    let contract = Contract::new(problem.to_table(), &interface, actor, provenance);
    to_tensors(&network, &contract).write(&args.out)
}
