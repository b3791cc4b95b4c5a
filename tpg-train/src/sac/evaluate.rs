//! `tpg-train eval --policy` and `tpg-train quantise`.

use super::comparison::Comparison;
use super::fixed::quantise_actor;
use super::weights;
use crate::files::write_atomically;
use crate::hybrid::actor::Actor;
use clap::Args;
use sha2::{Digest, Sha256};
use std::fs;
use std::path::{Path, PathBuf};
use tpg_arm::WIDOWX;
use tpg_codegen::policy::to_rust;
use tpg_graph::error::{InputError, Place};
use tpg_problems::arm::planner::{Choice, Planner};
use tpg_problems::arm::targets::{Start, Task};
use tpg_problems::arm::trial::{self, Trial};
use tpg_runtime::net::Kind;

/// Puts a policy to tasks: a `policy.safetensors`, a `policy.q.json`, or the classical `planner` or `nearest-goal`.
///
/// # Errors
/// If there is no such policy.
pub fn trial_of(policy: &str, start: Start, tasks: &[Task]) -> Result<Trial, InputError> {
    let choice = match policy {
        "planner" => Some(Choice::NearestFree),
        "nearest-goal" => Some(Choice::Nearest),
        _ => None,
    };
    match choice {
        Some(choice) => Ok(trial::run(&WIDOWX, &Planner::new(&WIDOWX, choice), start, tasks)),
        None => Ok(Actor::read(Path::new(policy))?.trial(start, tasks)),
    }
}

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
    /// Bits of weights and activations: w8a16, w16a16 or w8a8
    #[arg(long, default_value = "w8a16", value_parser = kind)]
    pub kind: Kind,
    /// A report to write, JSON: bytes, multiplications, agreement with floating point, and the success of both on 1,000
    /// validation episodes of each start
    #[arg(long, value_name = "FILE")]
    pub report: Option<PathBuf>,
    /// The seed of the training tasks that calibrate it
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
}

fn kind(name: &str) -> Result<Kind, String> {
    Kind::from_name(name).ok_or_else(|| format!("accepted: {}", Kind::ALL.map(Kind::name).join(", ")))
}

/// Writes the integers and says how large they are, and, where it is asked for, how well they do.
///
/// # Errors
/// If the policy cannot be read or put into integers, or the file cannot be written.
pub fn quantise(args: &QuantiseArgs) -> Result<(), InputError> {
    let file = args.policy.display().to_string();
    let (network, contract) = weights::read(&args.policy)?;
    let bytes = fs::read(&args.policy).map_err(|error| InputError::io(&args.policy, &error, "a policy.safetensors"))?;
    let hash = Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect();
    let policy = quantise_actor(&file, &network, &contract.actor, hash, args.kind, args.seed)?;
    if args.out == args.policy {
        return Err(InputError::new(file, Place::Whole, "the policy itself as --out", "another file"));
    }
    let report = args.report.as_ref().map(|path| Ok((path, Comparison::new(&network, &contract.actor, &policy)?)));
    let report = report.transpose()?;
    write_atomically(&args.out, policy.to_json().as_bytes())?;
    if let Some(path) = &args.rust {
        write_atomically(path, to_rust(&policy)?.as_bytes())?;
    }
    eprintln!("{} bytes of constants, {} multiplications a decision", policy.bytes(), policy.multiplications());
    if let Some((path, comparison)) = report {
        let text = serde_json::to_string_pretty(&comparison).expect("plain data") + "\n";
        write_atomically(path, text.as_bytes())?;
        eprintln!("{comparison}");
    }
    Ok(())
}
