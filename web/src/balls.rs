//! Two arms among the same moving balls: the shipped policy's, and one that walks straight to its target.

use crate::arm::points;
use tpg_arm::dodge::{Behaviour, Dodger, DodgerSettings};
use tpg_engine::Environment;
use tpg_generated::dodge::Dodge;
use tpg_problems::dodge::episode::{End, Episode};
use tpg_problems::dodge::scene::Scene;
use tpg_problems::dodge::{BODY, Dodge as Problem, DodgeConfig};
use tpg_runtime::policy::{ActionId, Policy};

/// Hand and target are less than this apart at the end, mm.
pub const TOLERANCE: f32 = 3.0;
/// The most balls of a scene.
pub const BALLS: usize = 3;

/// An arm among balls as a page reads it; the same layout in JavaScript.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BallsView {
    /// Shoulder, end of the upper arm, elbow, wrist, tip of the hand: x, y, z each, mm.
    pub points: [[f32; 3]; 5],
    /// Centre and radius of each ball, mm.
    pub balls: [[f32; 4]; BALLS],
    /// Number of balls.
    pub count: u32,
    /// Hand to target, mm.
    pub distance: f32,
    /// Distance of the arm from the nearest ball, mm; negative in a hit.
    pub clearance: f32,
    /// Steps so far.
    pub steps: u32,
    /// Index of the behaviour that acted last.
    pub behaviour: u32,
    /// 0 on the way, 1 at the target, 2 hit, 3 out of time.
    pub state: u32,
}

/// An arm on its way.
struct BallsCourse {
    episode: Episode,
    dodger: Dodger,
    /// True for the policy, false for the straight walk.
    learned: bool,
}

/// Number of arms.
pub const ARMS: usize = 2;

/// Two arms in the same scene.
#[derive(Default)]
pub struct Balls {
    courses: Vec<BallsCourse>,
    views: [BallsView; ARMS],
}

impl Balls {
    /// Begins a scene for both arms.
    pub fn begin(&mut self, scene: &Scene) {
        let course = |learned| {
            let episode = Episode::new(scene);
            let dodger = Dodger::new(DodgerSettings { guard: learned, ..DodgerSettings::DEFAULT }, &episode.view());
            BallsCourse { episode, dodger, learned }
        };
        self.courses = vec![course(true), course(false)];
        self.views = [BallsView::default(); ARMS];
        (0..ARMS).for_each(|arm| self.show(arm));
    }

    /// Lets one arm take a step. An arm beyond the last one, or at its end, does nothing.
    pub fn act(&mut self, arm: usize) {
        let (Some(course), Some(view)) = (self.courses.get_mut(arm), self.views.get_mut(arm)) else { return };
        if view.state != 0 {
            return;
        }
        let seen = course.episode.view();
        let action = if course.learned { Dodge.decide(&course.dodger.observe(&seen)) } else { STRAIGHT };
        let behaviour = Behaviour::ALL.get(usize::from(action.0)).copied().unwrap_or(Behaviour::Hold);
        let wanted = course.dodger.act(&seen, behaviour);
        view.behaviour = action.0.into();
        view.state = course.episode.step(wanted, TOLERANCE).map_or(0, |end| match end {
            End::Reached => 1,
            End::Hit => 2,
            End::Timeout => 3,
        });
        self.show(arm);
    }

    /// Shows an arm; the first one for a number beyond the last.
    pub fn view(&self, arm: usize) -> &BallsView {
        self.views.get(arm).unwrap_or(&self.views[0])
    }

    fn show(&mut self, arm: usize) {
        let (Some(course), Some(view)) = (self.courses.get(arm), self.views.get_mut(arm)) else { return };
        let (episode, seen) = (&course.episode, course.episode.view());
        view.points = points(&BODY.arm, episode.pose());
        view.count = seen.balls.len() as u32;
        for (place, ball) in view.balls.iter_mut().zip(seen.balls) {
            let [x, y, z] = ball.at;
            *place = [x, y, z, ball.radius];
        }
        view.distance = episode.distance();
        view.clearance = BODY.clearance_of_all(&BODY.at(episode.pose()), seen.balls, 0.0);
        view.steps = episode.steps();
    }
}

/// The behaviour that walks to the goal whatever is in its way.
const STRAIGHT: ActionId = ActionId(1);

/// Reads a scene as [`tpg_problems`] serialises it, by postcard; `None` for bytes that are not one.
pub fn scene(bytes: &[u8]) -> Option<Scene> {
    let scene = postcard::from_bytes(bytes).ok()?;
    Environment::<f32>::accepts(&Problem::new(&DodgeConfig::default()), &scene).then_some(scene)
}
