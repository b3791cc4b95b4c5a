//! The hybrid: a tangled program graph drives, a soft actor-critic helps where the graph gives up.
//!
//! The graph is cheap and stops, cycles or strays on some targets; the network costs more and knows what to do there.
//! This is Algorithm 1 of the paper as its artifact ran it, which differs from the print in three points: the network
//! takes over when the distance *exceeds* the best one by more than `separation` (printed the other way round), the
//! best distance starts anew when the network hands back, and of the network's turn only its last pose is judged.
//!
//! | item | subject |
//! | --- | --- |
//! | [`Settings`] | the paper's two parameters, and two of our own: a guard, and a hand-over that is final |
//! | [`Hybrid`] | two policies with their settings: constant, shared by all episodes |
//! | [`Switch`] | the policy whose turn it is: the state of one episode, a few words and a cycle detector |
//! | [`HybridEpisode`] | one episode in the simulated arm |
//! | [`Control`] | the state of a control loop on a real arm, whose readings may be wrong |
//!
//! On a real arm there is no [`HybridEpisode`]: the control loop calls [`Hybrid::step`], which [checks](crate::sensors) every
//! reading. A simulation of your own asks and tells the [`Switch`] itself; nothing is checked there:
//!
//! ```
//! use tpg_arm::{Joint, Move, WIDOWX};
//! use tpg_arm::cycle::Brent;
//! use tpg_arm::hybrid::{Driver, Guard, Hybrid, Settings, Switch};
//! use tpg_arm::observation::Observation;
//! use tpg_runtime::policy::Policy;
//!
//! struct Always(Move);
//!
//! impl Policy for Always {
//!     type State = Observation<f32>;
//!     type Action = Move;
//!     fn decide(&self, _seen: &Observation<f32>) -> Move { self.0 }
//! }
//!
//! let arm = WIDOWX.to_f32();
//! let settings = Settings { hand_back_after: 100, separation: 20.0, guard: Guard::JointLimits };
//! let hybrid = Hybrid { arm: &arm, tpg: Always(Move::STOP), sac: Always(Move::single(Joint(0), 1)), settings };
//!
//! let mut seen = Observation::at(&arm, arm.home, [0.0, 300.0, 300.0]);
//! let mut switch = Switch::new(settings, Brent::new(), &seen);
//! for _ in 0..10 {
//!     let chosen = hybrid.decide(&mut switch, &seen);
//!     // Here the motors move and are read; this is where they would be.
//!     let pose = arm.step(seen.pose, chosen.wanted).pose;
//!     seen = Observation::at(&arm, pose, seen.target);
//!     switch.acted(chosen, &seen);
//! }
//! // The graph wanted to stop, so the network has acted since.
//! assert_eq!((switch.counts().tpg_actions, switch.counts().sac_actions), (1, 9));
//! assert_eq!(switch.driver(), Driver::Sac);
//! ```

mod control;
mod episode;
mod part;
mod turns;

pub use control::Control;
pub use episode::{HybridEpisode, HybridSummary};
pub use tpg_runtime::switch::NEVER;
pub use turns::{CAUSES, Cause, Chosen, Counts, Driver, Switch};

use crate::arm::{Arm, Collision, Leeway, Move, Pose};
use crate::cycle::CycleDetector;
use crate::kinematics::Lattice;
use crate::observation::Observation;
use part::valid_part;
use tpg_runtime::named;
use tpg_runtime::policy::Policy;
use tpg_runtime::switch;

/// The rules by which two policies share an arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings<S> {
    /// Actions of the network before the graph is asked again: the paper's `nbItGoBackTPG`, from 1. [`NEVER`] makes the
    /// hand-over final.
    pub hand_back_after: u32,
    /// The network takes over when the distance exceeds the best one so far by more than this, mm: the paper's
    /// `sepDistance`. With infinity it never does for that reason.
    pub separation: S,
    /// The actions that are not executed.
    pub guard: Guard,
}

named! {
    /// The actions that are not executed. The paper has no guard.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
    pub enum Guard {
        /// Every action is executed, and an invalid one ends the episode.
        None = "none",
        /// Not the graph's that leave a joint's range: the network takes over instead. Two comparisons a joint.
        JointLimits = "joint-limits",
        /// Nor the graph's that collide: at most one collision test an action of the graph.
        Collisions = "collisions",
        /// Nor the network's: where its action would be invalid it holds joints, or lets the graph act once, or rests. From a
        /// free pose no invalid action is ever executed. At most one collision test an action, up to 9 where the network's would be
        /// invalid.
        Both = "both",
    }
}

impl Guard {
    /// Returns true if an action of the graph must not be executed. `collision` finds the arm's collision at a pose.
    #[inline(always)] // as `Hybrid::decide`
    pub fn refuses<S: Lattice>(
        self,
        arm: &Arm<S>,
        pose: Pose,
        wanted: Move,
        collision: impl FnOnce(Pose) -> Option<Collision>,
    ) -> bool {
        match self {
            Self::None => false,
            Self::JointLimits => arm.moved(pose, wanted).is_none(),
            Self::Collisions | Self::Both => {
                arm.moved(pose, wanted).is_none_or(|moved| moves_in_plane(wanted) && collision(moved).is_some())
            }
        }
    }

    /// Returns the part of a network's move that may be executed, with as few joints held as possible; `None` if there is none.
    pub fn part<S: Lattice>(self, arm: &Arm<S>, pose: Pose, wanted: Move) -> Option<Move> {
        if self == Self::Both { valid_part(arm, &Leeway::new(), pose, wanted) } else { Some(wanted) }
    }
}

/// Two policies that share an arm.
#[derive(Clone, Copy, Debug)]
pub struct Hybrid<'a, S, T, P> {
    /// The arm: the guard needs its limits and shapes.
    pub arm: &'a Arm<S>,
    /// Drives: a tangled program graph.
    pub tpg: T,
    /// Helps: a soft actor-critic's network.
    pub sac: P,
    /// The rules by which they share the arm.
    pub settings: Settings<S>,
}

impl<S, T, P> Hybrid<'_, S, T, P>
where
    S: Lattice,
    T: Policy<State = Observation<S>, Action = Move>,
    P: Policy<State = Observation<S>, Action = Move>,
{
    /// The next action and the policy that chose it. A guard may hand over here: then both policies are asked, once each.
    pub fn decide<D: CycleDetector<Pose>>(&self, switch: &mut Switch<S, D>, seen: &Observation<S>) -> Chosen {
        let both = switch::Pair { tpg: &self.tpg, sac: &self.sac };
        let guard = ArmGuard { arm: self.arm, guard: self.settings.guard, leeway: &switch.leeway };
        both.decide(&mut switch.turns, seen, &guard)
    }
}

/// A guard of an arm.
struct ArmGuard<'a, S> {
    arm: &'a Arm<S>,
    guard: Guard,
    leeway: &'a Leeway,
}

impl<S: Lattice> switch::Guard<Observation<S>, Move> for ArmGuard<'_, S> {
    #[inline(always)]
    fn refuses(&self, seen: &Observation<S>, &wanted: &Move) -> bool {
        self.guard.refuses(self.arm, seen.pose, wanted, |moved| self.leeway.collision(self.arm, moved))
    }

    #[inline(always)]
    fn mend(&self, seen: &Observation<S>, wanted: Move, again: impl FnOnce() -> Option<Move>) -> Chosen {
        if self.guard != Guard::Both {
            return Chosen { driver: Driver::Sac, wanted };
        }
        if let Some(wanted) = valid_part(self.arm, self.leeway, seen.pose, wanted) {
            return Chosen { driver: Driver::Sac, wanted };
        }
        match again() {
            Some(wanted) if wanted != Move::STOP => Chosen { driver: Driver::Tpg, wanted },
            _ => Chosen { driver: Driver::Sac, wanted: Move::STOP },
        }
    }
}

/// Returns true if more than the base moves. The base alone changes nothing in the arm's plane, where collisions are.
#[inline(always)]
fn moves_in_plane(Move([_, plane @ ..]): Move) -> bool {
    plane.iter().any(|&delta| delta != 0)
}
