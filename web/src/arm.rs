//! Four arms with one target: the hybrid's, its graph's alone, its network's alone, and a classical planner's.
//!
//! Each goes on from where it is when the target moves. An episode follows the rules of the test episodes: it ends at the
//! target, at a refused action, at rest, in a circle, or at the limit of actions of random
//! starts.

use core::cell::Cell;
use tpg_arm::binding;
use tpg_arm::cycle::Brent;
use tpg_arm::episode::{Episode, Outcome, ReachTask};
use tpg_arm::hybrid::{Driver, Hybrid, HybridEpisode};
use tpg_arm::kinematics::{Plane, Point, base_direction};
use tpg_arm::observation::{ArmPolicy, Observation, Source};
use tpg_arm::sac::packed::{Model, PackedPolicy};
use tpg_arm::{Arm, Invalid, Move, Pose, WIDOWX};
use tpg_generated::{widowx_rs_fast::WidowxRsFast, widowx_rs_hybrid, widowx_sac};
use tpg_problems::arm::planner::{Choice, Planner};
use tpg_problems::arm::targets::Start;
use tpg_runtime::policy::{ActionId, Policy};

/// Hand and target are less than this apart at the end, mm.
pub const TOLERANCE: f32 = 3.0;

static ARM: Arm<f32> = WIDOWX.to_f32();
static EXACT_ARM: Arm<f64> = WIDOWX;
static SOURCES: [Source; WidowxRsFast::SOURCES.len()] = binding::sources(WidowxRsFast::SOURCES);
static MOVES: [Move; WidowxRsFast::MOVES.len()] = binding::moves(WidowxRsFast::MOVES);

/// The number of values that the graph reads.
pub const SEEN: usize = 5;

/// The generated code of the graph, and what it saw last.
struct Watched(&'static Cell<[f32; SEEN]>);

impl Policy for Watched {
    type State = [f32; SEEN];
    type Action = ActionId;

    fn decide(&self, state: &[f32; SEEN]) -> ActionId {
        self.0.set(*state);
        WidowxRsFast.decide(state)
    }
}

type Graph = ArmPolicy<'static, f32, Watched>;
type Network = PackedPolicy<'static, { widowx_sac::SCRATCH }>;

/// The state of an arm, as numbers that a page reads.
#[repr(u32)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ArmState {
    /// The graph acted last, or nothing has yet.
    #[default]
    Graph,
    /// The network acted last.
    Network,
    /// The planner acted last.
    Planner,
    /// The hand is at the target.
    Reached,
    /// The policy rests elsewhere.
    Stop,
    /// The policy goes in a circle.
    Cycle,
    /// A joint would have left its range.
    JointLimit,
    /// The arm would have hit the table or its base.
    Collision,
    /// The limit of actions.
    Timeout,
}

impl ArmState {
    /// Tests for the end of an episode.
    pub fn is_end(self) -> bool {
        !matches!(self, Self::Graph | Self::Network | Self::Planner)
    }
}

impl From<Outcome> for ArmState {
    fn from(outcome: Outcome) -> Self {
        match outcome {
            Outcome::Reached => Self::Reached,
            Outcome::Invalid(Invalid::JointLimit(_)) => Self::JointLimit,
            Outcome::Invalid(Invalid::Collision(_)) => Self::Collision,
            Outcome::Stop => Self::Stop,
            Outcome::Cycle => Self::Cycle,
            Outcome::Timeout => Self::Timeout,
        }
    }
}

/// An arm as a page reads it; the same layout in JavaScript.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ArmView {
    /// Shoulder, end of the upper arm, elbow, wrist, tip of the hand: x, y, z each, mm.
    pub points: [[f32; 3]; 5],
    /// Hand to target, mm.
    pub distance: f32,
    /// Motor positions, ticks.
    pub pose: [i32; 4],
    /// Actions since the target moved: of the graph (or the planner), of the network.
    pub actions: [u32; 2],
    /// The policy that acted last, or the end.
    pub state: ArmState,
    /// The state by which the graph decided last.
    pub seen: [f32; SEEN],
}

/// An episode of one of the four.
enum ArmCourse {
    Hybrid(HybridEpisode<'static, f32, Graph, Network, widowx_rs_hybrid::Detector>),
    /// Of the graph, the network or the planner.
    Alone(Episode<'static, f32, Brent>, ArmState),
}

impl ArmCourse {
    fn seen(&self) -> &Observation<f32> {
        match self {
            Self::Hybrid(episode) => episode.observation(),
            Self::Alone(episode, _) => episode.observation(),
        }
    }
}

/// The number of arms.
pub const ARMS: usize = 4;

/// Four arms with one target.
pub struct Scene {
    hybrid: &'static Hybrid<'static, f32, Graph, Network>,
    seen: &'static Cell<[f32; SEEN]>,
    planner: Planner<'static>,
    target: [f64; 3],
    courses: [ArmCourse; ARMS],
    views: [ArmView; ARMS],
}

impl Scene {
    /// Puts all arms in the pose at rest. `None` if the network in flash is damaged.
    pub fn new() -> Option<Self> {
        let sac = Network::new(&ARM, Model::parse(&widowx_sac::MODEL).ok()?)?;
        // Both are one for the life of the page.
        let seen: &'static Cell<_> = Box::leak(Box::new(Cell::new([0.0; SEEN])));
        let tpg = ArmPolicy::new(Watched(seen), &ARM, &SOURCES, &MOVES);
        let hybrid = Box::leak(Box::new(Hybrid { arm: &ARM, tpg, sac, settings: widowx_rs_hybrid::SETTINGS }));
        let target = [0.0, 300.0, 300.0];
        let planner = Planner::new(&EXACT_ARM, Choice::NearestFree);
        let courses = courses(hybrid, [ARM.home; ARMS], target);
        let mut scene = Self { hybrid, seen, planner, target, courses, views: [ArmView::default(); ARMS] };
        scene.show_all();
        Some(scene)
    }

    /// Moves the target; every arm goes on from where it is. Numbers that are not finite change nothing.
    pub fn aim(&mut self, target: [f64; 3]) {
        if target.iter().all(|value| value.is_finite()) {
            self.target = target;
            self.begin(self.poses());
        }
    }

    /// Puts all arms in the pose at rest.
    pub fn home(&mut self) {
        self.begin([ARM.home; ARMS]);
    }

    /// Puts all arms where the first one is.
    pub fn gather(&mut self) {
        self.begin([self.poses()[0]; ARMS]);
    }

    /// Lets one arm do up to `count` actions. An arm beyond the last one does nothing.
    pub fn act(&mut self, arm: usize, count: u32) {
        for _ in 0..count {
            let (Some(course), Some(view)) = (self.courses.get_mut(arm), self.views.get_mut(arm)) else { return };
            if view.state.is_end() {
                break;
            }
            let (driver, outcome) = match course {
                ArmCourse::Hybrid(episode) => {
                    let (driver, outcome) = episode.advance();
                    (if driver == Driver::Sac { ArmState::Network } else { ArmState::Graph }, outcome)
                }
                ArmCourse::Alone(episode, driver) => {
                    let seen = episode.observation();
                    let wanted = match driver {
                        ArmState::Network => self.hybrid.sac.decide(seen),
                        ArmState::Planner => self.planner.decide(&Observation::at(&EXACT_ARM, seen.pose, self.target)),
                        _ => self.hybrid.tpg.decide(seen),
                    };
                    (*driver, episode.advance(wanted))
                }
            };
            view.actions[usize::from(driver == ArmState::Network)] += 1;
            view.state = outcome.map_or(driver, ArmState::from);
            view.seen = self.seen.get();
        }
        self.show(arm);
    }

    /// Shows an arm; the first one for a number beyond the last.
    pub fn view(&self, arm: usize) -> &ArmView {
        self.views.get(arm).unwrap_or(&self.views[0])
    }

    /// The pose of each arm.
    pub fn poses(&self) -> [Pose; ARMS] {
        self.courses.each_ref().map(|course| course.seen().pose)
    }

    fn begin(&mut self, poses: [Pose; ARMS]) {
        self.courses = courses(self.hybrid, poses, self.target);
        for view in &mut self.views {
            (view.actions, view.state) = ([0; 2], ArmState::Graph);
        }
        self.show_all();
    }

    fn show_all(&mut self) {
        (0..ARMS).for_each(|arm| self.show(arm));
    }

    fn show(&mut self, arm: usize) {
        let (Some(course), Some(view)) = (self.courses.get(arm), self.views.get_mut(arm)) else { return };
        let seen = course.seen();
        view.points = points(&ARM, seen.pose);
        view.distance = seen.distance();
        view.pose = seen.pose.0.map(i32::from);
        // Where the target lies in the hand, there is nothing to do.
        if !view.state.is_end() && view.distance < TOLERANCE {
            view.state = ArmState::Reached;
        }
    }
}

fn courses(
    hybrid: &'static Hybrid<'static, f32, Graph, Network>,
    poses: [Pose; ARMS],
    target: [f64; 3],
) -> [ArmCourse; ARMS] {
    [
        ArmCourse::Hybrid(HybridEpisode::new(hybrid, task(poses[0], target), widowx_rs_hybrid::Detector::new())),
        ArmCourse::Alone(Episode::new(&ARM, task(poses[1], target), Brent::new()), ArmState::Graph),
        ArmCourse::Alone(Episode::new(&ARM, task(poses[2], target), Brent::new()), ArmState::Network),
        ArmCourse::Alone(Episode::new(&ARM, task(poses[3], target), Brent::new()), ArmState::Planner),
    ]
}

fn task(start: Pose, target: [f64; 3]) -> ReachTask<f32> {
    let target = target.map(|mm| mm as f32);
    ReachTask { start, target, tolerance: TOLERANCE, max_actions: Start::Rs.max_actions() }
}

/// Returns shoulder, end of the upper arm, elbow, wrist and tip of an arm, mm.
pub(crate) fn points(arm: &Arm<f32>, pose: Pose) -> [[f32; 3]; 5] {
    let (plane, base) = (Plane::at(arm, pose), base_direction::<f32>(pose));
    let world = |point: Point<f32>| [point.x * base.sin, -(point.x * base.cos), point.z];
    [arm.shoulder(), plane.bracket, plane.elbow, plane.wrist, plane.tip].map(world)
}
