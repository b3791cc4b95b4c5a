//! A checkpoint whose bytes were changed, in any way, is never believed: exit status 2.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use tpg_engine::random::{Purpose, Stream};
use tpg_problems::{Problem, ProblemName};
use tpg_train::{Config as EvolutionConfig, Configuration as _, SacConfig};

/// Mutations of the checkpoint of each trainer.
const MUTATIONS: u64 = 150;

/// A run of some milliseconds.
struct Run {
    command: &'static str,
    config: PathBuf,
    folder: PathBuf,
}

impl Run {
    fn go(&self, folder: &Path) -> Output {
        let mut command = Command::new(env!("CARGO_BIN_EXE_tpg-train"));
        command.arg(self.command).arg("--config").arg(&self.config).arg("--out").arg(folder);
        command.args(["--resume", "--checkpoint-seconds", "0"]).output().expect("it starts")
    }
}

fn tpg(place: &Path) -> Run {
    let problem = Problem::new(ProblemName::Cartpole).to_table();
    let mut config = EvolutionConfig { problem, ..EvolutionConfig::default() };
    (config.tpg.nb_roots, config.tpg.init_nb_roots) = (12, 12);
    (config.learning.nb_iterations_per_policy_evaluation, config.learning.nb_generations) = (2, 4);
    (config.selection.racing_episodes, config.selection.validation_episodes) = (0, 2);
    run(place, "tpg", &config.to_toml())
}

fn sac(place: &Path) -> Run {
    let mut config = SacConfig::preset("general").expect("a preset");
    config.problem = Problem::new(ProblemName::Pendulum).to_table();
    (config.actor.hidden, config.critic.hidden) = (vec![3], vec![3]);
    (config.learning.decisions, config.learning.random_decisions, config.learning.batch) = (24, 8, 4);
    (config.validation.every, config.validation.episodes) = (12, 1);
    run(place, "sac", &config.to_toml())
}

fn run(place: &Path, command: &'static str, config: &str) -> Run {
    let run = Run { command, config: place.join(format!("{command}.toml")), folder: place.join(command) };
    fs::write(&run.config, config).expect("it can be written");
    let output = run.go(&run.folder);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    run
}

/// Changes bytes: every kind of change that disks, transfers and editors make.
fn mutated(whole: &[u8], stream: &mut Stream) -> (String, Vec<u8>) {
    let mut bytes = whole.to_vec();
    let at = stream.below(bytes.len());
    let digits: Vec<usize> = (0..bytes.len()).filter(|&at| bytes[at].is_ascii_digit()).collect();
    let what = match stream.below(8) {
        0 => {
            bytes[at] ^= 1 << stream.below(8);
            format!("a bit of byte {at}")
        }
        1 | 2 => {
            let at = *stream.pick(&digits);
            bytes[at] = b'0' + (bytes[at] - b'0' + 1 + stream.below(9) as u8) % 10;
            format!("the digit at {at}")
        }
        3 => {
            bytes.truncate(at);
            format!("cut to {at}")
        }
        4 => {
            bytes.remove(at);
            format!("without byte {at}")
        }
        5 => {
            bytes.insert(at, stream.below(256) as u8);
            format!("one more byte at {at}")
        }
        6 => {
            let end = (at + 512).min(bytes.len());
            bytes[at..end].fill(0);
            format!("zeros from {at}")
        }
        _ => {
            let other = stream.below(bytes.len());
            bytes.swap(at, other);
            format!("bytes {at} and {other} swapped")
        }
    };
    (what, bytes)
}

/// Copies a run's folder.
fn copied(from: &Path, to: &Path) {
    let _ = fs::remove_dir_all(to);
    fs::create_dir(to).expect("it can be made");
    for entry in fs::read_dir(from).expect("a folder") {
        let path = entry.expect("an entry").path();
        fs::copy(&path, to.join(path.file_name().expect("a name"))).expect("it can be copied");
    }
}

fn check(run: &Run, seed: u64) {
    let whole = fs::read(run.folder.join("checkpoint")).expect("a checkpoint");
    let damaged = run.folder.with_extension("damaged");
    for index in 0..MUTATIONS {
        let mut stream = Stream::new(seed, index, Purpose::Test, 0);
        let (what, bytes) = mutated(&whole, &mut stream);
        if bytes == whole {
            continue;
        }
        copied(&run.folder, &damaged);
        fs::write(damaged.join("checkpoint"), &bytes).expect("it can be written");
        let Output { status, stderr, .. } = run.go(&damaged);
        let stderr = String::from_utf8_lossy(&stderr);
        assert!(!stderr.contains("panicked"), "{}, {index}, {what}: {stderr}", run.command);
        assert_eq!(status.code(), Some(2), "{}, {index}, {what}: {stderr}", run.command);
        assert!(stderr.contains("a whole checkpoint"), "{stderr}");
        assert!(fs::read(damaged.join("checkpoint")).is_ok_and(|left| left == bytes), "it stays for its owner");
    }
}

#[test]
fn a_graphs_run_never_believes_a_damaged_checkpoint() {
    let place = tempfile::tempdir().expect("a temporary folder");
    check(&tpg(place.path()), 1);
}

#[test]
fn a_networks_run_never_believes_a_damaged_checkpoint() {
    let place = tempfile::tempdir().expect("a temporary folder");
    check(&sac(place.path()), 2);
}

#[test]
fn a_run_that_was_asked_for_less_than_it_has_had_is_refused_where_it_has_no_graph() {
    let place = tempfile::tempdir().expect("a temporary folder");
    let run = |more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_tpg-train"));
        command.args(["tpg", "--problem", "pendulum", "--checkpoint-seconds", "0", "--out"]);
        command.arg(place.path().join("run")).args(more);
        command
    };
    // The first validation comes after more generations than this.
    let mut child = run(&[]).spawn().expect("it starts");
    while !place.path().join("run/checkpoint").exists() {
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    child.kill().expect("it can be killed");
    child.wait().expect("it ends");
    let output = run(&["--resume", "--generations", "1"]).output().expect("it starts");
    let stderr = String::from_utf8_lossy(&output.stderr);
    let validated = place.path().join("run/graph.json").exists();
    assert_eq!(output.status.code(), Some(if validated { 0 } else { 2 }), "{stderr}");
    assert!(validated || stderr.contains("without a validation; accepted: more generations"), "{stderr}");
}
