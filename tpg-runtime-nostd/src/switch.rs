//! Two policies over one problem, and the rules by which they take turns.
//!
//! The first policy drives: a tangled program graph that is cheap and good far from difficulties. The second one helps for
//! a number of actions wherever the first has got worse, rests, goes in circles, or wants what a guard refuses: a network,
//! say. A [`Switch`] needs to know three things after an action: the distance to the goal, a key of the state, and
//! whether the action rests.
//!
//! ```
//! use tpg_runtime::cycle::Brent;
//! use tpg_runtime::policy::Policy;
//! use tpg_runtime::switch::{Cause, Driver, Pair, Settings, Switch, Unguarded};
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
//! let pair = Pair { tpg: Walk(0), sac: Walk(1) };
//! let settings = Settings { hand_back_after: 2, separation: 10.0 };
//! let (mut place, distance) = (0, |place: i32| f64::from((3 - place).abs()));
//! let mut switch = Switch::new(settings, Brent::new(), place, distance(place));
//! let mut causes = Vec::new();
//! for _ in 0..4 {
//!     let chosen = pair.decide(&mut switch, &place, &Unguarded);
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

/// The reason why the second policy took over. Where several of the rules' reasons fall together the first of these counts.
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
    /// The first policy asked, for one action: see [`AskSwitch`].
    Asked,
}

/// The number of causes that a [`Switch`] has of its own: the rules, all but [`Cause::Asked`].
pub const CAUSES: usize = 4;

/// Actions of each policy, and the reasons of their changes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Counts {
    /// Actions of the first policy.
    pub tpg_actions: u32,
    /// Actions of the second policy.
    pub sac_actions: u32,
    /// Hand-overs to the second policy by a rule, in the order of [`Cause`].
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
    fn refused(&mut self) {
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
    #[inline(always)] // as `Pair::decide`
    pub fn acted<K>(&mut self, driver: Driver, rests: bool, key: K, distance: S) -> Option<Cause>
    where
        D: CycleDetector<K>,
    {
        self.ended(driver);
        match driver {
            Driver::Tpg => self.judged(rests, key, distance),
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

    /// Applies the rules to the state behind an action in the first policy's turn.
    #[inline(always)] // as `acted`
    fn judged<K>(&mut self, rests: bool, key: K, distance: S) -> Option<Cause>
    where
        D: CycleDetector<K>,
    {
        if distance < self.best {
            self.best = distance;
        }
        // The detector is asked in any case: it must learn of every state of the first policy's turn.
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

    fn hand_over(&mut self, cause: Cause) {
        self.driver = Driver::Sac;
        self.left = self.settings.hand_back_after;
        if let Some(count) = self.counts.hand_overs.get_mut(cause as usize) {
            *count = count.saturating_add(1);
        }
    }
}

/// An answer of a first policy that can ask the second one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Answer<A> {
    /// An action of its own.
    Act(A),
    /// The second policy decides this action.
    Ask,
}

/// An action by either policy, and the reason if the second chose it in the first one's turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Turn<A> {
    /// The action and the policy that chose it.
    pub chosen: Chosen<A>,
    /// True if the second policy chose because the first asked.
    pub asked: bool,
}

impl<A> Turn<A> {
    /// The policy whose turn it was: the first one's where it asked.
    pub fn driver(&self) -> Driver {
        if self.asked { Driver::Tpg } else { self.chosen.driver }
    }
}

/// A [`Switch`] whose first policy can ask: the second one then decides a single action, and the turn stays the first
/// one's. The rules judge the state behind such an action as behind the first policy's own.
///
/// ```
/// use tpg_runtime::cycle::Brent;
/// use tpg_runtime::policy::Policy;
/// use tpg_runtime::switch::{Answer, AskSwitch, Pair, Settings, Switch, Unguarded};
///
/// /// Walks by 1, and asks at every third place.
/// struct Walk;
/// impl Policy for Walk {
///     type State = i32;
///     type Action = Answer<i32>;
///     fn decide(&self, place: &i32) -> Answer<i32> { if place % 3 == 2 { Answer::Ask } else { Answer::Act(1) } }
/// }
///
/// /// Leaps over it.
/// struct Leap;
/// impl Policy for Leap {
///     type State = i32;
///     type Action = i32;
///     fn decide(&self, _place: &i32) -> i32 { 2 }
/// }
///
/// // Nothing but asking hands over: the separation is infinite, and no state repeats.
/// let pair = Pair { tpg: Walk, sac: Leap };
/// let settings = Settings { hand_back_after: 1, separation: f32::INFINITY };
/// let (mut place, distance) = (0, |place: i32| (9 - place) as f32);
/// let mut switch = AskSwitch::new(Switch::new(settings, Brent::new(), place, distance(place)));
/// while place < 9 {
///     let turn = pair.decide_or_ask(&mut switch, &place, &Unguarded);
///     place += turn.chosen.wanted;
///     switch.acted(&turn, false, place, distance(place));
/// }
/// assert_eq!((switch.asks(), switch.counts().tpg_actions, switch.counts().sac_actions), (3, 4, 3));
/// ```
#[derive(Clone, Debug)]
pub struct AskSwitch<S, D> {
    rules: Switch<S, D>,
    asks: u32,
}

impl<S: Scalar, D> AskSwitch<S, D> {
    /// Lets the first policy of a switch ask; call it at the start of an episode.
    pub fn new(rules: Switch<S, D>) -> Self {
        Self { rules, asks: 0 }
    }

    /// The policy whose turn it is.
    pub fn driver(&self) -> Driver {
        self.rules.driver()
    }

    /// Actions that the first policy asked for: the count of [`Cause::Asked`].
    pub fn asks(&self) -> u32 {
        self.asks
    }

    /// Counts of the rules so far. Actions that were asked for count as the second policy's.
    pub fn counts(&self) -> &Counts {
        self.rules.counts()
    }

    /// Notes an action that ended the episode.
    pub fn ended<A>(&mut self, turn: &Turn<A>) {
        self.rules.ended(turn.chosen.driver);
        self.asks = self.asks.saturating_add(turn.asked.into());
    }

    /// Notes an action that did not end the episode, and the state behind it; see [`Switch::acted`]. Returns the reason why
    /// the second policy acts next, or why it acted.
    pub fn acted<A, K>(&mut self, turn: &Turn<A>, rests: bool, key: K, distance: S) -> Option<Cause>
    where
        D: CycleDetector<K>,
    {
        if !turn.asked {
            return self.rules.acted(turn.chosen.driver, rests, key, distance);
        }
        self.ended(turn);
        self.rules.judged(rests, key, distance).or(Some(Cause::Asked))
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
pub struct Pair<T, P> {
    /// The first, which drives.
    pub tpg: T,
    /// The second, which helps.
    pub sac: P,
}

impl<T: Policy, P: Policy<State = T::State, Action = T::Action>> Pair<T, P> {
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

impl<A, T: Policy<Action = Answer<A>>, P: Policy<State = T::State, Action = A>> Pair<T, P> {
    /// The next action where the first policy can ask. A guard judges what the first policy wants itself, and mends
    /// what the second one answers, whether it was asked or has its turn.
    pub fn decide_or_ask<S: Scalar, D>(
        &self,
        switch: &mut AskSwitch<S, D>,
        state: &T::State,
        guard: &impl Guard<T::State, A>,
    ) -> Turn<A> {
        if switch.driver() == Driver::Sac {
            let again = || match self.tpg.decide(state) {
                Answer::Act(wanted) => Some(wanted).filter(|wanted| !guard.refuses(state, wanted)),
                Answer::Ask => None,
            };
            return Turn { chosen: guard.mend(state, self.sac.decide(state), again), asked: false };
        }
        let asked = match self.tpg.decide(state) {
            Answer::Act(wanted) if !guard.refuses(state, &wanted) => {
                return Turn { chosen: Chosen { driver: Driver::Tpg, wanted }, asked: false };
            }
            Answer::Act(_) => {
                switch.rules.refused();
                false
            }
            Answer::Ask => true,
        };
        // The first policy has nothing of its own that may be executed.
        Turn { chosen: guard.mend(state, self.sac.decide(state), || None), asked }
    }
}
