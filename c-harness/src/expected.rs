//! The same problems on the host: the runtime's own definitions, the network as it was before packing.

use crate::Failure;
use crate::line::Line;
use crate::problems::{self, PARTS, problems, settings};
use crate::record::{Hash, code};
use crate::table;
use tpg_arm::binding;
use tpg_arm::cycle::Brent;
use tpg_arm::episode::{Episode, ReachTask};
use tpg_arm::hybrid::{Hybrid, HybridEpisode};
use tpg_arm::observation::{ArmPolicy, Observation};
use tpg_arm::sac::fixed::FixedPolicy;
use tpg_arm::{Arm, Move, Pose, WIDOWX};
use tpg_generated::{widowx_fs::WidowxFs, widowx_rs::WidowxRs, widowx_sac};
use tpg_problems::arm::targets::Start;
use tpg_runtime::policy::Policy;

const ARM: Arm<f32> = WIDOWX.to_f32();

pub(crate) const NETWORK: FixedPolicy<'static, 64, 64> =
    FixedPolicy { arm: &ARM, network: &widowx_sac::NETWORK, decision: widowx_sac::DECISION };

/// The lines of every scenario of sensor faults.
pub(crate) fn faults() -> Vec<Line> {
    let tpg = ArmPolicy::new(
        WidowxFs,
        &ARM,
        &const { binding::sources(WidowxFs::SOURCES) },
        &const { binding::moves(WidowxFs::MOVES) },
    );
    table::lines(&Hybrid { arm: &ARM, tpg, sac: NETWORK, settings: settings(Start::Fs) })
}

/// The lines of every episode, in the firmwares' order.
pub(crate) fn lines() -> Result<Vec<Line>, Failure> {
    let mut lines = Vec::new();
    let fs = ArmPolicy::new(
        WidowxFs,
        &ARM,
        &const { binding::sources(WidowxFs::SOURCES) },
        &const { binding::moves(WidowxFs::MOVES) },
    );
    let rs = ArmPolicy::new(
        WidowxRs,
        &ARM,
        &const { binding::sources(WidowxRs::SOURCES) },
        &const { binding::moves(WidowxRs::MOVES) },
    );
    let [fixed, random] = [problems(Start::Fs)?, problems(Start::Rs)?];
    hybrid(&mut lines, Start::Fs, fs.clone(), &fixed);
    hybrid(&mut lines, Start::Rs, rs.clone(), &random);
    single(&mut lines, Start::Fs, "graph", &fs, &fixed);
    single(&mut lines, Start::Rs, "graph", &rs, &random);
    single(&mut lines, Start::Fs, "network", &NETWORK, &fixed);
    single(&mut lines, Start::Rs, "network", &NETWORK, &random);
    Ok(lines)
}

fn hybrid<P>(lines: &mut Vec<Line>, start: Start, graph: P, problems: &[ReachTask<f32>])
where
    P: Policy<State = Observation<f32>, Action = Move>,
{
    let hybrid = Hybrid { arm: &ARM, tpg: graph, sac: NETWORK, settings: settings(start) };
    for (index, &problem) in problems.iter().enumerate() {
        let mut poses = Hash::new();
        let summary = HybridEpisode::new(&hybrid, problem, Brent::new()).run(|_, pose| poses.add_pose(pose));
        let counts = summary.counts;
        let who = [counts.tpg_actions, counts.sac_actions, counts.hand_overs.iter().sum()];
        let end = (code(summary.summary.outcome), summary.summary.actions, summary.summary.pose);
        lines.push(line(start, "hybrid", index, end, who, &poses));
    }
}

fn single<P>(lines: &mut Vec<Line>, start: Start, name: &str, policy: &P, problems: &[ReachTask<f32>])
where
    P: Policy<State = Observation<f32>, Action = Move>,
{
    for (index, &problem) in problems.iter().take(PARTS).enumerate() {
        let mut poses = Hash::new();
        let summary = Episode::new(&ARM, problem, Brent::new()).run(policy, |pose| poses.add_pose(pose));
        lines.push(line(start, name, index, (code(summary.outcome), summary.actions, summary.pose), [0; 3], &poses));
    }
}

fn line(start: Start, name: &str, index: usize, end: (i32, u32, Pose), who: [u32; 3], poses: &Hash) -> Line {
    let (outcome, actions, Pose([base, shoulder, elbow, wrist])) = end;
    let [graph, network, switches] = who;
    Line::parse(&format!(
        "episode {} {name} index={index} outcome={outcome} actions={actions} graph={graph} network={network} \
         switches={switches} base={base} shoulder={shoulder} elbow={elbow} wrist={wrist} poses={:016x}",
        problems::name(start),
        poses.0
    ))
}
