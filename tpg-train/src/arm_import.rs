//! `tpg-train arm import`: an arm's URDF as a section of a configuration.

use clap::{Args, Subcommand};
use std::path::PathBuf;
use tpg_graph::command::print;
use tpg_graph::error::InputError;
use tpg_graph::files::{read_text, write_atomically};
use tpg_problems::arm::import::{Radii, import};

/// Describe arms
#[derive(Clone, Debug, Args)]
pub(crate) struct ArmArgs {
    #[command(subcommand)]
    command: ArmCommand,
}

#[derive(Clone, Debug, Subcommand)]
enum ArmCommand {
    /// Turn a URDF into the section [problem.arm] of a configuration
    Import(UrdfArgs),
}

/// Arguments of `arm import`.
#[derive(Clone, Debug, Args)]
struct UrdfArgs {
    /// The URDF; a xacro file must be expanded first
    #[arg(value_name = "FILE.urdf")]
    file: PathBuf,
    /// The link whose origin must reach targets
    #[arg(long, value_name = "LINK")]
    tip: String,
    /// A joint that is held at an angle, rad
    #[arg(long, value_name = "JOINT=RAD", value_parser = held)]
    fix: Vec<(String, f64)>,
    /// A joint's limits, rad, within those of the file: for a joint that turns without end, or by more than a turn
    #[arg(long, value_name = "JOINT=LOW,HIGH", value_parser = limited, allow_hyphen_values = true)]
    limit: Vec<(String, [f64; 2])>,
    /// Half the thickness of forearm and hand in the collision test, mm: a URDF's shapes are not read
    #[arg(long, value_name = "MM", default_value_t = 20.0, value_parser = radius)]
    radius: f64,
    /// The radius of the base in the collision test, mm
    #[arg(long, value_name = "MM", default_value_t = 60.0, value_parser = radius)]
    base_radius: f64,
    /// The file to write; stdout if omitted
    #[arg(long, short, value_name = "ARM.toml")]
    output: Option<PathBuf>,
}

fn held(text: &str) -> Result<(String, f64), String> {
    let (joint, angle) = text.split_once('=').ok_or("a joint's name, `=` and an angle in rad")?;
    let angle = angle.parse::<f64>().ok().filter(|angle| angle.is_finite()).ok_or("an angle in rad behind `=`")?;
    Ok((joint.to_owned(), angle))
}

fn limited(text: &str) -> Result<(String, [f64; 2]), String> {
    let accepted = "a joint's name, `=` and its limits in rad, as in wrist=-3.1,3.1";
    let (joint, limits) = text.split_once('=').ok_or(accepted)?;
    let number = |text: &str| text.trim().parse::<f64>().ok().filter(|angle| angle.is_finite());
    let ends = limits.split_once(',').and_then(|(low, high)| Some([number(low)?, number(high)?]));
    let ends = ends.filter(|[low, high]| low < high).ok_or(accepted)?;
    Ok((joint.to_owned(), ends))
}

fn radius(text: &str) -> Result<f64, String> {
    let accepted = "a number of mm, 1 to 500";
    text.parse().ok().filter(|radius| (1.0..=500.0).contains(radius)).ok_or_else(|| accepted.to_owned())
}

/// Runs a command about arms.
///
/// # Errors
/// If the file cannot be read or is no URDF of an arm, or the result cannot be written.
pub(crate) fn execute(args: &ArmArgs) -> Result<(), InputError> {
    let ArmCommand::Import(args) = &args.command;
    let text = read_text(&args.file, "a URDF")?;
    let radii = Radii { link: args.radius, base: args.base_radius };
    let text = import(&args.file.display().to_string(), &text, &args.tip, &args.fix, &args.limit, radii)?;
    match &args.output {
        Some(path) => write_atomically(path, text.as_bytes()),
        None => print(&text),
    }
}
