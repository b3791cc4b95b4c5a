//! The watch over what motors do with their commands.

use super::lanes::{self, Expected, TOP};
use super::{Fault, Limits};
use crate::arm::{Move, Pose, TICKS_PER_TURN};
use crate::kinematics::{Lattice, Vector};

/// The difference that commanded and observed motion may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Watch {
    /// Ticks that a motor may be away from the place to which the commands led it; from 4096 on it is never found stuck.
    pub threshold: u16,
    /// Steps over which differences add up, from 1. After so many the comparison starts anew from where the motors are, so
    /// that motors which always fall a little short are not taken for stuck ones: by up to threshold / patience ticks a
    /// step. A greater patience than threshold finds a motor that is asked for a tick a step and does not move.
    pub patience: u16,
}

impl Watch {
    /// 32 ticks (2.8°) within 64 steps: a motor that is asked for 3 ticks a step and does not move is found after 11 steps,
    /// or 21 where the comparison starts anew meanwhile; one that does two thirds of a tick too little at each step is not
    /// trusted, half a tick is forgiven. A reading may be 10 steps late.
    pub const DEFAULT: Self = Self { threshold: 32, patience: 64 };
}

impl Default for Watch {
    fn default() -> Self {
        Self::DEFAULT
    }
}

/// Compares the motors' positions with the places to which the commands led them, and with an arm's [`Limits`].
///
/// Ask [`check`](Self::check) about every reading before anything is decided, and tell [`commanded`](Self::commanded) every
/// move that goes to the motors. Both together cost some fifty instructions on a Cortex-M4.
///
/// While it answers [`Fault::Stuck`] nothing is commanded, so the place where the commands led stays. There are two ways
/// out: the motors come there after all, as they do where readings were late or a single one jumped; or the cause is
/// removed and the caller says so by [`resume`](Self::resume).
#[derive(Clone, Debug)]
pub struct Watchdog<S> {
    limits: Limits<S>,
    /// The places to which the commands led, with the threshold on either side.
    expected: Expected,
    patience: u16,
    /// Steps until the comparison starts anew.
    left: u16,
}

impl<S: Lattice> Watchdog<S> {
    /// A watchdog over an arm of these limits whose motors are at `motors`.
    ///
    /// # Errors
    /// [`Fault::Sensor`] for a motor outside its joint's range.
    pub fn new(limits: Limits<S>, watch: Watch, motors: Pose) -> Result<Self, Fault> {
        if !limits.hold(motors) {
            return Err(Fault::Sensor);
        }
        let threshold = watch.threshold.min(TICKS_PER_TURN as u16);
        let patience = watch.patience.max(1);
        Ok(Self { limits, expected: Expected::around(lanes::from_pose(motors), threshold), patience, left: patience })
    }

    /// Starts anew from the motors' positions, after the cause of a fault was removed.
    ///
    /// # Errors
    /// [`Fault::Sensor`] for a motor outside its joint's range; nothing changes then.
    pub fn resume(&mut self, motors: Pose) -> Result<(), Fault> {
        if !self.limits.hold(motors) {
            return Err(Fault::Sensor);
        }
        self.anchor(motors);
        Ok(())
    }

    #[cold]
    #[inline(never)]
    fn anchor(&mut self, motors: Pose) {
        self.expected = self.expected.anew(lanes::from_pose(motors));
        self.left = self.patience;
    }

    /// Checks the motors' positions, and a target in mm.
    ///
    /// # Errors
    /// See [`Fault`]. Nothing changes then.
    #[inline(always)]
    pub fn check(&self, motors: Pose, target: &Vector<S>) -> Result<(), Fault> {
        if self.limits.reaches(target) { self.check_motors(motors) } else { Err(Fault::Target) }
    }

    /// Checks the motors' positions alone.
    ///
    /// # Errors
    /// [`Fault::Sensor`] or [`Fault::Stuck`]. Nothing changes then.
    #[inline(always)]
    pub(crate) fn check_motors(&self, motors: Pose) -> Result<(), Fault> {
        let at = lanes::from_pose(motors);
        if self.limits.ranges.hold(at) & self.expected.hold(at) & TOP == TOP {
            Ok(())
        } else if self.limits.hold(motors) {
            Err(Fault::Stuck)
        } else {
            Err(Fault::Sensor)
        }
    }

    /// Notes a move that goes to the motors, and their positions before it.
    #[inline(always)]
    pub fn commanded(&mut self, motors: Pose, wanted: Move) {
        self.left = self.left.wrapping_sub(1);
        if self.left == 0 {
            self.anchor(motors);
        }
        self.expected.shift(wanted);
    }
}
