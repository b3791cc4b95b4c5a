//! How balls are seen: exactly, or late, with noise, and without velocities.

use super::scene::{Path, SEED, Scene};
use tpg_arm::dodge::{Ball, Tracker};
use tpg_arm::kinematics::Vector;
use tpg_engine::random::{Purpose, Stream};

/// Steps for which balls have been seen when an episode begins, if their velocities are to be found.
const BEFORE: u16 = 40;

/// What is known of balls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensing {
    /// Standard deviation of each coordinate, mm.
    pub noise: f32,
    /// Steps that pass until a place is seen.
    pub delay: u8,
    /// True if displacements are seen; otherwise a [`Tracker`] finds them.
    pub velocities: bool,
}

impl Sensing {
    /// Everything is seen as it is.
    pub const EXACT: Self = Self { noise: 0.0, delay: 0, velocities: true };
}

/// The sensors of an episode.
#[derive(Clone, Debug)]
pub(super) struct Sensors {
    sensing: Sensing,
    random: Stream,
    trackers: Vec<Tracker>,
}

impl Sensors {
    /// Creates the sensors of a scene, which draw the same noise whenever it is played.
    pub(super) fn new(sensing: Sensing, scene: &Scene) -> Self {
        let mut random = Stream::new(SEED, 0, Purpose::Variation, address(scene));
        let first = -f32::from(BEFORE);
        let place = |path: &Path| Tracker::new(place(path, &sensing, first, &mut random), path.radius);
        let trackers = scene.balls.iter().map(place).collect();
        let mut sensors = Self { sensing, random, trackers };
        if !sensing.velocities {
            (1..BEFORE).for_each(|step| sensors.track(scene, first + f32::from(step)));
        }
        sensors
    }

    /// Returns the balls as they are seen at a time.
    pub(super) fn see(&mut self, scene: &Scene, time: f32) -> Vec<Ball> {
        let Sensing { delay, velocities, .. } = self.sensing;
        if !velocities {
            self.track(scene, time);
            return self.trackers.iter().map(|tracker| tracker.ball(delay.into())).collect();
        }
        let observed = |path: &Path| {
            let Ball { velocity, .. } = path.observed(time - f32::from(delay));
            Ball { at: place(path, &self.sensing, time, &mut self.random), velocity, radius: path.radius }
        };
        scene.balls.iter().map(observed).collect()
    }

    fn track(&mut self, scene: &Scene, time: f32) {
        for (tracker, path) in self.trackers.iter_mut().zip(&scene.balls) {
            tracker.see(place(path, &self.sensing, time, &mut self.random));
        }
    }
}

/// The place of a ball that is seen at a time.
fn place(path: &Path, sensing: &Sensing, time: f32, random: &mut Stream) -> Vector<f32> {
    path.at(time - f32::from(sensing.delay)).map(|mm| mm + sensing.noise * random.normal() as f32)
}

/// A number that other scenes hardly have: FNV-1a over start and balls.
fn address(scene: &Scene) -> u64 {
    let starts = scene.start.iter().map(|&ticks| ticks as u32);
    let balls =
        scene.balls.iter().flat_map(|path| [path.from, path.to, [path.radius, path.period, path.phase]].concat());
    let words = starts.chain(balls.map(f32::to_bits));
    words.fold(0xcbf2_9ce4_8422_2325, |hash, word| (hash ^ u64::from(word)).wrapping_mul(0x0100_0000_01b3))
}
