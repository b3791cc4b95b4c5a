//! Drives the simulated arm to a list of targets and prints a line an episode, as `firmware-c/control.c` does: by the
//! hybrid, and by each of its parts alone. The graphs are of profile `fast`, as in C.

#![no_std]
#![no_main]

use cortex_m_rt::entry;
use tpg_arm::binding;
use tpg_arm::cycle::Brent;
use tpg_arm::episode::{Episode, Outcome, ReachTask};
use tpg_arm::hybrid::{Chosen, Driver, Hybrid, HybridEpisode, Settings, Switch};
use tpg_arm::observation::{ArmPolicy, Observation};
use tpg_arm::sac::packed::{Model, PackedPolicy};
use tpg_arm::{Arm, Move, Pose, WIDOWX};
use tpg_firmware::record::code;
use tpg_firmware::{Counter, Report, Tally, paint_stack, run, stack_used};
use tpg_generated::{
    widowx_fs_fast::WidowxFsFast, widowx_fs_hybrid, widowx_rs_fast::WidowxRsFast, widowx_rs_hybrid, widowx_sac,
};
use tpg_runtime::policy::Policy;

include!(concat!(env!("TPG_GENERATED"), "/problems.rs"));

static ARM: Arm<f32> = WIDOWX.to_f32();

type Network = PackedPolicy<'static, { widowx_sac::SCRATCH }>;

/// Prints the line of an episode: how it ended, and what it took.
fn tell(tally: &Tally, line: Report, index: u32, outcome: Outcome, [graph, network, switches]: [u32; 3], pose: Pose) {
    let [base, shoulder, elbow, wrist] = pose.0.map(i32::from);
    let line = line
        .unsigned("index", index)
        .number("outcome", code(outcome))
        .unsigned("actions", tally.actions)
        .unsigned("graph", graph)
        .unsigned("network", network)
        .unsigned("switches", switches)
        .number("base", base)
        .number("shoulder", shoulder)
        .number("elbow", elbow)
        .number("wrist", wrist)
        .hexadecimal("poses", tally.hash.0);
    tally.costs(line).print();
}

/// One decision of a hybrid. A function of its own in the image, so that its worst case can be bounded.
#[inline(never)]
fn hybrid_decide<P>(episode: &mut HybridEpisode<'_, f32, P, Network, Brent>) -> Chosen
where
    P: Policy<State = Observation<f32>, Action = Move>,
{
    episode.decide()
}

/// The most bytes of stack that a decision takes in some episodes, its caller's not included.
fn stack<P>(hybrid: &Hybrid<'_, f32, P, Network>, problems: &[ReachTask<f32>]) -> u32
where
    P: Policy<State = Observation<f32>, Action = Move>,
{
    let mut deepest = 0;
    for &problem in problems.iter().take(8) {
        let mut episode = HybridEpisode::new(hybrid, problem, Brent::new());
        loop {
            let here = paint_stack();
            let chosen = hybrid_decide(&mut episode);
            deepest = deepest.max(stack_used(here));
            if episode.act(chosen).is_some() {
                break;
            }
        }
    }
    deepest
}

fn hybrids<P>(
    counter: &mut Counter,
    set: &str,
    graph: P,
    network: Network,
    settings: Settings<f32>,
    problems: &[ReachTask<f32>],
) where
    P: Policy<State = Observation<f32>, Action = Move>,
{
    let hybrid = Hybrid { arm: &ARM, tpg: graph, sac: network, settings };
    Report::new("decision ").word(set).unsigned("stack", stack(&hybrid, problems)).print();
    for (index, &problem) in (0..).zip(problems) {
        let mut episode = HybridEpisode::new(&hybrid, problem, Brent::new());
        let mut tally = Tally::new();
        loop {
            let (chosen, instructions) = counter.measure(|| hybrid_decide(&mut episode));
            let outcome = episode.act(chosen);
            tally.add(instructions);
            tally.hash.add_pose(episode.observation().pose);
            if let Some(outcome) = outcome {
                let counts = episode.switch().counts();
                let switches = counts.hand_overs.iter().fold(0u32, |sum, &count| sum.wrapping_add(count));
                let decided = [counts.tpg_actions, counts.sac_actions, switches];
                let line = Report::new("episode ").word(set).word(" hybrid");
                tell(&tally, line, index, outcome, decided, episode.observation().pose);
                break;
            }
        }
    }
}

fn singles<P>(counter: &mut Counter, set: &str, name: &str, policy: &P, problems: &[ReachTask<f32>])
where
    P: Policy<State = Observation<f32>, Action = Move>,
{
    for (index, &problem) in (0..).zip(problems).take(PARTS) {
        let mut episode = Episode::new(&ARM, problem, Brent::new());
        let mut tally = Tally::new();
        loop {
            let (wanted, instructions) = counter.measure(|| policy.decide(episode.observation()));
            let outcome = episode.advance(wanted);
            tally.add(instructions);
            tally.hash.add_pose(episode.observation().pose);
            if let Some(outcome) = outcome {
                let line = Report::new("episode ").word(set).word(" ").word(name);
                tell(&tally, line, index, outcome, [0; 3], episode.observation().pose);
                break;
            }
        }
    }
}

/// Counts the work of a controller beside its decision: it observes the arm and tells the switch.
fn around(counter: &mut Counter) {
    let Some(&problem) = RS_PROBLEMS.first() else { return };
    let (seen, observe) =
        counter.measure(|| Observation::at(&ARM, core::hint::black_box(problem.start), problem.target));
    let mut switch = Switch::new(widowx_rs_hybrid::SETTINGS, Brent::new(), &seen);
    let chosen = Chosen { driver: Driver::Tpg, wanted: Move([3, 0, 0, 0]) };
    let (_, acted) = counter.measure(|| switch.acted(core::hint::black_box(chosen), &seen));
    Report::new("around").unsigned("observe", observe).unsigned("switch", acted).print();
}

#[entry]
fn main() -> ! {
    run(|counter| {
        let network = Network::new(&ARM, Model::parse(&widowx_sac::MODEL).ok()?)?;
        let fs = ArmPolicy::new(
            WidowxFsFast,
            &ARM,
            &const { binding::sources(WidowxFsFast::SOURCES) },
            &const { binding::moves(WidowxFsFast::MOVES) },
        );
        let rs = ArmPolicy::new(
            WidowxRsFast,
            &ARM,
            &const { binding::sources(WidowxRsFast::SOURCES) },
            &const { binding::moves(WidowxRsFast::MOVES) },
        );
        around(counter);
        hybrids(counter, "fs", fs.clone(), network, widowx_fs_hybrid::SETTINGS, &FS_PROBLEMS);
        hybrids(counter, "rs", rs.clone(), network, widowx_rs_hybrid::SETTINGS, &RS_PROBLEMS);
        singles(counter, "fs", "graph", &fs, &FS_PROBLEMS);
        singles(counter, "rs", "graph", &rs, &RS_PROBLEMS);
        singles(counter, "fs", "network", &network, &FS_PROBLEMS);
        singles(counter, "rs", "network", &network, &RS_PROBLEMS);
        Some(())
    })
}
