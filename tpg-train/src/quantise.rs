//! `tpg-train quantise`: puts a trained network into integers.

use crate::folder::frame::checksum;
use crate::sac::integers::{self, Comparison};
use crate::sac::weights;
use clap::Args;
use serde::Deserialize as _;
use std::fs;
use std::path::PathBuf;
use tpg_codegen::policy::{Preferences, to_rust};
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
    /// A Rust module of constants to write beside it
    #[arg(long, value_name = "FILE")]
    pub rust: Option<PathBuf>,
    /// Bits of weights and activations: w8a16 or w16a16
    #[arg(long, default_value = "w8a16", value_parser = kind)]
    pub kind: Kind,
    /// A report to write, JSON: bytes, multiplications, and both networks on 1,000 validation episodes
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// The seed of the training tasks that calibrate it
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
}

fn kind(name: &str) -> Result<Kind, String> {
    Kind::from_name(name).ok_or_else(|| format!("accepted: {}", Kind::ALL.map(Kind::name).join(", ")))
}

/// Writes the integers and says how large they are, and, where a report is asked for, how well they do.
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
    let policy = integers::quantise(&file, actor, preferences, &&*environment, hash, args.kind, args.seed)?;
    write_atomically(&args.out, policy.to_json().as_bytes())?;
    if let Some(path) = &args.rust {
        write_atomically(path, to_rust(&policy)?.as_bytes())?;
    }
    tpg_graph::command::note(format_args!(
        "{} bytes of constants, {} multiplications a decision",
        policy.bytes(),
        policy.multiplications()
    ));
    if let Some(path) = &args.report {
        let comparison = Comparison::new(actor, &policy, &&*environment, args.seed);
        let text = serde_json::to_string_pretty(&comparison).expect("plain data") + "\n";
        write_atomically(path, text.as_bytes())?;
        tpg_graph::command::note(format_args!("{comparison}"));
    }
    Ok(())
}
