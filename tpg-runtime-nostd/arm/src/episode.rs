//! One episode: a policy drives the arm from a start towards a target, until one of five things happens.
//!
//! These are the project's own rules (the paper's with one end for every invalid action); the artifact's exact
//! bookkeeping, which ends a cycle one action later, lives with the conformance suite in `tpg-train`. An episode that two
//! policies share is a [`HybridEpisode`](crate::hybrid::HybridEpisode).

use crate::arm::{Arm, Invalid, Move, Play, Pose};
use crate::cycle::CycleDetector;
use crate::kinematics::{self, Lattice, Vector};
use crate::observation::Observation;
use tpg_runtime::policy::Policy;

/// A task for the arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReachTask<S> {
    /// The pose in which the arm starts.
    pub start: Pose,
    /// The target of the hand's tip, mm.
    pub target: Vector<S>,
    /// The episode succeeds when hand and target are less than this apart, mm.
    pub tolerance: S,
    /// After this many actions it is over.
    pub max_actions: u32,
}

/// The end of an episode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Outcome {
    /// The hand is at its target: the only success.
    Reached,
    /// The policy asked for something impossible. Counts as a collision.
    Invalid(Invalid),
    /// The policy chose not to move.
    Stop,
    /// A pose repeats: a memoryless policy will never leave the cycle.
    Cycle,
    /// The action limit was reached.
    Timeout,
}

/// The end of an episode, and its place.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary<S> {
    /// The end.
    pub outcome: Outcome,
    /// Actions done, the last one included.
    pub actions: u32,
    /// The final pose of the motors.
    pub pose: Pose,
    /// Hand to target at the end, mm.
    pub distance: S,
}

/// An episode under way.
#[derive(Clone, Debug)]
pub struct Episode<'a, S, D> {
    arm: &'a Arm<S>,
    problem: ReachTask<S>,
    play: Play,
    observation: Observation<S>,
    actions: u32,
    pub(crate) detector: D,
}

impl<'a, S: Lattice, D: CycleDetector<Pose>> Episode<'a, S, D> {
    /// Puts the arm at the problem's start.
    pub fn new(arm: &'a Arm<S>, problem: ReachTask<S>, detector: D) -> Self {
        Self::with_play(arm, problem, detector, Play::NONE)
    }

    /// Puts an arm whose joints have play at the problem's start.
    pub fn with_play(arm: &'a Arm<S>, problem: ReachTask<S>, mut detector: D, play: Play) -> Self {
        detector.reset(problem.start);
        let observation = Observation::at(arm, problem.start, problem.target);
        Self { arm, problem, play, observation, actions: 0, detector }
    }

    /// The observation that the policy sees now.
    pub fn observation(&self) -> &Observation<S> {
        &self.observation
    }

    /// Actions done so far.
    pub fn actions(&self) -> u32 {
        self.actions
    }

    /// Hand to target, mm: the hand where the joints put it, which is where a policy sees it unless they have [`Play`].
    pub fn distance(&self) -> S {
        if self.play == Play::NONE {
            return self.observation.distance();
        }
        let joints = self.play.joints(self.observation.pose);
        kinematics::distance(self.problem.target, kinematics::hand(self.arm, joints))
    }

    /// Does one action of a policy without memory; `Some` when it ended the episode.
    ///
    /// If several ends fall together, the first of these holds: invalid, reached, stop, cycle, timeout.
    pub fn advance(&mut self, wanted: Move) -> Option<Outcome> {
        if let Some(end) = self.step(wanted) {
            Some(end)
        } else if wanted == Move::STOP {
            Some(Outcome::Stop)
        } else if self.detector.repeats(self.observation.pose) {
            Some(Outcome::Cycle)
        } else {
            self.timeout()
        }
    }

    /// Does one action; `Some` where it was invalid or reached the target.
    pub(crate) fn step(&mut self, wanted: Move) -> Option<Outcome> {
        let step = self.arm.step(self.observation.pose, wanted);
        self.actions = self.actions.saturating_add(1);
        self.observation = Observation::at(self.arm, step.pose, self.problem.target);
        if let Some(invalid) = step.invalid {
            Some(Outcome::Invalid(invalid))
        } else if self.distance() < self.problem.tolerance {
            Some(Outcome::Reached)
        } else {
            None
        }
    }

    pub(crate) fn timeout(&self) -> Option<Outcome> {
        (self.actions >= self.problem.max_actions).then_some(Outcome::Timeout)
    }

    pub(crate) fn summary(&self, outcome: Outcome) -> Summary<S> {
        Summary { outcome, actions: self.actions, pose: self.observation.pose, distance: self.distance() }
    }

    /// Lets the policy act until the end; `each` sees the pose after every action.
    pub fn run<P>(mut self, policy: &P, mut each: impl FnMut(Pose)) -> Summary<S>
    where
        P: Policy<State = Observation<S>, Action = Move> + ?Sized,
    {
        loop {
            let outcome = self.advance(policy.decide(&self.observation));
            each(self.observation.pose);
            if let Some(outcome) = outcome {
                return self.summary(outcome);
            }
        }
    }
}
