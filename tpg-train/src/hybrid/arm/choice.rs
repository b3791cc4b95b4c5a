//! Evaluation of the cells: means over pairs, the Pareto front, the setting to use.

use super::cost::Costs;
use super::setting::{Detector, Setting};
use super::study::Cell;
use crate::hybrid::span::Span;
use crate::hybrid::spread::Spread;
use serde::Serialize;

/// One row of `settings.csv`: a setting, averaged over all pairs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Summary {
    /// The guard's name.
    pub guard: String,
    /// Method of detecting cycles.
    pub cycle_detector: Detector,
    /// The paper's `nbItGoBackTPG`.
    pub hand_back_after: Span,
    /// The paper's `sepDistance`, mm.
    pub separation_mm: f64,
    /// Mean success rate over pairs.
    pub success: f64,
    /// Its standard deviation over pairs.
    pub success_sd: f64,
    /// Mean collision rate over pairs.
    pub collision: f64,
    /// Its standard deviation over pairs.
    pub collision_sd: f64,
    /// Mean final distance over pairs.
    pub distance_mm: f64,
    /// Its standard deviation over pairs.
    pub distance_sd: f64,
    /// Mean number of actions over pairs.
    pub actions: f64,
    /// Mean over pairs of the fraction of actions that the graph chose.
    pub tpg_action_ratio: f64,
    /// Mean over pairs of the time of one action on this machine, by the costs in `timing.csv`.
    pub ns_per_action: f64,
    /// True if no other setting is at least as good in distance, success and time, and better in one of them.
    pub on_front: bool,
    /// True if this is the setting to use.
    pub chosen: bool,
}

impl Summary {
    /// Returns the setting.
    pub fn setting(&self, cells: &[Cell]) -> Option<Setting> {
        cells.iter().find(|cell| self.is_of(cell)).map(Cell::setting)
    }

    /// True if the summary includes the cell.
    pub fn is_of(&self, cell: &Cell) -> bool {
        cell.guard == self.guard
            && cell.cycle_detector == self.cycle_detector
            && cell.hand_back_after == self.hand_back_after
            && cell.separation_mm == self.separation_mm
    }

    fn dominates(&self, other: &Self) -> bool {
        let no_worse = self.distance_mm <= other.distance_mm
            && self.success >= other.success
            && self.ns_per_action <= other.ns_per_action;
        let better = self.distance_mm < other.distance_mm
            || self.success > other.success
            || self.ns_per_action < other.ns_per_action;
        no_worse && better
    }
}

/// Summarises every setting over all pairs and marks front and choice.
///
/// Among all settings whose mean success lies within one standard error of the highest, the choice is the one with the
/// least time per action; ties go to the first.
pub fn summarise(cells: &[Cell], settings: &[Setting], costs: &Costs) -> Vec<Summary> {
    let mut summaries: Vec<Summary> = settings.iter().map(|setting| summary(cells, setting, costs)).collect();
    let front: Vec<bool> =
        summaries.iter().map(|summary| !summaries.iter().any(|other| other.dominates(summary))).collect();
    summaries.iter_mut().zip(front).for_each(|(summary, on_front)| summary.on_front = on_front);
    if let Some(chosen) = choose(cells, &summaries) {
        summaries[chosen].chosen = true;
    }
    summaries
}

fn summary(cells: &[Cell], setting: &Setting, costs: &Costs) -> Summary {
    let of_setting: Vec<&Cell> = cells.iter().filter(|cell| cell.setting() == *setting).collect();
    let spread =
        |value: &dyn Fn(&Cell) -> f64| Spread::of(&of_setting.iter().map(|cell| value(cell)).collect::<Vec<_>>());
    let (success, collision) = (spread(&|cell| cell.success), spread(&|cell| cell.collision));
    let distance = spread(&|cell| cell.distance_mm);
    Summary {
        guard: setting.guard.name().to_owned(),
        cycle_detector: setting.detector,
        hand_back_after: setting.hand_back_after,
        separation_mm: setting.separation_mm,
        success: success.mean,
        success_sd: success.sd,
        collision: collision.mean,
        collision_sd: collision.sd,
        distance_mm: distance.mean,
        distance_sd: distance.sd,
        actions: spread(&|cell| cell.actions).mean,
        tpg_action_ratio: spread(&|cell| cell.tpg_action_ratio).mean,
        ns_per_action: spread(&|cell| costs.ns_per_action(cell)).mean,
        on_front: false,
        chosen: false,
    }
}

fn choose(cells: &[Cell], summaries: &[Summary]) -> Option<usize> {
    let best = summaries.iter().map(|summary| summary.success).max_by(f64::total_cmp)?;
    let episodes: usize = cells.iter().filter(|cell| summaries[0].is_of(cell)).map(|cell| cell.episodes).sum();
    let standard_error = (best * (1.0 - best) / episodes.max(1) as f64).sqrt();
    let good = summaries.iter().enumerate().filter(|(_, summary)| summary.success >= best - standard_error);
    good.min_by(|(_, a), (_, b)| a.ns_per_action.total_cmp(&b.ns_per_action)).map(|(place, _)| place)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tpg_arm::hybrid::Guard;

    fn cell(sac: usize, separation_mm: f64, success: f64, distance_mm: f64, tpg_action_ratio: f64) -> Cell {
        Cell {
            tpg: 0,
            sac,
            guard: "none".to_owned(),
            cycle_detector: Detector::Visited,
            hand_back_after: Span(10),
            separation_mm,
            episodes: 100,
            success,
            collision: 0.0,
            distance_mm,
            actions: 100.0,
            tpg_action_ratio,
            tpg_ratio_of_episodes: tpg_action_ratio,
            hand_overs_guard: 0.0,
            hand_overs_drift: 1.0,
            hand_overs_stop: 0.0,
            hand_overs_cycle: 0.0,
            hand_backs: 1.0,
        }
    }

    #[test]
    fn the_cheapest_of_the_good_is_chosen_and_what_is_dominated_is_not_on_the_front() {
        let costs = Costs { tpg: vec![100.0], sac: vec![1000.0, 1000.0], guards: [0.0, 5.0, 50.0, 50.0] };
        let cells = [
            cell(0, 1.0, 0.96, 3.0, 0.1), // best, but slow
            cell(1, 1.0, 0.94, 5.0, 0.1),
            cell(0, 3.0, 0.94, 4.0, 0.9), // within the standard error of 1.5 points, and fast
            cell(1, 3.0, 0.94, 4.0, 0.9),
            cell(0, 10.0, 0.80, 9.0, 0.5), // dominated
            cell(1, 10.0, 0.80, 9.0, 0.5),
        ];
        let setting = |separation_mm| Setting {
            hand_back_after: Span(10),
            separation_mm,
            guard: Guard::None,
            detector: Detector::Visited,
        };
        let summaries = summarise(&cells, &[setting(1.0), setting(3.0), setting(10.0)], &costs);
        assert_eq!(summaries.iter().map(|s| s.on_front).collect::<Vec<_>>(), [true, true, false]);
        assert_eq!(summaries.iter().map(|s| s.chosen).collect::<Vec<_>>(), [false, true, false]);
        assert!((summaries[0].success - 0.95).abs() < 1e-12 && (summaries[0].success_sd - 0.01).abs() < 1e-12);
        assert!((summaries[1].ns_per_action - 190.0).abs() < 1e-9, "{}", summaries[1].ns_per_action);
    }
}
