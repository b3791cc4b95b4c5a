//! Many arms side by side.
//!
//! Nearly every step is a usual one: a joint moves within its range, the arm stays clear of everything, the hand is not
//! near the target yet. Usual steps are done in vectors, by the same functions; every other one by
//! [`ArmEnvironment::step`], which alone knows the rules. What programs read most is shown in vectors as well, the rest by
//! [`ArmEnvironment::observe`].

use super::{ArmEnvironment, ArmEpisode, ArmScalar, ArmTask, base_angle, look_up};
use crate::engine::{BLOCK, Block, Ending, Environment, Episodes, SourceSet, View};
use pulp::{Arch, Simd, WithSimd};
use tpg_runtime::arm::{JOINTS, Move, Pose};
use tpg_runtime::kinematics::{Angle, Direction, Directions, Plane, difference, link_angles};
use tpg_runtime::observation::Source;
use tpg_runtime::policy::ActionId;

/// Neighbouring lanes, as usual steps need them.
#[derive(Clone, Debug)]
struct Group<S> {
    ticks: [Block<i32>; JOINTS],
    target: [Block<S>; 3],
    hand: [Block<S>; 3],
    /// A squared distance above this is no success, mm².
    far: Block<S>,
    roughness: Block<i32>,
    /// Actions before the last one that is allowed; from 0 on, steps are not usual.
    left: Block<i32>,
    /// The ticks before this action.
    before: [Block<i32>; JOINTS],
    /// Whether this action was not a usual one.
    other: Block<bool>,
}

/// [`ArmEnvironment::lanes`].
pub(super) struct ArmLanes<'e, S> {
    environment: &'e ArmEnvironment<S>,
    /// What each action moves, and at last what an action moves that does not exist.
    moves: Vec<[i32; JOINTS]>,
    groups: Vec<Group<S>>,
    keys: Vec<Block<u64>>,
    /// What usual steps do not need; its pose is out of date.
    episodes: Vec<ArmEpisode<S>>,
    state: Vec<S>,
    arch: Arch,
}

impl<'e, S: ArmScalar> ArmLanes<'e, S> {
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
            arch: Arch::new(),
        }
    }

    /// A lane's episode, with its pose and all that follows from it.
    fn caught_up(&mut self, lane: usize) -> &mut ArmEpisode<S> {
        let group = &self.groups[lane / BLOCK];
        let pose = Pose(group.ticks.map(|ticks| ticks[lane % BLOCK] as i16));
        let episode = &mut self.episodes[lane];
        episode.actions = (self.environment.problem.max_actions as i32 - 1 - group.left[lane % BLOCK]) as u32;
        if episode.pose != pose {
            let plane_moved = (episode.pose.packed() ^ pose.packed()) >> 16 != 0;
            let plane = plane_moved.then(|| self.environment.plane(pose));
            self.environment.arrive(episode, pose, plane);
        }
        episode
    }

    /// A lane's episode was done something to.
    fn put(&mut self, lane: usize) {
        let episode = &self.episodes[lane];
        let (group, lane) = (&mut self.groups[lane / BLOCK], lane % BLOCK);
        for (ticks, now) in group.ticks.iter_mut().zip(episode.pose.0) {
            ticks[lane] = i32::from(now);
        }
        for (to, now) in group.hand.iter_mut().zip(episode.hand) {
            to[lane] = now;
        }
        for (to, now) in group.target.iter_mut().zip(episode.target) {
            to[lane] = now;
        }
        let tolerance = self.environment.tolerance * S::from_i32(i32::from(episode.roughness));
        // Wide enough for every rounding. An arm that collides where it stands is never usual.
        let far = tolerance * tolerance * S::from_f64(1.01);
        group.far[lane] = if episode.collides { S::from_f64(f64::NAN) } else { far };
        group.roughness[lane] = i32::from(episode.roughness as i8);
        group.left[lane] = self.environment.problem.max_actions as i32 - 1 - episode.actions as i32;
    }
}

/// The usual steps.
struct Usual<'a, S> {
    environment: &'a ArmEnvironment<S>,
    moves: &'a [[i32; JOINTS]],
    groups: &'a mut [Group<S>],
    keys: &'a mut [Block<u64>],
    actions: &'a [ActionId],
}

impl<S: ArmScalar> WithSimd for Usual<'_, S> {
    type Output = ();

    #[inline(always)]
    fn with_simd<V: Simd>(self, _: V) {
        let nothing = self.moves.len() - 1;
        for ((group, keys), actions) in self.groups.iter_mut().zip(self.keys).zip(self.actions.chunks(BLOCK)) {
            let mut steps = [[0; BLOCK]; JOINTS];
            for (lane, action) in actions.iter().enumerate() {
                let step = self.moves[usize::from(action.0).min(nothing)];
                for (steps, step) in steps.iter_mut().zip(step) {
                    steps[lane] = step;
                }
            }
            match &self.environment.sines {
                Some(sines) => usual(
                    self.environment,
                    group,
                    keys,
                    &steps,
                    #[inline(always)]
                    |angle| look_up(sines, angle),
                ),
                None => usual(self.environment, group, keys, &steps, |angle| self.environment.direction(angle)),
            }
        }
    }
}

/// Each loop has a body without branches and reads single values of arrays: then it becomes vectors.
#[inline(always)]
#[allow(
    clippy::needless_range_loop,
    reason = "several arrays at the same place, and copies of arrays would stay copies"
)]
fn usual<S: ArmScalar>(
    environment: &ArmEnvironment<S>,
    group: &mut Group<S>,
    keys: &mut Block<u64>,
    steps: &[Block<i32>; JOINTS],
    direction: impl Fn(Angle) -> Direction<S>,
) {
    let mut ticks = group.ticks;
    let (mut inside, mut moved) = ([true; BLOCK], [0; BLOCK]);
    for joint in 0..JOINTS {
        let range = environment.arm.ranges[joint];
        for lane in 0..BLOCK {
            let step = steps[joint][lane] * group.roughness[lane];
            let step = step.clamp(i32::from(i8::MIN), i32::from(i8::MAX));
            let to = ticks[joint][lane] + step;
            ticks[joint][lane] = to;
            inside[lane] &= (to >= i32::from(range.min)) & (to <= i32::from(range.max));
            moved[lane] |= step;
        }
    }
    let pose = |lane: usize| Pose([0, 1, 2, 3].map(|joint: usize| ticks[joint][lane] as i16));
    let (mut cosines, mut sines) = ([[S::ZERO; BLOCK]; JOINTS], [[S::ZERO; BLOCK]; JOINTS]);
    for lane in 0..BLOCK {
        let [upper_arm, forearm, hand] = link_angles(pose(lane));
        let angles = [base_angle(pose(lane)), upper_arm, forearm, hand];
        for part in 0..JOINTS {
            let Direction { cos, sin } = direction(angles[part]);
            cosines[part][lane] = cos;
            sines[part][lane] = sin;
        }
    }
    let mut hands = group.hand;
    for lane in 0..BLOCK {
        let part = |part: usize| Direction { cos: cosines[part][lane], sin: sines[part][lane] };
        let plane = Plane::new(&environment.arm, Directions::of_links(part(1), part(2), part(3)));
        let hand = plane.hand_in_world(part(0));
        let target = [group.target[0][lane], group.target[1][lane], group.target[2][lane]];
        let [x, y, z] = difference(target, hand);
        let far = x * x + y * y + z * z > group.far[lane];
        for axis in 0..3 {
            hands[axis][lane] = hand[axis];
        }
        let clear = environment.stands_clear(&plane, S::ZERO);
        group.other[lane] = !(inside[lane] & (moved[lane] != 0) & far & clear & (group.left[lane] > 0));
    }
    for lane in 0..BLOCK {
        keys[lane] = pose(lane).packed();
        group.left[lane] -= 1;
    }
    (group.before, group.ticks, group.hand) = (group.ticks, ticks, hands);
}

impl<S: ArmScalar> Episodes<S, ArmTask> for ArmLanes<'_, S> {
    fn begin(&mut self, lane: usize, task: &ArmTask) {
        let episode = self.environment.start(task);
        if lane / BLOCK == self.groups.len() {
            self.groups.push(Group {
                ticks: [[0; BLOCK]; JOINTS],
                target: [[S::ZERO; BLOCK]; 3],
                hand: [[S::ZERO; BLOCK]; 3],
                far: [S::ZERO; BLOCK],
                roughness: [1; BLOCK],
                left: [0; BLOCK],
                before: [[0; BLOCK]; JOINTS],
                other: [false; BLOCK],
            });
            self.keys.push([0; BLOCK]);
        }
        self.keys[lane / BLOCK][lane % BLOCK] = episode.pose.packed();
        if lane == self.episodes.len() {
            self.episodes.push(episode);
        } else {
            self.episodes[lane] = episode;
        }
        self.put(lane);
    }

    fn step(&mut self, actions: &[ActionId], ended: &mut Vec<(usize, Ending)>) {
        let Self { environment, moves, groups, keys, .. } = self;
        self.arch.dispatch(Usual { environment, moves, groups, keys, actions });
        for (lane, &action) in actions.iter().enumerate() {
            if !self.groups[lane / BLOCK].other[lane % BLOCK] {
                continue;
            }
            let environment = self.environment;
            let group = &mut self.groups[lane / BLOCK];
            for (ticks, before) in group.ticks.iter_mut().zip(group.before) {
                ticks[lane % BLOCK] = before[lane % BLOCK];
            }
            group.left[lane % BLOCK] += 1;
            let episode = self.caught_up(lane);
            let ending = environment.step(episode, action);
            let key = episode.pose.packed();
            self.keys[lane / BLOCK][lane % BLOCK] = key;
            self.put(lane);
            ended.extend(ending.map(|ending| (lane, ending)));
        }
    }

    fn keys(&self) -> &[u64] {
        &self.keys.as_flattened()[..self.episodes.len()]
    }

    fn cycle(&self, lane: usize, key: u64, actions: u32) -> Option<Ending> {
        self.environment.cycle(&self.episodes[lane], key, actions)
    }

    fn observe(&mut self, wanted: SourceSet, view: &mut View<'_, S>) {
        let environment = self.environment;
        let mut others = SourceSet::NONE;
        for (place, (source, &at)) in environment.problem.sources.iter().zip(&environment.places).enumerate() {
            if wanted.contains(place) && !self.show(*source, at, view) {
                others = others.with(place);
            }
        }
        if others == SourceSet::NONE {
            return;
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
    }

    fn close_up(&mut self, lane: usize) {
        self.episodes.swap_remove(lane);
        let last = self.episodes.len();
        self.keys[lane / BLOCK][lane % BLOCK] = self.keys[last / BLOCK][last % BLOCK];
        if lane < last {
            let from = self.groups[last / BLOCK].clone();
            let (to, from, lane, last) = (&mut self.groups[lane / BLOCK], &from, lane % BLOCK, last % BLOCK);
            for (to, from) in to.ticks.iter_mut().zip(&from.ticks) {
                to[lane] = from[last];
            }
            for (to, from) in to.target.iter_mut().zip(&from.target).chain(to.hand.iter_mut().zip(&from.hand)) {
                to[lane] = from[last];
            }
            to.far[lane] = from.far[last];
            to.roughness[lane] = from.roughness[last];
            to.left[lane] = from.left[last];
        }
        if last.is_multiple_of(BLOCK) {
            self.groups.truncate(last / BLOCK);
            self.keys.truncate(last / BLOCK);
        }
    }
}

impl<S: ArmScalar> ArmLanes<'_, S> {
    /// Shows a source in every lane, if it is one of those that need no more than ticks, hand and target.
    fn show(&self, source: Source, at: usize, view: &mut View<'_, S>) -> bool {
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
                fill(axis, &|group| std::array::from_fn(|lane| group.target[axis][lane] - group.hand[axis][lane]));
            }),
            Source::Motors | Source::Servos => {
                (0..JOINTS).for_each(|joint| fill(joint, &|group| group.ticks[joint].map(S::from_i32)));
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
