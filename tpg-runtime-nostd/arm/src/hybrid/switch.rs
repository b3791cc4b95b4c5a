//! Whose turn it is.

use super::{NEVER, Settings};
use crate::arm::Move;
use crate::cycle::CycleDetector;
use crate::kinematics::Lattice;
use crate::observation::Observation;

/// Who acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Driver {
    /// The tangled program graph.
    Tpg,
    /// The soft actor-critic's network.
    Sac,
}

/// An action and whose it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Chosen {
    /// Who chose.
    pub driver: Driver,
    /// What the motors shall do.
    pub wanted: Move,
}

/// Why the network took over. Where several reasons fall together the first of these counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Cause {
    /// The graph's action was not executed: the guard refused it.
    Guard,
    /// The hand is more than the separation further away than it has been.
    Drift,
    /// The graph chose not to move.
    Stop,
    /// The graph came to a pose where it had been before.
    Cycle,
}

/// How many causes there are.
pub const CAUSES: usize = 4;

impl Cause {
    /// Every cause, in order.
    pub const ALL: [Self; CAUSES] = [Self::Guard, Self::Drift, Self::Stop, Self::Cycle];

    /// The name in tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Guard => "guard",
            Self::Drift => "drift",
            Self::Stop => "stop",
            Self::Cycle => "cycle",
        }
    }
}

/// Who acted how often, and why they changed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Counts {
    /// Actions of the graph.
    pub tpg_actions: u32,
    /// Actions of the network.
    pub sac_actions: u32,
    /// Hand-overs to the network, by cause, in the order of [`Cause::ALL`].
    pub hand_overs: [u32; CAUSES],
    /// Times that the network gave the arm back.
    pub hand_backs: u32,
}

/// The state of the switch in one episode.
///
/// Costs one addition and two comparisons an action, and what the detector costs. Of the detectors,
/// [`Visited`](crate::cycle::Visited) hands over at the first repeated pose, as the paper did, and
/// [`Brent`](crate::cycle::Brent) in 16 bytes at a later one: by then the graph may have gone round its cycle a few
/// times more.
#[derive(Clone, Debug)]
pub struct Switch<S, D> {
    settings: Settings<S>,
    detector: D,
    driver: Driver,
    /// Actions left to the network.
    left: u32,
    /// The least distance so far, mm.
    best: S,
    counts: Counts,
}

impl<S: Lattice, D: CycleDetector> Switch<S, D> {
    /// At the start of an episode the graph drives.
    pub fn new(settings: Settings<S>, mut detector: D, seen: &Observation<S>) -> Self {
        detector.reset(seen.pose);
        let (driver, counts) = (Driver::Tpg, Counts::default());
        Self { settings, detector, driver, left: 0, best: seen.distance(), counts }
    }

    /// Who acts next (and whom a guard may still turn down).
    pub fn driver(&self) -> Driver {
        self.driver
    }

    /// What happened so far.
    pub fn counts(&self) -> &Counts {
        &self.counts
    }

    /// The guard refused the graph's action, which was not executed.
    pub fn refused(&mut self) {
        self.hand_over(Cause::Guard);
    }

    /// An action ended the episode: it counts, and nothing else changes.
    pub fn ended(&mut self, chosen: Chosen) {
        let actions = match chosen.driver {
            Driver::Tpg => &mut self.counts.tpg_actions,
            Driver::Sac => &mut self.counts.sac_actions,
        };
        *actions = actions.saturating_add(1);
    }

    /// What is seen after an action that did not end the episode; tells why the network acts next, if it newly does.
    pub fn acted(&mut self, chosen: Chosen, seen: &Observation<S>) -> Option<Cause> {
        self.ended(chosen);
        let distance = seen.distance();
        match chosen.driver {
            Driver::Tpg => {
                if distance < self.best {
                    self.best = distance;
                }
                // Asked in any case: it must learn of every pose of the graph.
                let repeats = self.detector.repeats(seen.pose);
                let cause = if distance > self.best + self.settings.separation {
                    Cause::Drift
                } else if chosen.wanted == Move::STOP {
                    Cause::Stop
                } else if repeats {
                    Cause::Cycle
                } else {
                    return None;
                };
                self.hand_over(cause);
                Some(cause)
            }
            Driver::Sac => {
                if self.left != NEVER {
                    self.left = self.left.saturating_sub(1);
                }
                if self.left == 0 {
                    self.driver = Driver::Tpg;
                    self.best = distance;
                    self.counts.hand_backs = self.counts.hand_backs.saturating_add(1);
                }
                None
            }
        }
    }

    fn hand_over(&mut self, cause: Cause) {
        self.driver = Driver::Sac;
        self.left = self.settings.hand_back_after;
        if let Some(count) = self.counts.hand_overs.get_mut(cause as usize) {
            *count = count.saturating_add(1);
        }
    }
}
