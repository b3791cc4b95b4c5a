//! The control step of a hybrid on a real arm: readings in, a move out, nothing on bad readings.

use super::{Chosen, Hybrid, Settings, Switch};
use crate::arm::{Move, Pose};
use crate::cycle::CycleDetector;
use crate::kinematics::{self, Lattice, Vector};
use crate::observation::Observation;
use crate::sensors::{Fault, Limits, Watch, Watchdog};
use tpg_runtime::policy::Policy;

/// The state of a control loop towards one target: the policy whose turn it is, the last move that was commanded, and the
/// places where the motors should be.
#[derive(Clone, Debug)]
pub struct Control<S, D> {
    switch: Switch<S, D>,
    watchdog: Watchdog<S>,
    /// The last move that [`Hybrid::step`] answered. The switch learns of it at the next good reading.
    executed: Option<Chosen>,
}

impl<S: Lattice, D: CycleDetector<Pose>> Control<S, D> {
    /// A loop at its start, where the graph drives.
    ///
    /// # Errors
    /// [`Fault::Target`] or [`Fault::Sensor`] for what is seen at the start.
    pub fn new(
        limits: Limits<S>,
        settings: Settings<S>,
        watch: Watch,
        detector: D,
        seen: &Observation<S>,
    ) -> Result<Self, Fault> {
        limits.check(seen)?;
        let watchdog = Watchdog::new(limits, watch, seen.pose)?;
        Ok(Self { switch: Switch::new(settings, detector, seen), watchdog, executed: None })
    }

    /// The switch between the two policies, with its counts.
    pub fn switch(&self) -> &Switch<S, D> {
        &self.switch
    }

    /// Starts to compare commanded with observed motion anew, from where the motors are: the way out of [`Fault::Stuck`]
    /// once its cause is removed. The switch goes on as it is.
    ///
    /// # Errors
    /// [`Fault::Sensor`] for a motor outside its joint's range; nothing changes then.
    pub fn resume(&mut self, motors: Pose) -> Result<(), Fault> {
        self.watchdog.resume(motors)
    }
}

impl<S, T, P> Hybrid<'_, S, T, P>
where
    S: Lattice,
    T: Policy<State = Observation<S>, Action = Move>,
    P: Policy<State = Observation<S>, Action = Move>,
{
    /// Does one step of a control loop: takes the motors' positions and a target in mm, returns the observation and the next
    /// action, which the caller sends to the motors before the next step.
    ///
    /// It does all there is to do with a reading: checks it, observes, tells the switch about the previous action, decides.
    ///
    /// ```
    /// use tpg_arm::cycle::Brent;
    /// use tpg_arm::hybrid::{Control, Guard, Hybrid, Settings};
    /// use tpg_arm::observation::{Observation, Straight};
    /// use tpg_arm::sensors::{Fault, Limits, Watch};
    /// use tpg_arm::{Pose, WIDOWX};
    ///
    /// let (arm, target) = (WIDOWX.to_f32(), [0.0, 300.0, 300.0]);
    /// let settings = Settings { hand_back_after: 5, separation: f32::INFINITY, guard: Guard::Both };
    /// let hybrid = Hybrid { arm: &arm, tpg: Straight::new(&arm), sac: Straight::new(&arm), settings };
    ///
    /// let mut motors = arm.home;
    /// let seen = Observation::at(&arm, motors, target);
    /// let mut control = Control::new(Limits::new(&arm), settings, Watch::DEFAULT, Brent::new(), &seen)?;
    /// loop {
    ///     let (seen, chosen) = hybrid.step(&mut control, motors, target)?;
    ///     if seen.distance() < 3.0 {
    ///         break;
    ///     }
    ///     // Here the motors move and are read; this is where they would be.
    ///     motors = arm.step(motors, chosen.wanted).pose;
    /// }
    /// // A reading that cannot be commands nothing, and the next good one goes on.
    /// let garbage = Pose([-1; 4]);
    /// assert_eq!(hybrid.step(&mut control, garbage, target).map(|_| ()), Err(Fault::Sensor));
    /// assert_eq!(hybrid.step(&mut control, motors, [f32::NAN; 3]).map(|_| ()), Err(Fault::Target));
    /// # Ok::<(), Fault>(())
    /// ```
    ///
    /// # Errors
    /// See [`Fault`]. Nothing may be sent to the motors then, and nothing has changed: the same step can be done again with
    /// the next reading.
    #[inline]
    pub fn step<D: CycleDetector<Pose>>(
        &self,
        control: &mut Control<S, D>,
        motors: Pose,
        target: Vector<S>,
    ) -> Result<(Observation<S>, Chosen), Fault> {
        let nothing = [S::ZERO; 3];
        let mut seen = Observation { pose: motors, fixed_servos: [0; 2], hand: nothing, target, difference: nothing };
        let chosen = self.step_into(control, motors, &target, &mut seen)?;
        Ok((seen, chosen))
    }

    /// Does a [`step`](Self::step) and writes the observation to `seen`, but not if there is a fault.
    ///
    /// # Errors
    /// As [`step`](Self::step).
    #[inline(always)] // one step is one function: the one that calls it
    pub fn step_into<D: CycleDetector<Pose>>(
        &self,
        control: &mut Control<S, D>,
        motors: Pose,
        target: &Vector<S>,
        seen: &mut Observation<S>,
    ) -> Result<Chosen, Fault> {
        control.watchdog.check(motors, target)?;
        // `Observation::at`, but written where it goes.
        *seen = Observation::new(self.arm, motors, kinematics::hand(self.arm, motors), *target);
        if let Some(executed) = control.executed {
            control.switch.acted(executed, seen);
        }
        let chosen = self.decide(&mut control.switch, seen);
        control.watchdog.commanded(motors, chosen.wanted);
        control.executed = Some(chosen);
        Ok(chosen)
    }
}
