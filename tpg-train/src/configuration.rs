//! The configuration and the problem that the arguments of a run ask for: a preset, then a file, then single settings. Each changes
//! what it names; later ones win.
//!
//! | module | subject |
//! | --- | --- |
//! | (root) | [`Layers`] of settings, and what a run's arguments [choose](Chosen) |
//! | [`schema`](mod@schema) | settings with their descriptions |
//! | [`mod@print`] | `tpg-train config` |

pub(crate) mod print;
pub(crate) mod schema;

use crate::run_args::{RunArgs, command_line};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::path::Path;
use tpg_graph::error::{Finding, InputError, Place};
use tpg_graph::files::read_text;
use tpg_graph::settings;
use tpg_problems::{PolicyKind, Problem, ProblemName};

/// A configuration included with the trainer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Preset {
    /// Its name.
    pub name: &'static str,
    /// One-line description.
    pub about: &'static str,
    /// The preset that it differs from; none for the one that all others extend.
    extends: Option<&'static str>,
    /// The differences, as TOML.
    text: &'static str,
}

impl Preset {
    /// Creates the preset that all others extend.
    pub(crate) const fn base(name: &'static str, about: &'static str, text: &'static str) -> Self {
        Self { name, about, extends: None, text }
    }

    /// Creates a preset that differs from another one.
    pub(crate) const fn new(name: &'static str, about: &'static str, base: &'static str, text: &'static str) -> Self {
        Self { name, about, extends: Some(base), text }
    }
}

/// A trainer's configuration.
///
/// ```
/// use tpg_train::{Config, Configuration, SacConfig};
///
/// assert_eq!(Config::PRESETS.iter().filter(|preset| preset.name == "quick").count(), 1);
/// assert!(Config::table("no such preset").is_err());
/// let sac = SacConfig::preset("general")?;
/// assert_eq!(sac.actor.hidden, [64, 64]);
/// # Ok::<(), tpg_graph::error::InputError>(())
/// ```
pub trait Configuration: Sized + Serialize + DeserializeOwned {
    /// The configurations included with the trainer.
    const PRESETS: &'static [Preset];
    /// The kind of policies that it trains.
    const KIND: PolicyKind;
    /// The command that prints a configuration, for messages.
    const PRINTED_BY: &'static str;

    /// Returns the name of the preset used for a problem by default.
    fn default_preset(problem: ProblemName) -> &'static str;

    /// Returns the settings in a file of another program, and the name of the preset that they belong to; none for TOML.
    fn from_other(_file: &str, _text: &str) -> Option<Result<(toml::Table, &'static str), InputError>> {
        None
    }

    /// Checks what types cannot, except for the section `problem`.
    ///
    /// # Errors
    /// The first setting that is not accepted.
    fn check(&self) -> Result<(), Finding>;

    /// Reads and checks a configuration, except for its section `problem`; what it may leave out has the default.
    ///
    /// # Errors
    /// An unknown key or a value that is not accepted, with its line.
    fn from_toml(file: &str, text: &str) -> Result<Self, InputError> {
        let config: Self = settings::from_toml(file, text, &printed_by::<Self>())?;
        config.check().map_err(|finding| settings::place(file, text, finding))?;
        Ok(config)
    }

    /// Returns the configuration as TOML without comments, as stored in a run's folder and in checkpoints.
    ///
    /// # Panics
    /// Never: every part can be serialised.
    fn to_toml(&self) -> String {
        toml::to_string(self).expect("a configuration is plain data")
    }

    /// Returns the section `problem`.
    fn problem(&mut self) -> &mut toml::Table;

    /// Returns all settings of a preset.
    ///
    /// # Errors
    /// If there is no preset of that name.
    ///
    /// # Panics
    /// Never: a test reads every preset.
    fn table(name: &str) -> Result<toml::Table, InputError> {
        let preset = Self::PRESETS.iter().find(|preset| preset.name == name).ok_or_else(|| {
            let names: Vec<&str> = Self::PRESETS.iter().map(|preset| preset.name).collect();
            command_line(format!("the preset {name:?}"), names.join(", "))
        })?;
        let Some(extended) = preset.extends else {
            let base = Self::from_toml(name, preset.text).expect("a preset is accepted");
            return Ok(toml::Table::try_from(base).expect("plain data"));
        };
        let mut table = Self::table(extended)?;
        merge(&mut table, &preset.text.parse().expect("a preset is TOML"));
        Ok(table)
    }

    /// Returns the configuration of a preset.
    ///
    /// # Errors
    /// If there is no preset of that name.
    fn preset(name: &str) -> Result<Self, InputError> {
        Self::from_toml(&format!("<preset {name}>"), &Self::table(name)?.to_string())
    }
}

/// Settings above settings.
///
/// ```
/// use tpg_train::{Config as EvolutionConfig, Configuration as _, Layers};
///
/// let mut layers = Layers::of::<EvolutionConfig>(Some("quick"), None, |_| Ok("thorough"))?;
/// layers.set("tpg.nb_roots", 1.into());
/// let error = layers.read(EvolutionConfig::from_toml).expect_err("one root");
/// assert_eq!(error.to_string(), "the setting tpg.nb_roots: tpg.nb_roots = 1; accepted: 2 to 1000000");
/// # Ok::<(), tpg_graph::error::InputError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Layers {
    layers: Vec<PresetLayer>,
    merged: toml::Table,
}

/// Settings from one place.
#[derive(Clone, Debug)]
struct PresetLayer {
    /// Its name in messages.
    name: String,
    /// Its text, if it is a file.
    text: Option<String>,
    table: toml::Table,
}

impl Layers {
    /// Begins with a preset, and the settings of a file above it. Without `preset` it is the one that the file belongs to, if
    /// another program wrote it, or the `default` for the file's settings.
    ///
    /// # Errors
    /// If there is no such preset, or the file cannot be read; those of `default`.
    pub fn of<C: Configuration>(
        preset: Option<&str>,
        file: Option<&Path>,
        default: impl FnOnce(&toml::Table) -> Result<&'static str, InputError>,
    ) -> Result<Self, InputError> {
        let (mut above, mut of_other) = (None, None);
        if let Some(path) = file {
            let (name, text) = (path.display().to_string(), read_text(path, &printed_by::<C>())?);
            above = Some(match C::from_other(&name, &text).transpose()? {
                Some((table, preset)) => {
                    of_other = Some(preset);
                    PresetLayer { name, text: None, table }
                }
                None => PresetLayer { table: settings::from_toml(&name, &text, "TOML")?, name, text: Some(text) },
            });
        }
        let preset = match preset.or(of_other) {
            Some(preset) => preset,
            None => default(above.as_ref().map_or(&toml::Table::new(), |layer| &layer.table))?,
        };
        let (name, table) = (format!("<preset {preset}>"), C::table(preset)?);
        let mut layers = Self { merged: table.clone(), layers: vec![PresetLayer { name, text: None, table }] };
        above.into_iter().for_each(|layer| layers.add(layer));
        Ok(layers)
    }

    /// Sets one key, such as `tpg.nb_roots`.
    pub fn set(&mut self, key: &str, value: toml::Value) {
        let (sections, last) = key.rsplit_once('.').map_or(("", key), |(sections, last)| (sections, last));
        let inner = toml::Table::from_iter([(last.to_owned(), value)]);
        let sections = sections.split('.').filter(|section| !section.is_empty());
        let table = sections
            .rev()
            .fold(inner, |inner, section| toml::Table::from_iter([(section.to_owned(), toml::Value::Table(inner))]));
        self.add(PresetLayer { name: format!("the setting {key}"), text: None, table });
    }

    fn add(&mut self, layer: PresetLayer) {
        let name = |table: &toml::Table| table.get("problem").and_then(|problem| problem.get("name")).cloned();
        // Settings of another problem are none of this one.
        if name(&layer.table).is_some_and(|new| name(&self.merged).is_some_and(|old| old != new)) {
            self.merged.remove("problem");
        }
        merge(&mut self.merged, &layer.table);
        self.layers.push(layer);
    }

    /// Reads the merged settings; an error names the place that they come from.
    ///
    /// # Errors
    /// Those of `read`.
    pub fn read<T>(&self, read: impl FnOnce(&str, &str) -> Result<T, InputError>) -> Result<T, InputError> {
        let text = self.merged.to_string();
        read("<settings>", &text).map_err(|error| match error.place {
            Place::Line(line) => self.located(&key_at(&text, line), error),
            _ => error,
        })
    }

    /// Puts an error about a key where its value comes from.
    fn located(&self, key: &str, error: InputError) -> InputError {
        let has = |layer: &&PresetLayer, key: &str| {
            let mut value = layer.table.get(key.split('.').next().unwrap_or_default());
            for part in key.split('.').skip(1) {
                value = value.and_then(|value| value.get(part));
            }
            value.is_some()
        };
        let section = key.rsplit_once('.').map_or(key, |(section, _)| section);
        let newest = |key: &str| self.layers.iter().rev().find(|layer| has(layer, key));
        match newest(key).or_else(|| newest(section)) {
            Some(PresetLayer { name, text: Some(text), .. }) => {
                let place = settings::place(name, text, Finding::new(key, "", "")).place;
                InputError { file: name.clone(), place, ..error }
            }
            Some(PresetLayer { name, .. }) => InputError { file: name.clone(), place: Place::Whole, ..error },
            None => error,
        }
    }

    /// Returns the problem's name, and the layer that it comes from.
    fn problem(&self) -> Option<&PresetLayer> {
        let named =
            |layer: &&PresetLayer| layer.table.get("problem").is_some_and(|problem| problem.get("name").is_some());
        self.layers.iter().rev().find(named)
    }
}

fn printed_by<C: Configuration>() -> String {
    format!("the settings that `{}` prints", C::PRINTED_BY)
}

/// Puts the values of a table over those of another one.
fn merge(base: &mut toml::Table, over: &toml::Table) {
    for (key, value) in over {
        match (base.get_mut(key), value) {
            (Some(toml::Value::Table(base)), toml::Value::Table(over)) => merge(base, over),
            _ => drop(base.insert(key.clone(), value.clone())),
        }
    }
}

/// Returns the key, with its sections, at a line of a text that this crate has written.
fn key_at(text: &str, line: usize) -> String {
    let lines: Vec<&str> = text.lines().take(line).collect();
    let section = lines.iter().rev().find_map(|line| line.strip_prefix('[')?.strip_suffix(']'));
    let key = lines.last().and_then(|line| line.split_once(" = ")).map(|(key, _)| key);
    [section, key].into_iter().flatten().collect::<Vec<_>>().join(".")
}

/// A configuration and its problem.
#[derive(Clone, Debug)]
pub(crate) struct Chosen<C: Configuration> {
    /// Name of the preset; none if a file or an argument changes it.
    pub preset: Option<String>,
    /// The configuration, with the problem written out in its section.
    pub config: C,
    /// The problem.
    pub problem: Problem,
    /// The settings that a file or an argument changes.
    pub settings: toml::Table,
}

impl<C: Configuration> Chosen<C> {
    /// Returns what the arguments ask for: a preset or the problem's default one, with the changes of a file and of arguments.
    ///
    /// # Errors
    /// If the configuration cannot be read or is rejected, or nothing names a problem.
    pub(crate) fn by(run: &RunArgs) -> Result<Self, InputError> {
        let mut layers = Layers::of::<C>(run.preset.as_deref(), run.config.as_deref(), |file| {
            let in_file = || ProblemName::from_name(file.get("problem")?.get("name")?.as_str()?);
            run.problem.or_else(in_file).map(C::default_preset).ok_or_else(no_problem)
        })?;
        for setting in &run.set {
            let (key, value) = setting
                .split_once('=')
                .ok_or_else(|| command_line(format!("--set {setting}"), "--set KEY=VALUE, such as tpg.nb_roots=100"))?;
            let toml = toml::from_str::<toml::Table>(&format!("value = {value}"));
            let value = toml.ok().and_then(|mut table| table.remove("value")).unwrap_or_else(|| value.into());
            layers.set(key.trim(), value);
        }
        let problem = chosen_problem(&mut layers, run.problem, C::KIND)?;
        let mut config = layers.read(C::from_toml)?;
        *config.problem() = problem.to_table();
        let is_preset = run.config.is_none() && run.set.is_empty();
        let preset = || run.preset.clone().unwrap_or_else(|| C::default_preset(problem.name()).to_owned());
        let mut settings = toml::Table::new();
        layers.layers[1..].iter().for_each(|layer| merge(&mut settings, &layer.table));
        Ok(Self { preset: is_preset.then(preset), config, problem, settings })
    }
}

fn no_problem() -> InputError {
    let accepted = format!("--problem {}, or a section [problem] with a name", ProblemName::names());
    command_line("no problem, neither in the arguments nor in the settings", accepted)
}

/// Returns the problem of the settings, or of the command line. A preset made for another problem supplies only its parameters.
fn chosen_problem(layers: &mut Layers, asked: Option<ProblemName>, kind: PolicyKind) -> Result<Problem, InputError> {
    let read = |file: &str, text: &str| Problem::read(file, text, kind);
    let Some(layer) = layers.problem() else {
        let name = asked.ok_or_else(no_problem)?;
        if !layers.merged.contains_key("problem") {
            return Ok(Problem::new_for(name, kind));
        }
        layers.set("problem.name", name.name().into());
        return layers.read(read);
    };
    let is_preset = std::ptr::eq(layer, &layers.layers[0]);
    let problem = layers.read(read)?;
    match asked {
        Some(name) if problem.name() != name && is_preset => Ok(problem.renamed(name, kind)),
        Some(name) if problem.name() != name => {
            let found = format!("--problem {} with a configuration for {}", name.name(), problem.name().name());
            Err(command_line(found, "the same problem twice, or no --problem"))
        }
        _ => Ok(problem),
    }
}
