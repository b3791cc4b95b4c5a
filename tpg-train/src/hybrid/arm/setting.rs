//! Settings for sharing an arm between a graph and an actor, and their file `hybrid.toml`.

use crate::arm_of;
use crate::files::{read_graph, read_text};
use crate::hybrid::setting::{rust_distance, shown};
use crate::hybrid::span::Span;
use crate::sac::motors::MotorNetwork;
use serde::{Deserialize, Serialize};
use std::path::Path;
use tpg_arm::hybrid::{Guard, Settings};
use tpg_graph::Graph;
use tpg_graph::error::{Finding, InputError};
use tpg_graph::settings;
use tpg_runtime::scalar::Scalar;

/// Method of detecting that the graph has returned to an earlier pose.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, clap::ValueEnum)]
#[serde(rename_all = "kebab-case")]
pub enum Detector {
    /// The exact set of visited poses.
    Visited,
    /// Brent's detector, in 16 bytes.
    #[default]
    Brent,
}

impl Detector {
    /// Returns the name used in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Visited => "visited",
            Self::Brent => "brent",
        }
    }
}

/// The settings of a hybrid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Setting {
    /// The paper's `nbItGoBackTPG`.
    pub hand_back_after: Span,
    /// The paper's `sepDistance`, mm.
    pub separation_mm: f64,
    /// Actions of the graph that are not executed.
    pub guard: Guard,
    /// Method of detecting cycles.
    pub detector: Detector,
}

impl Setting {
    /// The paper's setting for fixed starts.
    pub const PAPER_FS: Self =
        Self { hand_back_after: Span(100), separation_mm: 20.0, guard: Guard::None, detector: Detector::Visited };
    /// The paper's setting for random starts.
    pub const PAPER_RS: Self = Self { separation_mm: 10.0, ..Self::PAPER_FS };

    /// Converts the setting for the runtime.
    pub fn settings<S: Scalar>(&self) -> Settings<S> {
        Settings {
            hand_back_after: self.hand_back_after.0,
            separation: S::from_f64(self.separation_mm),
            guard: self.guard,
        }
    }

    /// Describes the setting: `100 actions, 20 mm, guard joint-limits, brent`.
    pub fn sentence(&self) -> String {
        let back = match self.hand_back_after {
            Span::NEVER => "no hand-back".to_owned(),
            Span(actions) => format!("{actions} actions"),
        };
        let (mm, guard, detector) = (shown(self.separation_mm), self.guard.name(), self.detector.name());
        format!("{back}, {mm} mm, guard {guard}, {detector}")
    }
}

/// A complete hybrid, as written in `hybrid.toml`. Paths are relative to the file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct HybridFile {
    /// The graph.
    pub graph: String,
    /// The actor, integer or floating-point.
    pub actor: String,
    /// Number of actions of the network before the graph takes over again, or "never".
    pub hand_back_after: Span,
    /// The network takes over when the hand is this much further away than at its closest, mm; `inf` for never.
    pub separation_mm: f64,
    /// "none", "joint-limits", "collisions" or "both".
    pub guard: String,
    /// "visited" or "brent".
    pub cycle_detector: Detector,
}

impl HybridFile {
    /// Reads a file.
    ///
    /// # Errors
    /// If it cannot be read or contains an impossible setting.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        read(path).map(|(file, _)| file)
    }

    /// Reads the text of such a file; `name` is the file's, for messages.
    ///
    /// # Errors
    /// If it contains an impossible setting.
    pub fn parse(name: &str, text: &str) -> Result<Self, InputError> {
        parse(name, text).map(|(file, _)| file)
    }

    /// Returns the setting.
    ///
    /// # Errors
    /// An unknown guard, or a separation that is not a distance.
    pub fn setting(&self) -> Result<Setting, Finding> {
        let guard = Guard::from_name(&self.guard).ok_or_else(|| {
            Finding::new("guard", format!("{:?}", self.guard), Guard::ALL.map(Guard::name).join(", "))
        })?;
        if !matches!(self.separation_mm, 0.0..) {
            return Err(Finding::new("separation_mm", self.separation_mm, "a distance from 0 mm, or inf"));
        }
        let Self { hand_back_after, separation_mm, cycle_detector: detector, .. } = *self;
        Ok(Setting { hand_back_after, separation_mm, guard, detector })
    }

    /// Returns the setting as constants of a Rust crate that uses `tpg_runtime`.
    ///
    /// # Errors
    /// As [`setting`](Self::setting).
    pub fn to_rust(&self) -> Result<String, Finding> {
        let Setting { hand_back_after, separation_mm, guard, detector } = self.setting()?;
        let back_import = if hand_back_after == Span::NEVER { "NEVER, " } else { "" };
        let (back, separation) = (hand_back_after.to_rust(), rust_distance(separation_mm));
        let (guard, detector) = (format!("{guard:?}"), format!("{detector:?}"));
        let watched = if detector == "Brent" { detector } else { "Visited<4096>".to_owned() };
        let name = watched.split('<').next().unwrap_or_default();
        Ok(format!(
            "//! Settings for sharing the arm between this folder's graph and its actor: made from `hybrid.toml` by\n\
             //! `tpg-train constants`; do not edit.\n\
             \n\
             use tpg_arm::cycle::{name};\n\
             use tpg_arm::hybrid::{{Guard, {back_import}Settings}};\n\
             \n\
             /// The distance and the number of actions at which the policies take turns.\n\
             pub const SETTINGS: Settings<f32> = Settings {{\n    \
             hand_back_after: {back},\n    \
             separation: {separation},\n    \
             guard: Guard::{guard},\n\
             }};\n\
             \n\
             /// The detector of cycles: it notices that the graph returns to an earlier pose.\n\
             pub type Detector = {watched};\n"
        ))
    }
}

/// A hybrid with its policies.
#[derive(Debug)]
pub struct Hybrid {
    /// The graph, and its file.
    pub graph: (String, Graph),
    /// The actor.
    pub actor: MotorNetwork,
    /// The setting.
    pub setting: Setting,
}

impl Hybrid {
    /// Reads a `hybrid.toml` and the policies that it names, for the arm that the graph was trained for.
    ///
    /// # Errors
    /// If one of them cannot be read, or the setting is impossible.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let (file, setting) = read(path)?;
        let beside = |name: &str| path.parent().unwrap_or(Path::new("")).join(name);
        let graph = beside(&file.graph);
        let (name, graph) = (graph.display().to_string(), read_graph(&graph)?);
        let actor = MotorNetwork::read(&beside(&file.actor), Some(&arm_of::graph(&name, &graph)?))?;
        Ok(Self { graph: (name, graph), actor, setting })
    }
}

/// Reads a file and checks its setting.
fn read(path: &Path) -> Result<(HybridFile, Setting), InputError> {
    parse(&path.display().to_string(), &read_text(path, "a hybrid.toml")?)
}

fn parse(name: &str, text: &str) -> Result<(HybridFile, Setting), InputError> {
    let accepted = "graph, actor, hand_back_after, separation_mm, guard, cycle_detector";
    let file: HybridFile = settings::from_toml(name, text, accepted)?;
    let setting = file.setting().map_err(|finding| settings::place(name, text, finding))?;
    Ok((file, setting))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "graph = \"graph.json\"\nactor = \"../a/policy.q.json\"\nhand_back_after = \"never\"\n\
                        separation_mm = inf\nguard = \"collisions\"\ncycle_detector = \"brent\"\n";

    #[test]
    fn a_file_comes_back_as_it_was() {
        let file: HybridFile = toml::from_str(TEXT).expect("a good file");
        let setting = file.setting().expect("a setting");
        assert_eq!((setting.hand_back_after, setting.separation_mm), (Span::NEVER, f64::INFINITY));
        assert_eq!(toml::to_string(&file).expect("plain data"), TEXT);
        let numbers = TEXT.replace("\"never\"", "100").replace("inf", "20.0");
        let file: HybridFile = toml::from_str(&numbers).expect("a good file");
        assert_eq!(toml::to_string(&file).expect("plain data"), numbers);
        assert!(file.to_rust().expect("a setting").contains("hand_back_after: 100,\n    separation: 20.0,\n"));
    }

    #[test]
    fn what_no_hybrid_can_do_is_refused_at_its_place() {
        for (from, to, place) in
            [("collisions", "everything", "guard"), ("inf", "-1.0", "separation_mm"), ("inf", "nan", "separation_mm")]
        {
            let file: HybridFile = toml::from_str(&TEXT.replace(from, to)).expect("TOML");
            assert_eq!(file.setting().map_err(|finding| finding.key), Err(place.to_owned()));
        }
        for (from, to) in [("\"never\"", "0"), ("\"never\"", "\"soon\""), ("brent", "floyd"), ("guard", "guards")] {
            assert!(toml::from_str::<HybridFile>(&TEXT.replace(from, to)).is_err(), "{to}");
        }
    }
}
