//! The choice of a study: the setting to use, and its best pair.

use super::cells::Cell;
use super::setting::Setting;
use tpg_engine::Preference;

/// Returns the best pair of the setting to use.
///
/// That is, among the settings whose worth (the mean score over all pairs, or the success rate where the problem prefers it) lies
/// within one standard error of the highest, the one with the fewest actions of the network; ties go to the first.
pub(crate) fn choose<'c>(cells: &'c [Cell], settings: &[Setting], preference: Preference) -> Option<&'c Cell> {
    let by_success = |cell: &Cell| cell.result.success.filter(|_| preference == Preference::Success);
    let worth = |cell: &Cell| by_success(cell).unwrap_or(cell.result.score);
    let variance = |cell: &Cell| by_success(cell).map_or(cell.std_score * cell.std_score, |rate| rate * (1.0 - rate));
    let matching = |setting: &Setting| cells.iter().filter(|cell| cell.setting == *setting).collect::<Vec<&Cell>>();
    let groups: Vec<Vec<&Cell>> = settings.iter().map(matching).collect();
    let mean = |cells: &[&Cell], value: &dyn Fn(&Cell) -> f64| {
        cells.iter().map(|cell| value(cell)).sum::<f64>() / cells.len().max(1) as f64
    };
    let best = groups.iter().rev().max_by(|a, b| mean(a, &worth).total_cmp(&mean(b, &worth)))?;
    let error: f64 = best.iter().map(|cell| variance(cell) / cell.result.episodes.max(1) as f64).sum();
    let least = mean(best, &worth) - error.sqrt() / best.len().max(1) as f64;
    let network_actions = |cells: &[&Cell]| mean(cells, &|cell| cell.network_actions);
    let good = groups.iter().filter(|cells| mean(cells, &worth) >= least);
    let chosen = good.min_by(|a, b| network_actions(a).total_cmp(&network_actions(b)))?;
    chosen.iter().rev().copied().max_by(|a, b| worth(a).total_cmp(&worth(b)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::hybrid::span::Span;
    use tpg_engine::Summary;

    fn cell(sac: usize, patience: u32, score: f64, network_actions: f64) -> Cell {
        Cell {
            tpg: 0,
            sac,
            setting: Setting { patience: Span(patience), ..Setting::only_asks() },
            result: Summary { episodes: 100, score, success: Some(0.5), measure: 0.0, actions: 200.0 },
            std_score: 20.0,
            tpg_action_ratio: 1.0 - network_actions / 200.0,
            network_actions,
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
        let chosen = |settings: &[Setting], preference| choose(&cells, settings, preference).expect("a pair");
        assert_eq!(chosen(&settings, Preference::Score).setting, settings[1]);
        // All succeed as often: the cheapest is chosen.
        assert_eq!(chosen(&settings, Preference::Success).setting, settings[2]);
        let best = chosen(&settings[..1], Preference::Score);
        assert_eq!((best.sac, best.result.score), (0, -149.0));
    }
}
