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
    let groups = runs::read(&args.runs)?;
    let page = page(&groups, args.episodes as usize, args.seed, own)?;
    let html = page.html();
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

fn page(groups: &[Group], episodes: usize, seed: u64, own: Option<&dyn Shared>) -> Result<Page, InputError> {
    let tested: Vec<Vec<Option<Tested>>> = (groups.iter())
        .map(|group| group.runs.iter().map(|run| test::test(run, episodes, seed, own)).collect())
        .collect::<Result<_, _>>()?;
    let halls: Vec<Vec<(String, &Run, Tested)>> =
        (groups.iter()).map(|group| test::halls(&group.runs, episodes, seed, own)).collect::<Result<_, _>>()?;
    let has_problem = own.is_some() || groups.iter().flat_map(|group| &group.runs).any(|run| run.problem.is_some());
    let test = || {
        format!(
            "Tested on {episodes} episodes of the test set with seed {seed}, which no training and no selection reads."
        )
    };
    let lead = if has_problem { test() } else { String::new() };
    let best: Vec<Option<usize>> =
        groups.iter().zip(&tested).map(|(group, tested)| best(&group.runs, tested)).collect();
    let mut sections = vec![tables::section(groups, &tested)];
    for ((group, tested), best) in groups.iter().zip(&tested).zip(&best) {
        let Some(best) = *best else { continue };
        sections.push(policy::section(&group.runs[best], tested[best].as_ref()));
        sections.extend(rivals::section(&group.runs[best]));
    }
    sections.extend(curves::sections(groups));
    sections.extend(size::section(groups, &tested, &halls));
    let named = |group: &Group| match group.problem() {
        OWN => group.name.clone(),
        problem if group.name.contains(problem) => group.name.clone(),
        problem => format!("{problem}: {}", group.name),
    };
    let title = groups.iter().map(named).collect::<Vec<_>>().join(", ");
    Ok(Page { title, lead, headlines: headline::headlines(groups, &tested, &best), sections })
}

/// Returns the run with the highest success rate, if defined, then with the highest mean score, in validation where there was no
/// test; the first of equals.
fn best(runs: &[Run], tested: &[Option<Tested>]) -> Option<usize> {
    let worth = |place: &usize| {
        let summary = tested[*place].as_ref().map(Tested::summary);
        let validated = || runs[*place].validated().unwrap_or(f64::NEG_INFINITY);
        summary.map_or_else(|| (-1.0, validated()), |summary| (summary.success.unwrap_or(0.0), summary.score))
    };
    (0..tested.len()).rev().max_by(|a, b| worth(a).partial_cmp(&worth(b)).unwrap_or(std::cmp::Ordering::Equal))
}
