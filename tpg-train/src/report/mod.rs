//! `tpg-train report`: runs in one HTML file. Headlines, learning curves, return against size, and the policies: formulas,
//! graphs, episodes.
//!
//! `runs` reads folders, `test` runs the trained policies on the test episodes; the other modules write and draw. Nothing depends
//! on the clock or on the location of the folders: the same runs give the same bytes.

mod curves;
mod headline;
mod policy;
mod rivals;
mod runs;
mod size;
mod tables;
mod test;

use crate::hybrid::shared::Shared;
use clap::Args;
use runs::{Group, OWN, Run};
use std::path::{Path, PathBuf};
use test::Tested;
use tpg_graph::command::print;
use tpg_graph::error::{InputError, counted};
use tpg_graph::files::write_atomically;
use tpg_picture::Page;

/// Show runs in one HTML file.
///
/// Runs with equal configurations are one group: curves are their mean, with a band of one standard deviation.
#[derive(Clone, Debug, Args)]
pub struct ReportArgs {
    /// Folders of `tpg`, `sac` or `hybrid` runs; a `--seeds` folder means all its seeds
    #[arg(value_name = "RUN", required = true)]
    pub runs: Vec<PathBuf>,
    /// The file to write; - for stdout
    #[arg(long, short, value_name = "FILE", default_value = "report.html")]
    pub out: PathBuf,
    /// Test episodes for each run
    #[arg(long, value_name = "N", default_value_t = 1000, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub episodes: u32,
    /// The seed of the test episodes
    #[arg(long, value_name = "S", default_value_t = tpg_problems::TEST_SEED)]
    pub seed: u64,
}

/// Writes the report; `own` tests the runs on an environment that is not built in.
///
/// # Errors
/// A run that cannot be read, or a report that cannot be written.
pub fn report_with(args: &ReportArgs, own: Option<&dyn Shared>) -> Result<(), InputError> {
    let mut groups = runs::read(&args.runs)?;
    for run in groups.iter_mut().flat_map(|group| &mut group.runs) {
        run.result = test::test(run, args.episodes as usize, args.seed, own)?;
        for entry in &mut run.hall {
            entry.result = test::test(entry, args.episodes as usize, args.seed, own)?;
        }
    }
    let html = page(&groups, args, own.is_some()).html();
    if args.out == Path::new("-") {
        return print(&html);
    }
    write_atomically(&args.out, html.as_bytes())?;
    let runs: usize = groups.iter().map(|group| group.runs.len()).sum();
    tpg_graph::command::note(format_args!(
        "{}: {} in {}",
        args.out.display(),
        counted(runs, "run"),
        counted(groups.len(), "group")
    ));
    Ok(())
}

fn page(groups: &[Group], args: &ReportArgs, is_own: bool) -> Page {
    let has_problem = is_own || groups.iter().flat_map(|group| &group.runs).any(|run| run.problem.is_some());
    let test = || {
        let ReportArgs { episodes, seed, .. } = args;
        format!(
            "Tested on {episodes} episodes of the test set with seed {seed}, which no training and no selection reads."
        )
    };
    let lead = if has_problem { test() } else { String::new() };
    let mut sections = vec![tables::section(groups)];
    for group in groups {
        let best = best(&group.runs);
        sections.push(policy::section(best));
        sections.extend(rivals::section(best));
    }
    sections.extend(curves::sections(groups));
    sections.extend(size::section(groups));
    let named = |group: &Group| match group.problem() {
        OWN => group.name.clone(),
        problem if group.name.contains(problem) => group.name.clone(),
        problem => format!("{problem}: {}", group.name),
    };
    let title = groups.iter().map(named).collect::<Vec<_>>().join(", ");
    let headlines = groups.iter().map(|group| headline::headline(group, best(&group.runs))).collect();
    Page { title, lead, headlines, sections }
}

/// Returns the run with the highest success rate, if defined, then with the highest mean score, in validation where there was no
/// test; the first of equals.
fn best(runs: &[Run]) -> &Run {
    let worth = |run: &Run| {
        let summary = run.result.as_ref().map(Tested::summary);
        let validated = || run.validated().unwrap_or(f64::NEG_INFINITY);
        summary.map_or_else(|| (-1.0, validated()), |summary| (summary.success.unwrap_or(0.0), summary.score))
    };
    let by_worth = |a: &&Run, b: &&Run| worth(a).partial_cmp(&worth(b)).unwrap_or(std::cmp::Ordering::Equal);
    runs.iter().rev().max_by(by_worth).expect("a group has runs")
}
