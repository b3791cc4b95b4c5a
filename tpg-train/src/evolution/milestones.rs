//! The end of the search for weights: after so many generations, or by the steps that the run has.
//!
//! No number of generations fits every problem. Episodes of a pole that falls at once have ten steps, and the search has hardly begun
//! when it ends; episodes of a swimmer always have a thousand, and it takes the whole run. So a search that has taken less than one
//! share of the run's steps goes on while it gets better, and none goes beyond another share. After one that has stalled before the
//! first share, another one begins: it got stuck by bad luck, or looked for sums where products are needed.

use super::config::EvolutionConfig;
use serde::{Deserialize, Serialize};
use std::cmp::Ordering;
use tpg_graph::error::Finding;

/// A search ends when this part of its least steps has brought nothing better.
const PATIENCE: u64 = 2;
/// Least number of generations without progress before a search ends or is followed by another one.
const LEAST_PATIENCE: u64 = 10;
/// A search has come further when it has gained this part of all that it had gained before: creeping is no reason to go on.
const FURTHER: f64 = 0.2;
/// Greatest number of generations, in usual lengths of a search, after which none begins anew: a run whose steps never end must
/// not search for ever.
const MOST_LENGTHS: u64 = 30;

/// Milestones of a search for weights that is limited by steps.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Milestones {
    /// Where the latest search began; none if it is the first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub begun: Option<Begin>,
    /// The generation from which only the best of several searches goes on.
    pub chosen: Option<u64>,
    /// Number of generations of the search, once it has ended.
    pub ended: Option<u64>,
    /// The best score of a search so far.
    pub peak: Option<Point>,
    /// The first score of the latest search.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub first: Option<f64>,
    /// Where it last came further.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub further: Option<Point>,
}

/// Where a search began.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Begin {
    /// Its first generation.
    pub generation: u64,
    /// Number of actions before.
    pub steps: u64,
    /// Number of searches before.
    pub searches: u64,
}

/// A point that a search for weights has reached.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Point {
    /// Number of generations so far.
    pub generations: u64,
    /// Number of actions so far.
    pub steps: u64,
    /// Best score of a search then.
    pub score: f64,
}

/// The bounds of a search for weights.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    /// Usual number of generations.
    pub generations: u64,
    /// Bounds in steps; none in a run without a limit of steps.
    pub steps: Option<StepBounds>,
    /// True if no other search follows one that has had its steps.
    pub is_last: bool,
}

/// The bounds of a search for weights in steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct StepBounds {
    /// Number of steps at which it ends with its generations.
    pub least: u64,
    /// Number of steps with which it ends in any case.
    pub most: u64,
}

impl Milestones {
    /// True if nothing has happened: nothing is written then.
    pub(super) fn is_empty(&self) -> bool {
        *self == Self::default()
    }

    /// Records what a generation of the search brought: the choice among searches after half of each bound, a new beginning, and the
    /// end.
    pub(super) fn reach(&mut self, point: Point, bounds: Bounds) {
        let peak = *self.peak.get_or_insert(point);
        if point.score > peak.score {
            self.peak = Some(point);
        }
        let first = *self.first.get_or_insert(point.score);
        if self.further.is_none_or(|last| point.score - last.score > FURTHER * (last.score - first).max(0.0)) {
            self.further = Some(point);
        }
        let begun = self.begun.unwrap_or_default();
        let its_generations = point.generations - begun.generation;
        let is_over = |part: u64| {
            bounds.steps.is_some_and(|steps| point.steps >= begun.steps + steps.most.saturating_sub(begun.steps) / part)
        };
        if self.chosen.is_none() {
            if its_generations >= bounds.generations.div_ceil(2) || is_over(2) {
                // What goes on is compared with itself: of several searches some score was the best by luck.
                (self.chosen, self.peak, self.further) = (Some(point.generations), None, None);
            }
            return;
        }
        let is_over = is_over(1) || self.is_enough(point, its_generations, bounds);
        if is_over && bounds.is_last {
            self.ended = Some(point.generations);
        } else if is_over || self.is_stuck(point, its_generations, bounds) {
            let begun = Begin { generation: point.generations, steps: point.steps, searches: begun.searches + 1 };
            *self = Self { begun: Some(begun), ..Self::default() };
        }
    }

    /// True if a search has had its generations and need not go on.
    fn is_enough(&self, point: Point, its_generations: u64, bounds: Bounds) -> bool {
        match (its_generations.cmp(&bounds.generations), bounds.steps) {
            (Ordering::Less, _) => false,
            (_, None) => true,
            (Ordering::Equal, Some(steps)) if point.steps >= steps.least => true,
            (_, Some(steps)) => self.peak.is_none_or(|peak| {
                let generations = point.generations - peak.generations;
                let is_long = point.steps - peak.steps >= steps.least / PATIENCE;
                let is_late = point.generations >= MOST_LENGTHS * bounds.generations;
                generations >= LEAST_PATIENCE && (is_long || is_late)
            }),
        }
    }

    /// True if a search that has steps left has come no further for half as many generations as it usually has.
    fn is_stuck(&self, point: Point, its_generations: u64, bounds: Bounds) -> bool {
        let patience = (bounds.generations / 2).max(LEAST_PATIENCE);
        bounds.steps.is_some_and(|steps| point.steps < steps.least)
            && its_generations >= bounds.generations
            && self.further.is_some_and(|last| point.generations - last.generations >= patience)
    }

    /// Checks the milestones of a run after so many generations and steps.
    ///
    /// # Errors
    /// One that is later than the run, or that the configuration does not have.
    pub(super) fn check(&self, config: &EvolutionConfig, generation: u64, steps: u64) -> Result<(), Finding> {
        if !config.start.is_by_steps() && !self.is_empty() {
            return Err(Finding::new("milestones", "milestones", "none, without start.share"));
        }
        for (key, found) in [("chosen", self.chosen), ("ended", self.ended)] {
            Finding::range(&format!("milestones.{key}"), found.unwrap_or(0), 0, generation)?;
        }
        for (key, point) in [("peak", self.peak), ("further", self.further)] {
            let (generations, its_steps) = point.map_or((0, 0), |point| (point.generations, point.steps));
            Finding::range(&format!("milestones.{key}.generations"), generations, 0, generation)?;
            Finding::range(&format!("milestones.{key}.steps"), its_steps, 0, steps)?;
        }
        let begun = self.begun.unwrap_or_default();
        let latest = self.chosen.map_or(generation, |chosen| chosen.min(generation));
        Finding::range("milestones.begun.generation", begun.generation, 0, latest)?;
        Finding::range("milestones.begun.steps", begun.steps, 0, steps)?;
        Finding::range("milestones.begun.searches", begun.searches, 0, begun.generation)?;
        if self.ended.is_some_and(|ended| self.chosen.is_none_or(|chosen| chosen >= ended)) {
            return Err(Finding::new("milestones.ended", "an end", "one after milestones.chosen"));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::{Begin, Bounds, Milestones, Point, StepBounds};

    /// Runs a search whose generations take 100 steps and score what `score` says; returns its milestones once it has ended, and the
    /// generations in which it began anew.
    fn run(generations: u64, steps: Option<(u64, u64)>, score: impl Fn(u64) -> f64) -> (Milestones, Vec<u64>) {
        let steps = steps.map(|(least, most)| StepBounds { least, most });
        let mut milestones = Milestones::default();
        let mut beginnings = Vec::new();
        for now in 1..10_000 {
            let point = Point { generations: now, steps: 100 * now, score: score(now) };
            milestones.reach(point, Bounds { generations, steps, is_last: true });
            beginnings.extend(milestones.begun.map(|begun| begun.generation));
            if milestones.ended.is_some() {
                beginnings.dedup();
                return (milestones, beginnings);
            }
        }
        panic!("a search without end: {milestones:?}");
    }

    /// Returns the generations of the choice and of the end of a search that never begins anew.
    fn end(generations: u64, steps: Option<(u64, u64)>, score: impl Fn(u64) -> f64) -> (u64, u64) {
        let (milestones, beginnings) = run(generations, steps, score);
        assert!(beginnings.is_empty(), "{beginnings:?}");
        (milestones.chosen.expect("a choice"), milestones.ended.expect("an end"))
    }

    #[test]
    fn a_search_goes_on_while_it_gets_better_and_its_steps_last() {
        let (rising, flat) = (|now| now as f64, |_| 0.0);
        assert_eq!(end(20, Some((2_000, 100_000)), rising), (10, 20), "its generations have taken enough");
        assert_eq!(end(20, Some((2_001, 100_000)), flat), (10, 21), "never before ten generations");
        assert_eq!(end(20, Some((4_000, 100_000)), rising), (10, 1_000), "the second share");
        assert_eq!(end(20, Some((400, 1_600)), rising), (8, 16), "the second share, before its generations");
        assert_eq!(end(20, Some((400, 800)), rising), (4, 8), "it also ends what has hardly begun");
        assert_eq!(
            end(20, Some((3_000, 100_000)), |now| now.min(30) as f64),
            (10, 45),
            "stalled for half of its steps"
        );
    }

    #[test]
    fn a_search_that_stalls_with_steps_left_begins_anew() {
        // The first stalls ten generations after generation 11, the first that counts; the second gets better to its end.
        let second = |now: u64| if now > 21 { now as f64 } else { 0.0 };
        let (milestones, beginnings) = run(20, Some((8_000, 10_000)), second);
        assert_eq!(beginnings, [21]);
        assert_eq!(milestones.begun, Some(Begin { generation: 21, steps: 2_100, searches: 1 }));
        assert_eq!((milestones.chosen, milestones.ended), (Some(31), Some(100)));
        // It began with 900 of its 3,000 steps left, and chooses after half of them.
        let (milestones, _) = run(20, Some((2_900, 3_000)), second);
        assert_eq!((milestones.chosen, milestones.ended), (Some(26), Some(30)));
        // Creeping does not count as getting better, steps of a fifth do.
        let creeping = |now: u64| if now == 1 { 0.0 } else { 100.0 + now as f64 };
        assert_eq!(run(20, Some((8_000, 10_000)), creeping).1.first(), Some(&21));
        let leaping = |now: u64| libm::pow(1.2, (now / 9) as f64 * 1.5);
        assert!(run(20, Some((8_000, 10_000)), leaping).1.is_empty());
        // However many steps there are, no search begins after 30 times the usual number of generations.
        let (milestones, beginnings) = run(20, Some((1 << 50, 1 << 60)), |_| 0.0);
        assert_eq!(beginnings, (1..=28).map(|time| 21 * time).collect::<Vec<_>>());
        assert_eq!((milestones.chosen, milestones.ended), (Some(598), Some(609)));
    }

    #[test]
    fn another_search_follows_one_that_is_not_the_last_and_has_had_its_steps() {
        let mut milestones = Milestones::default();
        let steps = Some(StepBounds { least: 3_000, most: 3_000 });
        let bounds = |is_last| Bounds { generations: 20, steps, is_last };
        let point = |now: u64| Point { generations: now, steps: 100 * now, score: now as f64 };
        (1..30).for_each(|now| milestones.reach(point(now), bounds(false)));
        assert_eq!((milestones.begun, milestones.chosen), (None, Some(10)));
        let mut last = milestones;
        last.reach(point(30), bounds(true));
        assert_eq!((last.begun, last.ended), (None, Some(30)));
        milestones.reach(point(30), bounds(false));
        let begun = Some(Begin { generation: 30, steps: 3_000, searches: 1 });
        assert_eq!(milestones, Milestones { begun, ..Milestones::default() });
    }

    #[test]
    fn without_a_limit_of_steps_generations_decide() {
        assert_eq!(end(20, None, |now| now as f64), (10, 20));
        assert_eq!(end(20, None, |_| 0.0), (10, 20));
    }
}
