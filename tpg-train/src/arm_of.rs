//! The arm that a file of the arm's problems is for.

use crate::files::read_text;
use crate::run_args::command_line;
use serde::Deserialize as _;
use std::path::Path;
use tpg_arm::{Arm, WIDOWX};
use tpg_graph::Graph;
use tpg_graph::error::{Finding, InputError, Place};
use tpg_problems::arm::targets::Start;
use tpg_problems::arm::{ArmDescription, Config};
use tpg_problems::{Problem, ProblemName};

/// Returns the arm that a graph was trained for, as its provenance says; the WidowX where that says nothing.
///
/// # Errors
/// If what it says is no arm.
pub fn graph(file: &str, graph: &Graph) -> Result<Arm<f64>, InputError> {
    let Some(text) =
        graph.provenance().config.as_ref().and_then(|config| config.get("problem")?.get("arm").or(config.get("arm")))
    else {
        return Ok(WIDOWX);
    };
    let refuse = |found: String| {
        let place = Place::Path("$.provenance.config.problem.arm".to_owned());
        InputError::new(file, place, found, "an arm as `tpg-train config widowx` prints, or none")
    };
    let arm = ArmDescription::deserialize(text).map_err(|error| refuse(error.to_string()))?;
    arm.check().map_err(|Finding { key, found, .. }| refuse(format!("{key} = {found}")))?;
    Ok(Arm::from(&arm))
}

/// Reads the arm's section of a graph's configuration, with the arm in it.
///
/// # Errors
/// If it cannot be read, or is for another problem.
pub fn config(path: &Path, start: Start) -> Result<Config, InputError> {
    let text = read_text(path, "a configuration as `tpg-train config` prints")?;
    match Problem::from_toml(&path.display().to_string(), &text)? {
        Problem::Arm(of, config) if of == start => Ok(config),
        other => {
            let (asked, found) = (ProblemName::from(start).name(), other.name().name());
            Err(command_line(format!("--problem {asked} with a configuration for {found}"), "the same problem twice"))
        }
    }
}
