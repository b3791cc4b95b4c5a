//! The [switch](tpg_runtime::switch) over observations: distance in mm, and the pose as the key.

use super::Settings;
use crate::arm::{Leeway, Move, Pose};
use crate::cycle::CycleDetector;
use crate::kinematics::Lattice;
use crate::observation::Observation;
use tpg_runtime::switch;
pub use tpg_runtime::switch::{CAUSES, Cause, Counts, Driver};

/// A move and the policy that chose it.
pub type Chosen = switch::Chosen<Move>;

/// The state of the switch in one episode of one arm.
#[derive(Clone, Debug)]
pub struct Switch<S, D> {
    pub(super) turns: switch::Switch<S, D>,
    /// The guard's knowledge about poses near the arm's.
    pub(super) leeway: Leeway,
}

impl<S: Lattice, D: CycleDetector<Pose>> Switch<S, D> {
    /// A switch at the start of an episode, where the graph drives.
    pub fn new(settings: Settings<S>, detector: D, seen: &Observation<S>) -> Self {
        let Settings { hand_back_after, separation, .. } = settings;
        let settings = switch::Settings { hand_back_after, separation };
        Self { turns: switch::Switch::new(settings, detector, seen.pose, seen.distance()), leeway: Leeway::new() }
    }

    /// The policy that acts next, unless a guard turns it down.
    pub fn driver(&self) -> Driver {
        self.turns.driver()
    }

    /// Counts so far.
    pub fn counts(&self) -> &Counts {
        self.turns.counts()
    }

    /// Notes that an action ended the episode: it counts, and nothing else changes.
    pub fn ended(&mut self, chosen: Chosen) {
        self.turns.ended(chosen.driver);
    }

    /// Notes an action that did not end the episode, and the observation behind it; the reason why the network acts next,
    /// if it newly does.
    #[inline(always)] // as `Hybrid::decide`
    pub fn acted(&mut self, chosen: Chosen, seen: &Observation<S>) -> Option<Cause> {
        self.turns.acted(chosen.driver, chosen.wanted == Move::STOP, seen.pose, seen.distance())
    }
}
