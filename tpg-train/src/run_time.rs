//! The time of a run, `time.json`: the only one of its files that depends on the clock.

use serde::{Deserialize, Serialize};
use std::fs;
use std::path::Path;
use std::time::Instant;
use tpg_graph::error::InputError;
use tpg_graph::files::write_atomically;

/// Name of the file.
const NAME: &str = "time.json";

/// The time that a run has taken, over all of its sessions.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct RunTime {
    /// CPU time in seconds, if the system reports it.
    pub cpu_seconds: Option<f64>,
    /// Seconds on the clock.
    pub seconds: f64,
}

impl RunTime {
    /// Reads the time of the run in a folder; `None` if there is none.
    pub(crate) fn read(folder: &Path) -> Option<Self> {
        serde_json::from_slice(&fs::read(folder.join(NAME)).ok()?).ok()
    }
}

/// Measures a process of a run.
pub(crate) struct Stopwatch {
    began: Instant,
    cpu_before: Option<f64>,
    earlier: RunTime,
}

impl Stopwatch {
    /// Begins to measure this process of the run in a folder.
    pub(crate) fn new(folder: &Path) -> Self {
        let earlier = RunTime::read(folder).unwrap_or(RunTime { cpu_seconds: Some(0.0), seconds: 0.0 });
        Self { began: Instant::now(), cpu_before: cpu_seconds(), earlier }
    }

    /// Writes the time of the run so far.
    ///
    /// # Errors
    /// If it cannot be written.
    pub(crate) fn write(&self, folder: &Path) -> Result<(), InputError> {
        let session = cpu_seconds().zip(self.cpu_before).map(|(now, before)| now - before);
        let time = RunTime {
            cpu_seconds: self.earlier.cpu_seconds.zip(session).map(|(earlier, session)| earlier + session),
            seconds: self.earlier.seconds + self.began.elapsed().as_secs_f64(),
        };
        let text = serde_json::to_string(&time).expect("plain data") + "\n";
        write_atomically(&folder.join(NAME), text.as_bytes())
    }
}

/// Returns the CPU time so far, in seconds, of this process and its finished children, if the system reports it
/// (Linux).
fn cpu_seconds() -> Option<f64> {
    let stat = fs::read_to_string("/proc/self/stat").ok()?;
    // Fields 14 to 17, in ticks of 1/100 s; the second field, in brackets, may contain spaces.
    let fields = stat.rsplit_once(')')?.1.split_whitespace().skip(11).take(4);
    let ticks: Option<Vec<u64>> = fields.map(|field| field.parse().ok()).collect();
    Some(ticks?.iter().sum::<u64>() as f64 / 100.0)
}

#[cfg(test)]
mod tests {
    use super::{RunTime, Stopwatch};

    #[test]
    fn sessions_are_added() {
        let folder = tempfile::tempdir().expect("a folder");
        let earlier = RunTime { cpu_seconds: Some(2.0), seconds: 3.0 };
        std::fs::write(folder.path().join("time.json"), serde_json::to_string(&earlier).expect("plain data"))
            .expect("a file");
        Stopwatch::new(folder.path()).write(folder.path()).expect("it is written");
        let time = RunTime::read(folder.path()).expect("it was written");
        assert!(time.seconds > 3.0 && time.cpu_seconds.is_none_or(|seconds| seconds >= 2.0), "{time:?}");
    }
}
