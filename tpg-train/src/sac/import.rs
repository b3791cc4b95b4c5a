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
use std::path::{Path, PathBuf};
use tpg_graph::error::InputError;
use tpg_problems::{PolicyKind, Problem, ProblemName};

/// Turn an actor of Stable-Baselines3 or CleanRL into a policy.safetensors.
#[derive(Clone, Debug, Args)]
pub(crate) struct ImportArgs {
    /// The other trainer's actor
    pub actor: PathBuf,
    /// The policy.safetensors to write
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// The problem that it acts in; the arm's, fs and rs, need --actions too
    #[arg(long, value_enum, default_value = "rs")]
    pub problem: ProblemName,
    /// The arm: the meaning of the outputs, fine or coarse
    #[arg(long, value_name = "NAME")]
    pub actions: Option<String>,
    /// The arm: the moves that the policy refuses by itself, none or joint-limits [default: none]
    #[arg(long, value_name = "NAME")]
    pub mask: Option<String>,
    /// The arm: let it rest where no output reaches a threshold
    #[arg(long)]
    pub may_rest: bool,
}

impl ImportArgs {
    /// Returns the problem with the settings of the arguments.
    fn problem(&self) -> Result<Problem, InputError> {
        let mut table = Problem::new_for(self.problem, PolicyKind::Network).to_table();
        let decide = table.contains_key("mask");
        if decide && (self.actions.is_none()) {
            return Err(command_line("an actor of the arm without --actions", "--actions fine or coarse"));
        }
        let mask = self.mask.clone().or_else(|| decide.then(|| "none".to_owned()));
        for (key, value) in [("actions", &self.actions), ("mask", &mask)] {
            table.extend(value.iter().map(|value| (key.to_owned(), value.clone().into())));
        }
        if self.may_rest {
            table.insert("may_rest".to_owned(), true.into());
        }
        Problem::from_table("<command line>", &table, PolicyKind::Network)
    }
}

/// Reads the actor, checks it, writes the policy.
///
/// # Errors
/// If the file is damaged, is neither trainer's, or does not fit what the arguments say.
pub(crate) fn import(args: &ImportArgs) -> Result<(), InputError> {
    let problem = args.problem()?;
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
        problem: args.problem.name().to_owned(),
        ..NetworkOrigin::default()
    };
    let contract = Contract::new(problem.to_table(), &interface, actor, provenance);
    to_tensors(&network, &contract).write(Path::new(&args.out))
}
