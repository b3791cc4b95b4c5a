//! The sensor contract: readings that a control step refuses, and the watch over stuck motors.
//!
//! A policy answers any numbers with a move. On a real arm the numbers come from sensors, and a wrong one must not move
//! anything. So a control step checks its readings first:
//!
//! | fault | found by | the step answers |
//! | --- | --- | --- |
//! | the target is no number, or too far away | [`Limits::reaches`] | [`Fault::Target`] |
//! | a motor is outside its joint's range | [`Limits`] | [`Fault::Sensor`] |
//! | hand and difference do not belong together | [`Observation::is_consistent`] | [`Fault::Sensor`] |
//! | the motors are not where the commands led them | [`Watchdog`] | [`Fault::Stuck`] |
//!
//! Of several faults the first in this table is named. A step that finds one commands nothing and remembers nothing: the
//! next good reading goes on where the last good one was. Only [`Fault::Stuck`] may need help, see [`Watchdog`].
//!
//! [`Hybrid::step`](crate::hybrid::Hybrid::step) is a control step with all these checks. A loop of your own asks a
//! [`Watchdog`]:
//!
//! ```
//! use tpg_arm::sensors::{Fault, Limits, Watch, Watchdog};
//! use tpg_arm::{Joint, Move, WIDOWX};
//!
//! let arm = WIDOWX.to_f32();
//! let target = [0.0, 300.0, 300.0];
//! let mut watchdog = Watchdog::new(Limits::new(&arm), Watch::DEFAULT, arm.home)?;
//! let wanted = Move::single(Joint(0), 3);
//! let mut steps = 0;
//! // The motors never move.
//! let fault = loop {
//!     match watchdog.check(arm.home, &target) {
//!         Ok(()) => watchdog.commanded(arm.home, wanted),
//!         Err(fault) => break fault,
//!     }
//!     steps += 1;
//! };
//! assert_eq!((fault, steps), (Fault::Stuck, 11));
//! // Somebody freed the motors: start again from where they are.
//! watchdog.resume(arm.home)?;
//! assert_eq!(watchdog.check(arm.home, &target), Ok(()));
//! assert_eq!(watchdog.check(arm.home, &[f32::NAN; 3]), Err(Fault::Target));
//! # Ok::<(), Fault>(())
//! ```

mod lanes;
mod limits;
mod watchdog;

pub use limits::Limits;
pub use watchdog::{Watch, Watchdog};

use crate::kinematics::Lattice;
use crate::observation::Observation;
use core::fmt;

/// The reason why a control step commanded nothing.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Fault {
    /// The target is no number, or farther away than the stretched arm reaches.
    Target,
    /// A motor's position lies outside its joint's range, or the observation contradicts itself.
    Sensor,
    /// The motors are not where the commands led them: stuck, moved by something else, or read too late.
    Stuck,
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Target => "the target is no number, or out of reach",
            Self::Sensor => "a motor is outside its range, or the observation contradicts itself",
            Self::Stuck => "the motors are not where the commands led them",
        })
    }
}

impl core::error::Error for Fault {}

impl<S: Lattice> Observation<S> {
    /// Returns true if the difference is exactly target − hand, and all of them are finite.
    ///
    /// [`Observation::at`] always makes such a one. A hand that is wrong by a finite amount, with a difference to match,
    /// is not noticed: the motors' own hand would cost as much as observing anew.
    #[inline]
    pub fn is_consistent(&self) -> bool {
        let [x, y, z] = [0, 1, 2].map(|k| ((self.target[k] - self.hand[k]) - self.difference[k]).abs());
        // An infinity less an infinity is NaN, which is not zero.
        x + y + z == S::ZERO
    }
}
