//! Seaquest: a submarine shoots fish and other submarines, rescues divers and surfaces for oxygen, among ever more enemies.

use super::board::{Board, Draws, FIRST_COLUMN, LAST_COLUMN, SIDE, cell, is_inside};
use super::{Game, Move, Outcome};

/// A game of Seaquest.
#[derive(Clone, Debug)]
pub(crate) struct Seaquest {
    place: [i32; 2],
    /// 1 to the right, −1 to the left.
    way: i32,
    oxygen: i32,
    /// Divers on board. As in the package, it is −1 after six were brought up.
    rescued: i32,
    is_up: bool,
    own_bullets: Vec<Swimmer>,
    /// Bullets to the left, and to the right.
    bullets: [Board; 2],
    /// Fish, and submarines.
    enemies: [Vec<Swimmer>; 2],
    divers: Vec<Swimmer>,
    until_enemy: i32,
    until_diver: i32,
    until_ready: i32,
    /// Steps from one spawn of an enemy to the next, and those that an enemy waits between two moves.
    spawn_every: i32,
    enemy_wait: i32,
    ramps: u32,
}

/// Anything that moves along a row.
#[derive(Clone, Copy, Debug)]
struct Swimmer {
    place: [i32; 2],
    /// 1 to the right, −1 to the left.
    way: i32,
    until_move: i32,
    /// Steps until an enemy submarine shoots.
    until_shot: i32,
}

const SUBMARINES: usize = 1;
const DEEPEST: i32 = SIDE - 2;
const FULL: i32 = 200;
const SEATS: i32 = 6;
const ENEMY_EVERY: i32 = 20;
const DIVER_EVERY: i32 = 30;
const READY_AFTER: i32 = 5;
const SHOT_EVERY: i32 = 10;
/// Steps that a diver waits between two moves, and an enemy at first and at last.
const WAIT: i32 = 5;
const SHORTEST_WAIT: i32 = 2;

impl Swimmer {
    /// Draws one at an edge.
    fn new(right: bool, row: i32, wait: i32) -> Self {
        let (column, way) = if right { (0, 1) } else { (SIDE - 1, -1) };
        Self { place: [row, column], way, until_move: wait, until_shot: SHOT_EVERY }
    }

    /// Lets a step pass, in which it moves if it has waited.
    fn swim(&mut self, wait: i32) {
        if self.until_move == 0 {
            self.until_move = wait;
            self.place[1] += self.way;
        } else {
            self.until_move -= 1;
        }
    }

    fn is_inside(&self) -> bool {
        is_inside(self.place[1])
    }

    /// Returns the cell; none outside.
    fn cell(&self) -> Board {
        if self.is_inside() { cell(self.place[0], self.place[1]) } else { 0 }
    }
}

fn cells(swimmers: &[Swimmer]) -> Board {
    swimmers.iter().fold(0, |board, swimmer| board | swimmer.cell())
}

impl Seaquest {
    fn spawn(&mut self, draws: &mut Draws) {
        if self.until_enemy == 0 {
            self.until_enemy = self.spawn_every;
            let right = draws.unit() < 0.5;
            let kind = usize::from(draws.unit() < 1.0 / 3.0);
            let enemy = Swimmer::new(right, 1 + draws.below(8) as i32, self.enemy_wait);
            let is_towards = |other: &Swimmer| other.place[0] == enemy.place[0] && other.way != enemy.way;
            if !self.enemies.iter().flatten().any(is_towards) {
                self.enemies[kind].push(enemy);
            }
        }
        if self.until_diver == 0 {
            self.until_diver = DIVER_EVERY;
            let right = draws.unit() < 0.5;
            self.divers.push(Swimmer::new(right, 1 + draws.below(8) as i32, WAIT));
        }
    }

    fn act(&mut self, taken: Move) {
        if taken == Move::Fire && self.until_ready == 0 {
            self.own_bullets.push(Swimmer { place: self.place, way: self.way, until_move: 0, until_shot: 0 });
            self.until_ready = READY_AFTER;
        }
        let [row, column] = self.place;
        self.place = [(row + taken.down()).clamp(0, DEEPEST), (column + taken.right()).clamp(0, SIDE - 1)];
        if taken.right() != 0 {
            self.way = taken.right();
        }
    }

    /// Moves the own bullets, the newest first; one that meets an enemy is gone with it.
    fn move_own_bullets(&mut self, outcome: &mut Outcome) {
        for index in (0..self.own_bullets.len()).rev() {
            let bullet = &mut self.own_bullets[index];
            bullet.swim(0);
            let hit = self.enemies.iter_mut().find_map(|enemies| {
                let hit = enemies.iter().position(|enemy| enemy.place == bullet.place)?;
                Some(enemies.remove(hit))
            });
            outcome.reward += u32::from(hit.is_some());
            if hit.is_some() || !bullet.is_inside() {
                self.own_bullets.remove(index);
            }
        }
    }

    /// Moves the divers, the newest first, and takes those that the submarine meets on board.
    fn move_divers(&mut self) {
        for index in (0..self.divers.len()).rev() {
            let diver = &mut self.divers[index];
            let is_met = |diver: &Swimmer| diver.place == self.place && self.rescued < SEATS;
            let is_rescued = is_met(diver) || {
                diver.swim(WAIT);
                is_met(diver)
            };
            self.rescued += i32::from(is_rescued);
            if is_rescued || !diver.is_inside() {
                self.divers.remove(index);
            }
        }
    }

    /// Moves the enemies of a kind, the newest first.
    fn move_enemies(&mut self, kind: usize, outcome: &mut Outcome) {
        for index in (0..self.enemies[kind].len()).rev() {
            let enemy = &mut self.enemies[kind][index];
            outcome.is_over |= enemy.place == self.place;
            enemy.swim(self.enemy_wait);
            outcome.is_over |= enemy.place == self.place;
            if kind == SUBMARINES {
                enemy.until_shot -= 1;
                if enemy.until_shot < 0 {
                    enemy.until_shot = SHOT_EVERY;
                    self.bullets[usize::from(enemy.way > 0)] |= enemy.cell();
                }
            }
            let hit = self.own_bullets.iter().position(|bullet| bullet.place == enemy.place);
            if let Some(bullet) = hit {
                self.own_bullets.remove(bullet);
                outcome.reward += 1;
            }
            if hit.is_some() || !enemy.is_inside() {
                self.enemies[kind].remove(index);
            }
        }
    }

    fn move_bullets(&mut self, outcome: &mut Outcome) {
        let [left, right] = self.bullets;
        self.bullets = [(left & !FIRST_COLUMN) >> 1, (right & !LAST_COLUMN) << 1];
        let hits = left | right | self.bullets[0] | self.bullets[1];
        outcome.is_over |= hits & cell(self.place[0], self.place[1]) != 0;
    }

    /// Takes oxygen and brings divers up, which ends the game without any.
    fn surface(&mut self, outcome: &mut Outcome) {
        self.is_up = true;
        if self.rescued == 0 {
            outcome.is_over = true;
            return;
        }
        if self.rescued == SEATS {
            self.rescued = 0;
            outcome.reward += self.oxygen_cells() as u32;
        }
        self.oxygen = FULL;
        self.rescued -= 1;
        if self.spawn_every > 1 || self.enemy_wait > SHORTEST_WAIT {
            if self.enemy_wait > SHORTEST_WAIT && !self.ramps.is_multiple_of(2) {
                self.enemy_wait -= 1;
            }
            self.spawn_every -= i32::from(self.spawn_every > 1);
            self.ramps += 1;
        }
    }

    fn oxygen_cells(&self) -> i32 {
        self.oxygen.max(0) * SIDE / FULL
    }
}

impl Game for Seaquest {
    const CHANNELS: &'static [&'static str] =
        &["front", "back", "own_bullet", "trail", "bullet", "fish", "submarine", "oxygen", "rescued", "diver"];
    const MOVES: &'static [(&'static str, Move)] = &[
        ("stay", Move::Stay),
        ("left", Move::Left),
        ("up", Move::Up),
        ("right", Move::Right),
        ("down", Move::Down),
        ("fire", Move::Fire),
    ];

    fn new(_: &mut Draws) -> Self {
        Self {
            place: [0, 5],
            way: -1,
            oxygen: FULL,
            rescued: 0,
            is_up: true,
            own_bullets: vec![],
            bullets: [0; 2],
            enemies: [vec![], vec![]],
            divers: vec![],
            until_enemy: ENEMY_EVERY,
            until_diver: DIVER_EVERY,
            until_ready: 0,
            spawn_every: ENEMY_EVERY,
            enemy_wait: WAIT,
            ramps: 0,
        }
    }

    fn step(&mut self, taken: Move, draws: &mut Draws) -> Outcome {
        let mut outcome = Outcome::default();
        self.spawn(draws);
        self.act(taken);
        self.move_own_bullets(&mut outcome);
        self.move_divers();
        self.move_enemies(SUBMARINES, &mut outcome);
        self.move_bullets(&mut outcome);
        self.move_enemies(0, &mut outcome);
        self.until_enemy -= 1;
        self.until_diver -= 1;
        self.until_ready -= i32::from(self.until_ready > 0);
        outcome.is_over |= self.oxygen <= 0;
        if self.place[0] > 0 {
            self.oxygen -= 1;
            self.is_up = false;
        } else if !self.is_up {
            self.surface(&mut outcome);
        }
        outcome
    }

    fn boards(&self) -> Vec<Board> {
        let [row, column] = self.place;
        let swimmers = self.enemies.iter().chain([&self.divers]).flatten();
        let trail = swimmers.fold(0, |trail, swimmer| {
            let [row, column] = swimmer.place;
            trail | Swimmer { place: [row, column - swimmer.way], ..*swimmer }.cell()
        });
        let bar = |from: i32, cells: i32| ((1 << cells) - 1) * cell(SIDE - 1, from);
        vec![
            cell(row, column),
            cell(row, column - self.way),
            cells(&self.own_bullets),
            trail,
            self.bullets[0] | self.bullets[1],
            cells(&self.enemies[0]),
            cells(&self.enemies[SUBMARINES]),
            bar(0, self.oxygen_cells()),
            bar(SIDE - 1 - self.rescued.max(0), self.rescued.max(0)),
            cells(&self.divers),
        ]
    }
}
