//! SIGKILL at random moments, every second time while a file is being written.

use super::subject::{Subject, has_unfinished};
use super::table::Row;
use super::{CheckedRun, fresh};
use rand::RngExt as _;
use rand_chacha::ChaCha8Rng;
use std::path::Path;
use std::process::Child;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Kills of a run before it may end and the next one begins.
const KILLS_OF_A_RUN: u32 = 8;

/// Kills a subject's runs; each run is then finished and compared.
pub(super) fn kills(subject: &Subject, count: u32, random: &mut ChaCha8Rng) -> CheckedRun {
    let mut row = Row::new(subject.name, "killed");
    let mut writing = 0;
    let (mut done, mut run) = (0, 0);
    while done < count {
        let folder = fresh(subject, &format!("killed-{run}"));
        let most = KILLS_OF_A_RUN.min(count - done);
        let mut killed = 0;
        while killed < most {
            let mut child = subject.start(&folder);
            // A run has as many sessions as kills: each covers a part of it.
            sleep(subject.time.mul_f64(random.random_range(0.0..0.4)));
            if killed % 2 == 1 {
                wait_for_writing(&mut child, &folder, subject.time);
            }
            let _ = child.kill();
            let status = child.wait().ok();
            if status.is_some_and(|status| status.code().is_some()) {
                // It ended before the signal, well or by an error of its own.
                row.note(status.is_some_and(|status| status.success()), || format!("{}: failed", folder.display()));
                break;
            }
            writing += u32::from(has_unfinished(&folder));
            killed += 1;
        }
        done += killed;
        row.note(run < 10 * count + 10, || "runs end before they are killed".to_owned());
        if run >= 10 * count + 10 {
            break;
        }
        row.finish(subject, &folder);
        run += 1;
    }
    row.remark = format!("{done} kills, {writing} of them while a file was written");
    Ok(row)
}

/// Waits until a file is being written, the process ends, or time is over.
fn wait_for_writing(child: &mut Child, folder: &Path, most: Duration) {
    let start = Instant::now();
    while start.elapsed() < most && !has_unfinished(folder) && matches!(child.try_wait(), Ok(None)) {}
}
