//! Runs over several ranks: the same bytes as threads, whatever the number of ranks; failures name their rank.

use crate::evolution::command::{TpgArgs, execute};
use crate::ranks::Ranks;
use crate::ranks::link::Link;
use clap::Parser;
use std::fs;
use std::path::Path;
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use tempfile::TempDir;
use tpg_engine::EvaluationError;
use tpg_graph::command::{CommandError, Verdict};

/// A rank that is a thread, with messages in channels.
struct Channels {
    rank: usize,
    inbox: Receiver<(usize, Vec<u8>)>,
    others: Vec<Sender<(usize, Vec<u8>)>>,
}

impl Link for Channels {
    fn rank(&self) -> usize {
        self.rank
    }

    fn ranks(&self) -> usize {
        self.others.len()
    }

    fn send(&self, to: usize, message: &[u8]) -> Result<(), EvaluationError> {
        self.others[to]
            .send((self.rank, message.to_vec()))
            .map_err(|_| EvaluationError::new(format!("rank {to} is lost")))
    }

    fn poll(&self) -> Result<Option<(usize, Vec<u8>)>, EvaluationError> {
        match self.inbox.try_recv() {
            Ok(message) => Ok(Some(message)),
            Err(TryRecvError::Empty) => Ok(None),
            Err(TryRecvError::Disconnected) => Err(EvaluationError::new("every other rank is lost")),
        }
    }
}

fn links(ranks: usize) -> Vec<Channels> {
    let (senders, inboxes): (Vec<_>, Vec<_>) = (0..ranks).map(|_| channel()).unzip();
    let link = |(rank, inbox)| Channels { rank, inbox, others: senders.clone() };
    inboxes.into_iter().enumerate().map(link).collect()
}

/// Runs a command on ranks and returns each one's result.
fn on_ranks(
    ranks: usize,
    command: impl Fn(usize, &Ranks<'_>) -> Result<Verdict, CommandError> + Sync,
) -> Vec<Result<Verdict, CommandError>> {
    let one = |link: Channels| {
        let rank = link.rank();
        let place = Ranks::new(&link);
        place.close(command(rank, &place))
    };
    std::thread::scope(|scope| {
        let threads: Vec<_> = links(ranks).into_iter().map(|link| scope.spawn(|| one(link))).collect();
        threads.into_iter().map(|thread| thread.join().expect("no rank panics")).collect()
    })
}

#[derive(Parser)]
struct Tpg {
    #[command(flatten)]
    args: TpgArgs,
}

fn tpg(out: &Path, more: &[&str], ranks: Option<&Ranks<'_>>) -> Result<Verdict, CommandError> {
    let out = out.display().to_string();
    let small = ["tpg", "--threads", "2", "--checkpoint-seconds", "3600", "--out", &out];
    let args = Tpg::try_parse_from(small.iter().chain(more)).expect("arguments that are right").args;
    execute(&args, ranks).map_err(CommandError::other)
}

/// The files of a folder that must not depend on the number of ranks.
fn files(folder: &Path, names: &[&str]) -> Vec<Vec<u8>> {
    names.iter().map(|name| fs::read(folder.join(name)).unwrap_or_else(|_| panic!("{name}"))).collect()
}

/// Fails unless every rank ended well.
fn good(results: Vec<Result<Verdict, CommandError>>) {
    for (rank, result) in results.into_iter().enumerate() {
        assert_eq!(result.unwrap_or_else(|error| panic!("rank {rank}: {error}")), Verdict::Good);
    }
}

const RESULTS: [&str; 3] = ["graph.json", "checkpoint", "generations.jsonl"];

#[test]
fn any_number_of_ranks_gives_the_bytes_of_threads() {
    let folder = TempDir::new().expect("a folder");
    let random =
        ["--problem", "pendulum", "--preset", "quick", "--set", "learning.nb_generations=4", "--max-steps", "200000"];
    // Literals, leaves, a linear start and random search: everything that an evaluator is asked.
    for (problem, more) in [
        ("cartpole", &["--problem", "cartpole", "--generations", "4"][..]),
        ("pendulum", &["--problem", "pendulum", "--generations", "4"]),
        ("random", &random),
    ] {
        let alone = folder.path().join(format!("{problem}-alone"));
        assert_eq!(tpg(&alone, more, None).expect("it runs"), Verdict::Good);
        let expected = files(&alone, &RESULTS);
        for ranks in [1, 2, 3, 5] {
            let out = folder.path().join(format!("{problem}-{ranks}"));
            good(on_ranks(ranks, |_, place| tpg(&out, more, Some(place))));
            assert!(files(&out, &RESULTS) == expected, "{problem} on {ranks} ranks: other bytes");
        }
    }
}

#[test]
fn a_run_goes_on_with_another_number_of_ranks() {
    let folder = TempDir::new().expect("a folder");
    let first = ["--problem", "cartpole", "--generations", "2"];
    let second = ["--problem", "cartpole", "--generations", "4", "--resume"];
    let [alone, shared] = ["alone", "shared"].map(|name| folder.path().join(name));
    for more in [&first[..], &second] {
        tpg(&alone, more, None).expect("it runs");
    }
    good(on_ranks(3, |_, place| tpg(&shared, &first, Some(place))));
    good(on_ranks(2, |_, place| tpg(&shared, &second, Some(place))));
    assert!(files(&shared, &RESULTS) == files(&alone, &RESULTS), "other bytes");
}

#[test]
fn what_goes_wrong_on_a_rank_is_said_by_rank_0_and_ends_the_others() {
    let folder = TempDir::new().expect("a folder");
    let out = folder.path().join("run");
    let good = ["--problem", "cartpole"];
    let said = |results: Vec<Result<Verdict, CommandError>>| {
        let mut results = results.into_iter();
        let first = results.next().expect("rank 0").expect_err("it fails").to_string();
        assert!(results.all(|result| matches!(result, Ok(Verdict::Good))), "only rank 0 speaks");
        first
    };

    let other = ["--problem", "acrobot"];
    let results = on_ranks(3, |rank, place| tpg(&out, if rank == 2 { &other } else { &good }, Some(place)));
    let error = said(results);
    assert!(error.contains("rank 2 was started with another version, configuration or problem"), "{error}");

    let none = ["--problem", "cartpole", "--config", "/no/such/file.toml"];
    let error = said(on_ranks(3, |rank, place| tpg(&out, if rank == 1 { &none } else { &good }, Some(place))));
    assert!(error.contains("rank 1") && error.contains("/no/such/file.toml"), "{error}");

    let error = said(on_ranks(3, |rank, place| tpg(&out, if rank == 0 { &none } else { &good }, Some(place))));
    assert!(error.contains("/no/such/file.toml") && !error.contains("rank"), "{error}");
    assert!(!out.exists(), "nothing was begun");
}
