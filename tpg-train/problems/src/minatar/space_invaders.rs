//! Space Invaders: a cannon shoots aliens that come down, ever faster.

use super::board::{ALL, Board, Draws, FIRST_COLUMN, LAST_COLUMN, SIDE, block, cell, is_inside};
use super::{Game, Move, Outcome};

/// A game of Space Invaders.
#[derive(Clone, Debug)]
pub(crate) struct SpaceInvaders {
    cannon: i32,
    own_bullets: Board,
    bullets: Board,
    aliens: Board,
    go_right: bool,
    /// Steps from one move of the aliens to the next; fewer aliens move more often.
    move_every: i32,
    until_move: i32,
    until_shot: i32,
    until_ready: i32,
}

const WAVE: Board = block([0, 4], [2, 8]);
const LAST_ROW: Board = block([SIDE - 1, SIDE], [0, SIDE]);
/// Steps from one shot of the aliens to the next, and at least from one of the cannon to the next.
const SHOT_EVERY: i32 = 10;
const READY_AFTER: i32 = 5;
/// The shortest time between two moves of a whole wave.
const FASTEST: i32 = 6;

impl SpaceInvaders {
    /// Moves the aliens; true if they reach the cannon or the ground.
    fn march(&mut self, cannon: Board) -> bool {
        self.until_move = (self.aliens.count_ones() as i32).min(self.move_every);
        let edge = if self.go_right { LAST_COLUMN } else { FIRST_COLUMN };
        let mut is_over = false;
        if self.aliens & edge != 0 {
            self.go_right = !self.go_right;
            is_over = self.aliens & LAST_ROW != 0;
            // Aliens that leave at the bottom come back at the top.
            self.aliens = ((self.aliens << SIDE) | (self.aliens >> (SIDE * (SIDE - 1)))) & ALL;
        } else if self.go_right {
            self.aliens <<= 1;
        } else {
            self.aliens >>= 1;
        }
        is_over || self.aliens & cannon != 0
    }

    /// Lets the lowest alien of the column nearest to the cannon shoot.
    fn shoot(&mut self) {
        let nearest =
            (0..SIDE).flat_map(|far| [self.cannon - far, self.cannon + far]).filter(|&column| is_inside(column));
        let lowest = |column: i32| (0..SIDE).rev().map(|row| cell(row, column)).find(|at| self.aliens & at != 0);
        if let Some(alien) = nearest.into_iter().find_map(lowest) {
            self.bullets |= alien;
        }
    }
}

impl Game for SpaceInvaders {
    const CHANNELS: &'static [&'static str] = &["cannon", "alien", "alien_left", "alien_right", "own_bullet", "bullet"];
    const MOVES: &'static [(&'static str, Move)] =
        &[("stay", Move::Stay), ("left", Move::Left), ("right", Move::Right), ("fire", Move::Fire)];

    fn new(_: &mut Draws) -> Self {
        Self {
            cannon: 5,
            own_bullets: 0,
            bullets: 0,
            aliens: WAVE,
            go_right: false,
            move_every: 12,
            until_move: 12,
            until_shot: SHOT_EVERY,
            until_ready: 0,
        }
    }

    fn step(&mut self, taken: Move, _: &mut Draws) -> Outcome {
        if taken == Move::Fire && self.until_ready == 0 {
            self.own_bullets |= cell(SIDE - 1, self.cannon);
            self.until_ready = READY_AFTER;
        }
        self.cannon = (self.cannon + taken.right()).clamp(0, SIDE - 1);
        let cannon = cell(SIDE - 1, self.cannon);
        self.own_bullets >>= SIDE;
        self.bullets = (self.bullets << SIDE) & ALL;
        let mut is_over = (self.bullets | self.aliens) & cannon != 0;
        if self.until_move == 0 {
            is_over |= self.march(cannon);
        }
        if self.until_shot == 0 {
            self.until_shot = SHOT_EVERY;
            self.shoot();
        }
        let hit = self.aliens & self.own_bullets;
        self.aliens &= !hit;
        self.own_bullets &= !hit;
        self.until_ready -= i32::from(self.until_ready > 0);
        self.until_move -= 1;
        self.until_shot -= 1;
        if self.aliens == 0 {
            self.move_every -= i32::from(self.move_every > FASTEST);
            self.aliens = WAVE;
        }
        Outcome { reward: hit.count_ones(), is_over }
    }

    fn boards(&self) -> Vec<Board> {
        let (left, right) = if self.go_right { (0, self.aliens) } else { (self.aliens, 0) };
        vec![cell(SIDE - 1, self.cannon), self.aliens, left, right, self.own_bullets, self.bullets]
    }
}
