//! The control step among balls on a real arm: readings in, a move out, nothing on readings that cannot be.

use super::ball::Ball;
use super::behaviour::{BALLS, Behaviour, View};
use super::body::Body;
use super::dodger::{Dodger, DodgerSettings};
use super::sources::{DodgeSource, VALUES};
use crate::arm::{Move, Pose};
use crate::sensors::{Fault, Limits, Watch, Watchdog};
use tpg_runtime::policy::{ActionId, Policy};

/// Most poses that solve a task.
pub const GOALS: usize = 4;

/// A step of a control loop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct DodgeStep {
    /// The move that goes to the motors. No part of it is against limits, table or base.
    pub wanted: Move,
    /// The behaviour that the policy chose.
    pub behaviour: Behaviour,
}

/// The state of a control loop towards one target.
///
/// ```
/// use tpg_arm::dodge::{Ball, Behaviour, Body, DodgeControl, DodgerSettings, WIDOWX_RADII};
/// use tpg_arm::sensors::{Fault, Watch};
/// use tpg_arm::{Pose, WIDOWX};
///
/// let body = Body::new(WIDOWX.to_f32(), WIDOWX_RADII);
/// let mut motors = Pose([1536, 2048, 2048, 2048]);
/// let goals = [Pose([2560, 2048, 2048, 2048])];
/// let ball = Ball { at: [0.0, -450.0, 400.0], velocity: [0.0; 3], radius: 40.0 };
///
/// let mut control = DodgeControl::new(&body, DodgerSettings::DEFAULT, Watch::DEFAULT, &goals, motors, &[ball])?;
/// for _ in 0..1000 {
///     let step = control.step(&body, &|_: &[f32; 17]| Behaviour::Plan, motors, &[ball])?;
///     // Here the motors move and are read; this is where they would be.
///     motors = WIDOWX.step(motors, step.wanted).pose;
/// }
/// assert_eq!(motors, goals[0]);
/// // A reading that cannot be commands nothing, and the next good one goes on.
/// let nowhere = Ball { at: [f32::NAN; 3], ..ball };
/// let refused = control.step(&body, &|_: &[f32; 17]| Behaviour::Plan, motors, &[nowhere]);
/// assert_eq!(refused, Err(Fault::Sensor));
/// # Ok::<(), Fault>(())
/// ```
#[derive(Clone, Debug)]
pub struct DodgeControl {
    dodger: Dodger,
    watchdog: Watchdog<f32>,
    goals: [Pose; GOALS],
    count: u8,
}

impl DodgeControl {
    /// Begins a loop towards a target, which is given by the poses that solve it: one to [`GOALS`], the nearest first.
    ///
    /// # Errors
    /// [`Fault::Target`] for no goal, too many, or one that is outside the joints' ranges or touches table or base;
    /// [`Fault::Sensor`] for motors and balls as in [`step`](Self::step).
    pub fn new(
        body: &Body,
        settings: DodgerSettings,
        watch: Watch,
        goals: &[Pose],
        motors: Pose,
        balls: &[Ball],
    ) -> Result<Self, Fault> {
        let limits = Limits::new(&body.arm);
        let mut kept = [motors; GOALS];
        let is_reached = |&goal: &Pose| limits.hold(goal) && body.is_free(&body.at(goal));
        match kept.get_mut(..goals.len()) {
            Some(kept) if !goals.is_empty() && goals.iter().all(is_reached) => kept.copy_from_slice(goals),
            _ => return Err(Fault::Target),
        }
        let watchdog = Watchdog::new(limits, watch, motors)?;
        check(balls)?;
        let dodger = Dodger::new(settings, &View::new(body, motors, goals, balls));
        Ok(Self { dodger, watchdog, goals: kept, count: goals.len() as u8 })
    }

    /// Does one step: takes the motors' positions and the balls as they are seen, lets a policy choose a behaviour, and returns
    /// the move that the caller sends to the motors before the next step.
    ///
    /// `choose` answers the values of all sources, in the order of [`DodgeSource::ALL`]; see [`Chooser`] for a compiled graph.
    ///
    /// # Errors
    /// [`Fault::Sensor`] for a motor outside its joint's range, more than [`BALLS`] balls, or one that is not
    /// [sound](Ball::is_sound); [`Fault::Stuck`] where the motors are not where the moves led them. Nothing may be sent to the
    /// motors then, and nothing has changed: the same step can be done again with the next reading.
    #[inline]
    pub fn step<C>(&mut self, body: &Body, choose: &C, motors: Pose, balls: &[Ball]) -> Result<DodgeStep, Fault>
    where
        C: Fn(&[f32; VALUES]) -> Behaviour + ?Sized,
    {
        self.watchdog.check_motors(motors)?;
        check(balls)?;
        let goals = self.goals.get(..usize::from(self.count)).unwrap_or(&self.goals);
        let view = View::new(body, motors, goals, balls);
        let behaviour = choose(&self.dodger.observe(&view));
        let wanted = self.dodger.act(&view, behaviour);
        self.watchdog.commanded(motors, wanted);
        Ok(DodgeStep { wanted, behaviour })
    }

    /// Starts to compare commanded with observed motion anew, from where the motors are: the way out of [`Fault::Stuck`] once its
    /// cause is removed. The search goes on as it is.
    ///
    /// # Errors
    /// [`Fault::Sensor`] for a motor outside its joint's range; nothing changes then.
    pub fn resume(&mut self, motors: Pose) -> Result<(), Fault> {
        self.watchdog.resume(motors)
    }
}

/// Finds readings of balls that cannot be.
fn check(balls: &[Ball]) -> Result<(), Fault> {
    if balls.len() <= BALLS && balls.iter().all(Ball::is_sound) { Ok(()) } else { Err(Fault::Sensor) }
}

/// A compiled graph whose actions are behaviours: what it sees, and what each of its actions does.
///
/// An action past the end of `behaviours` holds.
#[derive(Clone, Copy, Debug)]
pub struct Chooser<'a, P> {
    /// The graph.
    pub policy: P,
    /// Its sources, in order.
    pub sources: &'a [DodgeSource],
    /// The behaviour of each action.
    pub behaviours: &'a [Behaviour],
}

impl<P> Chooser<'_, P> {
    /// Returns the behaviour that the graph chooses for the values of all sources.
    #[inline]
    pub fn choose<const N: usize>(&self, values: &[f32; VALUES]) -> Behaviour
    where
        P: Policy<State = [f32; N], Action = ActionId>,
    {
        let mut state = [0.0; N];
        DodgeSource::gather(self.sources, values, &mut state);
        let ActionId(action) = self.policy.decide(&state);
        self.behaviours.get(usize::from(action)).copied().unwrap_or(Behaviour::Hold)
    }
}
