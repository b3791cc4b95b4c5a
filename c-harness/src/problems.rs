//! Tasks of the firmwares: the first test episodes of each start, and the settings of the hybrid.

use crate::Failure;
use std::fmt::Write as _;
use tpg_arm::Pose;
use tpg_arm::episode::Problem;
use tpg_arm::hybrid::{Guard, Settings};
use tpg_codegen::emit::File;
use tpg_generated::{widowx_fs_hybrid, widowx_rs_hybrid};

/// Episodes of the hybrid, for each start.
pub(crate) const PROBLEMS: usize = 100;
/// Episodes of each part alone.
pub(crate) const PARTS: usize = 25;
/// Success is nearer than this, mm.
const TOLERANCE: f32 = 3.0;

/// The start of an episode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Start {
    /// At home.
    Fixed,
    /// Anywhere.
    Random,
}

impl Start {
    /// Both.
    pub(crate) const ALL: [Self; 2] = [Self::Fixed, Self::Random];

    /// In lines and names.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Fixed => "fs",
            Self::Random => "rs",
        }
    }

    /// The paper's limit.
    const fn max_actions(self) -> u32 {
        match self {
            Self::Fixed => 1707,
            Self::Random => 3414,
        }
    }

    /// The settings of the shipped hybrid.
    pub(crate) const fn settings(self) -> Settings<f32> {
        match self {
            Self::Fixed => widowx_fs_hybrid::SETTINGS,
            Self::Random => widowx_rs_hybrid::SETTINGS,
        }
    }

    /// The committed test episodes.
    pub(crate) fn problems(self) -> Result<Vec<Problem<f32>>, Failure> {
        let path = tpg_testing::library::top().join(format!("generated/test-targets/{}.csv", self.name()));
        let mut reader = csv::Reader::from_path(&path).map_err(|error| Failure::at(&path, error))?;
        let rows = reader.deserialize().take(PROBLEMS);
        rows.map(|row| {
            let (a, b, c, d, x, y, z): (i16, i16, i16, i16, f64, f64, f64) =
                row.map_err(|error| Failure::at(&path, error))?;
            let target = [x, y, z].map(|v| v as f32);
            Ok(Problem { start: Pose([a, b, c, d]), target, tolerance: TOLERANCE, max_actions: self.max_actions() })
        })
        .collect()
    }
}

/// `problems.h` and `problems.rs`.
pub(crate) fn files() -> Result<[File; 2], Failure> {
    let mut c =
        String::from("#ifndef PROBLEMS_H\n#define PROBLEMS_H\n\n#include \"tpg_runtime.h\"\n\n#include <math.h>\n\n");
    let mut rust = String::new();
    let _ = writeln!(c, "#define PROBLEMS {PROBLEMS}U\n#define PARTS {PARTS}U\n");
    let _ = writeln!(rust, "const PARTS: usize = {PARTS};");
    for start in Start::ALL {
        let (name, upper) = (start.name(), start.name().to_ascii_uppercase());
        let Settings { hand_back_after, separation, guard } = start.settings();
        let guard_code = Guard::ALL.iter().position(|&other| other == guard).unwrap_or(0);
        let separation = if separation.is_finite() { format!("{separation:?}F") } else { "INFINITY".to_owned() };
        let _ = writeln!(
            c,
            "static const tpg_settings_t {name}_settings = {{ {hand_back_after}U, {separation}, {guard_code} }};\n\
             static const tpg_problem_t {name}_problems[PROBLEMS] = {{"
        );
        let _ = writeln!(rust, "static {upper}_PROBLEMS: [Problem<f32>; {PROBLEMS}] = [");
        for Problem { start: Pose([p, q, r, s]), target: [x, y, z], tolerance, max_actions } in start.problems()? {
            let _ = writeln!(
                c,
                "    {{ {{ {{ {p}, {q}, {r}, {s} }} }}, {{ {x:?}F, {y:?}F, {z:?}F }}, {tolerance:?}F, {max_actions}U }},"
            );
            let _ = writeln!(
                rust,
                "    Problem {{ start: Pose([{p}, {q}, {r}, {s}]), target: [{x:?}, {y:?}, {z:?}], \
                 tolerance: {tolerance:?}, max_actions: {max_actions} }},"
            );
        }
        c.push_str("};\n\n");
        rust.push_str("];\n");
    }
    c.push_str("#endif\n");
    Ok([("problems.h", c), ("problems.rs", rust)].map(|(name, text)| File { name: name.to_owned(), text }))
}
