//! Tasks of the firmwares: the first test episodes of each start, and the settings of the hybrid.

use crate::Failure;
use Start::*;
use askama::Template;
use tpg_arm::WIDOWX;
use tpg_arm::hybrid::Settings;
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
    let mut tasks = read_csv(&WIDOWX, &path)?;
    tasks.truncate(PROBLEMS);
    Ok(tasks)
}

/// The tasks of a start, and how its hybrid shares the arm.
struct StartView {
    name: &'static str,
    settings: Settings<f32>,
    /// A TPG_GUARD code.
    guard: usize,
    actions: u32,
    tasks: Vec<Task>,
}

#[derive(Template)]
#[template(path = "problems.h", escape = "none")]
struct ProblemsHeader {
    tolerance: f64,
    count: usize,
    parts: usize,
    starts: Vec<StartView>,
}

/// `problems.h`.
pub(crate) fn file() -> Result<File, Failure> {
    let view = |start: Start| {
        let (name, settings, actions) = (name(start), settings(start), start.max_actions());
        Ok(StartView { name, settings, guard: settings.guard as usize, actions, tasks: problems(start)? })
    };
    let starts = STARTS.into_iter().map(view).collect::<Result<_, Failure>>()?;
    let header = ProblemsHeader { tolerance: TOLERANCE, count: PROBLEMS, parts: PARTS, starts };
    Ok(File { name: "problems.h".to_owned(), text: header.render()? })
}
