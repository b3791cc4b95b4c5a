//! Counts the instructions of a control step among balls: what is seen, the policy's decision, the behaviour with guard and
//! search. Arms and balls are drawn, three balls always; they fly straight on for the steps of a task.

#![no_std]
#![no_main]

mod platform;
mod report;

use core::hint::black_box;
use cortex_m_rt::entry;
use platform::Counter;
use report::Report;
use tpg_arm::dodge::{Ball, Behaviour, Body, Dodger, DodgerSettings, FIELD, SCOUT, View, WIDOWX_RADII};
use tpg_arm::{Pose, WIDOWX};
use tpg_generated::dodge::Dodge;
use tpg_runtime::policy::{ActionId, Policy};

static BODY: Body = Body::new(WIDOWX.to_f32(), WIDOWX_RADII);

const TASKS: u32 = 60;
const STEPS: u32 = 150;

/// Instructions of many calls.
#[derive(Clone, Copy, Default)]
struct Tally {
    actions: u32,
    instructions: u32,
    worst: u32,
}

impl Tally {
    fn add(&mut self, instructions: u32) {
        self.actions += 1;
        self.instructions = self.instructions.wrapping_add(instructions);
        self.worst = self.worst.max(instructions);
    }

    fn tell(&self, words: &str) {
        Report::new(words)
            .unsigned("actions", self.actions)
            .unsigned("instructions", self.instructions)
            .unsigned("worst", self.worst)
            .print();
    }
}

/// Numerical Recipes' generator: states for counting need no better one.
struct Random(u32);

impl Random {
    fn between(&mut self, low: f32, high: f32) -> f32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        low + (high - low) * (self.0 >> 8) as f32 / 16_777_216.0
    }

    /// A pose in which the arm stands.
    fn pose(&mut self) -> Pose {
        loop {
            let pose = Pose([(); 4].map(|()| self.between(1100.0, 3000.0) as i16));
            if BODY.stands(&BODY.at(pose)) {
                return pose;
            }
        }
    }

    fn ball(&mut self) -> Ball {
        Ball {
            at: [self.between(-350.0, 350.0), self.between(-350.0, 350.0), self.between(30.0, 400.0)],
            velocity: [self.between(-1.0, 1.0), self.between(-1.0, 1.0), self.between(-0.5, 0.5)],
            radius: self.between(30.0, 60.0),
        }
    }
}

#[entry]
fn main() -> ! {
    let stack = platform::paint_stack();
    let Some(peripherals) = cortex_m::Peripherals::take() else { platform::exit(false) };
    let mut counter = Counter::new(peripherals.SYST);
    let mut random = Random(1);
    let [mut see, mut decide, mut act, mut step, mut field, mut any] = [Tally::default(); 6];
    for _ in 0..TASKS {
        let (mut pose, goals) = (random.pose(), [(); 4].map(|()| random.pose()));
        let mut balls = [(); 3].map(|()| random.ball());
        let settings = DodgerSettings { scout: SCOUT, guard: true };
        let mut dodger = Dodger::new(settings, &View::new(&BODY, pose, &goals, &balls));
        for count in 0..STEPS {
            for ball in &mut balls {
                ball.at = ball.after(1.0);
            }
            let ((view, state), seen) = counter.measure(|| {
                let view = View::new(&BODY, black_box(pose), &goals, black_box(&balls));
                let state = dodger.observe(&view);
                (view, state)
            });
            let (_, walked) = counter.measure(|| FIELD.step(black_box(&view), view.goal()));
            let (ActionId(action), decided) = counter.measure(|| Dodge.decide(black_box(&state)));
            // Every other step takes a behaviour in turn, so that the dearest is among them.
            let other = count / 2 % Behaviour::ALL.len() as u32;
            let chosen = if count % 2 == 0 { u32::from(action) } else { other };
            let behaviour = Behaviour::ALL.get(chosen as usize).map_or(Behaviour::Hold, |(behaviour, _)| *behaviour);
            let (wanted, acted) = counter.measure(|| dodger.act(black_box(&view), black_box(behaviour)));
            see.add(seen);
            decide.add(decided);
            field.add(walked);
            any.add(seen + decided + acted);
            if count % 2 == 0 {
                act.add(acted);
                step.add(seen + decided + acted);
            }
            let mut moved = pose;
            for (ticks, by) in moved.0.iter_mut().zip(wanted.0) {
                *ticks += i16::from(by);
            }
            let inside = moved.0.iter().zip(&BODY.arm.ranges).all(|(&ticks, range)| range.contains(ticks));
            if inside && BODY.stands(&BODY.at(moved)) {
                pose = moved;
            }
        }
    }
    see.tell("cost dodge see");
    decide.tell("cost dodge decide");
    act.tell("cost dodge act");
    step.tell("cost dodge step");
    any.tell("cost dodge any behaviour");
    field.tell("cost dodge field");
    Report::new("done").unsigned("stack", platform::stack_used(stack)).print();
    platform::exit(true)
}
