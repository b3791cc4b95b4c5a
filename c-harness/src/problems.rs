//! Tasks of the firmwares: the first test episodes of each start, and the settings of the hybrid.

use crate::Failure;
use crate::data::{self, Data};
use Start::*;
use tpg_arm::WIDOWX;
use tpg_arm::hybrid::{Guard, Settings};
use tpg_codegen::emit::File;
use tpg_generated::{widowx_fs_hybrid, widowx_rs_hybrid};
use tpg_problems::arm::targets::{Start, TOLERANCE, Task, read_csv};

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
pub(crate) fn problems(start: Start) -> Result<Vec<Task>, Failure> {
    let path = tpg_testing::library::top().join(format!("generated/test-targets/{}.csv", name(start)));
    let mut tasks = read_csv(&WIDOWX, &path).map_err(Failure::new)?;
    tasks.truncate(PROBLEMS);
    Ok(tasks)
}

/// `problems.h`.
pub(crate) fn file() -> Result<File, Failure> {
    let head = "#include \"tpg_runtime.h\"\n\n#include <math.h>\n\n\
                typedef struct problem {\n    tpg_pose_t start;\n    float target[3];\n} problem_t;\n\n";
    let mut data = Data::new("problems", &format!("{head}#define TOLERANCE_MM {TOLERANCE:?}F\n"));
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
        data.number(&format!("{}_ACTIONS", name.to_uppercase()), start.max_actions() as usize);
        let row = |task: Task| {
            let [p, q, r, s] = task.start.0;
            format!("{{ {{ {{ {p}, {q}, {r}, {s} }} }}, {} }}", data::list(&task.target.map(|mm| mm as f32)))
        };
        data.table(&format!("static const problem_t {name}_problems[]"), problems(start)?.into_iter().map(row));
    }
    Ok(data.file())
}
