//! The arm as an [`Environment`]: the runtime's rules, with unchanged values cached from step to step.
//!
//! Every value comes from the runtime's own functions applied to the same arguments, so it has the same bits as a fresh
//! observation; a test compares both step by step.

mod clearance;
mod episode;
mod guard;
mod lanes;
mod regular;

pub use episode::ArmEpisode;

use crate::arm::problem::{ArmProblem, ArmTask, DISTANCE, OUTCOMES, on_the_arm};
use crate::arm::targets::{self, ReachableSpace, Set};
use crate::arm::{drawing, motors::MotorsConfig};
use crate::registry::Number;
use clearance::Clearances;
use tpg_arm::binding::MOVE;
use tpg_arm::episode::Outcome;
use tpg_arm::kinematics::{self, Angle, Direction, Directions, Plane, Vector, link_angles};
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_arm::sac::Decision;
use tpg_arm::{Arm, JOINTS, Joint, Move, Play, Pose, TICKS_PER_TURN};
use tpg_engine::random::Stream;
use tpg_engine::{
    Act, ActionSpace, End, Environment, EpisodeResult, Episodes, Guarded, Measure, OneByOne, Preference, SourceSet,
    Step, TaskSet, Training,
};
use tpg_graph::{ActionDocument, Effect, SourceDocument};

/// The environment of the arm.
#[derive(Clone, Debug)]
pub struct ArmEnvironment<S> {
    arm: Arm<S>,
    description: Arm<f64>,
    problem: ArmProblem,
    tolerance: S,
    moves: Vec<Move>,
    /// First index of each source in the flat state.
    places: Vec<usize>,
    clearances: Clearances<S>,
    sines: Box<Sines<S>>,
    /// The arm in the precision of networks, and how they drive it.
    narrow: Arm<f32>,
    decision: Decision<f32>,
}

/// Sines of all ticks of a turn.
type Sines<S> = [S; TICKS_PER_TURN as usize];

#[inline(always)]
fn look_up<S: Number>(sines: &Sines<S>, angle: Angle) -> Direction<S> {
    let within = (TICKS_PER_TURN - 1) as usize;
    let ticks = angle.0 as usize & within;
    let ahead = (ticks + TICKS_PER_TURN as usize / 4) & within;
    Direction { cos: sines[ahead], sin: sines[ticks] }
}

/// Returns the base's angle; 0 at motor position 2048.
#[inline(always)]
fn base_angle(pose: Pose) -> Angle {
    Angle(i32::from(pose.0[0]) - TICKS_PER_TURN / 2)
}

impl<S: Number> ArmEnvironment<S> {
    /// Creates an environment.
    ///
    /// Training tasks come from one sample of the reachable space, validation tasks from another.
    pub fn new(arm: &Arm<f64>, problem: ArmProblem) -> Self {
        let places = (0..problem.sources.len())
            .map(|place| problem.sources[..place].iter().map(|source| source.length()).sum())
            .collect();
        let steps = |joint| [problem.step, -problem.step].map(|ticks| Move::single(Joint(joint), ticks));
        let stop = problem.may_stop.then_some(Move::STOP);
        Self {
            moves: (0..JOINTS as u8).flat_map(steps).chain(stop).collect(),
            arm: S::arm(arm),
            description: *arm,
            tolerance: S::from_f64(problem.tolerance),
            problem,
            clearances: Clearances::new(arm),
            places,
            sines: Box::new(std::array::from_fn(|ticks| Angle(ticks as i32).direction().sin)),
            narrow: arm.to_f32(),
            decision: MotorsConfig::default().decision(),
        }
    }

    /// Returns the same environment for networks of these settings.
    pub(crate) fn with_network(self, config: &MotorsConfig) -> Self {
        Self { decision: config.decision(), ..self }
    }

    /// Returns the arm in this environment's scalar.
    pub fn arm(&self) -> &Arm<S> {
        &self.arm
    }

    /// Returns the problem.
    pub fn problem(&self) -> &ArmProblem {
        &self.problem
    }

    /// Returns the move of each action.
    pub fn moves(&self) -> &[Move] {
        &self.moves
    }

    #[inline(always)]
    fn direction(&self, angle: Angle) -> Direction<S> {
        look_up(&self.sines, angle)
    }

    #[inline(always)]
    fn plane(&self, pose: Pose) -> Plane<S> {
        let [upper_arm, forearm, hand] = link_angles(pose).map(|angle| self.direction(angle));
        Plane::new(&self.arm, Directions::of_links(upper_arm, forearm, hand))
    }

    #[inline(always)]
    fn base(&self, pose: Pose) -> Direction<S> {
        self.direction(base_angle(pose))
    }

    /// Moves the arm to a pose; `plane` is given if it changed.
    fn arrive(&self, episode: &mut ArmEpisode<S>, pose: Pose, plane: Option<Plane<S>>) {
        if pose.0[0] != episode.pose.0[0] {
            episode.base = self.base(pose);
        }
        if let Some(plane) = plane {
            episode.plane = plane;
        }
        episode.pose = pose;
        episode.hand = episode.plane.hand_in_world(episode.base);
    }

    /// Returns hand to target, mm, of motors at a pose whose own hand is known.
    fn distance(&self, episode: &ArmEpisode<S>, motors: Pose, hand: Vector<S>) -> S {
        if episode.play == Play::NONE {
            return kinematics::distance(episode.target, hand);
        }
        let joints = episode.play.joints(motors);
        kinematics::distance(episode.target, self.plane(joints).hand_in_world(self.base(joints)))
    }

    /// Takes one action and returns the ending if the episode ended. The only reward is the score at the end.
    fn advance(&self, episode: &mut ArmEpisode<S>, action: usize) -> Option<EpisodeResult> {
        self.go(episode, self.moves.get(action).copied().unwrap_or(Move::STOP), true)
    }

    /// Moves the arm. Rest ends an episode where a graph chose it: it will for ever.
    fn go(&self, episode: &mut ArmEpisode<S>, wanted: Move, rest_ends: bool) -> Option<EpisodeResult> {
        let wanted = Move(wanted.0.map(|ticks| ticks.saturating_mul(episode.roughness as i8)));
        let before = episode.pose;
        let mut moved_plane = None;
        let step = self.arm.step_with(before, wanted, |moved| {
            // The plane, and with it every collision, does not depend on the angle of the base.
            let plane_moved = (moved.packed() ^ before.packed()) >> 16 != 0;
            if !plane_moved && !episode.collides {
                return None;
            }
            let plane = self.plane(moved);
            moved_plane = Some(plane);
            if self.clearances.leaves_free(&plane) { None } else { plane.collision(&self.arm.shapes) }
        });
        episode.actions += 1;
        if step.pose != before {
            episode.collides = false;
            self.arrive(episode, step.pose, moved_plane);
        }
        let distance = self.distance(episode, episode.pose, episode.hand);
        // The same order as in the runtime's episode; cycles are detected by the engine.
        let outcome = if let Some(invalid) = step.invalid {
            Outcome::Invalid(invalid)
        } else if distance < self.tolerance * S::from_i32(i32::from(episode.roughness)) {
            Outcome::Reached
        } else if wanted == Move::STOP && rest_ends {
            Outcome::Stop
        } else if episode.actions >= self.problem.max_actions {
            Outcome::Timeout
        } else {
            return None;
        };
        Some(self.problem.ending(outcome, episode.actions, distance.to_f64()))
    }
}

impl<S: Number> Environment<S> for ArmEnvironment<S> {
    type Task = ArmTask;
    type Episode = ArmEpisode<S>;

    fn sources(&self) -> Vec<SourceDocument> {
        // Whole numbers: exact in every scalar.
        let range = |source: &Source, index: usize| {
            let [min, max] = source.range(&self.description, index);
            [min.floor(), max.ceil()]
        };
        let document = |source: &Source| {
            SourceDocument::new(
                source.name(),
                source.unit(),
                (0..source.length()).map(|index| range(source, index)).collect(),
            )
        };
        self.problem.sources.iter().map(document).collect()
    }

    fn actions(&self) -> ActionSpace {
        const NAMES: [&str; 9] = [
            "base_up",
            "base_down",
            "shoulder_up",
            "shoulder_down",
            "elbow_up",
            "elbow_down",
            "wrist_up",
            "wrist_down",
            "stop",
        ];
        let document = |((id, moves), name): ((u32, &Move), &str)| ActionDocument {
            id,
            name: name.to_owned(),
            effect: Some(Effect { name: MOVE.to_owned(), values: moves.0.map(f64::from).to_vec() }),
            ask: None,
        };
        ActionSpace::Discrete((0..).zip(&self.moves).zip(NAMES).map(document).collect())
    }

    fn outcomes(&self) -> &'static [&'static str] {
        &OUTCOMES
    }

    fn time_limit(&self) -> u32 {
        self.problem.max_actions
    }

    fn draw(&self, stream: &mut Stream) -> ArmTask {
        let space = ReachableSpace::shared(&self.description, 0, Set::Training);
        space.task(self.problem.start, stream).into()
    }

    fn training(&self) -> Option<&dyn Training<ArmTask>> {
        Some(self)
    }

    fn guarded(&self) -> Option<&dyn Guarded<S, ArmEpisode<S>>> {
        Some(self)
    }

    fn moment(&self, episode: &ArmEpisode<S>) -> Vec<f64> {
        drawing::moment(episode.pose, episode.target.map(S::to_f64))
    }

    /// Returns the distance of the hand as a policy sees it: without play.
    fn distance(&self, episode: &ArmEpisode<S>) -> Option<f64> {
        Some(kinematics::distance(episode.target, episode.hand).to_f64())
    }

    fn accepts(&self, task: &ArmTask) -> bool {
        on_the_arm(task.start) && (1..=127).contains(&task.roughness)
    }

    fn start(&self, task: &ArmTask) -> ArmEpisode<S> {
        let pose = Pose(task.start);
        let plane = self.plane(pose);
        let base = self.base(pose);
        ArmEpisode {
            pose,
            target: task.target.map(S::from_f64),
            roughness: task.roughness,
            play: self.problem.play(&task.into()),
            plane,
            base,
            hand: plane.hand_in_world(base),
            collides: plane.collision(&self.arm.shapes).is_some(),
            actions: 0,
            memo: TargetMemo::new(),
        }
    }

    fn lanes(&self) -> Box<dyn Episodes<S, ArmTask> + '_> {
        let ArmProblem { backlash, sources, .. } = &self.problem;
        if *backlash == 0 && sources.iter().all(lanes::is_in_columns) {
            Box::new(lanes::ArmLanes::new(self))
        } else {
            Box::new(OneByOne::new(self))
        }
    }

    fn observe(&self, episode: &mut ArmEpisode<S>, wanted: SourceSet, state: &mut [S]) {
        let seen = Observation::new(&self.arm, episode.pose, episode.hand, episode.target);
        for (place, (&source, &at)) in self.problem.sources.iter().zip(&self.places).enumerate() {
            if wanted.contains(place) {
                let values = &mut state[at..at + source.length()];
                source.write_with(&self.arm, &seen, &episode.memo, || episode.frame(&self.arm), values);
            }
        }
    }

    fn step(&self, episode: &mut ArmEpisode<S>, act: Act<'_, S>) -> Step {
        let ending = match act {
            Act::Values(values) => self.go(episode, self.steered(episode, values), false),
            act => self.advance(episode, act.choice()),
        };
        match ending {
            None => Step::reward(0.0),
            Some(EpisodeResult { outcome, success, score, measure, .. }) => {
                Step::reward(score).ending(End { outcome, success, measure, truncated: false })
            }
        }
    }

    fn measure(&self) -> Option<Measure> {
        Some(DISTANCE)
    }

    fn preference(&self) -> Preference {
        Preference::Success
    }

    fn key(&self, episode: &ArmEpisode<S>) -> Option<u64> {
        Some(episode.pose.packed())
    }

    fn cycle(&self, episode: &ArmEpisode<S>, key: u64, actions: u32) -> Option<EpisodeResult> {
        let pose = Pose::from_packed(key);
        let hand = self.plane(pose).hand_in_world(self.base(pose));
        Some(self.problem.ending(Outcome::Cycle, actions, self.distance(episode, pose, hand).to_f64()))
    }
}

impl<S: Number> Training<ArmTask> for ArmEnvironment<S> {
    fn coarser(&self, task: ArmTask, factor: u8) -> ArmTask {
        ArmTask { roughness: factor, ..task }
    }

    fn tasks(&self, set: TaskSet, seed: u64, count: usize) -> Option<Vec<ArmTask>> {
        let (set, seed) = Set::asked(set, seed, 0);
        let tasks = targets::tasks(&self.description, seed, set, self.problem.start, count);
        Some(tasks.into_iter().map(ArmTask::from).collect())
    }
}
