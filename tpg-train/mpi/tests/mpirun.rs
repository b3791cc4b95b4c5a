//! Runs under mpirun: the same bytes for any number of ranks, also after a rank was killed.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};
use tempfile::TempDir;
use tpg_train::Cli;

/// Files that must not depend on ranks.
const RESULTS: [&str; 3] = ["graph.json", "checkpoint", "generations.jsonl"];

/// A run of a few seconds, in several generations; checkpoints after each.
const RUN: [&str; 6] = ["--problem", "pendulum", "--generations", "12", "--checkpoint-seconds", "0"];

fn has_mpi() -> bool {
    tpg_testing::tool("mpirun", "openmpi-bin", "runs over MPI")
}

fn mpirun(ranks: usize, words: &[&str]) -> Command {
    let mut command = Command::new("mpirun");
    // More ranks than cores, also as root, as in a container; each rank has one thread.
    command.args(["--oversubscribe", "--bind-to", "none", "-n", &ranks.to_string()]);
    command.arg(env!("CARGO_BIN_EXE_tpg-mpi")).args(words);
    command.envs([("OMPI_ALLOW_RUN_AS_ROOT", "1"), ("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1")]);
    command.stdin(Stdio::null());
    command
}

fn run(ranks: usize, out: &Path, more: &[&str]) -> Output {
    let out = out.display().to_string();
    let words = [&["tpg", "--threads", "1", "--out", &out], &RUN[..], more].concat();
    mpirun(ranks, &words).output().expect("mpirun starts")
}

fn bytes(folder: &Path) -> Vec<Vec<u8>> {
    RESULTS.iter().map(|name| fs::read(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))).collect()
}

/// The bytes of the run by threads, without MPI.
fn by_threads(folder: &Path) -> Vec<Vec<u8>> {
    use clap::Parser;
    let out = folder.join("threads");
    let words = ["tpg-train", "tpg", "--threads", "2", "--out"].map(str::to_owned);
    let rest = RUN.map(str::to_owned);
    let _ = Cli::parse_from(words.into_iter().chain([out.display().to_string()]).chain(rest)).run();
    bytes(&out)
}

#[test]
fn one_two_three_and_five_ranks_give_the_bytes_of_threads() {
    if !has_mpi() {
        return;
    }
    let folder = TempDir::new().expect("a folder");
    let expected = by_threads(folder.path());
    for ranks in [1, 2, 3, 5] {
        let out = folder.path().join(ranks.to_string());
        let output = run(ranks, &out, &[]);
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{text}");
        assert!(bytes(&out) == expected, "{ranks} ranks: other bytes");
    }
}

#[test]
fn bad_input_is_said_once() {
    if !has_mpi() {
        return;
    }
    let folder = TempDir::new().expect("a folder");
    let output = run(3, &folder.path().join("run"), &["--config", "/no/such.toml"]);
    let text = String::from_utf8_lossy(&output.stderr);
    assert_eq!((output.status.code(), text.matches("/no/such.toml").count()), (Some(2), 1), "{text}");
    let output = mpirun(3, &["tpg", "--no-such-flag"]).output().expect("mpirun starts");
    let text = String::from_utf8_lossy(&output.stderr);
    assert_eq!((output.status.code(), text.matches("unexpected argument").count()), (Some(2), 1), "{text}");
}

/// The processes of a run's ranks: rank and process number.
fn ranks_of(out: &str) -> BTreeSet<(usize, u32)> {
    let one = |entry: fs::DirEntry| {
        let process = entry.file_name().to_str()?.parse().ok()?;
        let words = fs::read(entry.path().join("cmdline")).ok()?;
        let of_run = words.split(|&byte| byte == 0).any(|word| word == out.as_bytes());
        let environment = fs::read(entry.path().join("environ")).ok()?;
        let rank = environment.split(|&byte| byte == 0).find_map(|word| word.strip_prefix(b"OMPI_COMM_WORLD_RANK="))?;
        of_run.then_some((std::str::from_utf8(rank).ok()?.parse().ok()?, process))
    };
    fs::read_dir("/proc").expect("Linux").filter_map(|entry| one(entry.ok()?)).collect()
}

fn wait(child: &mut Child) -> i32 {
    let began = Instant::now();
    loop {
        if let Some(status) = child.try_wait().expect("a child") {
            return status.code().unwrap_or(-1);
        }
        assert!(began.elapsed() < Duration::from_secs(120), "the job hangs");
        std::thread::sleep(Duration::from_millis(20));
    }
}

#[test]
fn a_killed_rank_ends_the_job_and_a_resumed_run_has_the_same_bytes() {
    if !has_mpi() {
        return;
    }
    let folder = TempDir::new().expect("a folder");
    let expected = by_threads(folder.path());
    let mut killed = 0;
    for (number, after) in [40, 150, 300, 500, 800].into_iter().enumerate() {
        let out = folder.path().join(format!("killed-{number}"));
        let text = out.display().to_string();
        let words = [&["tpg", "--threads", "1", "--out", &text], &RUN[..]].concat();
        let log = fs::File::create(folder.path().join("log")).expect("a file");
        let mut job = mpirun(3, &words).stderr(log).stdout(Stdio::null()).spawn().expect("mpirun starts");
        while !out.join("config.toml").exists() && job.try_wait().expect("a child").is_none() {
            std::thread::sleep(Duration::from_millis(5));
        }
        std::thread::sleep(Duration::from_millis(after));
        let victim = ranks_of(&text).into_iter().find(|&(rank, _)| rank == 1 + number % 2);
        if let Some((_, process)) = victim {
            Command::new("kill").args(["-9", &process.to_string()]).status().expect("kill");
        }
        let status = wait(&mut job);
        if status != 0 {
            killed += 1;
            let log = fs::read_to_string(folder.path().join("log")).expect("text");
            assert!(log.contains(&format!("rank {}", 1 + number % 2)), "the message names the rank: {log}");
        }
        let output = run(2, &out, &["--resume"]);
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        assert!(bytes(&out) == expected, "killed after {after} ms, resumed on two ranks: other bytes");
    }
    assert!(killed > 0, "every run had ended before its rank was killed");
}
