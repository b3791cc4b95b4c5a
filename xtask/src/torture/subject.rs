//! The runs that are tortured: each takes a second or so and writes all the time.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// A run, and what it leaves when nothing disturbs it.
pub(super) struct Subject {
    pub(super) name: &'static str,
    /// True if it saves often enough to have a checkpoint and the previous one.
    pub(super) saves_often: bool,
    /// Parent of all folders.
    pub(super) place: PathBuf,
    /// Time of the undisturbed run.
    pub(super) time: Duration,
    /// Bytes in the folder of the undisturbed run.
    pub(super) size: u64,
    program: PathBuf,
    arguments: Vec<OsString>,
    results: &'static [&'static str],
    expected: Vec<Vec<u8>>,
}

/// Prefix of the files that are not complete.
const UNFINISHED: &str = ".tpg-";

/// Builds the trainer and runs each subject once, undisturbed.
pub(super) fn all(place: &Path) -> Result<Vec<Subject>, String> {
    let program = built()?;
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().ok_or("no workspace")?;
    let generated = |name: &str| root.join("generated").join(name).into_os_string();
    let words = |text: &str| text.split(' ').map(OsString::from).collect::<Vec<_>>();
    let tpg = "tpg --problem cartpole --set demes.count=1 --generations 12 --threads 2 --checkpoint-seconds 0";
    let mut sac = words("sac --problem pendulum --max-steps 1600 --checkpoint-seconds 0 --config");
    sac.push(with_many_lanes(&program, place)?.into_os_string());
    let hybrid = "hybrid --problem fs --episodes 2 --guard none --threads 2";
    let mut hybrid = words(hybrid);
    for (option, file) in [("--tpg", "widowx-fs/graph.json"), ("--policy", "widowx-sac/policy.q.json")] {
        hybrid.extend([option.into(), generated(file)]);
    }
    let logs =
        ["graph.json", "hall.jsonl", "generations.csv", "generations.jsonl", "checkpoint", "config.toml"].as_slice();
    let networks = ["policy.safetensors", "log.csv", "log.jsonl", "checkpoint", "config.toml"].as_slice();
    let cells = ["cells.csv", "alone.csv", "study.toml"].as_slice();
    [("tpg", true, words(tpg), logs), ("sac", true, sac, networks), ("hybrid", false, hybrid, cells)]
        .into_iter()
        .map(|(name, saves_often, arguments, results)| {
            let mut subject = Subject {
                name,
                saves_often,
                place: place.to_owned(),
                time: Duration::ZERO,
                size: 0,
                program: program.clone(),
                arguments,
                results,
                expected: Vec::new(),
            };
            subject.measure()?;
            Ok(subject)
        })
        .collect()
}

/// Builds tpg-train for release and returns the program.
fn built() -> Result<PathBuf, String> {
    let mut command = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    command.args(["build", "--quiet", "--release", "--package", "tpg-train", "--bin", "tpg-train"]);
    if !command.status().is_ok_and(|status| status.success()) {
        return Err("tpg-train does not build".to_owned());
    }
    Ok(tpg_testing::library::target_folder().join("release").join("tpg-train"))
}

/// Writes a configuration of networks that saves less often: after each decision of all lanes.
fn with_many_lanes(program: &Path, place: &Path) -> Result<PathBuf, String> {
    let output = Command::new(program).args(["config", "--sac", "general"]).output();
    let text = output.map(|output| String::from_utf8_lossy(&output.stdout).into_owned()).unwrap_or_default();
    let (from, to) = ("\nlanes = 2\n", "\nlanes = 64\n");
    if !text.contains(from) {
        return Err("the preset general has no lanes = 2".to_owned());
    }
    let path = place.join("sac.toml");
    fs::write(&path, text.replace(from, to)).map_err(|error| error.to_string())?;
    Ok(path)
}

impl Subject {
    fn measure(&mut self) -> Result<(), String> {
        let folder = super::fresh(self, "undisturbed");
        let start = Instant::now();
        let output = self.finish(&folder);
        self.time = start.elapsed();
        if !output.status.success() {
            return Err(format!("{}: {}", self.name, String::from_utf8_lossy(&output.stderr)));
        }
        self.expected = self.results_in(&folder).ok_or_else(|| format!("{}: results are missing", self.name))?;
        let entries = fs::read_dir(&folder).map_err(|error| error.to_string())?;
        self.size = entries.flatten().filter_map(|entry| entry.metadata().ok()).map(|file| file.len()).sum();
        Ok(())
    }

    /// Returns the command that begins a run in a folder or continues it.
    fn command(&self, folder: &Path) -> Command {
        let mut command = Command::new(&self.program);
        command.args(&self.arguments).arg("--resume").arg("--out").arg(folder).stdin(Stdio::null());
        command
    }

    /// Starts a run, or continues it.
    pub(super) fn start(&self, folder: &Path) -> Child {
        let mut command = self.command(folder);
        command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().expect("a program that was just built starts")
    }

    /// Runs to the end.
    pub(super) fn finish(&self, folder: &Path) -> Output {
        self.command(folder).output().expect("a program that was just built starts")
    }

    fn results_in(&self, folder: &Path) -> Option<Vec<Vec<u8>>> {
        self.results.iter().map(|name| fs::read(folder.join(name)).ok()).collect()
    }

    /// True if a folder holds the undisturbed run's bytes and nothing unfinished.
    pub(super) fn is_whole(&self, folder: &Path) -> bool {
        self.results_in(folder).is_some_and(|results| results == self.expected) && !has_unfinished(folder)
    }
}

/// True if a folder holds a file that is not complete.
pub(super) fn has_unfinished(folder: &Path) -> bool {
    let mut entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.any(|entry| entry.file_name().to_string_lossy().starts_with(UNFINISHED))
}
