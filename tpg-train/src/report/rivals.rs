//! Other controllers on the same episodes as a trained policy.

use super::runs::Run;
use crate::effort::Effort;
use tpg_engine::Sample;
use tpg_picture::{Formulas, Section, Table};

/// Returns the table of a run whose policy was compared with other controllers.
pub(super) fn section(run: &Run) -> Option<Section> {
    let tested = run.tested.as_ref().filter(|tested| !tested.rivals.is_empty())?;
    let ours: Vec<f64> = tested.episodes.iter().map(|ending| ending.score).collect();
    let row = |name: &str, scores: &[f64], effort: Option<Effort>, difference: String| {
        let text = |value: &dyn Fn(Effort) -> String| effort.map_or_else(String::new, value);
        let saturated = text(&|effort| format!("{:.1}", 100.0 * effort.saturated));
        vec![name.to_owned(), mean(scores), saturated, text(&|effort| format!("{:.4}", effort.chatter)), difference]
    };
    let rivals = tested.rivals.iter().map(|rival| {
        let differences: Vec<f64> = ours.iter().zip(&rival.scores).map(|(ours, theirs)| ours - theirs).collect();
        row(&rival.name, &rival.scores, rival.effort, mean(&differences))
    });
    let header = ["controller", "return", "saturated steps %", "chatter", "lead of the policy"];
    let laws: Vec<_> =
        tested.rivals.iter().filter_map(|rival| Some((rival.name.clone(), rival.law.clone()?))).collect();
    Some(Section {
        title: format!("{} beside other controllers", run.name),
        text: format!(
            "The same {} test episodes; ± is the 95 % interval. Chatter is the mean change of an output from step to step, as \
             a share of its range.",
            ours.len()
        ),
        formulas: if laws.is_empty() {
            Vec::new()
        } else {
            vec![Formulas { heading: "Their laws".to_owned(), rows: laws }]
        },
        tables: vec![Table {
            header: header.map(str::to_owned).to_vec(),
            rows: [row("this policy", &ours, tested.effort, String::new())].into_iter().chain(rivals).collect(),
        }],
        ..Section::default()
    })
}

/// Formats a mean with half of its interval.
fn mean(values: &[f64]) -> String {
    let sample = Sample::new(values);
    format!("{:.2} ± {:.2}", sample.mean, sample.interval()[1] - sample.mean)
}
