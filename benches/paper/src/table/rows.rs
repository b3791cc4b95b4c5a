//! Every policy on the committed test episodes.

use super::ProblemInputs;
use super::compiled::Times;
use super::ours::Ours;
use super::timing::{self, Time};
use std::path::{Path, PathBuf};
use tpg_arm::WIDOWX;
use tpg_arm::observation::Straight;
use tpg_codegen::emit::{Options, Prefix, Profile};
use tpg_codegen::size::{self, Target};
use tpg_engine::Sample;
use tpg_graph::Graph;
use tpg_graph::error::{InputError, Place};
use tpg_graph::files::read_graph;
use tpg_problems::arm::ArmProblem;
use tpg_problems::arm::evaluation::{ReachStatistics, run};
use tpg_problems::arm::planner::{Choice, Planner};
use tpg_problems::arm::targets::{Start, Task};
use tpg_train::{Acting, Hybrid, Network};

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

    /// Summarises hybrids, each with the fraction of actions that its graph chose.
    pub fn of_hybrids(name: &str, hybrids: &[(ReachStatistics, f64)]) -> Self {
        let (trials, ratios): (Vec<ReachStatistics>, Vec<f64>) = hybrids.iter().cloned().unzip();
        Self { by_graph: Some(Sample::new(&ratios)), ..Self::new(name, &trials) }
    }
}

/// Returns the size in bytes of a graph's C code on a Cortex-M4F, compiled for size, in profile `fast` and profile
/// `small`; `None` if the compiler is missing.
pub fn graph_bytes(graph: &Graph) -> Option<[usize; 2]> {
    let flash = |profile| {
        let options = Options { profile: Some(profile), ..Options::new("policy".parse::<Prefix>().ok()?) };
        let size = size::compile_c(graph, &options, Target::M4f).and_then(|object| size::measure(&object)).ok()?;
        Some((size.code + size.constants + size.data) as usize)
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
    let classical = rows.len();

    let shipped = Hybrid::read(&inputs.shipped)?;
    let ours = Ours::from_file(start, file);
    let Network::Fixed(actor) = &shipped.network.1 else {
        let (file, found) = (&shipped.network.0, "a network in floating point");
        return Err(InputError::new(file, Place::Whole, found, "one in integers, which ships"));
    };
    let actor_bytes = actor.bytes();
    let actor_row =
        |name: &str, trial: ReachStatistics| Row { bytes: Some([actor_bytes; 2]), ..Row::new(name, &[trial]) };
    rows.push(actor_row("SAC, shipped", ours.network(&shipped.network)?));
    let bytes = graph_bytes(&shipped.graph.1);
    rows.push(Row { bytes, ..Row::new("TPG, shipped", &[ours.graph(&shipped.graph)?]) });
    let both = ours.play(Acting::Both(&shipped.graph, &shipped.network, &shipped.setting))?;
    let bytes = bytes.map(|graph| graph.map(|graph| graph + actor_bytes));
    rows.push(Row { bytes, ..Row::of_hybrids("**hybrid, shipped**", &[both]) });
    for (row, time) in rows[classical..].iter_mut().zip([compiled.sac, compiled.tpg, compiled.hybrid]) {
        row.time = Some(time);
    }
    rows.extend(of_seeds(inputs, &shipped, &ours)?);
    Ok(rows)
}

/// Computes means over seeds, which predict another training, as opposed to a selected one.
fn of_seeds(inputs: &ProblemInputs, shipped: &Hybrid, ours: &Ours<'_>) -> Result<Vec<Row>, InputError> {
    let read = |path: &PathBuf| Ok((path.display().to_string(), read_graph(path)?));
    let graphs = inputs.tpg.iter().map(read).collect::<Result<Vec<(String, Graph)>, InputError>>()?;
    let read = |path: &PathBuf| Ok((path.display().to_string(), Network::read(path)?));
    let networks = inputs.sac.iter().map(read).collect::<Result<Vec<(String, Network)>, InputError>>()?;
    let ending = networks.iter().map(|network| ours.network(network)).collect::<Result<Vec<_>, _>>()?;
    let alone = graphs.iter().map(|graph| ours.graph(graph)).collect::<Result<Vec<_>, _>>()?;
    let mut together = Vec::new();
    for graph in &graphs {
        for network in &networks {
            together.push(ours.play(Acting::Both(graph, network, &shipped.setting))?);
        }
    }
    let mut rows = vec![
        Row::new("SAC, all seeds", &ending),
        Row::new("TPG, all seeds", &alone),
        Row::of_hybrids("hybrid, all pairs", &together),
    ];
    // Groups with a single policy are already listed above.
    rows.retain(|row| row.policies > 1);
    Ok(rows)
}
