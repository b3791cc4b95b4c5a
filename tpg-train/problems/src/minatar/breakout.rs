//! Breakout: a paddle keeps a ball in play, which takes bricks away.

use super::board::{Board, Draws, SIDE, block, cell, is_inside};
use super::{Game, Move, Outcome};

/// A game of Breakout.
#[derive(Clone, Debug)]
pub(crate) struct Breakout {
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

const WALL: Board = block([1, 4], [0, SIDE]);
const LAST_ROW: i32 = SIDE - 1;

impl Game for Breakout {
    const CHANNELS: &'static [&'static str] = &["paddle", "ball", "trail", "brick"];
    const MOVES: &'static [(&'static str, Move)] =
        &[("stay", Move::Stay), ("left", Move::Left), ("right", Move::Right)];

    fn new(draws: &mut Draws) -> Self {
        let (column, right) = [(0, 1), (SIDE - 1, -1)][draws.below(2)];
        let ball = [3, column];
        Self { ball, trail: ball, way: [1, right], paddle: 4, bricks: WALL, has_struck: false }
    }

    fn step(&mut self, taken: Move, _: &mut Draws) -> Outcome {
        let mut outcome = Outcome::default();
        self.paddle = (self.paddle + taken.right()).clamp(0, SIDE - 1);
        let [row, column] = self.ball;
        self.trail = self.ball;
        let mut next = [row + self.way[0], column + self.way[1]];
        if !is_inside(next[1]) {
            next[1] = next[1].clamp(0, SIDE - 1);
            self.way[1] = -self.way[1];
        }
        let mut is_in_bricks = false;
        if next[0] < 0 {
            next[0] = 0;
            self.way[0] = -self.way[0];
        } else if self.bricks & cell(next[0], next[1]) != 0 {
            is_in_bricks = true;
            if !self.has_struck {
                outcome.reward = 1;
                self.has_struck = true;
                self.bricks &= !cell(next[0], next[1]);
                next[0] = row;
                self.way[0] = -self.way[0];
            }
        } else if next[0] == LAST_ROW {
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
                outcome.is_over = true;
            }
        }
        self.has_struck &= is_in_bricks;
        self.ball = next;
        outcome
    }

    fn boards(&self) -> Vec<Board> {
        let [ball, trail] = [self.ball, self.trail].map(|[row, column]| cell(row, column));
        vec![cell(LAST_ROW, self.paddle), ball, trail, self.bricks]
    }
}
