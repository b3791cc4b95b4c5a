//! Progress bar of a run; indicatif draws nothing if stderr is not a terminal.

use crate::evolution::run::Progress;
use indicatif::{ProgressBar, ProgressStyle};
use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, Ordering};
use tpg_graph::command::is_quiet;

/// Creates a bar; one that is never shown if the program shall be quiet.
pub(crate) fn bar(length: u64) -> ProgressBar {
    if is_quiet() { ProgressBar::hidden() } else { ProgressBar::new(length) }
}

/// The progress of one run.
#[derive(Debug)]
pub(crate) struct Bar {
    bar: ProgressBar,
    began: bool,
}

impl Bar {
    /// Creates a bar that has not started.
    pub(crate) fn new() -> Self {
        let style = ProgressStyle::with_template("seed {prefix} {wide_bar} {pos}/{len} {msg}, {eta} left")
            .unwrap_or_else(|_| ProgressStyle::default_bar());
        Self { bar: bar(0).with_style(style), began: false }
    }

    /// Shows the progress of a run; returns `Break` when `stop` is set.
    pub(crate) fn show(&mut self, progress: &Progress<'_>, stop: &AtomicBool) -> ControlFlow<()> {
        self.bar.set_length(progress.of);
        self.bar.set_prefix(progress.seed.to_string());
        self.bar.set_position(progress.generations);
        if !std::mem::replace(&mut self.began, true) {
            self.bar.reset_eta();
        }
        if let Some(row) = progress.row {
            let best = progress.best.map(|best| format!(", {:.2} validated", best.result.score)).unwrap_or_default();
            self.bar.set_message(format!("best {:.2}, median {:.2}{best}", row.best_score, row.median_score));
        }
        if stop.load(Ordering::Relaxed) {
            self.bar.abandon();
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    }
}

impl Default for Bar {
    fn default() -> Self {
        Self::new()
    }
}
