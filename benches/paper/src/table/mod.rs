//! `tpg-paper table2`: the paper's table 2 with this project's policies, in `docs/results.md`.
//!
//! | module | subject |
//! | --- | --- |
//! | [`rows`] | every policy on the committed test episodes |
//! | [`timing`] | measured times |
//! | [`compiled`] | the shipped policies as compiled code |
//! | [`ideas`] | effects of guards, hand-overs and detectors from a random start, on validation episodes |
//! | [`markdown`] | the text |

pub mod compiled;
pub mod ideas;
pub mod markdown;
pub mod rows;
pub mod timing;

use clap::Args;
use serde::Deserialize;
use std::path::{Path, PathBuf};
use tpg_arm::WIDOWX;
use tpg_graph::error::InputError;
use tpg_graph::files::{make_folder, read_text, write_atomically};
use tpg_graph::settings;
use tpg_problems::arm::targets::{self, Start};

/// Measure every kind of policy and write docs/results.md.
#[derive(Clone, Debug, Args)]
pub struct Table2Args {
    /// The policies to measure: a TOML file; paths in it are relative to it
    #[arg(long, value_name = "TOML", default_value = "docs/results.toml")]
    pub inputs: PathBuf,
    /// The file to write
    #[arg(long, value_name = "MD", default_value = "docs/results.md")]
    pub out: PathBuf,
    /// The folder of the committed test episodes
    #[arg(long, value_name = "DIR", default_value = "generated/test-targets")]
    pub targets: PathBuf,
}

/// Number of tasks whose states are timed.
const TIMED: usize = 100;

/// Content of `docs/results.toml`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct InputsFile {
    fs: ProblemInputs,
    rs: ProblemInputs,
}

/// The policies of one problem.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ProblemInputs {
    /// The shipped hybrid's `hybrid.toml`.
    pub shipped: PathBuf,
    /// Graphs of several seeds.
    pub tpg: Vec<PathBuf>,
    /// Actors of several seeds.
    pub sac: Vec<PathBuf>,
}

impl ProblemInputs {
    fn beside(mut self, folder: &Path) -> Self {
        self.shipped = folder.join(self.shipped);
        self.tpg.iter_mut().chain(&mut self.sac).for_each(|path| *path = folder.join(&*path));
        self
    }
}

/// Measures the policies and writes the file.
///
/// # Errors
/// Invalid files, or a file that cannot be written.
pub fn execute(args: &Table2Args) -> Result<(), InputError> {
    let name = args.inputs.display().to_string();
    let text = read_text(&args.inputs, "a list of policies")?;
    let inputs: InputsFile = settings::from_toml(&name, &text, "[fs] and [rs] with shipped, tpg, sac")?;
    let folder = args.inputs.parent().unwrap_or(Path::new(""));
    let ideas = ideas::measure(&inputs.rs.clone().beside(folder))?;
    let mut problems = Vec::new();
    for (start, file, inputs) in [(Start::Fs, "fs.csv", inputs.fs), (Start::Rs, "rs.csv", inputs.rs)] {
        let tasks = targets::read_csv(&WIDOWX, &args.targets.join(file))?;
        let inputs = inputs.beside(folder);
        eprintln!("{file}: {} test episodes", tasks.len());
        let timed = &tasks[..TIMED.min(tasks.len())];
        let times = compiled::times(start, timed);
        let rows = rows::measure(start, &inputs, &tasks, timed, &args.targets.join(file), &times)?;
        problems.push(markdown::ProblemResults { start, episodes: tasks.len(), rows, times });
    }
    if let Some(folder) = args.out.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        make_folder(folder)?;
    }
    write_atomically(&args.out, markdown::page(&problems, &ideas).as_bytes())?;
    eprintln!("wrote {}", args.out.display());
    Ok(())
}
