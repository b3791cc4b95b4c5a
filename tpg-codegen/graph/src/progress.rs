//! The progress of a run: one line on stderr, if that is a terminal.

use crate::command::is_quiet;
use std::io::{IsTerminal as _, Write as _};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Time between two changes of the line.
const PAUSE: Duration = Duration::from_millis(200);

/// A line that shows how far a run is.
#[derive(Debug)]
pub struct Bar {
    is_shown: bool,
    began: Instant,
    /// The part of the run that was done before, and the time of the newest line.
    line: Mutex<(Option<f64>, Option<Instant>)>,
}

impl Bar {
    /// Begins a line; nothing is shown with `--quiet`, or where standard error is no terminal.
    pub fn begin() -> Self {
        let is_shown = !is_quiet() && std::io::stderr().is_terminal();
        Self { is_shown, began: Instant::now(), line: Mutex::new((None, None)) }
    }

    /// Shows that `done` of `all` are done; 0 for no known end.
    pub fn show(&self, done: u64, all: u64, message: impl FnOnce() -> String) {
        let mut line = self.line.lock().unwrap_or_else(PoisonError::into_inner);
        if !self.is_shown || line.1.is_some_and(|newest| newest.elapsed() < PAUSE) {
            return;
        }
        line.1 = Some(Instant::now());
        let mut text = format!("{done}");
        if all > 0 {
            let part = done as f64 / all as f64;
            let before = *line.0.get_or_insert(part);
            text += &format!(" of {all}");
            if part > before {
                let left = self.began.elapsed().as_secs_f64() / (part - before) * (1.0 - part);
                text += &format!(", {left:.0} s left");
            }
        }
        let mut stderr = std::io::stderr();
        // A terminal that is gone changes nothing.
        let _ = write!(stderr, "\r\x1b[K{text}  {}", message()).and_then(|()| stderr.flush());
    }
}

impl Drop for Bar {
    fn drop(&mut self) {
        if self.is_shown {
            eprint!("\r\x1b[K");
        }
    }
}
