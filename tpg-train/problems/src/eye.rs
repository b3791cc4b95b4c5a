//! A camera on a pan-tilt head follows a ball that is lighter or darker than what is behind it.
//!
//! The camera gives 24 rows of 32 grey pixels. Brightness, its gradient, the texture behind the ball and the noise of the pixels differ
//! from episode to episode; the head follows its commands with a lag.

use crate::sight::{Sight, mixed};
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, End, Environment, Output, SourceSet, Step};
use tpg_graph::SourceDocument;
use tpg_graph::image::Image;
use tpg_runtime::scalar::Scalar;

/// Rows of the image.
pub const ROWS: usize = 24;
/// Columns of the image.
pub const COLUMNS: usize = 32;
/// Actions of an episode.
const ACTIONS: u32 = 200;
/// The fastest command, in pixels an action.
const FASTEST: f32 = 2.0;
/// The part of the difference to its command by which the head's speed changes in an action.
const LAG: f32 = 0.6;
/// The distance of the ball from the middle, in pixels, at which an action earns nothing.
const FAR: f64 = 8.0;
/// Pixels of a patch of the texture are in one square of so many.
const PATCH: f32 = 4.0;

/// The problem. An action earns the more the nearer the ball is to the middle of the image, 100 in an episode at most; the episode
/// ends when the ball has left the image.
#[derive(Clone, Debug)]
pub(crate) struct Eye(Sight);

impl Default for Eye {
    fn default() -> Self {
        Self(Sight::new([ROWS, COLUMNS], &["image"], u8::MAX))
    }
}

/// A running episode. Places are those of the middle of the image, down and to the right, in pixels.
#[derive(Clone, Debug)]
pub struct EyeScene {
    seed: u64,
    actions: u64,
    radius: f32,
    contrast: f32,
    brightness: f32,
    gradient: [f32; 2],
    texture: f32,
    noise: f32,
    ball: [f32; 2],
    velocity: [f32; 2],
    head: [f32; 2],
    speed: [f32; 2],
}

/// Returns a number from 0 to below 1 of the upper 24 bits.
fn unit(bits: u64) -> f32 {
    (bits >> 40) as f32 / (1_u32 << 24) as f32
}

impl EyeScene {
    /// Begins the episode of a seed.
    ///
    /// ```
    /// use tpg_problems::eye::{COLUMNS, EyeScene, ROWS};
    ///
    /// let mut scene = EyeScene::new(1);
    /// scene.put_ball([0.0, 5.0]);
    /// assert_eq!(scene.pixels().len(), ROWS * COLUMNS);
    /// let step = scene.step([0.0, 2.0]);
    /// assert!(step.end.is_none() && scene.distance()[1] < 5.0, "the head turns to the right");
    /// ```
    pub fn new(seed: u64) -> Self {
        let mut number = 0;
        let mut draw = |low: f32, high: f32| {
            number += 1;
            low + (high - low) * unit(mixed(seed, number))
        };
        let sign = if draw(0.0, 1.0) < 0.5 { -1.0 } else { 1.0 };
        Self {
            seed,
            actions: 0,
            radius: draw(2.0, 4.0),
            contrast: sign * draw(50.0, 90.0),
            brightness: draw(95.0, 150.0),
            gradient: [draw(-1.0, 1.0), draw(-1.0, 1.0)],
            texture: draw(5.0, 15.0),
            noise: draw(2.0, 8.0),
            ball: [draw(-7.0, 7.0), draw(-10.0, 10.0)],
            velocity: [draw(-0.6, 0.6), draw(-0.6, 0.6)],
            head: [0.0; 2],
            speed: [0.0; 2],
        }
    }

    /// Returns the ball's distance from the middle of the image, down and to the right, in pixels.
    pub fn distance(&self) -> [f32; 2] {
        [self.ball[0] - self.head[0], self.ball[1] - self.head[1]]
    }

    /// Puts the ball at a distance from the middle of the image, at rest.
    pub fn put_ball(&mut self, distance: [f32; 2]) {
        self.ball = [0, 1].map(|axis| self.head[axis] + distance[axis]);
        self.velocity = [0.0; 2];
    }

    /// Draws the image, row after row.
    pub fn pixels(&self) -> Vec<u8> {
        let mut patch = ([i64::MAX; 2], 0.0);
        let pixels = (0..ROWS).flat_map(|row| (0..COLUMNS).map(move |column| [row, column]));
        let pixel = |place: [usize; 2]| {
            let at = [place[0] as f32 - (ROWS - 1) as f32 / 2.0, place[1] as f32 - (COLUMNS - 1) as f32 / 2.0];
            let square = [0, 1].map(|axis| ((at[axis] + self.head[axis]) / PATCH).floor() as i64);
            if square != patch.0 {
                patch = (square, self.texture(square));
            }
            self.pixel(place, at, patch.1)
        };
        pixels.map(pixel).collect()
    }

    /// Returns how much brighter a square of the background is than what is around it.
    fn texture(&self, [down, right]: [i64; 2]) -> f32 {
        let random = mixed(self.seed ^ 0x5555, (down as u64) << 32 ^ right as u64 & 0xFFFF_FFFF);
        (2.0 * unit(random) - 1.0) * self.texture
    }

    /// Turns the head by commands, down and to the right, in pixels.
    pub fn step(&mut self, command: [f32; 2]) -> Step {
        self.actions += 1;
        for axis in 0..2 {
            let command = command[axis].clamp(-FASTEST, FASTEST);
            self.speed[axis] += LAG * (command - self.speed[axis]);
            self.head[axis] += self.speed[axis];
            // The ball is pushed another way every eight actions.
            let push = 2.0 * unit(mixed(self.seed ^ 0xAAAA, self.actions / 8 * 2 + axis as u64)) - 1.0;
            self.velocity[axis] = (self.velocity[axis] + 0.12 * push).clamp(-1.2, 1.2);
            self.ball[axis] += self.velocity[axis];
        }
        let [down, right] = self.distance();
        let near = 1.0 - f64::from(down * down + right * right).sqrt() / FAR;
        let step = Step::reward(near.max(0.0) * 100.0 / f64::from(ACTIONS));
        let is_lost = down.abs() > ROWS as f32 / 2.0 || right.abs() > COLUMNS as f32 / 2.0;
        if is_lost { step.ending(End::new(0)) } else { step }
    }

    fn pixel(&self, [row, column]: [usize; 2], at: [f32; 2], texture: f32) -> u8 {
        let [down, right] = self.distance();
        let (down, right) = (at[0] - down, at[1] - right);
        let squared = down * down + right * right;
        let is_far = squared > (self.radius + 1.0).powi(2);
        let inside = if is_far { 0.0 } else { (self.radius + 0.5 - squared.sqrt()).clamp(0.0, 1.0) };
        let noise = mixed(self.seed ^ self.actions << 32, (row * COLUMNS + column) as u64);
        let noise = (unit(noise) + unit(noise << 20) - 1.0) * 2.4 * self.noise;
        let behind = self.brightness + self.gradient[0] * at[0] + self.gradient[1] * at[1];
        (behind + texture * (1.0 - inside) + self.contrast * inside + noise).round().clamp(0.0, 255.0) as u8
    }
}

/// A scene drawn once, for features that look at each pixel many times.
struct Frame(Vec<u8>);

impl Image for Frame {
    fn cell(&self, row: usize, column: usize, _: usize) -> u8 {
        self.0[row * COLUMNS + column]
    }
}

impl<S: Scalar> Environment<S> for Eye {
    /// The seed of a scene.
    type Task = u64;
    type Episode = EyeScene;

    fn sources(&self) -> Vec<SourceDocument> {
        self.0.sources()
    }

    fn actions(&self) -> ActionSpace {
        let output = |name: &str| {
            let (min, max) = (-f64::from(FASTEST), f64::from(FASTEST));
            Output { name: name.to_owned(), unit: "pixels".to_owned(), min, max }
        };
        ActionSpace::Box(["tilt", "pan"].map(output).into())
    }

    fn outcomes(&self) -> &'static [&'static str] {
        &["lost", "time limit"]
    }

    fn time_limit(&self) -> u32 {
        ACTIONS
    }

    fn draw(&self, stream: &mut Stream) -> u64 {
        stream.bits()
    }

    fn start(&self, seed: &u64) -> EyeScene {
        EyeScene::new(*seed)
    }

    fn observe(&self, scene: &mut EyeScene, _: SourceSet, state: &mut [S]) {
        self.0.look(&Frame(scene.pixels()), 0..state.len(), state);
    }

    fn observe_some(&self, scene: &mut EyeScene, _: SourceSet, inputs: &[u16], state: &mut [S]) {
        self.0.look(&Frame(scene.pixels()), inputs.iter().map(|&input| input.into()), state);
    }

    fn step(&self, scene: &mut EyeScene, act: Act<'_, S>) -> Step {
        let values = act.values();
        scene.step([values[0], values[1]].map(|value| value.to_f64() as f32))
    }
}

#[cfg(test)]
mod tests {
    use super::{Eye, EyeScene};
    use tpg_engine::{Act, Environment, SourceSet};

    /// Returns the mean score of a head that follows the brightest or the darkest window, whichever has more contrast, or does nothing.
    fn followed(is_still: bool) -> f64 {
        let eye = Eye::default();
        let scores = (0..100).map(|seed| {
            let (mut scene, mut score) = (EyeScene::new(seed), 0.0);
            let mut state = [0.0_f64; 54];
            for _ in 0..200 {
                eye.observe(&mut scene, SourceSet::ALL, &mut state);
                let place = if state[2] > state[5] { &state[..2] } else { &state[3..5] };
                let command = if is_still { [0.0; 2] } else { [1.6 * (place[0] - 11.5), 1.6 * (place[1] - 15.5)] };
                let step = Environment::<f64>::step(&eye, &mut scene, Act::Values(&command));
                score += step.reward;
                if step.end.is_some() {
                    break;
                }
            }
            score
        });
        scores.sum::<f64>() / 100.0
    }

    #[test]
    fn contrast_tells_where_the_ball_is() {
        let (followed, still) = (followed(false), followed(true));
        assert!(followed > 80.0 && still < 10.0, "{followed} {still}");
    }
}
