//! Many arms in parallel.
//!
//! Nearly every step is a regular one: a joint moves within its range, the arm stays clear of everything, and the hand is
//! not yet near the target. [Regular steps](Regular) are vectorised with the same functions; all others go through
//! [`ArmEnvironment::step`], which alone implements the rules. The most common sources are observed in vectors as well,
//! the others by [`ArmEnvironment::observe`].

use super::clearance::swing;
use super::group::{Group, Lane};
use super::regular::Regular;
use super::{ArmEnvironment, ArmEpisode, ArmTask};
use crate::registry::Number;
use fearless_simd::{Level, dispatch};
use tpg_arm::observation::Source;
use tpg_arm::{JOINTS, Move, Play};
use tpg_engine::{Acts, BLOCK, Block, Environment, EpisodeResult, Episodes, EvaluationError, SourceSet, View};

/// [`ArmEnvironment::lanes`].
pub(super) struct ArmLanes<'e, S: Copy> {
    environment: &'e ArmEnvironment<S>,
    /// Move of each action, followed by the move used for actions that do not exist.
    moves: Vec<[i32; JOINTS]>,
    groups: Vec<Group<S>>,
    keys: Vec<Block<u64>>,
    /// Data that regular steps do not need; the poses are stale.
    episodes: Vec<ArmEpisode<S>>,
    state: Vec<S>,
    level: Level,
}

impl<'e, S: Number> ArmLanes<'e, S> {
    pub(super) fn new(environment: &'e ArmEnvironment<S>) -> Self {
        let moves = environment.moves.iter().chain([&Move::STOP]).map(|moves| moves.0.map(i32::from)).collect();
        let length = environment.problem.sources.iter().map(|source| source.length()).sum();
        Self {
            environment,
            moves,
            groups: Vec::new(),
            keys: Vec::new(),
            episodes: Vec::new(),
            state: vec![S::ZERO; length],
            level: Level::new(),
        }
    }

    /// Brings a lane's episode up to date: its pose and everything derived from it.
    fn caught_up(&mut self, lane: usize) -> &mut ArmEpisode<S> {
        let group = &self.groups[lane / BLOCK];
        let pose = group.pose(lane % BLOCK);
        let episode = &mut self.episodes[lane];
        episode.actions = (self.environment.problem.max_actions as i32 - 1 - group.now.left[lane % BLOCK]) as u32;
        if episode.pose != pose {
            let plane_moved = (episode.pose.packed() ^ pose.packed()) >> 16 != 0;
            let plane = plane_moved.then(|| self.environment.plane(pose));
            self.environment.arrive(episode, pose, plane);
        }
        episode
    }

    /// Returns a distance, mm, beyond which play leads no hand astray from where its motors would put it.
    fn astray(&self, play: Play) -> S {
        if play == Play::NONE {
            return S::ZERO;
        }
        let ticks: i32 = play.0.iter().map(|&ticks| i32::from(ticks).abs()).sum();
        S::from_f64(swing(&self.environment.description, f64::from(ticks)))
    }

    /// Returns the lane that corresponds to an episode.
    fn lane(&self, episode: &ArmEpisode<S>) -> Lane<S> {
        let tolerance =
            self.environment.tolerance * S::from_i32(i32::from(episode.roughness)) + self.astray(episode.play);
        Lane {
            ticks: episode.pose.0.map(i32::from),
            target: episode.target,
            hand: episode.hand,
            // Wide enough for every rounding error. An arm that collides in its current pose never takes a regular step.
            far: if episode.collides { S::from_f64(f64::NAN) } else { tolerance * tolerance * S::from_f64(1.01) },
            roughness: i32::from(episode.roughness as i8),
            left: self.environment.problem.max_actions as i32 - 1 - episode.actions as i32,
        }
    }
}

impl<S: Number> Episodes<S, ArmTask> for ArmLanes<'_, S> {
    fn begin(&mut self, lane: usize, task: &ArmTask) -> Result<(), EvaluationError> {
        let episode = self.environment.start(task);
        let (new, key) = (self.lane(&episode), episode.pose.packed());
        if lane / BLOCK == self.groups.len() {
            self.groups.push(Group::new(new));
            self.keys.push([key; BLOCK]);
        }
        if lane == self.episodes.len() {
            self.episodes.push(episode);
        } else {
            self.episodes[lane] = episode;
        }
        self.groups[lane / BLOCK].put(lane % BLOCK, new);
        self.keys[lane / BLOCK][lane % BLOCK] = key;
        Ok(())
    }

    fn step(&mut self, acts: Acts<'_, S>, ended: &mut Vec<(usize, EpisodeResult)>) -> Result<(), EvaluationError> {
        let actions = acts.choices();
        let Self { environment, moves, groups, keys, .. } = self;
        dispatch!(self.level, _ => Regular { environment, moves, groups, keys, actions }.take());
        for (lane, &action) in actions.iter().enumerate() {
            if !self.groups[lane / BLOCK].other[lane % BLOCK] {
                continue;
            }
            let environment = self.environment;
            self.groups[lane / BLOCK].take_back(lane % BLOCK);
            let ending = environment.advance(self.caught_up(lane), usize::from(action.0));
            let episode = &self.episodes[lane];
            let (new, key) = (self.lane(episode), episode.pose.packed());
            self.groups[lane / BLOCK].put(lane % BLOCK, new);
            self.keys[lane / BLOCK][lane % BLOCK] = key;
            ended.extend(ending.map(|ending| (lane, ending)));
        }
        Ok(())
    }

    fn keys(&self) -> &[u64] {
        &self.keys.as_flattened()[..self.episodes.len()]
    }

    fn cycle(&self, lane: usize, key: u64, actions: u32) -> Option<EpisodeResult> {
        self.environment.cycle(&self.episodes[lane], key, actions)
    }

    fn observe(&mut self, wanted: SourceSet, view: &mut View<'_, S>) -> Result<(), EvaluationError> {
        let environment = self.environment;
        let mut others = SourceSet::NONE;
        for (place, (source, &at)) in environment.problem.sources.iter().zip(&environment.places).enumerate() {
            if wanted.contains(place) && !self.show(*source, at, view) {
                others = others.with(place);
            }
        }
        if others == SourceSet::NONE {
            return Ok(());
        }
        for lane in 0..self.episodes.len() {
            self.caught_up(lane);
            environment.observe(&mut self.episodes[lane], others, &mut self.state);
            for (place, (source, &at)) in environment.problem.sources.iter().zip(&environment.places).enumerate() {
                if others.contains(place) {
                    for input in at..at + source.length() {
                        if let Some(column) = view.column(input) {
                            column[lane / BLOCK][lane % BLOCK] = self.state[input];
                        }
                    }
                }
            }
        }
        Ok(())
    }

    fn close_up(&mut self, lane: usize) {
        self.episodes.swap_remove(lane);
        let last = self.episodes.len();
        self.keys[lane / BLOCK][lane % BLOCK] = self.keys[last / BLOCK][last % BLOCK];
        if lane < last {
            let moved = self.groups[last / BLOCK].lane(last % BLOCK);
            self.groups[lane / BLOCK].put(lane % BLOCK, moved);
        }
        if last.is_multiple_of(BLOCK) {
            self.groups.truncate(last / BLOCK);
            self.keys.truncate(last / BLOCK);
        }
    }
}

impl<S: Number> ArmLanes<'_, S> {
    /// Writes a source in every lane, if it depends only on ticks, hand and target; returns false otherwise.
    fn show(&self, source: Source, at: usize, view: &mut View<'_, S>) -> bool {
        let mut fill = |value: usize, each: &dyn Fn(&Group<S>) -> Block<S>| {
            if let Some(column) = view.column(at + value) {
                for (block, group) in column.iter_mut().zip(&self.groups) {
                    *block = each(group);
                }
            }
        };
        match source {
            Source::Target => (0..3).for_each(|axis| fill(axis, &|group| group.now.target[axis])),
            Source::Hand => (0..3).for_each(|axis| fill(axis, &|group| group.now.hand[axis])),
            Source::Difference => (0..3).for_each(|axis| {
                fill(axis, &|group| {
                    std::array::from_fn(|lane| group.now.target[axis][lane] - group.now.hand[axis][lane])
                });
            }),
            Source::Motors | Source::Servos => {
                (0..JOINTS).for_each(|joint| fill(joint, &|group| group.now.ticks[joint].map(S::from_i32)));
                for (servo, ticks) in self.environment.arm.fixed_servos.into_iter().enumerate() {
                    if source == Source::Servos {
                        fill(JOINTS + servo, &|_| [S::from_i32(i32::from(ticks)); BLOCK]);
                    }
                }
            }
            _ => return false,
        }
        true
    }
}
