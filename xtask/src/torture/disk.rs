//! A full disk: a small file system in memory, which only root can make.

use super::subject::Subject;
use super::table::Row;
use super::{CheckedRun, fresh};
use rand_chacha::ChaCha8Rng;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Runs on a disk with half of the space that the run needs, then with enough.
pub(super) fn full(subject: &Subject, _random: &mut ChaCha8Rng) -> CheckedRun {
    let mut row = Row::new(subject.name, "full disk");
    let disk = Disk::mount(&fresh(subject, "full"), subject.size / 2)?;
    let folder = disk.0.join("run");
    for _ in 0..3 {
        let output = subject.finish(&folder);
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        let is_full = error.contains("space");
        row.note(output.status.code() == Some(2) && is_full, || format!("not a full disk: {error}"));
    }
    run(Command::new("mount").args(["-o", "remount,size=1g"]).arg(&disk.0))?;
    row.finish(subject, &folder);
    Ok(row)
}

/// A mounted file system; unmounted when dropped.
struct Disk(PathBuf);

impl Disk {
    fn mount(path: &Path, size: u64) -> Result<Self, String> {
        fs::create_dir_all(path).map_err(|error| error.to_string())?;
        run(Command::new("mount").args(["-t", "tmpfs", "-o", &format!("size={size}"), "tmpfs"]).arg(path))?;
        Ok(Self(path.to_owned()))
    }
}

impl Drop for Disk {
    fn drop(&mut self) {
        let _ = run(Command::new("umount").arg(&self.0));
    }
}

fn run(command: &mut Command) -> Result<(), String> {
    let output = command.output().map_err(|error| format!("no mount: {error}"))?;
    let why = String::from_utf8_lossy(&output.stderr).trim().to_owned();
    if output.status.success() {
        Ok(())
    } else {
        Err(format!("a file system cannot be mounted (only root can): {why}"))
    }
}
