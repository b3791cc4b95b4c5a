//! Asterix: a player takes gold and keeps out of the way of enemies, ever faster.

use super::board::{Board, Draws, SIDE, cell, is_inside};
use super::{Game, Move, Outcome};

/// A game of Asterix.
#[derive(Clone, Debug)]
pub(crate) struct Asterix {
    player: [i32; 2],
    /// The objects that move in rows 1 to 8.
    things: [Option<Thing>; 8],
    until_spawn: i32,
    until_move: i32,
    until_ramp: i32,
    /// Steps from one spawn, and from one move, to the next.
    spawn_every: i32,
    move_every: i32,
    ramps: u32,
}

/// Gold or an enemy.
#[derive(Clone, Copy, Debug)]
struct Thing {
    column: i32,
    /// 1 to the right, −1 to the left.
    way: i32,
    is_gold: bool,
}

/// Steps from one rise of the difficulty to the next.
const RAMP: i32 = 100;

impl Asterix {
    /// Takes the gold that the player is on; an enemy there ends the game.
    fn meet(&mut self, row: usize, outcome: &mut Outcome) {
        let is_met = |thing: &Thing| [row as i32 + 1, thing.column] == self.player;
        if let Some(thing) = self.things[row].filter(is_met) {
            if thing.is_gold {
                self.things[row] = None;
                outcome.reward += 1;
            } else {
                outcome.is_over = true;
            }
        }
    }

    fn spawn(&mut self, draws: &mut Draws) {
        let way = if draws.unit() < 0.5 { 1 } else { -1 };
        let is_gold = draws.unit() < 1.0 / 3.0;
        let free: Vec<usize> = (0..self.things.len()).filter(|&row| self.things[row].is_none()).collect();
        if !free.is_empty() {
            let column = if way > 0 { 0 } else { SIDE - 1 };
            self.things[free[draws.below(free.len())]] = Some(Thing { column, way, is_gold });
        }
    }

    fn ramp(&mut self) {
        if self.spawn_every <= 1 && self.move_every <= 1 {
            return;
        }
        if self.until_ramp >= 0 {
            self.until_ramp -= 1;
            return;
        }
        if self.move_every > 1 && !self.ramps.is_multiple_of(2) {
            self.move_every -= 1;
        }
        self.spawn_every -= i32::from(self.spawn_every > 1);
        self.ramps += 1;
        self.until_ramp = RAMP;
    }
}

impl Game for Asterix {
    const CHANNELS: &'static [&'static str] = &["player", "enemy", "trail", "gold"];
    const MOVES: &'static [(&'static str, Move)] =
        &[("stay", Move::Stay), ("left", Move::Left), ("up", Move::Up), ("right", Move::Right), ("down", Move::Down)];

    fn new(_: &mut Draws) -> Self {
        Self {
            player: [5, 5],
            things: [None; 8],
            until_spawn: 10,
            until_move: 5,
            until_ramp: RAMP,
            spawn_every: 10,
            move_every: 5,
            ramps: 0,
        }
    }

    fn step(&mut self, taken: Move, draws: &mut Draws) -> Outcome {
        let mut outcome = Outcome::default();
        if self.until_spawn == 0 {
            self.spawn(draws);
            self.until_spawn = self.spawn_every;
        }
        let [row, column] = self.player;
        self.player = [(row + taken.down()).clamp(1, SIDE - 2), (column + taken.right()).clamp(0, SIDE - 1)];
        for row in 0..self.things.len() {
            self.meet(row, &mut outcome);
        }
        if self.until_move == 0 {
            self.until_move = self.move_every;
            for row in 0..self.things.len() {
                if let Some(thing) = &mut self.things[row] {
                    thing.column += thing.way;
                    if !is_inside(thing.column) {
                        self.things[row] = None;
                    }
                }
                self.meet(row, &mut outcome);
            }
        }
        self.until_spawn -= 1;
        self.until_move -= 1;
        self.ramp();
        outcome
    }

    fn boards(&self) -> Vec<Board> {
        let mut boards = vec![cell(self.player[0], self.player[1]), 0, 0, 0];
        for (row, thing) in (1..).zip(self.things) {
            let Some(Thing { column, way, is_gold }) = thing else { continue };
            boards[if is_gold { 3 } else { 1 }] |= cell(row, column);
            if is_inside(column - way) {
                boards[2] |= cell(row, column - way);
            }
        }
        boards
    }
}
