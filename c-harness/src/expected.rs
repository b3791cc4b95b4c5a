//! The same problems on the host, by generated Rust.

use crate::Failure;
use crate::line::Line;
use crate::problems::{self, PARTS, problems, settings};
use crate::record::Hash;
use Start::*;
use tpg_arm::binding;
use tpg_arm::cycle::Brent;
use tpg_arm::hybrid::{Control, Counts, Hybrid};
use tpg_arm::observation::{ArmPolicy, Observation, Source};
use tpg_arm::sac::packed::{Model, PackedPolicy};
use tpg_arm::sensors::{Fault, Limits, Watch};
use tpg_arm::{Arm, Move, Pose, WIDOWX};
use tpg_generated::{widowx_fs::WidowxFs, widowx_rs::WidowxRs, widowx_sac};
use tpg_problems::arm::targets::{Start, TOLERANCE, Task};
use tpg_runtime::policy::Policy;

pub(crate) const ARM: Arm<f32> = WIDOWX.to_f32();

/// The shipped network.
pub(crate) fn network() -> impl Policy<State = Observation<f32>, Action = Move> {
    let model = Model::parse(&widowx_sac::MODEL).expect("a committed model");
    PackedPolicy::<{ widowx_sac::SCRATCH }>::new(&ARM, model).expect("its own scratch memory")
}

/// The shipped graph for a fixed start, on the arm.
pub(crate) fn fs() -> impl Policy<State = Observation<f32>, Action = Move> + Clone {
    const SOURCES: [Source; WidowxFs::SOURCES.len()] = binding::sources(WidowxFs::SOURCES);
    const MOVES: [Move; WidowxFs::MOVES.len()] = binding::moves(WidowxFs::MOVES);
    ArmPolicy::new(WidowxFs, &ARM, &SOURCES, &MOVES)
}

/// The shipped graph for a random start.
fn rs() -> impl Policy<State = Observation<f32>, Action = Move> + Clone {
    const SOURCES: [Source; WidowxRs::SOURCES.len()] = binding::sources(WidowxRs::SOURCES);
    const MOVES: [Move; WidowxRs::MOVES.len()] = binding::moves(WidowxRs::MOVES);
    ArmPolicy::new(WidowxRs, &ARM, &SOURCES, &MOVES)
}

/// Checks that every episode is as on the host: its end, the actions of each policy, and a hash of every motor position.
pub(crate) fn check(place: &str, lines: &[Line]) -> Result<(), Failure> {
    same(place, &self::lines()?, lines)
}

/// Compares the lines of episodes with the expected ones.
pub(crate) fn same(place: &str, expected: &[Line], lines: &[Line]) -> Result<(), Failure> {
    let found = lines.iter().filter(|line| line.starts_with("episode"));
    let found: Vec<Line> = found.map(|line| line.clone().without(&["instructions", "worst"])).collect();
    if let Some((wanted, found)) = expected.iter().zip(&found).find(|(wanted, found)| wanted != found) {
        return Err(Failure(format!("{place} is not the host: {found:?}, not {wanted:?}")));
    }
    if found.len() != expected.len() {
        return Err(Failure(format!("{place}: {} episodes, not {}", found.len(), expected.len())));
    }
    let actions: u64 = found.iter().map(|line| line.number("actions")).sum();
    println!("{place}: {} episodes, {actions} actions: every position as on the host", found.len());
    Ok(())
}

/// The lines of every episode, in the firmwares' order.
pub(crate) fn lines() -> Result<Vec<Line>, Failure> {
    let mut lines = Vec::new();
    let (fs, rs) = (fs(), rs());
    let [fixed, random] = [problems(Fs)?, problems(Rs)?];
    hybrid(&mut lines, Fs, fs.clone(), &fixed)?;
    hybrid(&mut lines, Rs, rs.clone(), &random)?;
    single(&mut lines, Fs, "graph", &fs, &fixed)?;
    single(&mut lines, Rs, "graph", &rs, &random)?;
    single(&mut lines, Fs, "network", &network(), &fixed)?;
    single(&mut lines, Rs, "network", &network(), &random)?;
    Ok(lines)
}

fn hybrid<P>(lines: &mut Vec<Line>, start: Start, graph: P, tasks: &[Task]) -> Result<(), Failure>
where
    P: Policy<State = Observation<f32>, Action = Move>,
{
    let hybrid = Hybrid { arm: &ARM, tpg: graph, sac: network(), settings: settings(start) };
    for (index, task) in tasks.iter().enumerate() {
        let target = task.target.map(|mm| mm as f32);
        let seen = Observation::at(&ARM, task.start, target);
        let begun = Control::new(Limits::new(&ARM), hybrid.settings, Watch::DEFAULT, Brent::new(), &seen);
        let mut control = begun?;
        let rollout = ArmRollout::new(start, task, |motors| {
            let (seen, chosen) = hybrid.step(&mut control, motors, target)?;
            Ok((seen, chosen.wanted, false))
        });
        let Counts { tpg_actions, sac_actions, hand_overs, .. } = *control.switch().counts();
        lines.push(rollout?.line(start, "hybrid", index, [tpg_actions, sac_actions, hand_overs.iter().sum()]));
    }
    Ok(())
}

fn single<P>(lines: &mut Vec<Line>, start: Start, name: &str, policy: &P, tasks: &[Task]) -> Result<(), Failure>
where
    P: Policy<State = Observation<f32>, Action = Move>,
{
    for (index, task) in tasks.iter().take(PARTS).enumerate() {
        let rollout = ArmRollout::new(start, task, |motors| {
            let seen = Observation::at(&ARM, motors, task.target.map(|mm| mm as f32));
            let wanted = policy.decide(&seen);
            Ok((seen, wanted, wanted == Move::STOP))
        });
        lines.push(rollout?.line(start, name, index, [0; 3]));
    }
    Ok(())
}

/// An episode as it went here.
struct ArmRollout {
    reached: bool,
    actions: u32,
    motors: Pose,
    poses: Hash,
}

impl ArmRollout {
    /// Goes until the hand is at the target, a move is not valid, `decide` gives up, or time is up; `decide` returns what it sees, a
    /// move, and whether it gives up.
    fn new(
        start: Start,
        task: &Task,
        mut decide: impl FnMut(Pose) -> Result<(Observation<f32>, Move, bool), Fault>,
    ) -> Result<Self, Failure> {
        let mut rollout = Self { reached: false, actions: 0, motors: task.start, poses: Hash::new() };
        while rollout.actions < start.max_actions() {
            let (seen, wanted, gives_up) = decide(rollout.motors)?;
            rollout.reached = seen.distance() < TOLERANCE as f32;
            let step = ARM.step(rollout.motors, if rollout.reached { Move::STOP } else { wanted });
            rollout.motors = step.pose;
            rollout.actions += 1;
            rollout.poses.add_pose(step.pose);
            if rollout.reached || step.invalid.is_some() || gives_up {
                break;
            }
        }
        Ok(rollout)
    }

    fn line(&self, start: Start, name: &str, index: usize, [graph, network, switches]: [u32; 3]) -> Line {
        let Self { reached, actions, motors: Pose([base, shoulder, elbow, wrist]), poses } = self;
        Line::parse(&format!(
            "episode {} {name} index={index} reached={} actions={actions} graph={graph} network={network} \
             switches={switches} base={base} shoulder={shoulder} elbow={elbow} wrist={wrist} poses={:016x}",
            problems::name(start),
            u8::from(*reached),
            poses.0
        ))
    }
}
