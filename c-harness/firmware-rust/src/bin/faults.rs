//! The table of sensor faults on the target, and what the checks cost.

#![no_std]
#![no_main]

#[path = "../../../src/faults.rs"]
mod faults;
#[path = "../../../src/scenarios.rs"]
mod scenarios;

use core::hint::black_box;
use cortex_m_rt::entry;
use scenarios::SCENARIOS;
use tpg_arm::binding;
use tpg_arm::cycle::Brent;
use tpg_arm::episode::ReachTask;
use tpg_arm::hybrid::{Chosen, Control, Hybrid, Switch};
use tpg_arm::observation::{ArmPolicy, Observation};
use tpg_arm::sac::packed::{Model, PackedPolicy};
use tpg_arm::sensors::{Fault, Watch};
use tpg_arm::{Arm, Move, Pose, WIDOWX};
use tpg_firmware::{Counter, Report, Tally, exit, record, run};
use tpg_generated::{widowx_fs_fast::WidowxFsFast, widowx_fs_hybrid, widowx_sac};
use tpg_runtime::policy::Policy;

include!(concat!(env!("TPG_GENERATED"), "/problems.rs"));

static ARM: Arm<f32> = WIDOWX.to_f32();

type Network = PackedPolicy<'static, { widowx_sac::SCRATCH }>;

/// Steps of an episode that are counted.
const STEPS: u32 = 1707;

/// Whole control steps along episodes, with the checks of readings and without: observe, tell the switch, decide.
fn costs<P>(counter: &mut Counter, hybrid: &Hybrid<'_, f32, P, Network>)
where
    P: Policy<State = Observation<f32>, Action = Move>,
{
    let [mut with, mut without] = [Tally::new(); 2];
    for &ReachTask { start, target, tolerance, .. } in FS_PROBLEMS.iter().take(PARTS) {
        let mut motors = start;
        let mut seen = Observation::at(&ARM, motors, target);
        let Ok(mut control) = Control::new(&ARM, hybrid.settings, Watch::DEFAULT, Brent::new(), &seen) else {
            exit(false)
        };
        let mut switch = Switch::new(hybrid.settings, Brent::new(), &seen);
        // What is kept about a target is computed before, so that neither way pays for it alone.
        black_box(hybrid.decide(&mut switch.clone(), &seen));
        let mut executed = None;
        for _ in 0..STEPS {
            let reading = black_box(motors);
            let (chosen, instructions) = counter.measure(|| checked(hybrid, &mut control, reading, &target, &mut seen));
            with.add(instructions);
            let mut again = seen;
            let (same, instructions) =
                counter.measure(|| unchecked(hybrid, &mut switch, reading, &target, &mut again, &mut executed));
            without.add(instructions);
            let Ok(chosen) = chosen else { exit(false) };
            if same != chosen || again != seen {
                exit(false);
            }
            if seen.distance() < tolerance {
                break;
            }
            motors = ARM.step(motors, chosen.wanted).pose;
        }
        black_box(&seen);
    }
    with.print("cost fs step");
    without.print("cost fs step without checks");
}

#[inline(never)]
fn checked<P>(
    hybrid: &Hybrid<'_, f32, P, Network>,
    control: &mut Control<f32, Brent>,
    motors: Pose,
    target: &[f32; 3],
    seen: &mut Observation<f32>,
) -> Result<Chosen, Fault>
where
    P: Policy<State = Observation<f32>, Action = Move>,
{
    hybrid.step_into(control, motors, target, seen)
}

#[inline(never)]
fn unchecked<P>(
    hybrid: &Hybrid<'_, f32, P, Network>,
    switch: &mut Switch<f32, Brent>,
    motors: Pose,
    target: &[f32; 3],
    seen: &mut Observation<f32>,
    executed: &mut Option<Chosen>,
) -> Chosen
where
    P: Policy<State = Observation<f32>, Action = Move>,
{
    *seen = Observation::at(hybrid.arm, motors, *target);
    if let Some(executed) = *executed {
        switch.acted(executed, seen);
    }
    let chosen = hybrid.decide(switch, seen);
    *executed = Some(chosen);
    chosen
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
        let hybrid = Hybrid { arm: &ARM, tpg: fs, sac: network, settings: widowx_fs_hybrid::SETTINGS };
        for scenario in &SCENARIOS {
            let log = faults::run(&hybrid, scenario);
            let [ok, target, sensor, stuck] = log.codes;
            let [graph, network] = log.actions;
            let [base, shoulder, elbow, wrist] = log.motors.0.map(i32::from);
            Report::new("fault ")
                .word(scenario.name)
                .unsigned("ok", ok)
                .unsigned("target", target)
                .unsigned("sensor", sensor)
                .unsigned("stuck", stuck)
                .unsigned("broken", log.broken)
                .unsigned("graph", graph)
                .unsigned("network", network)
                .number("base", base)
                .number("shoulder", shoulder)
                .number("elbow", elbow)
                .number("wrist", wrist)
                .hexadecimal("log", log.hash.0)
                .print();
        }
        costs(counter, &hybrid);
        Some(())
    })
}
