//! `tpg-train arm import`: an arm's URDF as the section `[problem.arm]` of a configuration, or as a section `[chain]`.
//!
//! | module | subject |
//! | --- | --- |
//! | `urdf` | the joints between a file's root and a link, or what is wrong with them |
//! | `planar` | a turning base and three parallel axes in them: lengths, zeros, signs |
//! | `section` | the section with its comments |
//! | `chain` | the section of joints that are no planar arm |

mod chain;
mod planar;
mod section;
mod urdf;

use crate::files::{read_text, write_atomically};
use clap::{Args, Subcommand};
pub use section::Radii;
use std::path::PathBuf;
use tpg_graph::error::{Finding, InputError, Place};

/// Describe arms
#[derive(Clone, Debug, Args)]
pub struct ArmArgs {
    #[command(subcommand)]
    command: ArmCommand,
}

#[derive(Clone, Debug, Subcommand)]
enum ArmCommand {
    /// Turn a URDF into the section [problem.arm] of a configuration, or a section [chain] where the arm is not planar
    Import(ImportArgs),
}

/// Arguments of `arm import`.
#[derive(Clone, Debug, Args)]
struct ImportArgs {
    /// The URDF; a xacro file must be expanded first
    #[arg(value_name = "FILE.urdf")]
    file: PathBuf,
    /// The link whose origin must reach targets
    #[arg(long, value_name = "LINK")]
    tip: String,
    /// A joint that is held at an angle, rad
    #[arg(long, value_name = "JOINT=RAD", value_parser = held)]
    fix: Vec<(String, f64)>,
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

fn radius(text: &str) -> Result<f64, String> {
    let accepted = "a number of mm, 1 to 500";
    text.parse().ok().filter(|radius| (1.0..=500.0).contains(radius)).ok_or_else(|| accepted.to_owned())
}

/// Runs a command about arms.
///
/// # Errors
/// If the file cannot be read or is no URDF of an arm, or the result cannot be written.
pub fn execute(args: &ArmArgs) -> Result<(), InputError> {
    let ArmCommand::Import(args) = &args.command;
    let text = read_text(&args.file, "a URDF")?;
    let radii = Radii { link: args.radius, base: args.base_radius };
    let Imported { text, not_planar } = import(&args.file.display().to_string(), &text, &args.tip, &args.fix, radii)?;
    if let Some(reason) = not_planar {
        tpg_graph::command::note(format_args!("a [chain], which cannot be trained: not a planar arm: {reason}"));
    }
    match &args.output {
        Some(path) => write_atomically(path, text.as_bytes()),
        None => tpg_graph::command::print(&text)
            .map_err(|error| InputError::io("<stdout>".as_ref(), &error, "an open pipe")),
    }
}

/// An imported arm.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// Its section, with comments.
    pub text: String,
    /// The reason why that is a `[chain]`; none for a `[problem.arm]`.
    pub not_planar: Option<String>,
}

/// Returns the section for a URDF's text. `file` is its name in messages, `tip` the link whose origin must reach
/// targets, `fix` the joints that are held, each at an angle in rad.
///
/// # Errors
/// A text that is no URDF, a link or joint that it does not have, a joint that does not turn within limits, an arm that cannot be.
pub fn import(file: &str, text: &str, tip: &str, fix: &[(String, f64)], radii: Radii) -> Result<Imported, InputError> {
    let joints = urdf::chain(file, text, tip, fix)?;
    let held = section::held(fix);
    let refuse = |Finding { key, found, accepted }: Finding| {
        InputError::new(file, Place::Whole, format!("an arm whose {key} = {found}"), accepted)
    };
    match planar::recognise(file, &joints) {
        Ok(arm) => {
            let description = section::describe(&arm, radii);
            description.check().map_err(refuse)?;
            Ok(Imported { text: section::text(file, tip, &held, &arm, &description), not_planar: None })
        }
        Err(error) => {
            let description = chain::describe(file, &joints)?;
            description.check().map_err(refuse)?;
            let reason = format!("{}{}", error.place, error.found);
            let text = chain::text(file, tip, &held, &description, &reason);
            Ok(Imported { text, not_planar: Some(reason) })
        }
    }
}

#[cfg(test)]
mod tests;
