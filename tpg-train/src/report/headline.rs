//! The head of the page: result with its interval, size and training time of the best run of each group.

use super::runs::{Group, Run};
use super::test::Tested;
use crate::hybrid::rollout::Policies;
use std::io;
use tpg_codegen::emit::Code;
use tpg_codegen::emit::Language;
use tpg_codegen::{Options, compile, size};
use tpg_engine::{Sample, confidence, finite};
use tpg_graph::Graph;
use tpg_picture::Headline;

/// Returns the headline of a group's best run.
pub(super) fn headline(group: &Group, run: &Run) -> Headline {
    let mut notes = Vec::new();
    let value = match &run.result {
        Some(tested) => {
            notes.push(format!("on {} test episodes, with its 95 % interval", tested.endings.len()));
            result(tested)
        }
        None => {
            notes.push(
                "on the episodes that chose it; not tested: evaluate() does that where the environment is".to_owned(),
            );
            run.validated().map_or_else(|| "–".to_owned(), |score| format!("return {score:.2}"))
        }
    };
    notes.push(match &run.policies {
        Policies::Graph(graph) => flash_in_words(&graph.1),
        Policies::Both(hybrid) => format!("its graph: {}", flash_in_words(&hybrid.graph.1)),
        Policies::Network((_, network)) => format!("hidden layers {:?}", &network.widths()[1..]),
    });
    notes.extend(run.cpu.map(|cpu| {
        format!("trained in {} CPU seconds", if cpu < 0.1 { "under 0.1".to_owned() } else { format!("{cpu:.1}") })
    }));
    let whose = if group.runs.len() > 1 {
        format!("{}, the best of {} seeds", group.name, group.runs.len())
    } else {
        run.name.clone()
    };
    Headline { name: whose, value, note: notes.join("; ") }
}

/// The success rate with Wilson's interval where there is one, else the mean return with its interval.
fn result(tested: &Tested) -> String {
    let summary = tested.summary();
    match summary.success {
        Some(rate) => {
            let [low, high] = confidence(rate, summary.episodes).map(|end| 100.0 * end);
            format!("{:.1} % ({low:.1} to {high:.1})", 100.0 * rate)
        }
        None => {
            let scores = Sample::new(&tested.endings.iter().map(|ending| finite(ending.score)).collect::<Vec<_>>());
            let [_, high] = scores.interval();
            format!("return {:.2} ± {:.2}", scores.mean, high - scores.mean)
        }
    }
}

/// Returns the flash of a graph's fast C on a Cortex-M4F, bytes.
pub(super) fn flash(graph: &Graph) -> io::Result<u64> {
    size::flash_of_c(&Code::of(compile(graph, &options(), Language::C)))
}

fn flash_in_words(graph: &Graph) -> String {
    match flash(graph) {
        Ok(bytes) => format!("{bytes} bytes of C on a Cortex-M4F"),
        Err(error) => format!("bytes of C on a Cortex-M4F: not known: {error}"),
    }
}

/// The options of code that is measured and explained, and not written.
pub(super) fn options() -> Options {
    Options::new("policy".parse().expect("a prefix"))
}
