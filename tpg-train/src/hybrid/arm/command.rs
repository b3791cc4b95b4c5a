//! The arm's part of `tpg-train hybrid`: the study of the paper's two parameters, under guards.

use super::choice::{self, Summary};
use super::cost::Costs;
use super::report;
use super::setting::{Detector, HybridFile};
use super::study::{Cell, Study, settings};
use super::trial::graph_alone;
use crate::arm_of;
use crate::files::{read_graph, write_atomically};
use crate::hybrid::command::{HybridArgs, StudyArgs};
use crate::hybrid::setting::Detector as AnyDetector;
use crate::hybrid::study::{self, Input, absolute, to_csv};
use crate::ranks::workplace::Workplace;
use crate::run_args::command_line;
use crate::sac::motors::MotorNetwork;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use tpg_arm::Arm;
use tpg_arm::hybrid::Guard;
use tpg_graph::Graph;
use tpg_graph::command::Verdict;
use tpg_graph::error::{InputError, Place};
use tpg_problems::arm::Config;
use tpg_problems::arm::targets::{Set, Start, tasks};

/// One row of `alone.csv`: a policy acting alone.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Alone {
    /// `tpg` or `sac`.
    pub kind: &'static str,
    /// Its position on the command line, from 0.
    pub place: usize,
    /// Its file.
    pub file: String,
    /// Fraction of the episodes that reached their target.
    pub success: f64,
    /// Fraction of the episodes that ended with an invalid action.
    pub collision: f64,
    /// Mean final distance.
    pub distance_mm: f64,
    /// Mean number of actions.
    pub actions: f64,
}

/// Content of `study.toml`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
struct Asked {
    problem: Start,
    episodes: usize,
    seed: u64,
    guards: Vec<String>,
    cycle_detectors: Vec<Detector>,
    tpg: Vec<Input>,
    policy: Vec<Input>,
    /// Of a configuration.
    #[serde(skip_serializing_if = "Option::is_none")]
    settings: Option<Config>,
}

/// Runs the study.
///
/// # Errors
/// Files that are not policies, settings that the arm does not have, a folder with another study, files that cannot be
/// written.
pub fn execute(args: &HybridArgs, start: Start, place: &impl Workplace) -> Result<Verdict, InputError> {
    let guards = if args.guard.is_empty() { Guard::ALL.to_vec() } else { args.guard.clone() };
    let detectors = detectors(args)?;
    let config = args.config.as_deref().map(|path| arm_of::config(path, start)).transpose()?;
    let args = &args.study;
    let tpgs = args.tpg.iter().map(|path| Ok((path.display().to_string(), read_graph(path)?)));
    let tpgs = tpgs.collect::<Result<Vec<_>, InputError>>()?;
    let arm = match &config {
        Some(config) => config.arm(),
        None => common_arm(&tpgs)?,
    };
    let sacs = args.policy.iter().map(|path| Ok((path.display().to_string(), MotorNetwork::read(path, Some(&arm))?)));
    let sacs = sacs.collect::<Result<Vec<_>, InputError>>()?;
    let problem = config.as_ref().map_or_else(|| sacs[0].1.tests(start), |config| config.problem(start));
    let asked = Asked {
        problem: start,
        episodes: args.episodes,
        seed: args.seed,
        guards: guards.iter().map(|guard| guard.name().to_owned()).collect(),
        cycle_detectors: detectors.clone(),
        tpg: Input::of(&args.tpg)?,
        policy: Input::of(&args.policy)?,
        settings: config,
    };
    let study = Study {
        tpgs,
        sacs,
        settings: settings(&guards, &detectors),
        arm,
        problem,
        tasks: tasks(&arm, args.seed, Set::Validation, start, args.episodes),
    };
    let threads = study::threads(args.threads)?;
    place.study(&study::identity(&asked), &threads, &|number| study::numbered(&study, number), |cells| {
        let folder = study::open_folder(&args.out, args.resume, &asked)?;
        let costs = Costs::measure(&study)?;
        let Some(cells) = study::in_folder(&study, &folder, cells)? else { return Ok(Verdict::Interrupted) };
        let alone = threads.install(|| alone(&study))?;
        finish(args, &study, &costs, &cells, &alone)?;
        Ok(Verdict::Good)
    })
}

/// Returns the arm that all graphs were trained for.
fn common_arm(tpgs: &[(String, Graph)]) -> Result<Arm<f64>, InputError> {
    let (first, graph) = &tpgs[0];
    let arm = arm_of::graph(first, graph)?;
    for (file, graph) in tpgs {
        if arm_of::graph(file, graph)? != arm {
            let accepted = format!("one for the arm of {first}, or --config");
            return Err(InputError::new(file, Place::Whole, "a graph for another arm", accepted));
        }
    }
    Ok(arm)
}

/// Returns the detectors asked for; the settings of other problems are refused.
fn detectors(args: &HybridArgs) -> Result<Vec<Detector>, InputError> {
    let refuse = |found: &str, accepted: &str| {
        let found = format!("{found} with --problem {}", args.problem.name());
        command_line(found, accepted)
    };
    let StudyArgs { hand_back_after, separation, patience, cycle_detector, .. } = &args.study;
    if !hand_back_after.is_empty() || !separation.is_empty() || !patience.is_empty() {
        let accepted = "the paper's settings: without them";
        return Err(refuse("--hand-back-after, --separation or --patience", accepted));
    }
    let of = |detector: &AnyDetector| match detector {
        AnyDetector::None => Err(refuse("--cycle-detector none", "visited, brent")),
        AnyDetector::Visited => Ok(Detector::Visited),
        AnyDetector::Brent => Ok(Detector::Brent),
    };
    if cycle_detector.is_empty() { Ok(vec![Detector::Visited]) } else { cycle_detector.iter().map(of).collect() }
}

fn alone(study: &Study) -> Result<Vec<Alone>, InputError> {
    let tpgs = (0..study.tpgs.len()).map(|place| ("tpg", place));
    let all: Vec<(&'static str, usize)> = tpgs.chain((0..study.sacs.len()).map(|place| ("sac", place))).collect();
    all.into_par_iter()
        .map(|(kind, place)| {
            let (file, trial) = if kind == "tpg" {
                let (file, graph) = &study.tpgs[place];
                (file, graph_alone(file, graph, &study.arm, study.problem.clone(), &study.tasks)?)
            } else {
                let (file, actor) = &study.sacs[place];
                let arm = study.arm.to_f32();
                (file, tpg_problems::arm::trial::run(&arm, &actor.policy(), study.problem.clone(), &study.tasks))
            };
            Ok(Alone {
                kind,
                place,
                file: file.clone(),
                success: trial.success_rate,
                collision: trial.collision_rate,
                distance_mm: trial.mean_distance_mm,
                actions: trial.mean_actions,
            })
        })
        .collect()
}

fn finish(args: &StudyArgs, study: &Study, costs: &Costs, cells: &[Cell], alone: &[Alone]) -> Result<(), InputError> {
    let summaries = choice::summarise(cells, &study.settings, costs);
    let file = |name: &str| args.out.join(name);
    write_atomically(&file("settings.csv"), &to_csv(summaries.iter()))?;
    write_atomically(&file("alone.csv"), &to_csv(alone.iter()))?;
    write_atomically(&file("timing.csv"), timing(study, costs).as_bytes())?;
    write_atomically(&file("report.html"), report::page(study.problem.start, cells, &summaries, alone).as_bytes())?;
    let Some(chosen) = summaries.iter().find(|summary| summary.chosen) else { return Ok(()) };
    if let Some(text) = best_pair(args, cells, chosen) {
        write_atomically(&file("hybrid.toml"), text.as_bytes())?;
    }
    if let Some(setting) = chosen.setting(cells) {
        tpg_graph::command::note(format_args!(
            "chosen: {}: {:.1} % success, {:.1} % collision, {:.2} mm, {:.0} % of the actions by the graph",
            setting.sentence(),
            100.0 * chosen.success,
            100.0 * chosen.collision,
            chosen.distance_mm,
            100.0 * chosen.tpg_action_ratio
        ));
    }
    Ok(())
}

/// Returns the chosen setting with the pair that has the highest success rate under it; ties go to the smaller final
/// distance.
fn best_pair(args: &StudyArgs, cells: &[Cell], chosen: &Summary) -> Option<String> {
    let better = |a: &&Cell, b: &&Cell| a.success.total_cmp(&b.success).then(b.distance_mm.total_cmp(&a.distance_mm));
    let best = cells.iter().filter(|cell| chosen.is_of(cell)).max_by(better)?;
    let file = HybridFile {
        graph: absolute(&args.tpg[best.tpg]),
        actor: absolute(&args.policy[best.sac]),
        hand_back_after: best.hand_back_after,
        separation_mm: best.separation_mm,
        guard: best.guard.clone(),
        cycle_detector: best.cycle_detector,
    };
    Some(toml::to_string(&file).expect("plain data"))
}

fn timing(study: &Study, costs: &Costs) -> String {
    let mut text = "what,ns_per_decision\n".to_owned();
    let files = study.tpgs.iter().map(|(file, _)| file).chain(study.sacs.iter().map(|(file, _)| file));
    for (file, ns) in files.zip(costs.tpg.iter().chain(&costs.sac)) {
        text += &format!("{file},{ns:.1}\n");
    }
    for (guard, ns) in Guard::ALL.iter().zip(costs.guards) {
        text += &format!("guard {},{ns:.1}\n", guard.name());
    }
    text
}
