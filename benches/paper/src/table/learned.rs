//! Policies trained on different observations or rewards: the paper's learning problem, rewards without a planner, and
//! this project's.

use super::ProblemInputs;
use super::rows::{Row, STRAIGHT};
use crate::data;
use serde::Deserialize;
use std::path::{Path, PathBuf};
use tpg_arm::WIDOWX;
use tpg_arm::observation::Straight;
use tpg_graph::error::InputError;
use tpg_problems::arm::Shield;
use tpg_problems::arm::planner::{Choice, Planner};
use tpg_problems::arm::targets::{Start, Task};
use tpg_problems::arm::trial::{Trial, run};
use tpg_problems::arm::{ArmProblem, ArmTask};
use tpg_train::evaluate::arm::shielded_endings_of;
use tpg_train::files::read_graph;
use tpg_train::sac::motors::MotorNetwork;

/// Trainings that differ only in their seed: `[[fs.learned]]` and `[[rs.learned]]`.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Learned {
    /// Name of the training.
    pub name: String,
    /// Graphs.
    #[serde(default)]
    pub tpg: Vec<PathBuf>,
    /// Actors.
    #[serde(default)]
    pub sac: Vec<PathBuf>,
}

/// The same policies on two sets of tasks.
#[derive(Clone, Debug, PartialEq)]
pub struct LearnedRow {
    /// Result on the committed test episodes.
    pub test: Row,
    /// Result on the paper's recorded targets, if available.
    pub paper: Option<Row>,
}

/// Measures a row for each kind of training, and for the classical policies.
///
/// # Errors
/// Files that are not policies, or a folder that is not the paper's.
pub fn measure(
    start: Start,
    inputs: &ProblemInputs,
    tasks: &[Task],
    conformance: Option<&Path>,
) -> Result<Vec<LearnedRow>, InputError> {
    let recorded = recorded(start, conformance)?;
    let mut rows = Vec::new();
    for learned in &inputs.learned {
        if !learned.sac.is_empty() {
            let row = |tasks: &[Task]| actors(learned, start, tasks);
            rows.push(LearnedRow { test: row(tasks)?, paper: recorded.as_deref().map(row).transpose()? });
        }
        if !learned.tpg.is_empty() {
            for shield in [Shield::None, Shield::LimitsAndCollision] {
                let row = |tasks: &[Task]| graphs(learned, shield, start, tasks);
                rows.push(LearnedRow { test: row(tasks)?, paper: recorded.as_deref().map(row).transpose()? });
            }
        }
    }
    let of = |name: &str, trial: &dyn Fn(&[Task]) -> Trial| {
        let row = |tasks: &[Task]| Row::of(name, &[trial(tasks)]);
        LearnedRow { test: row(tasks), paper: recorded.as_deref().map(row) }
    };
    let arm = WIDOWX.to_f32();
    rows.push(of(STRAIGHT, &|tasks| run(&arm, &Straight::new(&arm), start, tasks)));
    for (name, choice) in [
        ("memoryless inverse kinematics: nearest goal, straight", Choice::Nearest),
        ("classical planner", Choice::NearestFree),
    ] {
        let planner = Planner::new(&WIDOWX, choice);
        rows.push(of(name, &|tasks| run(&WIDOWX, &planner, start, tasks)));
    }
    Ok(rows)
}

fn graphs(learned: &Learned, shield: Shield, start: Start, tasks: &[Task]) -> Result<Row, InputError> {
    let tasks: Vec<ArmTask> = tasks.iter().copied().map(ArmTask::from).collect();
    let values = |path: &PathBuf| {
        let (file, graph) = (path.display().to_string(), read_graph(path)?);
        let problem = ArmProblem::new(start, Vec::new());
        let endings = shielded_endings_of(&file, &graph, &WIDOWX, problem, shield, &tasks)?;
        let trial = Trial::of(start, endings);
        Ok([trial.success_rate, trial.collision_rate, trial.mean_distance_mm, trial.mean_actions])
    };
    let values: Result<Vec<_>, InputError> = learned.tpg.iter().map(values).collect();
    let shielded = if shield == Shield::None { "" } else { ", shielded" };
    Ok(Row::of_values(&format!("{}{shielded}", learned.name), &values?))
}

fn actors(learned: &Learned, start: Start, tasks: &[Task]) -> Result<Row, InputError> {
    let trial = |path: &PathBuf| Ok(MotorNetwork::read(path, None)?.trial(start, tasks));
    let trials: Result<Vec<_>, InputError> = learned.sac.iter().map(trial).collect();
    Ok(Row::of(&learned.name, &trials?))
}

/// Reads the paper's targets; `None` if the folder is missing.
fn recorded(start: Start, folder: Option<&Path>) -> Result<Option<Vec<Task>>, InputError> {
    let Some(folder) = folder else { return Ok(None) };
    let name = if start == Start::Fs { "targets_fs.csv" } else { "targets_rs.csv" };
    let tasks = data::tasks(&folder.join(name))?;
    Ok(Some(tasks.into_values().map(|task| Task { start: task.start, target: task.target }).collect()))
}
