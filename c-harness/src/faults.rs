//! Runs the table of sensor faults against a simulated arm, in Rust: on the host, and in the firmware.
//!
//! Every step is checked against the contract: the code that the table asks for; with any other code than OK a move of zero
//! and a switch that is as before; no move of more than 3 ticks.
#![allow(dead_code, reason = "each of the programs that include this file uses a part")]

use crate::record::Hash;
use crate::scenarios::{BAD_SENSOR, BAD_TARGET, FAR_TARGET, GOOD_TARGET, OK, Phase, Reading, STUCK, Scenario, Target};
use Reading::*;
use tpg_arm::cycle::Brent;
use tpg_arm::hybrid::{Chosen, Control, Driver, Hybrid};
use tpg_arm::observation::Observation;
use tpg_arm::sensors::{Fault, Watch};
use tpg_arm::{Move, Pose};
use tpg_runtime::policy::Policy;

/// Steps that a reading may be late.
const REMEMBERED: usize = 32;

/// The run of a scenario.
pub(crate) struct Log {
    /// Steps by code: OK, bad target, bad sensor, stuck.
    pub(crate) codes: [u32; 4],
    /// The first step that broke the contract, counted from 1; 0 for none.
    pub(crate) broken: u32,
    /// Actions of the graph and of the network, as the switch counted them.
    pub(crate) actions: [u32; 2],
    /// The motors' last positions.
    pub(crate) motors: Pose,
    /// Code, move and driver of every step.
    pub(crate) hash: Hash,
}

/// The simulated arm: where the motors are, and have been.
struct FaultWorld {
    motors: Pose,
    past: [Pose; REMEMBERED],
    steps: usize,
}

impl FaultWorld {
    /// The measured places of the motors.
    fn reading(&self, phase: &Phase, odd: bool) -> Pose {
        let Pose(mut ticks) = self.motors;
        let joint = usize::from(phase.joint);
        let there = ticks.get(joint).copied().unwrap_or_default();
        let read = match phase.reading {
            Late => {
                let then = self.steps.saturating_sub(phase.amount.unsigned_abs().into());
                return self.past.get(then % REMEMBERED).copied().unwrap_or_default();
            }
            Jump => there.saturating_add(phase.amount),
            Fixed => phase.amount,
            Flicker if !odd => phase.amount,
            _ => there,
        };
        ticks.get_mut(joint).into_iter().for_each(|ticks| *ticks = read);
        Pose(ticks)
    }

    /// The motors do what they were told, as far as the phase lets them.
    fn advance<T, P>(&mut self, hybrid: &Hybrid<'_, f32, T, P>, phase: &Phase, Move(mut wanted): Move) {
        match phase.reading {
            Stuck => wanted = [0; 4],
            JointStuck => wanted.get_mut(usize::from(phase.joint)).into_iter().for_each(|delta| *delta = 0),
            _ => {}
        }
        self.motors = hybrid.arm.step(self.motors, Move(wanted)).pose;
        self.steps += 1;
        if let Some(slot) = self.past.get_mut(self.steps % REMEMBERED) {
            *slot = self.motors;
        }
    }
}

/// An observation with a wrong hand or difference; `None` in the other phases.
fn garbled<T, P>(
    hybrid: &Hybrid<'_, f32, T, P>,
    motors: Pose,
    target: [f32; 3],
    reading: Reading,
) -> Option<Observation<f32>> {
    let mut seen = Observation::at(hybrid.arm, motors, target);
    match reading {
        HandNan => seen.hand[1] = f32::NAN,
        DifferenceInfinite => seen.difference[2] = f32::NEG_INFINITY,
        HandOff => seen.hand[0] += 50.0,
        HandInfinite => {
            seen.hand[0] = f32::INFINITY;
            seen.difference[0] = f32::NEG_INFINITY;
        }
        _ => return None,
    }
    Some(seen)
}

fn code<T>(result: &Result<T, Fault>) -> i32 {
    match result {
        Ok(_) => OK,
        Err(Fault::Target) => BAD_TARGET,
        Err(Fault::Sensor) => BAD_SENSOR,
        Err(Fault::Stuck) => STUCK,
    }
}

fn target_of(phase: &Phase) -> [f32; 3] {
    let [x, y, z] = GOOD_TARGET;
    match phase.target {
        Target::Good => GOOD_TARGET,
        Target::Nan => [x, f32::NAN, z],
        Target::Infinite => [f32::INFINITY, y, z],
        Target::Huge => [x, y, -1e38],
        Target::Far => FAR_TARGET,
    }
}

/// A loop's first reading, if it may begin.
fn begun<T, P>(
    hybrid: &Hybrid<'_, f32, T, P>,
    scenario: &Scenario,
    motors: Pose,
    target: [f32; 3],
) -> Result<Control<f32, Brent>, Fault> {
    let (threshold, patience) = scenario.watch;
    let seen = Observation::at(hybrid.arm, motors, target);
    Control::new(hybrid.arm, hybrid.settings, Watch { threshold, patience }, Brent::new(), &seen)
}

/// Runs a scenario.
pub(crate) fn run<T, P>(hybrid: &Hybrid<'_, f32, T, P>, scenario: &Scenario) -> Log
where
    T: Policy<State = Observation<f32>, Action = Move>,
    P: Policy<State = Observation<f32>, Action = Move>,
{
    let home = hybrid.arm.home;
    let mut log = Log { codes: [0; 4], broken: 0, actions: [0; 2], motors: home, hash: Hash::new() };
    let mut world = FaultWorld { motors: home, past: [home; REMEMBERED], steps: 0 };
    let mut control: Option<Control<f32, Brent>> = None;
    let (mut step, mut before) = (0u32, OK);
    for phase in scenario.phases {
        for index in 0..phase.steps {
            let odd = index % 2 == 1;
            let (motors, target) = (world.reading(phase, odd), target_of(phase));
            if let (true, 0, Some(control)) = (phase.resume, index, &mut control) {
                let _ = control.resume(motors);
            }
            let counts = control.as_ref().map(|control| *control.switch().counts());
            // A loop begins with the first good reading.
            let begun = match control {
                Some(_) => Ok(()),
                None => begun(hybrid, scenario, motors, target).map(|begun| control = Some(begun)),
            };
            let result = begun.and_then(|()| match (&mut control, garbled(hybrid, motors, target, phase.reading)) {
                (Some(control), None) => hybrid.step(control, motors, target).map(|(_, chosen)| chosen),
                (Some(control), Some(seen)) => hybrid.drive(control, &seen),
                (None, _) => Err(Fault::Sensor),
            });
            let found = code(&result);
            let chosen = result.unwrap_or(Chosen { driver: Driver::Tpg, wanted: Move::STOP });
            step += 1;
            let due = if odd && phase.reading == Flicker { OK } else { phase.code };
            let right = found == due || (index < phase.within && (found == before || found == OK));
            let unharmed = found == OK || counts == control.as_ref().map(|control| *control.switch().counts());
            let small = chosen.wanted.0.iter().all(|delta| (-3..=3).contains(delta));
            if !(right && unharmed && small) && log.broken == 0 {
                log.broken = step;
            }
            match found {
                OK => log.codes[0] += 1,
                BAD_TARGET => log.codes[1] += 1,
                BAD_SENSOR => log.codes[2] += 1,
                _ => log.codes[3] += 1,
            }
            log.hash.add(found as u32 as u64);
            chosen.wanted.0.into_iter().for_each(|delta| log.hash.add(u64::from(delta as u8)));
            log.hash.add(u64::from(chosen.driver == Driver::Sac));
            world.advance(hybrid, phase, chosen.wanted);
        }
        before = phase.code;
    }
    if let Some(control) = control {
        let counts = control.switch().counts();
        log.actions = [counts.tpg_actions, counts.sac_actions];
    }
    log.motors = world.motors;
    log
}
