//! Every policy on the committed test episodes.

use super::ProblemInputs;
use super::compiled::Times;
use super::timing::{self, Time};
use std::path::{Path, PathBuf};
use tpg_arm::WIDOWX;
use tpg_arm::observation::Straight;
use tpg_codegen::emit::{Code, Language, Options, Prefix, Profile};
use tpg_codegen::{compile, size};
use tpg_engine::{Sample, TaskSet};
use tpg_graph::Graph;
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::read_graph;
use tpg_problems::Problem;
use tpg_problems::arm::ArmProblem;
use tpg_problems::arm::evaluation::{ReachStatistics, run};
use tpg_problems::arm::planner::{Choice, Planner};
use tpg_problems::arm::targets::{Start, Task};
use tpg_train::{Acting, Episodes, Hybrid, Network, Shared as _};

/// One row of the table. Rates lie in 0..1.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// The policy.
    pub name: String,
    /// Number of policies averaged.
    pub policies: usize,
    /// Fraction of the episodes that reached their target.
    pub success: Sample,
    /// Fraction of the episodes that ended with an invalid action.
    pub collision: Sample,
    /// Final distance, mm.
    pub distance: Sample,
    /// Number of actions in an episode.
    pub actions: Sample,
    /// Fraction of the actions chosen by the graph, for hybrids.
    pub by_graph: Option<Sample>,
    /// Time measured on this machine.
    pub time: Option<Time>,
    /// Size of the model on a Cortex-M4F: with the graph's C in profile `fast`, and in profile `small`.
    pub bytes: Option<[usize; 2]>,
}

impl Row {
    /// Summarises trials.
    pub fn new(name: &str, trials: &[ReachStatistics]) -> Self {
        let sample = |value: fn(&ReachStatistics) -> f64| Sample::new(&trials.iter().map(value).collect::<Vec<_>>());
        Self {
            name: name.to_owned(),
            policies: trials.len(),
            success: sample(|trial| trial.success_rate),
            collision: sample(|trial| trial.collision_rate),
            distance: sample(|trial| trial.mean_distance_mm),
            actions: sample(|trial| trial.mean_actions),
            by_graph: None,
            time: None,
            bytes: None,
        }
    }
}

/// A problem with its episodes.
#[derive(Clone, Copy, Debug)]
pub struct Ours<'a> {
    /// Start of the episodes.
    pub start: Start,
    /// The episodes.
    pub episodes: Episodes<'a>,
}

impl Ours<'_> {
    /// Lets the trainer play with each of some policies, and summarises them.
    ///
    /// # Errors
    /// If a policy is not one of the arm.
    pub fn row<'a>(&self, name: &str, policies: impl IntoIterator<Item = Acting<'a>>) -> Result<Row, InputError> {
        let (mut trials, mut ratios) = (Vec::new(), Vec::new());
        for acting in policies {
            let share = matches!(acting, Acting::Both(..));
            let done = Problem::tested(self.start.into(), None)?.play(acting, self.episodes)?;
            trials.push(ReachStatistics::new(&done.endings));
            ratios.extend(share.then_some(done.tpg_action_ratio));
        }
        let by_graph = (!ratios.is_empty()).then(|| Sample::new(&ratios));
        Ok(Row { by_graph, ..Row::new(name, &trials) })
    }
}

/// Returns the size in bytes of a graph's C code on a Cortex-M4F, compiled for size, in profile `fast` and profile
/// `small`; `None` if the compiler is missing.
fn graph_bytes(graph: &Graph) -> Option<[usize; 2]> {
    let flash = |profile| {
        let options = Options { profile: Some(profile), ..Options::new("policy".parse::<Prefix>().ok()?) };
        Some(size::flash_of_c(&Code::of(compile(graph, &options, Language::C))).ok()? as usize)
    };
    Some([flash(Profile::Fast)?, flash(Profile::Small)?])
}

/// Number of tasks that are timed of the planner, which is slow.
const TIMED_PLANNER: usize = 20;

/// Measures the rows of one problem on tasks, of which some are timed.
///
/// # Errors
/// Files that are not policies.
pub fn measure(
    start: Start,
    inputs: &ProblemInputs,
    tasks: &[Task],
    timed: &[Task],
    file: &Path,
    compiled: &Times,
) -> Result<Vec<Row>, InputError> {
    let (arm, problem) = (WIDOWX.to_f32(), ArmProblem::from(start));
    let mut rows = Vec::new();
    for (name, choice) in [("classical planner", Choice::NearestFree), ("nearest goal, straight", Choice::Nearest)] {
        let planner = Planner::new(&WIDOWX, choice);
        let trial = ReachStatistics::new(&run(&WIDOWX, &planner, &problem, tasks));
        let time = timing::of_policy(&WIDOWX, &planner, start, &tasks[..TIMED_PLANNER.min(tasks.len())]);
        rows.push(Row { time: Some(time), ..Row::new(name, &[trial]) });
    }
    let straight = Straight::new(&arm);
    let time = Some(timing::of_policy(&arm, &straight, start, timed));
    let trial = ReachStatistics::new(&run(&arm, &straight, &problem, tasks));
    rows.push(Row { time, ..Row::new("one goal, straight (`stance`)", &[trial]) });
    let Hybrid { graph, network, setting, .. } = Hybrid::read(&inputs.shipped)?;
    let ours = Ours { start, episodes: Episodes { set: TaskSet::Test, count: 0, seed: 0, file: Some(file) } };
    let Network::Fixed(actor) = &network.1 else {
        return Err(InputError::new(
            network.0,
            Place::Whole,
            "a network in floating point",
            "one in integers, which ships",
        ));
    };
    let actor_bytes = actor.bytes();
    let bytes = graph_bytes(&graph.1);
    let together = bytes.map(|graph| graph.map(|graph| graph + actor_bytes));
    for (name, acting, bytes, time) in [
        ("SAC, shipped", Acting::Network(&network), Some([actor_bytes; 2]), compiled.sac),
        ("TPG, shipped", Acting::Graph(&graph), bytes, compiled.tpg),
        ("**hybrid, shipped**", Acting::Both(&graph, &network, &setting), together, compiled.hybrid),
    ] {
        rows.push(Row { bytes, time: Some(time), ..ours.row(name, [acting])? });
    }
    // Means over seeds, which predict another training, as opposed to a selected one.
    let named = |path: &PathBuf| path.display().to_string();
    let graphs = inputs.tpg.iter().map(|path| Ok((named(path), read_graph(path)?)));
    let graphs = graphs.collect::<Result<Vec<(String, Graph)>, InputError>>()?;
    let networks = inputs.sac.iter().map(|path| Ok((named(path), Network::read(path)?)));
    let networks = networks.collect::<Result<Vec<(String, Network)>, InputError>>()?;
    let pairs = graphs.iter().flat_map(|graph| networks.iter().map(move |network| (graph, network)));
    let seeds = [
        ours.row("SAC, all seeds", networks.iter().map(Acting::Network))?,
        ours.row("TPG, all seeds", graphs.iter().map(Acting::Graph))?,
        ours.row("hybrid, all pairs", pairs.map(|(graph, network)| Acting::Both(graph, network, &setting)))?,
    ];
    // Groups with a single policy are already listed above.
    rows.extend(seeds.into_iter().filter(|row| row.policies > 1));
    Ok(rows)
}
