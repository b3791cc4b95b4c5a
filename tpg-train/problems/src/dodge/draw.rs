//! The generator of scenes: every one is solvable, and a plan proves it.

use super::BODY;
use super::config::DodgeConfig;
pub use super::scene::SEED;
use super::scene::{Path, Scene};
use super::walk::{self, Leg, candidate, follow};
use crate::amount::Amount;
use crate::arm::targets::{ReachableSpace, Set, Start};
use std::sync::Arc;
use tpg_arm::dodge::CAPSULES;
use tpg_arm::dodge::plan::steps;
use tpg_arm::kinematics::{Vector, distance};
use tpg_arm::{Pose, WIDOWX};
use tpg_engine::random::{Purpose, Stream};

/// Tries for the certificate of a scene of training or validation.
pub(super) const TRIES: u32 = 1500;
/// Tries for the certificate of a test scene.
pub const TEST_TRIES: u32 = 2500;
/// Steps of an episode.
pub const LIMIT: u32 = 1000;
/// Number of solutions that are tried as the first goal.
const FIRST_GOALS: usize = 24;
/// Draws of one ball before the scene is drawn anew.
const BALL_DRAWS: usize = 30;
/// Share of balls that do not move.
const SHARE_STATIC: f64 = 0.15;
/// Share of balls that cross the arm's straight walk: the first ball, and the others.
const AIMED: [f64; 2] = [0.85, 0.6];
/// Maximum distance of an aimed ball's path from a point of the arm, mm.
const PASS_BY: f64 = 90.0;
/// Minimum and maximum way of a ball to either side of a point that it passes, mm.
const WAY: [f64; 2] = [120.0, 350.0];
/// Minimum clearance from the arm at step 0, mm.
const CLEAR_AT_START: f32 = 40.0;
/// Steps for which an arm at its start is not hit.
const REST_FREE: u32 = 40;
/// Clearance that a solving plan keeps, mm.
pub const MARGIN: f32 = 1.0;

/// A scene with the plan that solves it.
#[derive(Clone, Debug, PartialEq)]
pub struct Certified {
    /// The scene.
    pub scene: Scene,
    /// The plan, from the scene's start.
    pub plan: Vec<Leg>,
}

/// Draws scenes.
#[derive(Clone, Debug)]
pub struct Generator {
    space: Arc<ReachableSpace>,
    config: DodgeConfig,
}

impl Generator {
    /// Prepares the scenes of a set; `seed` samples the reachable space.
    pub fn new(config: &DodgeConfig, seed: u64, set: Set) -> Self {
        Self { space: ReachableSpace::shared(&WIDOWX, seed, set), config: config.clone() }
    }

    /// Draws a scene. Those without a certificate after `tries` tries are drawn anew.
    pub fn draw(&self, random: &mut Stream, tries: u32) -> Certified {
        loop {
            let task = self.space.task(Start::Rs, random);
            let (start, target) = (task.start, task.target.map(|value| value as f32));
            let solutions = walk::solutions(target, start.0);
            let Some(goal) = self.first_goal(start, &solutions) else { continue };
            let Some(balls) = self.balls(start, goal, random) else { continue };
            let goals = walk::stances(start, goal, &solutions).into_iter().map(|pose| pose.0).collect();
            let scene = Scene { start: start.0, target, goals, balls };
            let mut ends = vec![goal];
            ends.extend(solutions.into_iter().filter(|&pose| pose != goal));
            if let Some(plan) = self.certificate(&scene, &ends, tries, random) {
                return Certified { scene, plan };
            }
        }
    }

    /// The nearest solution that a straight walk reaches without table and base, if there were no balls.
    fn first_goal(&self, start: Pose, solutions: &[Pose]) -> Option<Pose> {
        let is_free = |goal: &Pose| {
            let legs = [Leg { to: *goal, wait: 0 }];
            follow(start, &legs, 1400, 0.0, |_, _| 1.0).is_some()
        };
        let goal = solutions.iter().take(FIRST_GOALS).copied().find(is_free)?;
        let ticks = goal.0.iter().zip(start.0).map(|(to, from)| to.abs_diff(from)).max().unwrap_or(0);
        (180..=1800).contains(&ticks).then_some(goal)
    }

    /// One to three balls.
    fn balls(&self, start: Pose, goal: Pose, random: &mut Stream) -> Option<Vec<Path>> {
        let [fewest, most] = self.config.balls;
        let count = usize::from(fewest) + random.below(usize::from(most - fewest) + 1);
        let ball = |index| (0..BALL_DRAWS).find_map(|_| self.ball(index, start, goal, random));
        (0..count).map(ball).collect()
    }

    /// One draw of a ball; `None` if it stands against the rules.
    fn ball(&self, index: usize, start: Pose, goal: Pose, random: &mut Stream) -> Option<Path> {
        let between = |range, random: &mut Stream| Amount::Between(range).draw(random) as f32;
        let radius = between(self.config.radius, random);
        let speed = if random.chance(SHARE_STATIC) { 0.0 } else { between(self.config.speed, random) };
        let [first, others] = AIMED;
        let aimed = random.chance(if index == 0 { first } else { others });
        let (pass, when) = if aimed { self.aim(start, goal, random) } else { self.elsewhere(start, goal, random) };
        let mut direction = unit_vector(random);
        direction[2] *= 0.5;
        let [before, after] = [(); 2].map(|()| between(WAY, random));
        let end = |side: f32| std::array::from_fn(|axis| pass[axis] + side * direction[axis]);
        let (from, to) = if speed == 0.0 { (pass, pass) } else { (end(-before), end(after)) };
        let length = distance(from, to);
        let sine = random.chance(0.5);
        let place = if length > 0.0 { distance(from, pass) / length } else { 0.0 };
        let period = match (speed > 0.0, sine) {
            (false, _) => 0.0,
            (true, true) => std::f32::consts::PI * length / speed,
            (true, false) => 2.0 * length / speed,
        };
        let turn = if sine { libm::acosf(1.0 - 2.0 * place) / std::f32::consts::TAU } else { place / 2.0 };
        let turn = if random.chance(0.5) { turn } else { 1.0 - turn };
        let phase = if period == 0.0 { 0.0 } else { turn - when / period };
        let path = Path { from, to, radius, period, phase: phase - libm::floorf(phase), sine };
        self.accepts(&path, start).then_some(path)
    }

    /// A point beside the arm somewhere on its straight walk, and when the arm is there.
    fn aim(&self, start: Pose, goal: Pose, random: &mut Stream) -> (Vector<f32>, f32) {
        let ticks = goal.0.iter().zip(start.0).map(|(to, from)| to.abs_diff(from)).max().unwrap_or(0);
        let when = (0.25 + 0.65 * random.unit()) as f32 * (f32::from(ticks) / 3.0);
        let moved = (3.0 * when) as i16;
        let pose =
            Pose(std::array::from_fn(|joint| start.0[joint] + (goal.0[joint] - start.0[joint]).clamp(-moved, moved)));
        let capsule = 1 + random.below(CAPSULES - 1);
        let place = random.unit() as f32;
        let point = BODY.at(pose).on_axis(capsule, place);
        let aside = (PASS_BY * random.unit()) as f32;
        let direction = unit_vector(random);
        (std::array::from_fn(|axis| point[axis] + aside * direction[axis]), when)
    }

    /// A place that the hand can reach, and a time of the straight walk.
    fn elsewhere(&self, start: Pose, goal: Pose, random: &mut Stream) -> (Vector<f32>, f32) {
        let place = BODY.at(self.space.pose(random)).hand();
        (place, random.unit() as f32 * steps(start, goal) as f32)
    }

    /// True for a ball above the table and aside of the base that leaves the arm time at its start.
    fn accepts(&self, path: &Path, start: Pose) -> bool {
        let Path { from, to, radius, .. } = *path;
        let on_the_way = (0..=16).all(|part| {
            let part = part as f32 / 16.0;
            let [x, y, z]: [f32; 3] = std::array::from_fn(|axis| from[axis] + (to[axis] - from[axis]) * part);
            z >= radius && (x.hypot(y) >= radius + 90.0 || z > 420.0 + radius)
        });
        let posture = BODY.at(start);
        let least = |time| if time == 0 { CLEAR_AT_START } else { 5.0 };
        on_the_way && (0..=REST_FREE).all(|time| BODY.clearance(&posture, path.at(time as f32), radius) >= least(time))
    }

    /// A plan that solves a scene with a margin, by trying; `None` if none is found.
    fn certificate(&self, scene: &Scene, goals: &[Pose], tries: u32, random: &mut Stream) -> Option<Vec<Leg>> {
        let start = Pose(scene.start);
        let holds = |legs: &Vec<Leg>| replay(scene, legs, MARGIN).is_some();
        (0..tries as usize).map(|index| candidate(index, start, goals, random)).find(holds)
    }
}

/// Follows a plan in a scene whose future is known.
pub fn replay(scene: &Scene, legs: &[Leg], margin: f32) -> Option<u32> {
    follow(Pose(scene.start), legs, LIMIT, margin, |posture, time| {
        let clearances = scene.balls.iter().map(|path| BODY.clearance(posture, path.at(time as f32), path.radius));
        clearances.fold(f32::INFINITY, f32::min)
    })
}

/// Draws the scenes of a set: the first `count` of it, with a certificate found in at most `tries` tries.
pub fn scenes(config: &DodgeConfig, seed: u64, set: Set, count: usize, tries: u32) -> Vec<Certified> {
    let generator = Generator::new(config, seed, set);
    let stream = |index| Stream::new(seed, (set as u64) << 8 | 77, Purpose::Task, index);
    (0..count as u64).map(|index| generator.draw(&mut stream(index), tries)).collect()
}

/// A direction of space, uniformly distributed.
fn unit_vector(random: &mut Stream) -> Vector<f32> {
    loop {
        let vector: [f32; 3] = std::array::from_fn(|_| (2.0 * random.unit() - 1.0) as f32);
        let square: f32 = vector.iter().map(|value| value * value).sum();
        if square > 0.01 && square < 1.0 {
            return vector.map(|value| value / square.sqrt());
        }
    }
}
