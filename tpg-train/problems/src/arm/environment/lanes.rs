//! Many arms in parallel, for policies that see ticks, hand and target as they are.
//!
//! Nearly every step is a regular one: a joint moves within its range, the arm stays clear of everything, and the hand is
//! not yet near the target. [Regular steps](regular::take) are vectorised with the same functions; all others go through
//! [`ArmEnvironment::advance`], which alone implements the rules.

use super::{ArmEnvironment, ArmEpisode, ArmTask, regular};
use crate::registry::Number;
use fearless_simd::{Level, dispatch};
use std::array::from_fn;
use tpg_arm::observation::Source;
use tpg_arm::{JOINTS, Move, Pose};
use tpg_engine::{Acts, BLOCK, Block, Environment, EpisodeResult, Episodes, EvaluationError, SourceSet, View};

/// Columns of neighbouring lanes: what regular steps need.
#[derive(Clone, Debug)]
pub(super) struct Group<S> {
    pub(super) ticks: [Block<i32>; JOINTS],
    pub(super) target: [Block<S>; 3],
    pub(super) hand: [Block<S>; 3],
    /// A squared distance above this is not a success, mm²; NaN if no step is regular.
    pub(super) far: Block<S>,
    /// Remaining actions, minus the last one allowed; from 0 on, steps are not regular.
    pub(super) left: Block<i32>,
    /// Ticks before the last action.
    pub(super) before: [Block<i32>; JOINTS],
    /// True if the last action was not a regular step.
    pub(super) other: Block<bool>,
}

impl<S: Number> Group<S> {
    fn new() -> Self {
        let (ticks, axes) = ([[0; BLOCK]; JOINTS], [[S::ZERO; BLOCK]; 3]);
        let (far, left, other) = ([S::ZERO; BLOCK], [0; BLOCK], [false; BLOCK]);
        Self { ticks, target: axes, hand: axes, far, left, before: ticks, other }
    }
}

/// [`ArmEnvironment::lanes`] of sources that [are in columns](is_in_columns).
pub(super) struct ArmLanes<'e, S: Copy> {
    environment: &'e ArmEnvironment<S>,
    /// Move of each action, followed by the move used for actions that do not exist.
    moves: Vec<[i32; JOINTS]>,
    groups: Vec<Group<S>>,
    keys: Vec<Block<u64>>,
    /// Data that regular steps do not need; the poses are stale.
    episodes: Vec<ArmEpisode<S>>,
    level: Level,
}

/// True if a source depends only on ticks, hand and target.
pub(super) fn is_in_columns(source: &Source) -> bool {
    !matches!(source, Source::Polar | Source::Floor | Source::Stance)
}

impl<'e, S: Number> ArmLanes<'e, S> {
    pub(super) fn new(environment: &'e ArmEnvironment<S>) -> Self {
        let moves = environment.moves.iter().chain([&Move::STOP]).map(|moves| moves.0.map(i32::from)).collect();
        let (groups, keys, episodes) = (Vec::new(), Vec::new(), Vec::new());
        Self { environment, moves, groups, keys, episodes, level: Level::new() }
    }

    /// Brings a lane's episode up to date: its pose and everything derived from it.
    fn caught_up(&mut self, lane: usize) -> &mut ArmEpisode<S> {
        let Group { ticks, left, .. } = &self.groups[lane / BLOCK];
        let pose = Pose(from_fn(|joint| ticks[joint][lane % BLOCK] as i16));
        let episode = &mut self.episodes[lane];
        episode.actions = (self.environment.problem.max_actions as i32 - 1 - left[lane % BLOCK]) as u32;
        if episode.pose != pose {
            let plane_moved = (episode.pose.packed() ^ pose.packed()) >> 16 != 0;
            let plane = plane_moved.then(|| self.environment.plane(pose));
            self.environment.arrive(episode, pose, plane);
        }
        episode
    }

    /// Writes a lane's episode into the columns.
    fn put(&mut self, lane: usize) {
        let (environment, episode) = (self.environment, &self.episodes[lane]);
        let (group, place) = (&mut self.groups[lane / BLOCK], lane % BLOCK);
        (0..JOINTS).for_each(|joint| group.ticks[joint][place] = episode.pose.0[joint].into());
        (0..3).for_each(|axis| group.target[axis][place] = episode.target[axis]);
        (0..3).for_each(|axis| group.hand[axis][place] = episode.hand[axis]);
        // Wide enough for every rounding error. An arm that collides in its current pose never takes a regular step.
        let far = environment.tolerance * environment.tolerance * S::from_f64(1.01);
        let is_regular = !episode.collides && episode.roughness == 1;
        group.far[place] = if is_regular { far } else { S::from_f64(f64::NAN) };
        group.left[place] = environment.problem.max_actions as i32 - 1 - episode.actions as i32;
        self.keys[lane / BLOCK][place] = episode.pose.packed();
    }

    /// Writes a source in every lane.
    fn show(&self, source: Source, at: usize, view: &mut View<'_, S>) {
        let mut fill = |value: usize, each: &dyn Fn(&Group<S>) -> Block<S>| {
            if let Some(column) = view.column(at + value) {
                for (block, group) in column.iter_mut().zip(&self.groups) {
                    *block = each(group);
                }
            }
        };
        match source {
            Source::Target => (0..3).for_each(|axis| fill(axis, &|group| group.target[axis])),
            Source::Hand => (0..3).for_each(|axis| fill(axis, &|group| group.hand[axis])),
            Source::Difference => (0..3).for_each(|axis| {
                fill(axis, &|group| from_fn(|lane| group.target[axis][lane] - group.hand[axis][lane]));
            }),
            _ => {
                (0..JOINTS).for_each(|joint| fill(joint, &|group| group.ticks[joint].map(S::from_i32)));
                for (servo, ticks) in self.environment.arm.fixed_servos.into_iter().enumerate() {
                    if source == Source::Servos {
                        fill(JOINTS + servo, &|_| [S::from_i32(i32::from(ticks)); BLOCK]);
                    }
                }
            }
        }
    }
}

impl<S: Number> Episodes<S, ArmTask> for ArmLanes<'_, S> {
    fn begin(&mut self, lane: usize, task: &ArmTask) -> Result<(), EvaluationError> {
        let episode = self.environment.start(task);
        if lane / BLOCK == self.groups.len() {
            self.groups.push(Group::new());
            self.keys.push([0; BLOCK]);
        }
        if lane == self.episodes.len() {
            self.episodes.push(episode);
        } else {
            self.episodes[lane] = episode;
        }
        self.put(lane);
        Ok(())
    }

    fn step(&mut self, acts: Acts<'_, S>, ended: &mut Vec<(usize, EpisodeResult)>) -> Result<(), EvaluationError> {
        let actions = acts.choices();
        let Self { environment, moves, groups, keys, .. } = self;
        dispatch!(self.level, _ => regular::take(environment, moves, groups, keys, actions));
        for (lane, &action) in actions.iter().enumerate() {
            let (environment, group, place) = (self.environment, &mut self.groups[lane / BLOCK], lane % BLOCK);
            if !group.other[place] {
                continue;
            }
            (0..JOINTS).for_each(|joint| group.ticks[joint][place] = group.before[joint][place]);
            group.left[place] += 1;
            let ending = environment.advance(self.caught_up(lane), usize::from(action.0));
            self.put(lane);
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
        for (place, (&source, &at)) in environment.problem.sources.iter().zip(&environment.places).enumerate() {
            if wanted.contains(place) {
                self.show(source, at, view);
            }
        }
        Ok(())
    }

    fn close_up(&mut self, lane: usize) {
        let last = self.episodes.len() - 1;
        self.caught_up(last);
        self.episodes.swap_remove(lane);
        if lane < last {
            self.put(lane);
        }
        self.groups.truncate(last.div_ceil(BLOCK));
        self.keys.truncate(last.div_ceil(BLOCK));
    }
}
