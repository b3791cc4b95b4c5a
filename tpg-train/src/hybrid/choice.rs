//! Evaluation of the cells: means over pairs, the setting to use.

use super::cells::Cell;
use super::setting::Setting;
use serde::Serialize;
use tpg_engine::{Preference, Sample};

/// One row of `settings.csv`: a setting, averaged over all pairs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(crate) struct SettingSummary {
    /// The setting, written before the other columns.
    #[serde(skip)]
    pub setting: Setting,
    /// Mean score over pairs.
    pub score: f64,
    /// Its standard deviation over pairs.
    pub score_sd: f64,
    /// Mean success rate over pairs; empty if the problem does not define success.
    pub success: Option<f64>,
    /// Mean of the problem's measure over pairs; 0 if it has none.
    pub measure: f64,
    /// Mean number of actions over pairs.
    pub steps: f64,
    /// Mean over pairs of the fraction of actions that the graph chose.
    pub tpg_action_ratio: f64,
    /// Mean over pairs of the network's actions per episode.
    pub network_actions: f64,
    /// True if this is the setting to use.
    pub chosen: bool,
}

impl SettingSummary {
    fn new(setting: &Setting, cells: &[&Cell]) -> Self {
        let spread =
            |value: &dyn Fn(&Cell) -> f64| Sample::new(&cells.iter().map(|cell| value(cell)).collect::<Vec<_>>());
        let score = spread(&|cell| cell.mean_score);
        let success = cells.iter().all(|cell| cell.success.is_some());
        Self {
            setting: setting.clone(),
            score: score.mean,
            score_sd: score.deviation(),
            success: success.then(|| spread(&|cell| cell.success.unwrap_or(0.0)).mean),
            measure: spread(&|cell| cell.mean_measure).mean,
            steps: spread(&|cell| cell.mean_steps).mean,
            tpg_action_ratio: spread(&|cell| cell.tpg_action_ratio).mean,
            network_actions: spread(&|cell| cell.network_actions).mean,
            chosen: false,
        }
    }

    /// Returns the quantity that is preferred: the score, or the success rate.
    fn worth(&self, preference: Preference) -> f64 {
        worth(preference, self.score, self.success)
    }
}

fn worth(preference: Preference, score: f64, success: Option<f64>) -> f64 {
    match (preference, success) {
        (Preference::Success, Some(success)) => success,
        _ => score,
    }
}

/// Summarises every setting over all pairs and marks the choice.
///
/// The choice is, among the settings whose worth (the mean score, or the success rate where the problem prefers it) lies
/// within one standard error of the highest, the one with the fewest actions of the network; ties go to the first.
pub(crate) fn summarise(cells: &[Cell], settings: &[Setting], preference: Preference) -> Vec<SettingSummary> {
    let matching = |setting: &Setting| cells.iter().filter(|cell| cell.setting == *setting).collect::<Vec<_>>();
    let mut summaries: Vec<SettingSummary> =
        settings.iter().map(|setting| SettingSummary::new(setting, &matching(setting))).collect();
    let costs: Vec<(f64, f64)> =
        summaries.iter().map(|summary| (summary.worth(preference), summary.network_actions)).collect();
    let best = (0..costs.len()).rev().max_by(|&a, &b| costs[a].0.total_cmp(&costs[b].0));
    let Some(best) = best else { return summaries };
    let least = costs[best].0 - standard_error(&matching(&settings[best]), preference);
    let good = (0..costs.len()).filter(|&place| costs[place].0 >= least);
    if let Some(chosen) = good.min_by(|&a, &b| costs[a].1.total_cmp(&costs[b].1)) {
        summaries[chosen].chosen = true;
    }
    summaries
}

/// Returns the standard error of the mean worth of a setting's cells.
fn standard_error(cells: &[&Cell], preference: Preference) -> f64 {
    let variance = |cell: &Cell| match (preference, cell.success) {
        (Preference::Success, Some(rate)) => rate * (1.0 - rate),
        _ => cell.std_score * cell.std_score,
    };
    let sum: f64 = cells.iter().map(|cell| variance(cell) / cell.episodes.max(1) as f64).sum();
    sum.sqrt() / cells.len().max(1) as f64
}

/// Returns the pair with the highest worth under a setting; ties go to the first.
pub(crate) fn best_pair<'a>(cells: &'a [Cell], setting: &Setting, preference: Preference) -> Option<&'a Cell> {
    let cell_worth = |cell: &Cell| worth(preference, cell.mean_score, cell.success);
    cells.iter().rev().filter(|cell| cell.setting == *setting).max_by(|a, b| cell_worth(a).total_cmp(&cell_worth(b)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hybrid::span::Span;

    fn cell(sac: usize, patience: u32, score: f64, network_actions: f64) -> Cell {
        Cell {
            tpg: 0,
            sac,
            setting: Setting { patience: Span(patience), ..Setting::only_asks() },
            episodes: 100,
            mean_score: score,
            std_score: 20.0,
            success: Some(0.5),
            mean_measure: 0.0,
            mean_steps: 200.0,
            tpg_action_ratio: 1.0 - network_actions / 200.0,
            network_actions,
            hand_overs_guard: 0.0,
            hand_overs_drift: 0.0,
            hand_overs_stall: 1.0,
            hand_overs_cycle: 0.0,
            hand_backs: 1.0,
        }
    }

    #[test]
    fn the_fewest_actions_of_the_network_among_the_good_are_chosen() {
        let cells = [
            cell(0, 1, -149.0, 90.0), // best on average
            cell(1, 1, -151.0, 90.0),
            cell(0, 2, -151.0, 40.0), // within the standard error of 1.41
            cell(1, 2, -151.0, 40.0),
            cell(0, 3, -160.0, 20.0), // cheapest, but too bad
            cell(1, 3, -160.0, 20.0),
            cell(0, 4, -160.0, 60.0), // dominated
            cell(1, 4, -160.0, 60.0),
        ];
        let settings: Vec<Setting> = cells.iter().step_by(2).map(|cell| cell.setting.clone()).collect();
        let chosen = |preference| {
            let summaries = summarise(&cells, &settings, preference);
            summaries.iter().position(|summary| summary.chosen)
        };
        assert_eq!(chosen(Preference::Score), Some(1));
        // All succeed as often: the cheapest is chosen.
        assert_eq!(chosen(Preference::Success), Some(2));
        let best = best_pair(&cells, &settings[0], Preference::Score).expect("a pair");
        assert_eq!((best.sac, best.mean_score), (0, -149.0));
    }
}
