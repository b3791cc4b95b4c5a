//! Runs the fuzz targets under libFuzzer; needs a nightly compiler and cargo-fuzz, and skips loudly without them.

use crate::check::answers;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};
use tpg_testing::library;

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
    /// Runs the targets one after another and prints a table; returns true if nothing was found.
    pub(crate) fn run(&self) -> bool {
        if !answers("cargo", &["+nightly", "fuzz", "--version"]) {
            tpg_testing::skip("fuzzing: not installed (rustup toolchain install nightly; cargo install cargo-fuzz)");
            return !tpg_testing::required();
        }
        let folder = library::top().join("fuzz");
        let all = names(&folder.join("fuzz_targets"));
        if let Some(unknown) = self.targets.iter().find(|name| !all.contains(name)) {
            eprintln!("{unknown}: no such target; there are {}", all.join(" "));
            return false;
        }
        let wanted = all.iter().filter(|name| self.targets.is_empty() || self.targets.contains(name));
        let mut table = String::from("| target | runs | seconds | found |\n| --- | --- | --- | --- |\n");
        let mut good = true;
        for name in wanted {
            let (passed, text) = self.target(&folder, name);
            let stat = |name: &str| {
                let line = text.lines().find_map(|line| line.strip_prefix("stat::").unwrap_or("").strip_prefix(name));
                line.map_or("?", |line| line.trim_start_matches(':').trim()).to_owned()
            };
            let (runs, found) = (stat("number_of_executed_units"), if passed { "nothing" } else { "see above" });
            table += &format!("| {name} | {runs} | {} | {found} |\n", self.seconds);
            if !passed {
                eprintln!("{text}");
            }
            good &= passed;
        }
        print!("\n{table}");
        good
    }

    /// Runs a target; returns true if nothing was found, and the text of the run.
    fn target(&self, folder: &Path, name: &str) -> (bool, String) {
        println!("==== {name}");
        let found = folder.join("found").join(name);
        if let Err(error) = fs::create_dir_all(&found) {
            return (false, format!("{}: {error}", found.display()));
        }
        let mut cargo = Command::new("cargo");
        cargo.args(["+nightly", "fuzz", "run", "--fuzz-dir"]).arg(folder);
        // The flags of a release build: what cargo-fuzz adds for debugging would halve the runs.
        cargo.args(["--sanitizer", if self.address { "address" } else { "none" }, "--release", name]);
        // New inputs go to the first folder; the seeds stay as they are committed.
        cargo.arg(&found).arg(folder.join("corpus").join(name)).arg("--");
        cargo.arg(format!("-dict={}", folder.join("tpg.dict").display()));
        cargo.arg(format!("-max_total_time={}", self.seconds)).arg(format!("-max_len={LONGEST}"));
        cargo.args(["-print_final_stats=1", "-timeout=60", "-rss_limit_mb=2048", "-verbosity=0"]);
        cargo.current_dir(library::top()).env_remove("RUSTUP_TOOLCHAIN").env_remove("RUSTC").stdin(Stdio::null());
        match cargo.output() {
            Ok(output) => (output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned()),
            Err(error) => (false, error.to_string()),
        }
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
