//! `tpg-train eval --policy` and `tpg-train quantise`.

use super::fixed::{FixedActor, quantise_actor};
use super::lanes::ARM;
use super::policy::ActorPolicy;
use super::weights;
use crate::files::{read_text, write_atomically};
use crate::planner::{Choice, Planner};
use crate::targets::{Start, Task};
use crate::trial::{self, Trial};
use clap::Args;
use sha2::{Digest, Sha256};
use std::fs;
use std::path::{Path, PathBuf};
use tpg_codegen::error::{InputError, Place};
use tpg_codegen::policy::{QuantisedPolicy, to_rust};
use tpg_runtime::arm::WIDOWX;

/// Puts a policy to tasks: a `policy.safetensors`, a `policy.q.json`, or the classical `planner` or `nearest-goal`.
///
/// # Errors
/// If there is no such policy.
pub fn trial_of(policy: &str, start: Start, tasks: &[Task]) -> Result<Trial, InputError> {
    let path = Path::new(policy);
    let choice = match policy {
        "planner" => Some(Choice::NearestFree),
        "nearest-goal" => Some(Choice::Nearest),
        _ => None,
    };
    if let Some(choice) = choice {
        Ok(trial::run(&WIDOWX, &Planner::new(&WIDOWX, choice), start, tasks))
    } else if path.extension().is_some_and(|extension| extension == "json") {
        let fixed = QuantisedPolicy::from_json(policy, &read_text(path, "a policy.q.json")?)?;
        Ok(trial::run(&ARM, &FixedActor::new(fixed)?, start, tasks))
    } else {
        let (network, contract) = weights::read(path)?;
        Ok(trial::run(&ARM, &ActorPolicy::new(&network, &contract.actor), start, tasks))
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
    /// The seed of the training tasks that calibrate it
    #[arg(long, value_name = "S", default_value_t = 1)]
    pub seed: u64,
}

/// Writes the integers and says how large they are.
///
/// # Errors
/// If the policy cannot be read or put into integers, or the file cannot be written.
pub fn quantise(args: &QuantiseArgs) -> Result<(), InputError> {
    let file = args.policy.display().to_string();
    let (network, contract) = weights::read(&args.policy)?;
    let bytes = fs::read(&args.policy).map_err(|error| InputError::io(&args.policy, &error, "a policy.safetensors"))?;
    let hash = Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect();
    let policy = quantise_actor(&file, &network, &contract.actor, hash, args.seed)?;
    if args.out == args.policy {
        return Err(InputError::new(file, Place::Whole, "the policy itself as --out", "another file"));
    }
    write_atomically(&args.out, policy.to_json().as_bytes())?;
    if let Some(path) = &args.rust {
        write_atomically(path, to_rust(&policy)?.as_bytes())?;
    }
    eprintln!("{} bytes of constants, {} multiplications a decision", policy.bytes(), policy.multiplications());
    Ok(())
}
