//! MinAtar's Breakout: a paddle keeps a ball in play, which takes bricks away; an image of ten by ten cells, with a flag for each
//! channel.
//!
//! The rules are those of the package `minatar` 1.0.15 with its sticky actions; an episode here has at most 5,000 actions.

use serde::{Deserialize, Serialize};
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, End, Environment, SourceSet, Step};
use tpg_graph::SourceDocument;
use tpg_graph::image::{Image, Vision, features_of};
use tpg_runtime::scalar::Scalar;

/// Rows, and columns.
const SIDE: i32 = 10;
const LAST: i32 = SIDE - 1;
/// The probability that the last move is made once more instead of the one that is chosen.
const STICKY: f64 = 0.1;
/// Actions of an episode.
const ACTIONS: u32 = 5000;
/// The names of the image's channels; the first one shows what the player moves.
const CHANNELS: [&str; 4] = ["paddle", "ball", "trail", "brick"];
/// The names of the actions.
const MOVES: [&str; 3] = ["stay", "left", "right"];
/// The columns by which each action moves the paddle.
const STEPS: [i32; 3] = [0, -1, 1];

/// A channel: cell (row, column) is bit 10 · row + column.
type Board = u128;

/// The bricks of a new wall: rows 1 to 3.
const WALL: Board = ((1 << (3 * SIDE)) - 1) << SIDE;

fn cell([row, column]: [i32; 2]) -> Board {
    1 << (SIDE * row + column)
}

/// The random numbers of an episode: SplitMix64.
#[derive(Clone, Debug)]
struct Draws(u64);

impl Draws {
    /// Returns a number from 0 to below 1.
    fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A running game.
#[derive(Clone, Debug)]
pub(crate) struct Game {
    draws: Draws,
    /// The last step of the paddle.
    last: i32,
    ball: [i32; 2],
    /// The cell that the ball was in before.
    trail: [i32; 2],
    /// The way of the ball: down and to the right, 1 or −1 each.
    way: [i32; 2],
    paddle: i32,
    bricks: Board,
    /// The ball was in the bricks already.
    has_struck: bool,
}

impl Game {
    fn new(seed: u64) -> Self {
        let mut draws = Draws(seed);
        let (column, right) = if draws.unit() < 0.5 { (0, 1) } else { (LAST, -1) };
        let ball = [3, column];
        Self { draws, last: 0, ball, trail: ball, way: [1, right], paddle: 4, bricks: WALL, has_struck: false }
    }

    /// Makes a move; returns the reward, and true if the ball is lost.
    fn step(&mut self, choice: usize) -> (u32, bool) {
        if self.draws.unit() >= STICKY {
            self.last = STEPS[choice];
        }
        let (mut reward, mut is_lost) = (0, false);
        self.paddle = (self.paddle + self.last).clamp(0, LAST);
        let [row, column] = self.ball;
        self.trail = self.ball;
        let mut next = [row + self.way[0], column + self.way[1]];
        if !(0..SIDE).contains(&next[1]) {
            next[1] = next[1].clamp(0, LAST);
            self.way[1] = -self.way[1];
        }
        let mut is_in_bricks = false;
        if next[0] < 0 {
            next[0] = 0;
            self.way[0] = -self.way[0];
        } else if self.bricks & cell(next) != 0 {
            is_in_bricks = true;
            if !self.has_struck {
                reward = 1;
                self.has_struck = true;
                self.bricks &= !cell(next);
                next[0] = row;
                self.way[0] = -self.way[0];
            }
        } else if next[0] == LAST {
            if self.bricks == 0 {
                self.bricks = WALL;
            }
            if column == self.paddle {
                self.way[0] = -self.way[0];
                next[0] = row;
            } else if next[1] == self.paddle {
                self.way = self.way.map(|way| -way);
                next[0] = row;
            } else {
                is_lost = true;
            }
        }
        self.has_struck &= is_in_bricks;
        self.ball = next;
        (reward, is_lost)
    }

    /// Returns the channels.
    fn boards(&self) -> [Board; 4] {
        [cell([LAST, self.paddle]), cell(self.ball), cell(self.trail), self.bricks]
    }
}

/// The channels as an image.
struct Boards([Board; 4]);

impl Boards {
    fn place(bit: u32) -> [usize; 2] {
        [bit / SIDE as u32, bit % SIDE as u32].map(|part| part as usize)
    }
}

impl Image for Boards {
    fn cell(&self, row: usize, column: usize, channel: usize) -> u8 {
        (self.0[channel] >> (row * SIDE as usize + column) & 1) as u8
    }

    fn first(&self, _: [usize; 3], channel: usize) -> Option<[usize; 2]> {
        (self.0[channel] != 0).then(|| Self::place(self.0[channel].trailing_zeros()))
    }

    fn last(&self, _: [usize; 3], channel: usize) -> Option<[usize; 2]> {
        self.0[channel].checked_ilog2().map(Self::place)
    }
}

/// The section `[problem]` of a configuration: the game has no settings.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Config {}

/// The game as a problem. A policy reads features of the image: see [`features_of`].
#[derive(Clone, Debug)]
pub(crate) struct Breakout {
    sources: Vec<SourceDocument>,
    vision: Vision,
}

impl Default for Breakout {
    fn default() -> Self {
        let sources = features_of([SIDE as u32, SIDE as u32, CHANNELS.len() as u32], &CHANNELS, 1);
        let vision = Vision::new(&sources).expect("the sources are of an image");
        Self { sources, vision }
    }
}

impl<S: Scalar> Environment<S> for Breakout {
    type Task = u64;
    type Episode = Game;

    fn sources(&self) -> Vec<SourceDocument> {
        self.sources.clone()
    }

    fn actions(&self) -> ActionSpace {
        ActionSpace::discrete(MOVES)
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

    fn start(&self, seed: &u64) -> Game {
        Game::new(*seed)
    }

    fn observe(&self, game: &mut Game, wanted: SourceSet, state: &mut [S]) {
        let inputs: Vec<u16> = (0..state.len() as u16).collect();
        self.observe_some(game, wanted, &inputs, state);
    }

    fn observe_some(&self, game: &mut Game, _: SourceSet, inputs: &[u16], state: &mut [S]) {
        let inputs = inputs.iter().map(|&input| usize::from(input));
        self.vision.look(&Boards(game.boards()), inputs, |input, value| state[input] = S::from_f64(value));
    }

    fn step(&self, game: &mut Game, act: Act<'_, S>) -> Step {
        let (reward, is_lost) = game.step(act.choice());
        let step = Step::reward(reward.into());
        if is_lost { step.ending(End::new(0)) } else { step }
    }
}

#[cfg(test)]
mod tests {
    use super::{Draws, Game, MOVES};

    /// The numbers of episodes and rewards, and the digest of 20,000 steps, are those that `breakout.py` prints of the package, with
    /// the same draws.
    #[test]
    fn it_is_played_as_by_the_package() {
        let mut seed = 7;
        let (mut choices, mut game) = (Draws(seed ^ 0xABCD), Game::new(seed));
        let (mut episodes, mut rewards, mut digest) = (0, 0, 0xCBF2_9CE4_8422_2325_u64);
        for _ in 0..20_000 {
            let choice = (choices.unit() * MOVES.len() as f64) as usize;
            let (reward, is_lost) = game.step(choice);
            rewards += reward;
            let head = [choice as u128, reward.into(), is_lost.into()];
            for byte in head.into_iter().chain(game.boards()).flat_map(u128::to_le_bytes) {
                digest = (digest ^ u64::from(byte)).wrapping_mul(0x100_0000_01B3);
            }
            if is_lost {
                seed += 1;
                episodes += 1;
                game = Game::new(seed);
            }
        }
        assert_eq!((episodes, rewards, digest), (1957, 810, 0x991C_8C9C_CDE9_49F8));
    }
}
