//! Settings for sharing a problem between a graph and a network, and their file `hybrid.toml`.

use super::span::Span;
use crate::run_args::command_line;
use crate::sac::network::Network;
use serde::{Deserialize, Serialize};
use std::path::Path;
use tpg_graph::Graph;
use tpg_graph::error::{Finding, InputError};
use tpg_graph::files::{read_graph, read_text};
use tpg_graph::settings;
use tpg_runtime::scalar::Scalar;
use tpg_runtime::switch::Settings;

/// Method of detecting that the graph has returned to an earlier state.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Detector {
    /// Cycles are not detected.
    #[default]
    None,
    /// The exact set of visited states.
    Visited,
    /// Brent's detector, which remembers one state.
    Brent,
}

impl Detector {
    /// Returns the name used in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::None => "none",
            Self::Visited => "visited",
            Self::Brent => "brent",
        }
    }
}

/// The settings of a hybrid: three triggers that hand over to the network, and the length of its turn.
///
/// A graph that asks needs no trigger. All triggers judge the distance to the goal, in the problem's own unit: see
/// [`Environment::distance`](tpg_engine::Environment::distance).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Setting {
    /// Method of detecting cycles, after which the network takes over too.
    #[serde(rename = "cycle_detector")]
    pub detector: Detector,
    /// Number of actions of the network before the graph takes over again.
    pub hand_back_after: Span,
    /// The network takes over when the distance exceeds the least one of the graph's turn by more than this; infinity
    /// for never.
    pub separation: f64,
    /// The network takes over after that many actions of the graph without a new least distance.
    pub patience: Span,
    /// The problem's guard of that name: the network takes over where it refuses an action of the graph.
    pub guard: String,
}

/// The name of the guard of problems without guards.
pub(crate) const UNGUARDED: &str = "none";

impl Setting {
    /// Returns the setting without a trigger: the graph only asks.
    pub fn only_asks() -> Self {
        Self {
            hand_back_after: Span::NEVER,
            separation: f64::INFINITY,
            patience: Span::NEVER,
            detector: Detector::None,
            guard: UNGUARDED.to_owned(),
        }
    }

    /// Converts the setting for the runtime.
    pub fn settings<S: Scalar>(&self) -> Settings<S> {
        Settings { hand_back_after: self.hand_back_after.0, separation: S::from_f64(self.separation) }
    }

    /// True if the graph can ever hand over.
    pub(crate) fn has_trigger(&self) -> bool {
        let has_rule = self.separation.is_finite() || self.patience != Span::NEVER || self.detector != Detector::None;
        has_rule || self.guard != UNGUARDED
    }

    /// Describes the setting: `hands back after 20, separation 3.5, patience never, cycles none`, or `only asks` without a
    /// trigger.
    pub fn sentence(&self) -> String {
        if !self.has_trigger() {
            return "only asks".to_owned();
        }
        let Self { hand_back_after, separation, patience, detector, guard } = self;
        let cycles = detector.name();
        let guard = if guard == UNGUARDED { String::new() } else { format!(", guard {guard}") };
        let separation = if separation.is_infinite() { "∞".to_owned() } else { separation.to_string() };
        format!(
            "hands back after {hand_back_after}, separation {separation}, patience {patience}, cycles {cycles}{guard}"
        )
    }

    /// Checks the setting for itself.
    ///
    /// # Errors
    /// A separation that is no distance.
    pub fn check(&self) -> Result<(), Finding> {
        if matches!(self.separation, 0.0..) {
            return Ok(());
        }
        Err(Finding::new("separation", self.separation, "a distance from 0, or inf"))
    }

    /// Checks the setting for a problem of that name with these guards, whose states have keys or not.
    ///
    /// # Errors
    /// A guard that the problem does not have, or cycles of states without keys.
    pub(crate) fn check_on(&self, problem: &str, guards: &[&str], has_key: bool) -> Result<(), InputError> {
        if self.guard != UNGUARDED && !guards.contains(&self.guard.as_str()) {
            let accepted = if guards.is_empty() { UNGUARDED.to_owned() } else { guards.join(", ") };
            return Err(command_line(format!("guard {} for {problem}", self.guard), accepted));
        }
        if has_key || self.detector == Detector::None {
            return Ok(());
        }
        let cycles = self.detector.name();
        let found = format!("cycle detector {cycles} for {problem}, which has no keys to detect cycles by");
        Err(command_line(found, "none, with a separation or a patience; or an Environment with `key`"))
    }

    /// Checks the setting for a graph.
    ///
    /// # Errors
    /// As [`check`](Self::check), or no trigger at all for a graph that asks nobody.
    fn check_for(&self, graph: &Graph) -> Result<(), Finding> {
        self.check()?;
        if self.has_trigger() || graph.asks().next().is_some() {
            return Ok(());
        }
        let accepted =
            "a finite separation, a patience in actions, cycle_detector visited or brent, or a graph that asks";
        Err(Finding::new("separation", "inf, with patience never and cycle_detector none", accepted))
    }
}

fn infinity() -> f64 {
    f64::INFINITY
}

/// A complete hybrid, as written in `hybrid.toml`. Paths are relative to the file. Rules that it leaves out are off: a
/// graph that only asks needs none.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HybridFile {
    /// The problem's name; files of earlier versions leave it out for the arm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub problem: Option<String>,
    /// The graph.
    pub graph: String,
    /// The network: policy.safetensors or policy.q.json.
    pub actor: String,
    /// Number of actions of the network before the graph takes over again, or "never".
    #[serde(default)]
    pub hand_back_after: Span,
    /// The network takes over when the distance is this much greater than at its least; `inf` for never.
    #[serde(default = "infinity", alias = "separation_mm")]
    pub separation: f64,
    /// The network takes over after that many actions without progress, or "never".
    #[serde(default)]
    pub patience: Span,
    /// "none", "visited" or "brent".
    #[serde(default)]
    pub cycle_detector: Detector,
    /// The problem's guard of that name.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub guard: Option<String>,
}

/// A hybrid with its policies.
#[derive(Clone, Debug)]
pub struct Hybrid {
    /// The problem's name, if the file says it.
    pub problem: Option<String>,
    /// The graph, and its file.
    pub graph: (String, Graph),
    /// The network, and its file.
    pub network: (String, Network),
    /// The setting.
    pub setting: Setting,
}

impl HybridFile {
    /// Returns the setting.
    pub fn setting(&self) -> Setting {
        let Self { hand_back_after, separation, patience, cycle_detector: detector, .. } = *self;
        let guard = self.guard.clone().unwrap_or_else(|| UNGUARDED.to_owned());
        Setting { hand_back_after, separation, patience, detector, guard }
    }
}

impl Hybrid {
    /// Reads a `hybrid.toml` and the policies that it names.
    ///
    /// # Errors
    /// If one of them cannot be read, or the setting is impossible for the graph.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let (name, text) = (path.display().to_string(), read_text(path, ACCEPTED)?);
        let file = parse_file(&name, &text)?;
        let beside = |name: &str| path.parent().unwrap_or(Path::new("")).join(name);
        let (graph, actor) = (beside(&file.graph), beside(&file.actor));
        let setting = file.setting();
        let graph = (graph.display().to_string(), read_graph(&graph)?);
        setting.check_for(&graph.1).map_err(|finding| settings::place(&name, &text, finding))?;
        let network = (actor.display().to_string(), Network::read(&actor)?);
        Ok(Self { problem: file.problem, graph, network, setting })
    }
}

/// The file, for messages.
const ACCEPTED: &str = "a hybrid.toml";

/// Reads the text of a `hybrid.toml` without its policies; `name` is the file's, for messages.
///
/// # Errors
/// If it cannot be read or contains a setting that no graph can have.
pub fn parse_file(name: &str, text: &str) -> Result<HybridFile, InputError> {
    let accepted = "problem, graph, actor, hand_back_after, separation, patience, cycle_detector, guard";
    let file: HybridFile = settings::from_toml(name, text, accepted)?;
    file.setting().check().map_err(|finding| settings::place(name, text, finding))?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "problem = \"pendulum\"\ngraph = \"graph.json\"\nactor = \"policy.q.json\"\n\
                        hand_back_after = 20\nseparation = 2.5\npatience = \"never\"\ncycle_detector = \"none\"\n";

    #[test]
    fn a_file_comes_back_as_it_was() {
        let file: HybridFile = toml::from_str(TEXT).expect("a good file");
        assert_eq!(toml::to_string(&file).expect("plain data"), TEXT);
    }

    #[test]
    fn rules_that_are_left_out_are_off() {
        let text: String = TEXT.lines().take(3).map(|line| format!("{line}\n")).collect();
        let file = parse_file("hybrid.toml", &text).expect("a good file");
        assert_eq!(file.setting(), Setting::only_asks());
        assert_eq!(parse_file("hybrid.toml", &toml::to_string(&file).expect("plain data")), Ok(file));
    }

    #[test]
    fn an_impossible_setting_is_refused_at_its_line() {
        for (from, to, line, found) in [
            ("2.5", "-1.0", 5, "separation = -1"),
            ("2.5", "nan", 5, "separation = NaN"),
            ("20", "0", 4, "\"0\": neither a number"),
            ("\"never\"", "\"soon\"", 6, "\"soon\": neither a number"),
            ("\"none\"", "\"floyd\"", 7, "unknown variant"),
            ("patience", "guards", 6, "unknown field `guards`"),
        ] {
            let error = parse_file("hybrid.toml", &TEXT.replace(from, to)).expect_err(to);
            assert_eq!(error.place, tpg_graph::error::Place::Line(line), "{error}");
            assert!(error.found.starts_with(found), "{error}");
        }
    }
}
