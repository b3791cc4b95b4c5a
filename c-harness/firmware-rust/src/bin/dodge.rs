//! The control step among balls: recorded scenes, in which every motor position is as on the host, and drawn ones, which are
//! counted: the whole step, and its parts. Three balls always; they fly straight on for the steps of a task.

#![no_std]
#![no_main]

use core::hint::black_box;
use cortex_m_rt::entry;
use tpg_arm::dodge::{
    BALLS, Ball, Behaviour, Body, Control, Dodger, DodgerSettings, FIELD, GOALS, SCOUT, VALUES, View, WIDOWX_RADII,
};
use tpg_arm::sensors::Watch;
use tpg_arm::{Pose, WIDOWX};
use tpg_firmware::{Counter, Tally, exit, run};
use tpg_generated::dodge::Dodge;
use tpg_runtime::policy::{ActionId, Policy};

include!(concat!(env!("TPG_GENERATED"), "/balls.rs"));

static BODY: Body = Body::new(WIDOWX.to_f32(), WIDOWX_RADII);

const TASKS: u32 = 60;
const STEPS: u32 = 150;

/// The behaviour of an action: the graph's actions are all behaviours, in their order.
fn behaviour(action: usize) -> Behaviour {
    Behaviour::ALL.get(action).map_or(Behaviour::Hold, |(behaviour, _)| *behaviour)
}

/// The shipped graph's choice.
fn shipped(values: &[f32; VALUES]) -> Behaviour {
    let ActionId(action) = Dodge.decide(values);
    behaviour(usize::from(action))
}

/// The balls of a scene at a step: where they are, and how far they went since the step before.
fn observe(scene: &Scene, step: usize) -> ([Ball; BALLS], usize) {
    let mut balls = [Ball::default(); BALLS];
    let count = scene.radii.len();
    let at = |time: usize, ball: usize| CENTRES.get(scene.first + time * count + ball).copied().unwrap_or_default();
    for (place, (ball, &radius)) in balls.iter_mut().zip(scene.radii).enumerate() {
        let ([x, y, z], [nx, ny, nz]) = (at(step, place), at(step + 1, place));
        *ball = Ball { at: [nx, ny, nz], velocity: [nx - x, ny - y, nz - z], radius };
    }
    (balls, count)
}

/// Runs the recorded scenes; `None` where a step is refused.
fn recorded(counter: &mut Counter, settings: DodgerSettings) -> Option<Tally> {
    let mut tally = Tally::new();
    for scene in &SCENES {
        let mut goals = [Pose([0; 4]); GOALS];
        goals.iter_mut().zip(scene.goals).for_each(|(goal, ticks)| *goal = Pose(*ticks));
        let mut motors = Pose(scene.start);
        let (balls, count) = observe(scene, 0);
        let (goals, balls) = (goals.get(..scene.goals.len())?, balls.get(..count)?);
        let mut control = Control::new(&BODY, settings, Watch::DEFAULT, goals, motors, balls).ok()?;
        for step in 0..scene.steps {
            let (balls, count) = observe(scene, step);
            let balls = balls.get(..count)?;
            let (step, count) = counter.measure(|| control.step(&BODY, &shipped, black_box(motors), black_box(balls)));
            motors = BODY.arm.step(motors, step.ok()?.wanted).pose;
            tally.add(count);
            tally.hash.add_pose(motors);
        }
    }
    Some(tally)
}

/// Numerical Recipes' generator: states for counting need no better one.
struct Random(u32);

impl Random {
    fn between(&mut self, low: f32, high: f32) -> f32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        low + (high - low) * (self.0 >> 8) as f32 / 16_777_216.0
    }

    /// A pose without a collision.
    fn pose(&mut self) -> Pose {
        loop {
            let pose = Pose([(); 4].map(|()| self.between(1100.0, 3000.0) as i16));
            if BODY.is_free(&BODY.at(pose)) {
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
    run(|counter| {
        let mut random = Random(1);
        let settings = DodgerSettings { scout: SCOUT, guard: true };
        let scenes = recorded(counter, settings)?;
        let [mut see, mut decide, mut act, mut field, mut any] = [Tally::new(); 5];
        for _ in 0..TASKS {
            let (mut pose, goals) = (random.pose(), [(); 4].map(|()| random.pose()));
            let mut balls = [(); 3].map(|()| random.ball());
            let begun = Control::new(&BODY, settings, Watch::DEFAULT, &goals, pose, &balls);
            let Ok(mut control) = begun else { return None };
            // The parts of a step, beside it: the same search from the same readings.
            let mut dodger = Dodger::new(settings, &View::new(&BODY, pose, &goals, &balls));
            for count in 0..STEPS {
                for ball in &mut balls {
                    ball.at = ball.after(1.0);
                }
                // Every other step takes a behaviour in turn, so that the dearest is among them.
                let choose = |values: &[f32; VALUES]| {
                    let chosen = shipped(values);
                    if count % 2 == 0 { chosen } else { behaviour(count as usize / 2 % Behaviour::ALL.len()) }
                };
                let (step, all) = counter.measure(|| control.step(&BODY, &choose, black_box(pose), black_box(&balls)));
                let Ok(step) = step else { return None };
                let ((view, state), seen) = counter.measure(|| {
                    let view = View::new(&BODY, black_box(pose), &goals, black_box(&balls));
                    let state = dodger.observe(&view);
                    (view, state)
                });
                let (_, walked) = counter.measure(|| FIELD.step(black_box(&view), view.goal()));
                let (_, decided) = counter.measure(|| shipped(black_box(&state)));
                let (wanted, acted) = counter.measure(|| dodger.act(black_box(&view), black_box(step.behaviour)));
                if wanted != step.wanted {
                    exit(false);
                }
                see.add(seen);
                decide.add(decided);
                act.add(acted);
                field.add(walked);
                any.add(all);
                pose = BODY.arm.step(pose, step.wanted).pose;
                any.hash.add_pose(pose);
            }
        }
        scenes.print_with_hash("cost dodge scenes");
        see.print("cost dodge see");
        decide.print("cost dodge decide");
        act.print("cost dodge act");
        field.print("cost dodge field");
        any.print_with_hash("cost dodge any behaviour");
        Some(())
    })
}
