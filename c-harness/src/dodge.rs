//! The control step among balls: the first test scenes with the shipped graph, run here and written down for the firmware,
//! which must come to the same motor positions.
//!
//! A firmware has no model of how balls fly: it gets where they were seen, step by step.

use crate::Failure;
use crate::build::graph_in_c;
use crate::line::{self, Line};
use crate::record::Hash;
use askama::Template;
use tpg_arm::Pose;
use tpg_arm::dodge::{Behaviour, Chooser, DodgeControl, DodgeSource};
use tpg_arm::kinematics::Vector;
use tpg_arm::sensors::Watch;
use tpg_codegen::emit::File;
use tpg_generated::dodge::Dodge;
use tpg_problems::dodge::episode::{End, Episode};
use tpg_problems::dodge::file::read_csv;
use tpg_problems::dodge::scene::Scene;
use tpg_problems::dodge::{BODY, DodgeConfig};
use tpg_testing::library;

/// Scenes that are run.
const SCENES: usize = 100;

/// A scene as it went here.
struct DodgeRollout {
    scene: Scene,
    end: End,
    steps: u32,
    /// The place of its first one among the [centres](Rollouts::centres).
    first: usize,
}

/// All scenes as they went here, in C for the firmware.
#[derive(Template)]
#[template(path = "balls.c", escape = "none")]
struct Rollouts {
    rollouts: Vec<DodgeRollout>,
    /// The places where each ball was seen: before the first step, and in every step.
    centres: Vec<Vector<f32>>,
}

/// Runs the scenes here: each, and a hash of every pose.
fn run() -> Result<(Rollouts, Hash), Failure> {
    let config = DodgeConfig::default();
    let (body, settings) = (&BODY, config.settings());
    let chooser = Chooser { policy: Dodge, sources: &DodgeSource::ALL, behaviours: &Behaviour::ALL };
    let choose = |values: &_| chooser.choose(values);
    let (mut poses, mut centres) = (Hash::new(), Vec::new());
    let rollout = |scene: Scene| {
        let goals: Vec<Pose> = scene.goals.iter().copied().map(Pose).collect();
        let mut episode = Episode::new(&scene);
        let first = centres.len();
        centres.extend(scene.balls.iter().map(|path| path.at(-1.0)));
        let begun = DodgeControl::new(body, settings, Watch::DEFAULT, &goals, episode.pose(), episode.view().balls);
        let mut control = begun?;
        let end = loop {
            let view = episode.view();
            centres.extend(view.balls.iter().map(|ball| ball.at));
            let step = control.step(body, &choose, view.pose, view.balls)?;
            let end = episode.step(step.wanted, config.tolerance);
            poses.add_pose(episode.pose());
            if let Some(end) = end {
                break end;
            }
        };
        Ok(DodgeRollout { end, steps: episode.steps(), first, scene })
    };
    let path = library::top().join("generated/test-targets/dodge.csv");
    let scenes = read_csv(&path)?.into_iter().take(SCENES).map(|certified| certified.scene);
    let rollouts = scenes.map(rollout).collect::<Result<_, Failure>>()?;
    Ok((Rollouts { rollouts, centres }, poses))
}

/// The shipped graph and the scenes in C.
pub(crate) fn files() -> Result<Vec<File>, Failure> {
    let mut files = graph_in_c("generated/dodge/graph.json")?;
    let (scenes, _) = run()?;
    // The header with the declarations is written by hand: linters would take minutes over all these numbers.
    files.push(File { name: "balls.c".to_owned(), text: scenes.render()? });
    Ok(files)
}

/// Compares a firmware's motor positions with this machine's.
pub(crate) fn check(lines: &[Line]) -> Result<(), Failure> {
    let (Rollouts { rollouts: scenes, .. }, poses) = run()?;
    let steps: u64 = scenes.iter().map(|rollout| u64::from(rollout.steps)).sum();
    line::check("firmware", lines, "cost dodge scenes", steps, &poses)?;
    let reached = scenes.iter().filter(|rollout| rollout.end == End::Reached).count();
    println!(
        "{} scenes among balls, {reached} targets reached, {steps} steps: every position as on the host",
        scenes.len()
    );
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{check, run};
    use crate::line::Line;

    #[test]
    fn one_other_bit_is_a_failure() {
        let (scenes, poses) = run().expect("committed scenes");
        let steps: u32 = scenes.rollouts.iter().map(|rollout| rollout.steps).sum();
        let checked = |steps: u32, hash: u64| {
            let text = format!("cost dodge scenes actions={steps} instructions=1 worst=1 hash={hash:016x}");
            check(&[Line::parse(&text)])
        };
        assert!(checked(steps, poses.0).is_ok());
        assert!(checked(steps, poses.0 ^ 1).is_err());
        assert!(checked(steps - 1, poses.0).is_err());
    }
}
