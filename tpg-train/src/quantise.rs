//! `tpg-train quantise`: puts a trained network into integers.

use crate::folder::frame::checksum;
use crate::sac::integers::quantised;
use crate::sac::weights;
use clap::Args;
use serde::Deserialize as _;
use std::fs;
use std::path::PathBuf;
use tpg_codegen::policy::Preferences;
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::write_atomically;
use tpg_problems::{PolicyKind, Problem};
use tpg_runtime::net::Kind;

/// Put a policy's network into integers.
#[derive(Clone, Debug, Args)]
pub struct QuantiseArgs {
    /// The policy.safetensors
    pub policy: PathBuf,
    /// The policy.q.json to write
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Bits of weights and activations: w8a16 or w16a16
    #[arg(long, default_value = "w8a16", value_parser = kind)]
    pub kind: Kind,
    /// The seed of the training tasks that calibrate it
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
}

fn kind(name: &str) -> Result<Kind, String> {
    Kind::from_name(name).ok_or_else(|| format!("accepted: {}", Kind::ALL.map(Kind::name).join(", ")))
}

/// Writes the integers and says how large they are.
///
/// # Errors
/// If the policy cannot be read or put into integers, or the file cannot be written.
pub fn quantise(args: &QuantiseArgs) -> Result<(), InputError> {
    let file = args.policy.display().to_string();
    if args.out == args.policy {
        return Err(InputError::new(file, Place::Whole, "the policy itself as --out", "another file"));
    }
    let (network, contract) = weights::read(&args.policy)?;
    let bytes = fs::read(&args.policy).map_err(|error| InputError::io(&args.policy, &error, "a policy.safetensors"))?;
    let hash = checksum(&bytes);
    let problem = Problem::from_table(&file, &contract.problem, PolicyKind::Network)?;
    let preferences = problem.kept_settings().map(Preferences::deserialize).transpose().map_err(|error| {
        InputError::new(&file, Place::Whole, error.message(), "settings of a network whose outputs are preferences")
    })?;
    let (environment, actor) = (problem.network_environment(args.seed), (&network, &contract));
    let policy = quantised(&file, actor, preferences, &&*environment, hash, args.kind, args.seed)?;
    write_atomically(&args.out, policy.to_json().as_bytes())?;
    tpg_graph::command::note(format_args!(
        "{} bytes of constants, {} multiplications a decision",
        policy.bytes(),
        policy.multiplications()
    ));
    Ok(())
}
