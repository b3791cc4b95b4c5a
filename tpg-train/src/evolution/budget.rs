//! The budget of the search for weights: when one search is followed by another, and when evolution begins.
//!
//! No number of generations fits every problem. Episodes of a pole that falls at once have ten steps, and a search has hardly begun
//! after them; episodes of a swimmer always have a thousand. So the searches share a part of the run, and one that stalls makes room
//! for the next: it got stuck by bad luck, or looked for sums where products are needed.

use serde::{Deserialize, Serialize};

/// Minimum number of generations without progress before a search has stalled.
const MIN_PATIENCE: u64 = 10;
/// A search makes progress when it gains this part of what its last progress was: slow gains do not count.
const PROGRESS: f64 = 0.2;
/// Maximum number of generations of all searches, in default lengths of one: a run without a limit must terminate.
const MAX_LENGTHS: u64 = 30;
/// The part of the budget after which no other search begins.
const TOO_LATE: f64 = 0.9;
/// The part of its budget after which a random search ends that is no better than luck.
const TRIAL: f64 = 0.25;
/// A random search that gains less than this part of its last progress, in the first of these parts of its budget, starts again,
/// unless more than the last part is over. The second part is that of searches beside which another one waits.
const RANDOM_PROGRESS: f64 = 0.1;
const RANDOM_PATIENCE: [f64; 2] = [0.15, 0.05];
const RANDOM_TOO_LATE: f64 = 0.75;

/// Progress of the search for weights.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Budget {
    /// The generation with which the current search began.
    pub begun: u64,
    /// Number of searches before it.
    pub searches: u64,
    /// The part of the run that was over then.
    pub part: f64,
    /// The gain of its last progress.
    gain: f64,
    /// Generation, part of the run and score at its last progress.
    progress: Option<(u64, f64, f64)>,
    /// The generation before which the last search ended.
    pub ended: Option<u64>,
}

/// Result of a generation of a search.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    /// Number of generations of the run so far.
    pub generation: u64,
    /// The part of the run that is over; none in a run without a limit.
    pub part: Option<f64>,
    /// Score of the search.
    pub score: f64,
}

/// The limits of a search.
#[derive(Clone, Copy, Debug)]
pub(super) struct Limits {
    /// Default number of generations.
    pub length: u64,
    /// The part of the run at which it ends.
    pub part: f64,
    /// For a random search the score of luck; another search follows it.
    pub luck: Option<f64>,
    /// True for one that should start again, in a run with a limit.
    pub restart: bool,
    /// True if an earlier random search waits to go on.
    pub waits: bool,
}

impl Budget {
    /// Records what a generation has brought; the search goes on unless `searches` or `ended` has changed.
    pub(super) fn spend(&mut self, point: Point, limits: Limits) {
        let (progress, now) =
            (if limits.luck.is_some() { RANDOM_PROGRESS } else { PROGRESS }, point.part.unwrap_or(0.0));
        let gain = self.progress.map(|(_, _, last)| point.score - last);
        if gain.is_none_or(|gain| gain > progress * self.gain) {
            self.gain = gain.unwrap_or(0.0);
            self.progress = Some((point.generation, now, point.score));
        }
        let since = |begin: u64| point.generation - begin;
        let has_stalled = since(self.begun) >= limits.length
            && self.progress.is_some_and(|(last, ..)| since(last) >= (limits.length / 2).max(MIN_PATIENCE));
        let is_over = |part: f64| point.part.is_some_and(|over| over >= part * limits.part);
        let patience = RANDOM_PATIENCE[usize::from(limits.waits)];
        if let Some(luck) = limits.luck {
            let is_lucky = point.score > luck;
            let share = |part: f64| self.part + part * (limits.part - self.part);
            if now >= share(if is_lucky { 1.0 } else { TRIAL }) && point.part.is_some()
                || (point.part.is_none() && has_stalled)
            {
                self.begin_another(&point);
            } else if is_lucky
                && (limits.restart && point.part.is_some()
                    || self.progress.is_some_and(|(_, last, _)| now - last >= patience * limits.part))
                && !is_over(RANDOM_TOO_LATE)
            {
                self.begin_another(&point);
                self.searches -= 1;
            }
        } else if is_over(1.0) || point.generation >= MAX_LENGTHS * limits.length {
            self.ended = Some(point.generation);
        } else if has_stalled {
            let is_late = point.part.is_none() || is_over(TOO_LATE);
            // Nothing follows a search that has the whole run.
            if is_late && (point.part.is_none() || limits.part < 1.0) {
                self.ended = Some(point.generation);
            } else if !is_late {
                self.begin_another(&point);
            }
        }
    }

    fn begin_another(&mut self, point: &Point) {
        let part = point.part.unwrap_or(0.0);
        *self = Self { begun: point.generation, part, searches: self.searches + 1, ..Self::default() };
    }
}

#[cfg(test)]
mod tests {
    use super::{Budget, Limits, Point};

    /// Spends a budget on generations that score what `score` says, each a hundredth of the run if it has a limit; returns the
    /// generations in which a search began or ended.
    fn run(limits: Limits, has_limit: bool, score: impl Fn(u64) -> f64) -> Vec<u64> {
        let (mut budget, mut events) = (Budget::default(), Vec::new());
        for generation in 1..2000 {
            let before = budget.searches;
            let part = has_limit.then_some(generation as f64 / 100.0);
            budget.spend(Point { generation, part, score: score(generation) }, limits);
            if budget.searches > before || budget.ended.is_some() {
                events.push(generation);
            }
            if budget.ended.is_some() || limits.luck.is_some() && budget.searches > 0 {
                return events;
            }
        }
        panic!("no end: {budget:?}");
    }

    #[test]
    fn searches_share_their_part_of_a_run() {
        let cma = Limits { length: 20, part: 0.6, luck: None, restart: false, waits: false };
        let random = Limits { luck: Some(50.0), ..cma };
        let (rising, flat) = (|now: u64| now as f64, |_: u64| 0.0);
        // Slow: a fifth of what was gained before is not gained within ten generations.
        let slow = |now: u64| if now == 1 { 0.0 } else { 100.0 + now as f64 };
        let second = |now: u64| if now > 20 { now as f64 } else { 0.0 };
        for (what, limits, has_limit, score, events) in [
            ("progress uses the whole part", cma, true, &rising as &dyn Fn(u64) -> f64, &[60][..]),
            ("one that stalls makes room, until it is too late", cma, true, &flat, &[20, 40, 60]),
            ("slow gains are none", cma, true, &slow, &[20, 60]),
            ("the second one goes on", cma, true, &second, &[20, 60]),
            ("without a limit the first that stalls is the last", cma, false, &flat, &[20]),
            ("with the whole run it goes on", Limits { part: 1.0, ..cma }, true, &flat, &[20, 40, 60, 80, 100]),
            ("a part that is short ends it early", Limits { part: 0.1, ..cma }, true, &rising, &[10]),
            ("a random search has its part if it is good", random, true, &|_| 51.0, &[60]),
            ("and a quarter of it if it is not", random, true, &flat, &[15]),
            ("without a limit it ends when it stalls", random, false, &flat, &[20]),
        ] {
            assert_eq!(run(limits, has_limit, score), events, "{what}");
        }
        let mut budget = Budget::default();
        let begun = (1..60).map(|generation: i32| {
            let (part, score) = (Some(f64::from(generation) / 100.0), f64::from(generation.min(20)));
            budget.spend(Point { generation: generation as u64, part, score }, Limits { luck: Some(5.0), ..cma });
            (budget.begun, budget.part)
        });
        let begun: std::collections::BTreeMap<_, _> = begun.collect();
        assert_eq!(
            begun,
            [(0, 0.0), (30, 0.3), (40, 0.4)].into(),
            "a random search starts again where it has stalled, but not late"
        );
        let long = Limits { length: 20, part: 1e9, luck: None, restart: false, waits: false };
        assert_eq!(run(long, true, flat).last(), Some(&600), "30 lengths at most");
    }
}
