//! Games of MinAtar: images of ten by ten cells, each with a flag for every channel.
//!
//! The rules are those of the package `minatar` 1.0.15 with its sticky actions and rising difficulty; an episode here has at most
//! 5,000 actions, or Freeway's 2,501.

mod asterix;
mod board;
mod breakout;
mod freeway;
mod seaquest;
mod space_invaders;

pub(crate) use asterix::Asterix;
pub(crate) use breakout::Breakout;
pub(crate) use freeway::Freeway;
pub(crate) use seaquest::Seaquest;
pub(crate) use space_invaders::SpaceInvaders;

use crate::sight::Sight;
use board::{Board, Draws, SIDE};
use std::marker::PhantomData;
use tpg_engine::random::Stream;
use tpg_engine::{Act, ActionSpace, End, Environment, SourceSet, Step};
use tpg_graph::SourceDocument;
use tpg_graph::image::Image;
use tpg_runtime::scalar::Scalar;

/// The probability that the last move is made once more instead of the one that is chosen.
const STICKY: f64 = 0.1;

/// A game.
pub(crate) trait Game: Clone + Send + Sync + 'static {
    /// The names of the image's channels; the first one shows what the player moves.
    const CHANNELS: &'static [&'static str];
    /// The names of the actions, and the moves that they are.
    const MOVES: &'static [(&'static str, Move)];
    /// Actions of an episode.
    const ACTIONS: u32 = 5000;

    /// Begins a game.
    fn new(draws: &mut Draws) -> Self;
    /// Makes a move.
    fn step(&mut self, taken: Move, draws: &mut Draws) -> Outcome;
    /// Returns the channels.
    fn boards(&self) -> Vec<Board>;
}

/// A move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Move {
    Stay,
    Left,
    Up,
    Right,
    Down,
    Fire,
}

impl Move {
    fn right(self) -> i32 {
        i32::from(self == Self::Right) - i32::from(self == Self::Left)
    }

    fn down(self) -> i32 {
        i32::from(self == Self::Down) - i32::from(self == Self::Up)
    }
}

/// The consequence of a move.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Outcome {
    reward: u32,
    is_over: bool,
}

/// A game as a problem. A policy reads features of the image: see [`features_of`](tpg_graph::image::features_of).
#[derive(Clone, Debug)]
pub(crate) struct MinAtar<G>(Sight, PhantomData<G>);

impl<G: Game> Default for MinAtar<G> {
    fn default() -> Self {
        Self(Sight::new([SIDE as usize; 2], G::CHANNELS, 1), PhantomData)
    }
}

/// A running game.
#[derive(Clone, Debug)]
pub(crate) struct Play<G> {
    game: G,
    draws: Draws,
    last: Move,
}

impl<G: Game> Play<G> {
    fn new(seed: u64) -> Self {
        let mut draws = Draws { seed, drawn: 0 };
        Self { game: G::new(&mut draws), draws, last: Move::Stay }
    }

    fn step(&mut self, choice: usize) -> Outcome {
        if self.draws.unit() >= STICKY {
            self.last = G::MOVES[choice].1;
        }
        self.game.step(self.last, &mut self.draws)
    }
}

/// The channels of a game as an image.
struct Boards(Vec<Board>);

impl Boards {
    fn place(bit: u32) -> [usize; 2] {
        let bit = bit as usize;
        [bit / SIDE as usize, bit % SIDE as usize]
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

impl<S: Scalar, G: Game> Environment<S> for MinAtar<G> {
    /// The seed of the game's draws.
    type Task = u64;
    type Episode = Play<G>;

    fn sources(&self) -> Vec<SourceDocument> {
        self.0.sources()
    }

    fn actions(&self) -> ActionSpace {
        ActionSpace::discrete(G::MOVES.iter().map(|(name, _)| *name))
    }

    fn outcomes(&self) -> &'static [&'static str] {
        &["lost", "time limit"]
    }

    fn time_limit(&self) -> u32 {
        G::ACTIONS
    }

    fn draw(&self, stream: &mut Stream) -> u64 {
        stream.bits()
    }

    fn start(&self, seed: &u64) -> Play<G> {
        Play::new(*seed)
    }

    fn observe(&self, play: &mut Play<G>, _: SourceSet, state: &mut [S]) {
        self.0.look(&Boards(play.game.boards()), 0..state.len(), state);
    }

    fn observe_some(&self, play: &mut Play<G>, _: SourceSet, inputs: &[u16], state: &mut [S]) {
        self.0.look(&Boards(play.game.boards()), inputs.iter().map(|&input| input.into()), state);
    }

    fn step(&self, play: &mut Play<G>, act: Act<'_, S>) -> Step {
        let Outcome { reward, is_over } = play.step(act.choice());
        let step = Step::reward(reward.into());
        if is_over { step.ending(End::new(0)) } else { step }
    }
}

#[cfg(test)]
mod tests {
    use super::board::{SIDE, cell, is_inside};
    use super::{Asterix, Board, Boards, Breakout, Draws, Freeway, Game, Outcome, Play, Seaquest, SpaceInvaders};

    /// Returns the number of episodes, the rewards, and a digest of 20,000 steps by random moves.
    fn played<G: Game>() -> (u32, u32, u64) {
        let mut seed = 7;
        let (mut choices, mut play) = (Draws { seed: seed ^ 0xABCD, drawn: 0 }, Play::<G>::new(seed));
        let (mut episodes, mut rewards, mut digest) = (0, 0, 0xCBF2_9CE4_8422_2325_u64);
        let mut actions = 0;
        for _ in 0..20_000 {
            let choice = choices.below(G::MOVES.len());
            let Outcome { reward, is_over } = play.step(choice);
            rewards += reward;
            actions += 1;
            let is_over = is_over || actions == G::ACTIONS;
            let head = [choice as u128, reward.into(), is_over.into()];
            for word in head.into_iter().chain(play.game.boards()) {
                let bytes = word.to_le_bytes();
                digest =
                    bytes.iter().fold(digest, |digest, &byte| (digest ^ u64::from(byte)).wrapping_mul(0x100_0000_01B3));
            }
            if is_over {
                seed += 1;
                episodes += 1;
                actions = 0;
                play = Play::new(seed);
            }
        }
        (episodes, rewards, digest)
    }

    /// The numbers are those that `minatar/record.py` prints of the package, with the same draws.
    #[test]
    fn games_are_played_as_by_the_package() {
        assert_eq!(played::<Breakout>(), (1957, 810, 0x991C_8C9C_CDE9_49F8));
        assert_eq!(played::<Asterix>(), (302, 153, 0x772F_5132_2391_A234));
        assert_eq!(played::<SpaceInvaders>(), (347, 1408, 0xB7CD_AE94_84D2_839B));
        assert_eq!(played::<Freeway>(), (7, 4, 0x0DD4_6901_BD36_68BF));
        assert_eq!(played::<Seaquest>(), (619, 60, 0x1BA6_5B22_032E_6033));
    }

    /// Returns the mean return of a rule over some games. A rule chooses from the boards, the player's place, and a function that tests
    /// whether a channel is set so far down and to the right of the player.
    fn ruled<G: Game>(games: u64, rule: impl Fn(&[Board], [i32; 2], &dyn Fn(usize, i32, i32) -> bool) -> usize) -> f64 {
        let mut rewards = 0;
        for seed in 0..games {
            let mut play = Play::<G>::new(seed);
            for _ in 0..G::ACTIONS {
                let boards = play.game.boards();
                let at = Boards::place(boards[0].trailing_zeros()).map(|place| place as i32);
                let is_set = |channel: usize, down: i32, right: i32| {
                    let [row, column] = [at[0] + down, at[1] + right];
                    is_inside(row) && is_inside(column) && boards[channel] & cell(row, column) != 0
                };
                let outcome = play.step(rule(&boards, at, &is_set));
                rewards += outcome.reward;
                if outcome.is_over {
                    break;
                }
            }
        }
        f64::from(rewards) / games as f64
    }

    /// The chicken goes up unless a car is, or will soon be, in the cell above, and makes room for a car that comes.
    #[test]
    fn a_careful_chicken_crosses_the_road() {
        let careful = ruled::<Freeway>(20, |_, _, is_set| {
            let is_hit = |down| {
                let comes = |speed, far| {
                    [-1, 1].iter().any(|side| is_set(1, down, side * far) && is_set(speed, down, side * (far + 1)))
                };
                is_set(1, down, 0) || comes(2, 2) || (2..7).any(|speed| comes(speed, 1))
            };
            match [-1, 0, 1].map(is_hit) {
                [false, ..] => 1,
                [_, true, false] => 2,
                _ => 0,
            }
        });
        let hasty = ruled::<Freeway>(20, |_, _, _| 1);
        assert!(careful > 62.0 && hasty < 25.0, "{careful} {hasty}");
    }

    /// The submarine shoots what is ahead, turns to what is behind, keeps away from enemies and fetches divers until it has to surface.
    #[test]
    fn a_submarine_surfaces_with_divers() {
        let score = ruled::<Seaquest>(200, |boards, [row, column], is_set| {
            let [stay, left, up, right, down, fire] = [0, 1, 2, 3, 4, 5];
            let is_near = |down, right| (-2..=2).any(|by| (4..7).any(|enemy| is_set(enemy, down, right + by)));
            let is_target = |right| is_set(5, 0, right) || is_set(6, 0, right);
            let [oxygen, rescued] = [7, 8].map(|channel: usize| boards[channel].count_ones());
            let to = if boards[9] == 0 || rescued == 6 { [5, 5] } else { Boards::place(boards[9].trailing_zeros()) };
            let [to_row, to_column] = to.map(|place| place as i32);
            let (ahead, turn) = if is_set(1, 0, -1) { (1, left) } else { (-1, right) };
            let is_blocked = (4..7).any(|enemy| is_set(enemy, -1, 0));
            let can_rise = row > 1 && !is_near(-1, 0);
            let can_dive = row < SIDE - 2 && !is_near(1, 0);
            let moves = [
                (!is_blocked && (rescued == 6 || rescued > 0 && oxygen < 4), up),
                ((1..5).any(|far| is_target(ahead * far)), fire),
                ((2..5).any(|far| is_target(-ahead * far)), turn),
                (is_near(0, 0) && can_dive, down),
                (is_near(0, 0) && can_rise, up),
                (to_row > row && can_dive, down),
                (to_row < row && can_rise, up),
                (to_column > column && !is_near(0, 1), right),
                (to_column < column && !is_near(0, -1), left),
            ];
            moves.iter().find(|(is_wise, _)| *is_wise).map_or(stay, |(_, wise)| *wise)
        });
        assert!(score > 12.0, "{score}");
    }
}
