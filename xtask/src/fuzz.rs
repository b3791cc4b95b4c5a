//! Runs the fuzz targets under libFuzzer; needs a nightly compiler and cargo-fuzz, and skips loudly without them.

use crate::check::Run;
use std::path::Path;
use std::process::Command;
use std::{fs, io};
use tpg_testing::{answers, library};

/// Longest input, bytes: more would only be more of the same.
const LONGEST: u32 = 20_000;

#[derive(Clone, Debug, clap::Args)]
pub(crate) struct FuzzArgs {
    /// Time for each target, seconds
    #[arg(long, default_value_t = 60)]
    seconds: u32,
    /// Only these targets
    targets: Vec<String>,
    /// Instrument with AddressSanitizer, too: slower, and it sees what unsafe code does
    #[arg(long)]
    address: bool,
}

impl FuzzArgs {
    /// Runs the targets one after another.
    pub(crate) fn run(&self, run: &mut Run) {
        if !answers("cargo", &["+nightly", "fuzz", "--version"]) {
            return run.missing("fuzzing", "rustup toolchain install nightly; cargo install cargo-fuzz");
        }
        let folder = library::top().join("fuzz");
        let all = names(&folder.join("fuzz_targets"));
        if let Some(unknown) = self.targets.iter().find(|name| !all.contains(name)) {
            return run.failed(unknown, &io::Error::other(format!("no such target; there are {}", all.join(" "))));
        }
        for name in if self.targets.is_empty() { &all } else { &self.targets } {
            match self.command(&folder, name) {
                Ok(command) => run.check(name, command),
                Err(error) => run.failed(name, &error),
            }
        }
    }

    /// Returns the command that runs a target.
    fn command(&self, folder: &Path, name: &str) -> io::Result<Command> {
        let found = folder.join("found").join(name);
        fs::create_dir_all(&found)?;
        let mut cargo = Command::new("cargo");
        cargo.args(["+nightly", "fuzz", "run", "--fuzz-dir"]).arg(folder);
        // The flags of a release build: what cargo-fuzz adds for debugging would halve the runs.
        cargo.args(["--sanitizer", if self.address { "address" } else { "none" }, "--release", name]);
        // New inputs go to the first folder; the seeds stay as they are committed.
        cargo.arg(&found).arg(folder.join("corpus").join(name)).arg("--");
        cargo.arg(format!("-dict={}", folder.join("tpg.dict").display()));
        cargo.arg(format!("-max_total_time={}", self.seconds)).arg(format!("-max_len={LONGEST}"));
        cargo.args(["-print_final_stats=1", "-timeout=60", "-rss_limit_mb=2048", "-verbosity=0"]);
        cargo.current_dir(library::top()).env_remove("RUSTUP_TOOLCHAIN").env_remove("RUSTC");
        Ok(cargo)
    }
}

/// Returns the names of the targets, sorted.
fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<String> =
        entries.filter_map(|entry| entry.path().file_stem().map(|stem| stem.to_string_lossy().into_owned())).collect();
    names.sort_unstable();
    names
}
