//! Two policies over one problem: whose turn it is, and when they change.
//!
//! The first policy drives: a tangled program graph that is cheap and good far from difficulties. The second one helps for
//! a number of actions wherever the first has got worse, rests, goes in circles, or wants what a guard refuses: a network,
//! say. A [`Switch`] needs to know three things after an action: the distance to the goal, a key of the state, and
//! whether the action rests.
//!
//! ```
//! use tpg_runtime::cycle::Brent;
//! use tpg_runtime::policy::Policy;
//! use tpg_runtime::switch::{Cause, Driver, Hybrid, Settings, Switch, Unguarded};
//!
//! /// Walks by a step.
//! struct Walk(i32);
//! impl Policy for Walk {
//!     type State = i32;
//!     type Action = i32;
//!     fn decide(&self, _place: &i32) -> i32 { self.0 }
//! }
//!
//! // The first policy rests at 0, the goal lies at 3: the second one takes over, for two actions.
//! let hybrid = Hybrid { tpg: Walk(0), sac: Walk(1) };
//! let settings = Settings { hand_back_after: 2, separation: 10.0 };
//! let (mut place, distance) = (0, |place: i32| f64::from((3 - place).abs()));
//! let mut switch = Switch::new(settings, Brent::new(), place, distance(place));
//! let mut causes = Vec::new();
//! for _ in 0..4 {
//!     let chosen = hybrid.decide(&mut switch, &place, &Unguarded);
//!     place += chosen.wanted;
//!     causes.extend(switch.acted(chosen.driver, chosen.wanted == 0, place, distance(place)));
//! }
//! assert_eq!(causes, [Cause::Stop, Cause::Stop]);
//! assert_eq!((place, switch.driver()), (2, Driver::Sac));
//! ```

use crate::cycle::CycleDetector;
use crate::policy::Policy;
use crate::scalar::Scalar;

/// For [`Settings::hand_back_after`]: the second policy keeps the problem until the episode ends.
pub const NEVER: u32 = u32::MAX;

/// The times at which two policies change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings<S> {
    /// Actions of the second policy before the first is asked again, from 1. [`NEVER`] makes the hand-over final.
    pub hand_back_after: u32,
    /// The second policy takes over when the distance exceeds the best one so far by more than this. With infinity it
    /// never does for that reason.
    pub separation: S,
}

/// The policy that acts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Driver {
    /// The first: a tangled program graph.
    Tpg,
    /// The second: a soft actor-critic's network.
    Sac,
}

/// An action and the policy that chose it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Chosen<A> {
    /// The policy that chose.
    pub driver: Driver,
    /// The action.
    pub wanted: A,
}

/// The reason why the second policy took over. Where several reasons fall together the first of these counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Cause {
    /// The first policy's action was not executed: the guard refused it.
    Guard,
    /// The distance is greater than it has been, by more than the separation.
    Drift,
    /// The first policy rests: it chose an action that changes nothing, or its [`Patience`] is at an end.
    Stop,
    /// The first policy came to a state where it had been before.
    Cycle,
}

/// The number of causes.
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

/// Actions of each policy, and the reasons of their changes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Counts {
    /// Actions of the first policy.
    pub tpg_actions: u32,
    /// Actions of the second policy.
    pub sac_actions: u32,
    /// Hand-overs to the second policy, by cause, in the order of [`Cause::ALL`].
    pub hand_overs: [u32; CAUSES],
    /// Times that the second policy handed back.
    pub hand_backs: u32,
}

/// The state of the switch in one episode.
///
/// Costs one addition and two comparisons an action, and the cost of its detector. Of the detectors,
/// [`Visited`](crate::cycle::Visited) hands over at the first repeated state, and [`Brent`](crate::cycle::Brent) in a few
/// bytes at a later one: by then the first policy may have gone round its cycle a few times more.
#[derive(Clone, Debug)]
pub struct Switch<S, D> {
    settings: Settings<S>,
    detector: D,
    driver: Driver,
    /// Actions left to the second policy.
    left: u32,
    /// The least distance so far.
    best: S,
    counts: Counts,
}

impl<S: Scalar, D> Switch<S, D> {
    /// A switch at the start of an episode, where the first policy drives.
    pub fn new<K>(settings: Settings<S>, mut detector: D, start: K, distance: S) -> Self
    where
        D: CycleDetector<K>,
    {
        detector.reset(start);
        let (driver, counts) = (Driver::Tpg, Counts::default());
        Self { settings, detector, driver, left: 0, best: distance, counts }
    }

    /// The policy that acts next, unless a guard turns it down.
    pub fn driver(&self) -> Driver {
        self.driver
    }

    /// Counts so far.
    pub fn counts(&self) -> &Counts {
        &self.counts
    }

    /// Notes that the guard refused the first policy's action, which was not executed.
    pub fn refused(&mut self) {
        self.hand_over(Cause::Guard);
    }

    /// Notes that an action ended the episode: it counts, and nothing else changes.
    pub fn ended(&mut self, driver: Driver) {
        let actions = match driver {
            Driver::Tpg => &mut self.counts.tpg_actions,
            Driver::Sac => &mut self.counts.sac_actions,
        };
        *actions = actions.saturating_add(1);
    }

    /// Notes an action that did not end the episode, and the state behind it; the reason why the second policy acts next,
    /// if it newly does. `rests` is judged by the caller: the action changes nothing, or a [`Patience`] is at an end.
    #[inline(always)] // as `Hybrid::decide`
    pub fn acted<K>(&mut self, driver: Driver, rests: bool, key: K, distance: S) -> Option<Cause>
    where
        D: CycleDetector<K>,
    {
        self.ended(driver);
        match driver {
            Driver::Tpg => {
                if distance < self.best {
                    self.best = distance;
                }
                // Asked in any case: it must learn of every state of the first policy.
                let repeats = self.detector.repeats(key);
                let cause = if distance > self.best + self.settings.separation {
                    Cause::Drift
                } else if rests {
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

/// A limit on the first policy's actions without progress, for problems that know no action of rest.
///
/// Progress is a distance below the least one of the present turn. The answer of [`ends`](Self::ends) is what
/// [`Switch::acted`] takes as `rests`.
///
/// ```
/// use tpg_runtime::switch::{Driver, Patience};
///
/// let mut patience = Patience::new(2, 9.0);
/// let ends = [8.0, 8.0, 7.0, 7.5, 7.0].map(|distance| patience.ends(Driver::Tpg, distance));
/// assert_eq!(ends, [false, false, false, false, true]);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Patience<S> {
    limit: u32,
    /// The least distance of the turn.
    best: S,
    /// Actions since then.
    without: u32,
}

impl<S: Scalar> Patience<S> {
    /// A count at the start of an episode. `limit` is a number of actions from 1, or [`NEVER`].
    pub fn new(limit: u32, distance: S) -> Self {
        Self { limit, best: distance, without: 0 }
    }

    /// Notes an action and the distance behind it. Returns true if the first policy has acted `limit` times without
    /// progress; an action of the second one starts the count anew.
    pub fn ends(&mut self, driver: Driver, distance: S) -> bool {
        if driver == Driver::Sac || distance < self.best {
            self.best = distance;
            self.without = 0;
            return false;
        }
        self.without = self.without.saturating_add(1);
        self.limit != NEVER && self.without >= self.limit
    }
}

/// A problem's say in which actions are executed.
pub trait Guard<State: ?Sized, A> {
    /// Returns true if the first policy's action must not be executed.
    fn refuses(&self, state: &State, wanted: &A) -> bool;

    /// The second policy's action as it may be executed. `again` asks the first policy once more; it answers `None` where
    /// it has just been refused, or is refused now.
    fn mend(&self, state: &State, wanted: A, again: impl FnOnce() -> Option<A>) -> Chosen<A>;
}

/// No guard: every action is executed.
#[derive(Clone, Copy, Debug, Default)]
pub struct Unguarded;

impl<State: ?Sized, A> Guard<State, A> for Unguarded {
    fn refuses(&self, _: &State, _: &A) -> bool {
        false
    }

    fn mend(&self, _: &State, wanted: A, _: impl FnOnce() -> Option<A>) -> Chosen<A> {
        Chosen { driver: Driver::Sac, wanted }
    }
}

/// Two policies over one problem.
#[derive(Clone, Copy, Debug)]
pub struct Hybrid<T, P> {
    /// The first, which drives.
    pub tpg: T,
    /// The second, which helps.
    pub sac: P,
}

impl<T: Policy, P: Policy<State = T::State, Action = T::Action>> Hybrid<T, P> {
    /// The next action and the policy that chose it. A guard may hand over here: then both policies are asked, once each.
    #[inline(always)] // a problem's own function is this one with its guard
    pub fn decide<S: Scalar, D>(
        &self,
        switch: &mut Switch<S, D>,
        state: &T::State,
        guard: &impl Guard<T::State, T::Action>,
    ) -> Chosen<T::Action> {
        let first = || Some(self.tpg.decide(state)).filter(|wanted| !guard.refuses(state, wanted));
        let drives = switch.driver() == Driver::Tpg;
        if drives {
            if let Some(wanted) = first() {
                return Chosen { driver: Driver::Tpg, wanted };
            }
            switch.refused();
        }
        // Refused once, it would be refused again.
        guard.mend(state, self.sac.decide(state), || if drives { None } else { first() })
    }
}
