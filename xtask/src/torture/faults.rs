//! Two processes in one folder, checkpoints that are damaged.

use super::subject::Subject;
use super::table::Row;
use super::{CheckedRun, fresh};
use rand::RngExt as _;
use rand_chacha::ChaCha8Rng;
use std::fs;
use std::path::Path;
use std::process::{Child, Command};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// Rounds of each.
const ROUNDS: u32 = 5;
/// Damaged checkpoints.
const DAMAGED: u32 = 20;

/// Starts a second process while the first one is stopped: it is refused with the first one's number.
pub(super) fn two_processes(subject: &Subject, _random: &mut ChaCha8Rng) -> CheckedRun {
    let mut row = Row::new(subject.name, "two processes");
    for round in 0..ROUNDS {
        let folder = fresh(subject, &format!("twice-{round}"));
        let mut first = subject.start(&folder);
        let owner = format!("process {},", first.id());
        let locked = || fs::read_to_string(folder.join("run.lock")).is_ok_and(|line| line.contains(&owner));
        row.note(wait(subject.time * 10, locked), || "the folder was not locked".to_owned());
        signal(&first, "STOP");
        let second = subject.finish(&folder);
        signal(&first, "CONT");
        let error = String::from_utf8_lossy(&second.stderr).into_owned();
        row.note(second.status.code() == Some(2) && error.contains(&owner), || format!("not refused: {error}"));
        row.note(first.wait().is_ok_and(|status| status.success()), || "the first one failed".to_owned());
        row.finish(subject, &folder);
    }
    Ok(row)
}

/// Damages the newest checkpoint of a run that was killed: the run goes on from the previous one. With both damaged it is
/// refused.
pub(super) fn damaged(subject: &Subject, random: &mut ChaCha8Rng) -> CheckedRun {
    let mut row = Row::new(subject.name, "damaged checkpoint");
    for round in 0..DAMAGED {
        let folder = fresh(subject, &format!("damaged-{round}"));
        let [newest, previous] = ["checkpoint", "checkpoint.previous"].map(|name| folder.join(name));
        let mut child = subject.start(&folder);
        let begun = wait(subject.time * 2, || previous.exists() && newest.exists());
        sleep(subject.time.mul_f64(random.random_range(0.0..0.5)));
        let _ = child.kill();
        let _ = child.wait();
        row.note(begun && newest.exists(), || "there was no checkpoint".to_owned());
        if !newest.exists() || !previous.exists() {
            // Killed in the moment in which the previous one is replaced: the newest must stay whole.
            row.finish(subject, &folder);
            continue;
        }
        damage(&newest, random);
        if round % 4 == 3 {
            let whole = fs::read(&previous).unwrap_or_default();
            damage(&previous, random);
            let refused = subject.finish(&folder).status.code() == Some(2);
            row.note(refused, || "two damaged checkpoints were not refused".to_owned());
            row.note(fs::write(&previous, whole).is_ok(), || "it cannot be repaired".to_owned());
        }
        row.finish(subject, &folder);
    }
    Ok(row)
}

fn damage(path: &Path, random: &mut ChaCha8Rng) {
    let mut bytes = fs::read(path).unwrap_or_default();
    let at = random.random_range(0..bytes.len().max(1));
    match (random.random_range(0..3), bytes.get_mut(at)) {
        (0, Some(byte)) => *byte ^= 1 << random.random_range(0..8),
        (1, Some(_)) => bytes.truncate(at),
        (2, Some(_)) => {
            let end = (at + 4096).min(bytes.len());
            bytes[at..end].fill(0xff);
        }
        _ => bytes.push(0),
    }
    // A new file: the old one may have a second name, as the previous checkpoint.
    let written = fs::remove_file(path).and_then(|()| fs::write(path, bytes));
    written.expect("a checkpoint of a run that was killed can be written");
}

/// Sends a signal.
fn signal(child: &Child, name: &str) -> bool {
    Command::new("kill").args(["-s", name, &child.id().to_string()]).output().is_ok()
}

/// Waits until something is true; false if it takes longer than `most`, or a second if that is more.
fn wait(most: Duration, condition: impl Fn() -> bool) -> bool {
    let start = Instant::now();
    while !condition() {
        if start.elapsed() > most.max(Duration::from_secs(1)) {
            return false;
        }
        sleep(Duration::from_millis(1));
    }
    true
}
