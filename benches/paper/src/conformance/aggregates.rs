//! Means of the paper's complete evaluation of hybrids: every pair and every row.

use super::ArtifactProblem;
use super::artifact::{Recording, cell};
use serde::Serialize;
use std::path::Path;
use tpg_graph::command::CommandError;

/// Pairs of a graph and an actor.
const PAIRS: u32 = 50;
const SEPARATIONS: [u32; 6] = [1, 3, 10, 20, 100, 10_000];
const ACTIONS: [u32; 6] = [1, 5, 10, 50, 100, 1000];

/// Means over pairs of the means over rows.
#[derive(Serialize)]
struct AggregateCell {
    problem: &'static str,
    sep_mm: u32,
    nb_it: u32,
    dist_mean: f64,
    dist_sd: f64,
    success: f64,
    success_sd: f64,
    collision: f64,
    nb_actions: f64,
    tpg_ratio: f64,
}

/// Returns the cells of both problems as JSON, a value a line.
pub(super) fn json(data: &Path, problems: &[ArtifactProblem]) -> Result<String, CommandError> {
    let mut cells = Vec::new();
    for problem in problems {
        for sep_mm in SEPARATIONS {
            for nb_it in ACTIONS {
                cells.push(of_cell(data, problem, sep_mm, nb_it)?);
            }
        }
    }
    let text = serde_json::to_string_pretty(&cells).map_err(CommandError::other)?;
    Ok(text.lines().map(str::trim_start).collect::<Vec<_>>().join("\n"))
}

fn of_cell(data: &Path, problem: &ArtifactProblem, sep_mm: u32, nb_it: u32) -> Result<AggregateCell, CommandError> {
    let mut pairs: [Vec<f64>; 5] = Default::default();
    for pair in 0..PAIRS {
        let recording = Recording::read(&cell(data, problem.hybrids, pair, sep_mm, nb_it))?;
        let mut sums = [0.0; 5];
        for run in &recording.runs {
            let actions = f64::from(run.actions);
            let by_tpg = f64::from(run.tpg_actions.unwrap_or_default());
            let values = [
                run.distance_um as f64 / 1000.0,
                f64::from(run.success),
                f64::from(run.collision),
                actions,
                by_tpg / actions,
            ];
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
        }
        pairs.iter_mut().zip(sums).for_each(|(means, sum)| means.push(sum / recording.runs.len() as f64));
    }
    let [distance, success, collision, actions, ratio] = pairs.each_ref().map(|means| mean(means));
    let [dist_sd, success_sd] = [deviation(&pairs[0]), deviation(&pairs[1])];
    Ok(AggregateCell {
        problem: problem.name,
        sep_mm,
        nb_it,
        dist_mean: distance,
        dist_sd,
        success,
        success_sd,
        collision,
        nb_actions: actions,
        tpg_ratio: ratio,
    })
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Returns the standard deviation of a population.
fn deviation(values: &[f64]) -> f64 {
    let mean = mean(values);
    (values.iter().map(|value| (value - mean) * (value - mean)).sum::<f64>() / values.len() as f64).sqrt()
}
