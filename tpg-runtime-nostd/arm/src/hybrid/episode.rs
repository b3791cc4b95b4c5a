//! One episode of a hybrid in the simulated arm.

use super::{Counts, Driver, Hybrid, NEVER, Switch};
use crate::arm::{Move, Pose};
use crate::cycle::{Brent, CycleDetector};
use crate::episode::{Episode, Outcome, ReachTask, Summary};
use crate::kinematics::Lattice;
use crate::observation::Observation;
use tpg_runtime::policy::Policy;

/// The end of a hybrid's episode, and the actions of each policy.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HybridSummary<S> {
    /// The end and its place.
    pub summary: Summary<S>,
    /// Actions of each policy, the last one included, and the reasons of their changes.
    pub counts: Counts,
}

/// An episode under way.
///
/// It ends when the hand is at its target, at an invalid action of either policy, and at the action limit. Stops and
/// cycles of the graph are the [`Switch`]'s business. Where the network never hands back and comes to a pose again, it
/// will for ever: that ends the episode as a cycle, too.
#[derive(Clone, Debug)]
pub struct HybridEpisode<'a, S, T, P, D> {
    hybrid: &'a Hybrid<'a, S, T, P>,
    /// Its detector watches the network once that keeps the arm to the end.
    episode: Episode<'a, S, Brent>,
    switch: Switch<S, D>,
    /// True in the network's last turn.
    is_last_turn: bool,
}

impl<'a, S, T, P, D> HybridEpisode<'a, S, T, P, D>
where
    S: Lattice,
    T: Policy<State = Observation<S>, Action = Move>,
    P: Policy<State = Observation<S>, Action = Move>,
    D: CycleDetector<Pose>,
{
    /// Puts the arm at the problem's start.
    pub fn new(hybrid: &'a Hybrid<'a, S, T, P>, problem: ReachTask<S>, detector: D) -> Self {
        let episode = Episode::new(hybrid.arm, problem, Brent::new());
        let switch = Switch::new(hybrid.settings, detector, episode.observation());
        Self { hybrid, episode, switch, is_last_turn: false }
    }

    /// The observation that the policies see now.
    pub fn observation(&self) -> &Observation<S> {
        self.episode.observation()
    }

    /// Does one action; returns the policy that chose it, and the episode's end if it ended.
    ///
    /// If several ends fall together, the first of these holds: invalid, reached, cycle, timeout.
    pub fn advance(&mut self) -> (Driver, Option<Outcome>) {
        let chosen = self.hybrid.decide(&mut self.switch, self.episode.observation());
        let is_network = chosen.driver == Driver::Sac;
        if is_network && self.hybrid.settings.hand_back_after == NEVER && !self.is_last_turn {
            self.episode.detector.reset(self.observation().pose);
            self.is_last_turn = true;
        }
        let outcome = self.episode.step(chosen.wanted);
        if outcome.is_some() {
            self.switch.ended(chosen);
            return (chosen.driver, outcome);
        }
        self.switch.acted(chosen, self.episode.observation());
        let pose = self.observation().pose;
        let cycles = is_network && self.is_last_turn && self.episode.detector.repeats(pose);
        (chosen.driver, if cycles { Some(Outcome::Cycle) } else { self.episode.timeout() })
    }

    /// Lets the hybrid act until the end; `each` sees the policy that acted and the pose after every action.
    pub fn run(mut self, mut each: impl FnMut(Driver, Pose)) -> HybridSummary<S> {
        loop {
            let (driver, outcome) = self.advance();
            each(driver, self.episode.observation().pose);
            if let Some(outcome) = outcome {
                return HybridSummary { summary: self.episode.summary(outcome), counts: *self.switch.counts() };
            }
        }
    }
}
