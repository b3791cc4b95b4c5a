//! Settings for sharing an arm between a graph and an actor, and their file `hybrid.toml`.

use crate::files::{read_text, write_atomically};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use tpg_arm::hybrid::{Guard, NEVER, Settings};
use tpg_graph::error::{InputError, Place};
use tpg_runtime::scalar::Scalar;

/// Number of actions after which the network hands the arm back.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct HandBack(pub u32);

impl HandBack {
    /// The network never hands the arm back.
    pub const NEVER: Self = Self(NEVER);
}

impl std::fmt::Display for HandBack {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if *self == Self::NEVER { f.write_str("never") } else { write!(f, "{}", self.0) }
    }
}

impl std::str::FromStr for HandBack {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.parse() {
            _ if text == "never" => Ok(Self::NEVER),
            Ok(actions) if (1..NEVER).contains(&actions) => Ok(Self(actions)),
            _ => Err(format!("{text:?}: neither a number of actions from 1 nor \"never\"")),
        }
    }
}

impl Serialize for HandBack {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if *self == Self::NEVER { serializer.serialize_str("never") } else { serializer.serialize_u32(self.0) }
    }
}

impl<'de> Deserialize<'de> for HandBack {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged)]
        enum Either {
            Actions(u32),
            Word(String),
        }
        let text = match Either::deserialize(deserializer)? {
            Either::Actions(actions) => actions.to_string(),
            Either::Word(word) => word,
        };
        text.parse().map_err(serde::de::Error::custom)
    }
}

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
    pub hand_back_after: HandBack,
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
        Self { hand_back_after: HandBack(100), separation_mm: 20.0, guard: Guard::None, detector: Detector::Visited };
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
            HandBack::NEVER => "for good".to_owned(),
            HandBack(actions) => format!("{actions} actions"),
        };
        let (mm, guard, detector) = (shown(self.separation_mm), self.guard.name(), self.detector.name());
        format!("{back}, {mm} mm, guard {guard}, {detector}")
    }
}

/// Formats a distance; infinity is shown as ∞.
pub fn shown(mm: f64) -> String {
    if mm == f64::INFINITY { "∞".to_owned() } else { mm.to_string() }
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
    pub hand_back_after: HandBack,
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
        let name = path.display().to_string();
        let text = read_text(path, "a hybrid.toml")?;
        let file: Self = toml::from_str(&text).map_err(|error| {
            let line = error.span().map_or(0, |span| text[..span.start].lines().count().max(1));
            let accepted = "graph, actor, hand_back_after, separation_mm, guard, cycle_detector";
            InputError::new(&name, Place::Line(line), error.message(), accepted)
        })?;
        file.setting().map_err(|(key, found, accepted)| InputError::new(&name, Place::Path(key), found, accepted))?;
        Ok(file)
    }

    /// Returns the setting; the error is the key, the value found and the accepted values.
    ///
    /// # Errors
    /// An unknown guard, or a separation that is not a distance.
    pub fn setting(&self) -> Result<Setting, (String, String, String)> {
        let guard = Guard::from_name(&self.guard).ok_or_else(|| {
            let accepted = Guard::ALL.map(Guard::name).join(", ");
            ("guard".to_owned(), format!("{:?}", self.guard), accepted)
        })?;
        if !matches!(self.separation_mm, 0.0..) {
            let accepted = "a distance from 0 mm, or inf".to_owned();
            return Err(("separation_mm".to_owned(), self.separation_mm.to_string(), accepted));
        }
        let Self { hand_back_after, separation_mm, cycle_detector: detector, .. } = *self;
        Ok(Setting { hand_back_after, separation_mm, guard, detector })
    }

    /// Returns the setting as constants of a Rust crate that uses `tpg_runtime`.
    ///
    /// # Errors
    /// As [`setting`](Self::setting).
    pub fn to_rust(&self) -> Result<String, (String, String, String)> {
        let Setting { hand_back_after, separation_mm, guard, detector } = self.setting()?;
        let (back, back_import) = match hand_back_after {
            HandBack::NEVER => ("NEVER".to_owned(), "NEVER, "),
            HandBack(actions) => (actions.to_string(), ""),
        };
        let separation =
            if separation_mm.is_finite() { format!("{separation_mm:?}") } else { "f32::INFINITY".to_owned() };
        let (guard, detector) = (format!("{guard:?}"), format!("{detector:?}"));
        let watched = if detector == "Brent" { detector } else { "Visited<4096>".to_owned() };
        let name = watched.split('<').next().unwrap_or_default();
        Ok(format!(
            "//! How this folder's graph and its actor share the arm: made from `hybrid.toml` by `tpg-train`; do not edit.\n\
             \n\
             use tpg_arm::cycle::{name};\n\
             use tpg_arm::hybrid::{{Guard, {back_import}Settings}};\n\
             \n\
             /// When they change.\n\
             pub const SETTINGS: Settings<f32> = Settings {{\n    \
             hand_back_after: {back},\n    \
             separation: {separation},\n    \
             guard: Guard::{guard},\n\
             }};\n\
             \n\
             /// What notices that the graph comes to a pose again.\n\
             pub type Detector = {watched};\n"
        ))
    }
}

/// Turn a hybrid.toml into Rust constants
#[derive(Clone, Debug, clap::Args)]
pub struct ConstantsArgs {
    /// The hybrid.toml
    pub hybrid: PathBuf,
    /// The Rust file to write
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
}

/// Writes the constants.
///
/// # Errors
/// If the file is not a `hybrid.toml`, or the output cannot be written.
pub fn constants(args: &ConstantsArgs) -> Result<(), InputError> {
    let name = args.hybrid.display().to_string();
    let rust = HybridFile::read(&args.hybrid)?.to_rust();
    let rust = rust.map_err(|(key, found, accepted)| InputError::new(name, Place::Path(key), found, accepted))?;
    write_atomically(&args.out, rust.as_bytes())
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
        assert_eq!((setting.hand_back_after, setting.separation_mm), (HandBack::NEVER, f64::INFINITY));
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
            assert_eq!(file.setting().map_err(|(key, ..)| key), Err(place.to_owned()));
        }
        for (from, to) in [("\"never\"", "0"), ("\"never\"", "\"soon\""), ("brent", "floyd"), ("guard", "guards")] {
            assert!(toml::from_str::<HybridFile>(&TEXT.replace(from, to)).is_err(), "{to}");
        }
    }
}
