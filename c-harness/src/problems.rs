//! Tasks of the firmwares: the first test episodes of each start, and the settings of the hybrid.

use crate::Failure;
use crate::data::{self, Data};
use Start::*;
use tpg_arm::episode::ReachTask;
use tpg_arm::hybrid::{Guard, Settings};
use tpg_arm::{Pose, WIDOWX};
use tpg_codegen::emit::File;
use tpg_generated::{widowx_fs_hybrid, widowx_rs_hybrid};
use tpg_problems::arm::targets::{Start, read_csv};

/// Episodes of the hybrid, for each start.
pub(crate) const PROBLEMS: usize = 100;
/// Episodes of each part alone.
pub(crate) const PARTS: usize = 25;

/// Both starts.
pub(crate) const STARTS: [Start; 2] = [Fs, Rs];

/// The name of a start in lines and names.
pub(crate) const fn name(start: Start) -> &'static str {
    match start {
        Fs => "fs",
        Rs => "rs",
    }
}

/// The settings of the shipped hybrid.
pub(crate) const fn settings(start: Start) -> Settings<f32> {
    match start {
        Fs => widowx_fs_hybrid::SETTINGS,
        Rs => widowx_rs_hybrid::SETTINGS,
    }
}

/// The first of the committed test episodes.
pub(crate) fn problems(start: Start) -> Result<Vec<ReachTask<f32>>, Failure> {
    let path = tpg_testing::library::top().join(format!("generated/test-targets/{}.csv", name(start)));
    let tasks = read_csv(&WIDOWX, &path).map_err(Failure::new)?;
    Ok(tasks.iter().take(PROBLEMS).map(|task| task.problem(start)).collect())
}

/// `problems.h`.
pub(crate) fn file() -> Result<File, Failure> {
    let mut data = Data::new("problems", "#include \"tpg_runtime.h\"\n\n#include <math.h>\n\n");
    // Fewer of them are run on slow cores.
    data.number("PROBLEMS", PROBLEMS);
    data.number("PARTS", PARTS);
    for start in STARTS {
        let name = name(start);
        let Settings { hand_back_after, separation, guard } = settings(start);
        let guard = Guard::ALL.iter().position(|&other| other == guard).unwrap_or(0);
        let separation = if separation.is_finite() { format!("{separation:?}F") } else { "INFINITY".to_owned() };
        data.text(&format!(
            "static const tpg_settings_t {name}_settings = {{ {hand_back_after}U, {separation}, {guard} }};\n"
        ));
        let row = |task: ReachTask<f32>| {
            let ReachTask { start: Pose([p, q, r, s]), target, tolerance, max_actions } = task;
            let target = data::list(&target);
            format!("{{ {{ {{ {p}, {q}, {r}, {s} }} }}, {target}, {tolerance:?}F, {max_actions}U }}")
        };
        data.table(&format!("static const tpg_problem_t {name}_problems[]"), problems(start)?.into_iter().map(row));
    }
    Ok(data.file())
}
