//! `tpg-train config`: prints presets, and the schema of settings.

use super::Configuration;
use super::schema::{commented, schema};
use crate::evolution::config::EvolutionConfig;
use crate::sac::config::SacConfig;
use clap::Args;
use schemars::JsonSchema;
use tpg_graph::command::print;
use tpg_graph::error::InputError;
use tpg_problems::arm::arms::{ARMS, NamedArm};

/// Print a commented configuration.
#[derive(Clone, Debug, Args)]
pub(crate) struct ConfigArgs {
    /// The preset [default: thorough; with --sac general], or an arm, such as widowx, for the section that describes it
    #[arg(value_name = "NAME")]
    pub name: Option<String>,
    /// A preset of `tpg-train sac` instead of `tpg-train tpg`
    #[arg(long)]
    pub sac: bool,
    /// List the presets with a description of each
    #[arg(long)]
    pub list: bool,
    /// The JSON Schema of all settings, for editors
    #[arg(long, conflicts_with_all = ["list", "name"])]
    pub schema: bool,
}

/// Prints a preset, the list of all, or the schema.
///
/// # Errors
/// If there is no preset with that name, or stdout is closed.
pub(crate) fn print_config(args: &ConfigArgs) -> Result<(), InputError> {
    let text = if args.sac {
        text::<SacConfig>(args, "general", &[])
    } else {
        text::<EvolutionConfig>(args, "thorough", &ARMS)
    };
    print(&text?)
}

fn text<C: Configuration + JsonSchema>(
    args: &ConfigArgs,
    default: &str,
    arms: &[NamedArm],
) -> Result<String, InputError> {
    let name = args.name.as_deref().unwrap_or(default);
    if args.schema {
        return Ok(format!("{:#}\n", schema::<C>()));
    }
    let presets = C::PRESETS.iter().map(|preset| (preset.name, preset.about));
    let mut all = presets.chain(arms.iter().map(|arm| (arm.name, arm.about)));
    if args.list {
        return Ok(all.map(|(name, about)| format!("{name:18} {about}\n")).collect());
    }
    if let Some(arm) = arms.iter().find(|arm| arm.name == name) {
        return Ok(arm.text.to_owned());
    }
    let table = C::table(name).map_err(|error| {
        let accepted = all.by_ref().map(|(name, _)| name).collect::<Vec<_>>().join(", ");
        InputError { accepted, ..error }
    });
    Ok(commented(&schema::<C>(), &table?))
}
