//! `tpg-train config`: prints presets, and the schema of settings.

use super::Configuration as _;
use super::schema::{commented, schema};
use crate::evolution::config::EvolutionConfig;
use crate::run_args::print;
use crate::sac::config::SacConfig;
use clap::Args;
use tpg_graph::error::{InputError, Place};
use tpg_problems::arm::arms::ARMS;

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
    let text = text(args)?;
    print(&text)
}

fn text(args: &ConfigArgs) -> Result<String, InputError> {
    let schema = if args.sac { schema::<SacConfig>() } else { schema::<EvolutionConfig>() };
    if args.schema {
        return Ok(format!("{schema:#}\n"));
    }
    let own = EvolutionConfig::PRESETS.iter().map(|preset| (preset.name, preset.about, None::<String>));
    let arms = ARMS.iter().map(|arm| (arm.name, arm.about, Some(arm.text.to_owned())));
    let networks = SacConfig::PRESETS.iter().map(|preset| (preset.name, preset.about, None));
    let all: Vec<_> = if args.sac { networks.collect() } else { own.chain(arms).collect() };
    if args.list {
        return Ok(all.into_iter().map(|(name, about, _)| format!("{name:18} {about}\n")).collect());
    }
    let name = args.name.as_deref().unwrap_or(if args.sac { "general" } else { "thorough" });
    match all.iter().find(|(known, ..)| *known == name) {
        Some((_, _, Some(text))) => Ok(text.clone()),
        Some(_) => {
            let table = if args.sac { SacConfig::table(name) } else { EvolutionConfig::table(name) };
            Ok(commented(&schema, &table.unwrap_or_default()))
        }
        None => {
            let accepted = all.iter().map(|(name, ..)| *name).collect::<Vec<_>>().join(", ");
            Err(InputError::new("<command line>", Place::Whole, format!("the preset {name:?}"), accepted))
        }
    }
}
