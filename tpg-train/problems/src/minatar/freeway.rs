//! Freeway: a chicken crosses eight lanes of cars, which change their speeds whenever it has arrived.

use super::board::{Board, Draws, SIDE, cell};
use super::{Game, Move, Outcome};

/// A game of Freeway.
#[derive(Clone, Debug)]
pub(crate) struct Freeway {
    row: i32,
    /// Steps until the chicken can move.
    until_ready: i32,
    /// The cars of rows 1 to 8.
    cars: [Car; 8],
}

#[derive(Clone, Copy, Debug, Default)]
struct Car {
    column: i32,
    until_move: i32,
    /// 1 to the right, −1 to the left.
    way: i32,
    /// Steps that the car waits between two moves.
    wait: i32,
}

/// The column of the chicken, and the row where it begins.
const COLUMN: i32 = 4;
const START: i32 = SIDE - 1;
/// Steps from one move of the chicken to the next.
const MOVE_EVERY: i32 = 3;
/// The longest wait of a car.
const SLOWEST: usize = 5;

impl Freeway {
    fn change_speeds(&mut self, draws: &mut Draws) {
        for car in &mut self.cars {
            car.wait = 1 + draws.below(SLOWEST) as i32;
            car.until_move = car.wait;
        }
        for car in &mut self.cars {
            car.way = if draws.unit() > 0.5 { 1 } else { -1 };
        }
    }
}

impl Car {
    /// Returns the column that is so many cells ahead; cars that leave come back at the other side.
    fn ahead(&self, cells: i32) -> i32 {
        (self.column + cells * self.way).rem_euclid(SIDE)
    }
}

impl Game for Freeway {
    const CHANNELS: &'static [&'static str] = &["chicken", "car", "speed1", "speed2", "speed3", "speed4", "speed5"];
    const MOVES: &'static [(&'static str, Move)] = &[("stay", Move::Stay), ("up", Move::Up), ("down", Move::Down)];
    const ACTIONS: u32 = 2501;

    fn new(draws: &mut Draws) -> Self {
        let mut game = Self { row: START, until_ready: MOVE_EVERY, cars: [Car::default(); 8] };
        game.change_speeds(draws);
        game
    }

    fn step(&mut self, taken: Move, draws: &mut Draws) -> Outcome {
        let mut outcome = Outcome::default();
        if taken.down() != 0 && self.until_ready == 0 {
            self.until_ready = MOVE_EVERY;
            self.row = (self.row + taken.down()).min(START);
        }
        if self.row == 0 {
            outcome.reward = 1;
            self.change_speeds(draws);
            self.row = START;
        }
        for (row, car) in (1..).zip(&mut self.cars) {
            let mut is_hit = car.column == COLUMN;
            if car.until_move == 0 {
                car.until_move = car.wait;
                car.column = car.ahead(1);
                is_hit |= car.column == COLUMN;
            } else {
                car.until_move -= 1;
            }
            if is_hit && row == self.row {
                self.row = START;
            }
        }
        self.until_ready -= i32::from(self.until_ready > 0);
        outcome
    }

    fn boards(&self) -> Vec<Board> {
        let mut boards = vec![0; Self::CHANNELS.len()];
        boards[0] = cell(self.row, COLUMN);
        for (row, car) in (1..).zip(&self.cars) {
            boards[1] |= cell(row, car.column);
            boards[1 + car.wait as usize] |= cell(row, car.ahead(-1));
        }
        boards
    }
}
