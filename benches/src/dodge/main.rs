//! The arm among balls: every rival on the committed test scenes, success and hits with 95 % intervals, as a table.
//!
//! `cargo run --release -p tpg-benches --bin dodge -- generated/test-targets/dodge.csv`

mod rival;

use clap::Parser;
use rival::{ByHand, Clairvoyant, OneStepSearch, PotentialField, Replanner, Rival, StopAndWait, Straight};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;
use tpg_arm::dodge::Behaviour;
use tpg_engine::confidence;
use tpg_problems::dodge::Config;
use tpg_problems::dodge::draw::Certified;
use tpg_problems::dodge::episode::{End, Episode};
use tpg_problems::dodge::file::read_csv;
use tpg_problems::{Problem, ProblemSettings};

/// Runs every rival on scenes and prints a table in Markdown.
#[derive(Debug, Parser)]
struct Args {
    /// The scenes, as `tpg-train targets --problem dodge` prints them
    scenes: PathBuf,
    /// The problem's settings, as `tpg-train eval` takes them
    #[arg(long, value_name = "FILE")]
    config: Option<PathBuf>,
    /// The replanner with 64 samples too, which takes minutes
    #[arg(long)]
    slow: bool,
}

/// The outcomes of the scenes.
#[derive(Default)]
struct DodgeTally {
    ends: [usize; 3],
    /// Of those with a ball that stays: the number, and the successes.
    still: [usize; 2],
    steps: u64,
    steps_of_successes: u64,
}

fn main() -> ExitCode {
    let args = Args::parse();
    let scenes = match read_csv(&args.scenes) {
        Ok(scenes) => scenes,
        Err(error) => {
            eprintln!("{error}");
            return ExitCode::from(2);
        }
    };
    let config = match args.config.as_deref().map_or(Ok(Config::default()), settings) {
        Ok(config) => config,
        Err(message) => {
            eprintln!("{message}");
            return ExitCode::from(2);
        }
    };
    println!("| policy | success % | hits % | time-outs % | with a static ball % | steps of a success | ns a step |");
    println!("| --- | --- | --- | --: | --: | --: | --: |");
    let settings = config.settings();
    let show = |name: &str, rival: &mut dyn Rival, scenes: &[Certified]| show(&config, name, rival, scenes);
    show("straight walk", &mut Straight, &scenes);
    show("stop and wait, 32 steps", &mut StopAndWait { horizon: 32 }, &scenes);
    show("stop and wait, 96 steps", &mut StopAndWait { horizon: 96 }, &scenes);
    show("potential field", &mut PotentialField::default(), &scenes);
    show("field with escape script", &mut PotentialField::escaping(20, 40), &scenes);
    show("one-step search, 82 moves", &mut OneStepSearch, &scenes);
    show("replanner, 16 samples", &mut Replanner::new(16), &scenes);
    if args.slow {
        show("replanner, 64 samples", &mut Replanner::new(64), &scenes);
    }
    let plan = |_: &_| Behaviour::Plan;
    show("the search's plan, always", &mut ByHand::new(settings, plan), &scenes);
    let unguarded = tpg_arm::dodge::DodgerSettings { guard: false, ..settings };
    show("the same without the guard", &mut ByHand::new(unguarded, plan), &scenes);
    let selection = ByHand::new(settings, |dodger| {
        if dodger.scout().fate().free_steps() < 20 { Behaviour::FieldPlan } else { Behaviour::Plan }
    });
    show("the plan, in the field while it meets something within 20 steps", &mut { selection }, &scenes);
    let plans = scenes.iter().map(|certified| certified.plan.clone()).collect();
    show("clairvoyant: the certificate", &mut Clairvoyant::new(plans), &scenes);
    ExitCode::SUCCESS
}

/// The settings that a configuration has for the arm among balls.
fn settings(path: &Path) -> Result<Config, String> {
    let file = path.display().to_string();
    let text = std::fs::read_to_string(path).map_err(|error| format!("{file}: {error}"))?;
    let problem = Problem::from_toml(&file, &text).map_err(|error| error.to_string())?;
    let name = problem.name().name();
    match problem.settings {
        ProblemSettings::Dodge(config) => Ok(config),
        _ => Err(format!("{file}: the problem {name}, expected dodge")),
    }
}

fn show(config: &Config, name: &str, rival: &mut dyn Rival, scenes: &[Certified]) {
    let began = Instant::now();
    let tally = run(config, rival, scenes);
    let nanoseconds = began.elapsed().as_nanos() as f64 / tally.steps as f64;
    let count = scenes.len();
    let rate = |part: usize| {
        let [low, high] = confidence(part as f64 / count as f64, count);
        format!("{:.1} ({:.1} to {:.1})", 100.0 * part as f64 / count as f64, 100.0 * low, 100.0 * high)
    };
    let [reached, hit, timeout] = tally.ends;
    println!(
        "| {name} | {} | {} | {:.1} | {:.1} | {:.0} | {nanoseconds:.0} |",
        rate(reached),
        rate(hit),
        100.0 * timeout as f64 / count as f64,
        100.0 * tally.still[1] as f64 / tally.still[0].max(1) as f64,
        tally.steps_of_successes as f64 / reached.max(1) as f64,
    );
}

fn run(config: &Config, rival: &mut dyn Rival, scenes: &[Certified]) -> DodgeTally {
    let body = config.body();
    let mut tally = DodgeTally::default();
    for Certified { scene, .. } in scenes {
        let mut episode = Episode::sensed(&body, scene, config.sensing());
        rival.begin(&body, scene, &episode.view(&body));
        let end = loop {
            let step = rival.step(&episode.view(&body));
            if let Some(end) = episode.step(&body, step, config.tolerance) {
                break end;
            }
        };
        let steps = u64::from(episode.steps());
        let reached = end == End::Reached;
        tally.ends[end as usize] += 1;
        tally.steps += steps;
        tally.steps_of_successes += if reached { steps } else { 0 };
        if scene.balls.iter().any(|ball| ball.period == 0.0) {
            tally.still[0] += 1;
            tally.still[1] += usize::from(reached);
        }
    }
    tally
}
