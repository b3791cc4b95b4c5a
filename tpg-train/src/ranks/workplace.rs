//! The place where a command evaluates roots and computes cells.

use super::leader::{Crew, Jobs, Leader, Traffic, dismiss};
use super::link::Link;
use super::message::{Order, Reply, decode, encode};
use super::worker::{Roots, serve};
use crate::evolution::run::RunError;
use rayon::prelude::*;
use std::cell::Cell;
use std::fmt;
use std::sync::Mutex;
use std::sync::PoisonError;
use std::sync::atomic::{AtomicBool, Ordering};
use tpg_engine::{Environment, EvaluationError, Evaluator, LocalThreads};
use tpg_graph::command::{CommandError, Verdict};
use tpg_graph::error::{InputError, Place};
use tpg_runtime::ops::Maths;
use tpg_runtime::scalar::Scalar;

/// Computes the cell of a study with a number, as bytes.
pub type Compute<'c> = dyn Fn(u64) -> Result<Vec<u8>, InputError> + Sync + 'c;

/// Takes the bytes of a cell with a number.
pub type Done<'c> = dyn FnMut(u64, Vec<u8>) -> Result<(), InputError> + Send + 'c;

/// A place where cells are computed.
pub trait Cells {
    /// Computes cells in any order; `done` gets each of them. Ends early, without an error, once `stop` is set.
    ///
    /// # Errors
    /// If a cell cannot be computed, or `done` refuses one.
    fn compute(&self, open: &[u64], stop: &AtomicBool, done: &mut Done<'_>) -> Result<(), InputError>;
}

/// The place where a command evaluates: the threads of one process, or several ranks. What one rank alone does (reading
/// checkpoints, breeding, writing files) stands in `lead`, which the other ranks do not run.
pub trait Workplace {
    /// Returns the number of ranks.
    fn ranks(&self) -> usize {
        1
    }

    /// Trains with the roots' evaluator of this place. `identity` is everything that must be equal on all ranks.
    ///
    /// # Errors
    /// Those of `lead`, and ranks that are lost.
    fn train<S: Scalar, M: Maths<S>, E: Environment<S>>(
        &self,
        identity: &str,
        local: &LocalThreads<'_, S, M, E>,
        lead: impl FnOnce(&dyn Evaluator<E::Task>) -> Result<Verdict, RunError>,
    ) -> Result<Verdict, RunError>;

    /// Computes a study's cells with the `threads` of each rank.
    ///
    /// # Errors
    /// Those of `lead`, and ranks that are lost.
    fn study(
        &self,
        identity: &str,
        threads: &rayon::ThreadPool,
        compute: &Compute<'_>,
        lead: impl FnOnce(&dyn Cells) -> Result<Verdict, InputError>,
    ) -> Result<Verdict, InputError>;
}

/// This process alone.
#[derive(Clone, Copy, Debug, Default)]
pub struct ThisProcess;

impl Workplace for ThisProcess {
    fn train<S: Scalar, M: Maths<S>, E: Environment<S>>(
        &self,
        _: &str,
        local: &LocalThreads<'_, S, M, E>,
        lead: impl FnOnce(&dyn Evaluator<E::Task>) -> Result<Verdict, RunError>,
    ) -> Result<Verdict, RunError> {
        lead(local)
    }

    fn study(
        &self,
        _: &str,
        threads: &rayon::ThreadPool,
        compute: &Compute<'_>,
        lead: impl FnOnce(&dyn Cells) -> Result<Verdict, InputError>,
    ) -> Result<Verdict, InputError> {
        lead(&OwnCells { threads, compute })
    }
}

struct OwnCells<'c> {
    threads: &'c rayon::ThreadPool,
    compute: &'c Compute<'c>,
}

impl Cells for OwnCells<'_> {
    fn compute(&self, open: &[u64], stop: &AtomicBool, done: &mut Done<'_>) -> Result<(), InputError> {
        let done = Mutex::new(done);
        self.threads.install(|| {
            open.par_iter().try_for_each(|&number| {
                if stop.load(Ordering::Relaxed) {
                    return Ok(());
                }
                let cell = (self.compute)(number)?;
                (done.lock().unwrap_or_else(PoisonError::into_inner))(number, cell)
            })
        })
    }
}

/// Several ranks: rank 0 leads, the others evaluate.
#[derive(Debug)]
pub struct Ranks<L> {
    link: L,
    /// True once this rank has told the others, or has heard from them.
    begun: Cell<bool>,
    traffic: Cell<Traffic>,
}

impl<L: Link> Ranks<L> {
    /// Joins ranks by a link.
    pub fn new(link: L) -> Self {
        Self { link, begun: Cell::new(false), traffic: Cell::default() }
    }

    /// Returns the bytes that rank 0 has sent and received.
    pub fn traffic(&self) -> Traffic {
        self.traffic.get()
    }

    /// Ends a command on this rank: a rank that failed before the others began, or that leads and failed, tells them.
    /// Only rank 0 has a result; what went wrong elsewhere is in it.
    ///
    /// # Errors
    /// Rank 0's, or ranks that are lost.
    pub fn close(&self, result: Result<Verdict, CommandError>) -> Result<Verdict, CommandError> {
        let worker = self.link.rank() > 0;
        if !self.begun.get() {
            let told = if worker { self.tell(&result) } else { self.dismiss_all() };
            return if worker { told.map(|()| Verdict::Good).map_err(CommandError::other) } else { result };
        }
        result
    }

    fn tell(&self, result: &Result<Verdict, CommandError>) -> Result<(), EvaluationError> {
        let text = result.as_ref().map_or_else(ToString::to_string, |_| "nothing to do".to_owned());
        self.link.send(0, &encode(&Reply::Failed(text))?)
    }

    fn dismiss_all(&self) -> Result<(), EvaluationError> {
        for _ in 1..self.link.ranks() {
            let (rank, bytes) = self.link.receive()?;
            if let Reply::Ready { .. } = decode(&bytes)? {
                dismiss(&self.link, &[rank])?;
            }
        }
        Ok(())
    }

    /// Leads with the other ranks, and dismisses them afterwards.
    fn lead<T, X: From<EvaluationError>>(
        &self,
        identity: &str,
        threads: usize,
        lead: impl FnOnce(&Crew<'_, L>) -> Result<T, X>,
    ) -> Result<T, X> {
        self.begun.set(true);
        let crew = Crew::gather(&self.link, identity, threads)?;
        let result = lead(&crew);
        self.traffic.set(crew.traffic());
        let workers: Vec<usize> = (1..self.link.ranks()).collect();
        dismiss(&self.link, &workers)?;
        result
    }
}

impl<L: Link> Workplace for Ranks<L> {
    fn ranks(&self) -> usize {
        self.link.ranks()
    }

    fn train<S: Scalar, M: Maths<S>, E: Environment<S>>(
        &self,
        identity: &str,
        local: &LocalThreads<'_, S, M, E>,
        lead: impl FnOnce(&dyn Evaluator<E::Task>) -> Result<Verdict, RunError>,
    ) -> Result<Verdict, RunError> {
        if self.link.rank() > 0 {
            self.begun.set(true);
            let ready = Reply::Ready { identity: identity.to_owned(), threads: local.threads() as u64 };
            let mut roots = Roots::<E::Task, _>::new(local);
            serve(&self.link, &ready, |order| roots.answer(order))?;
            return Ok(Verdict::Good);
        }
        self.lead(identity, local.threads(), |crew| lead(&Leader::new(crew, local)))
    }

    fn study(
        &self,
        identity: &str,
        threads: &rayon::ThreadPool,
        compute: &Compute<'_>,
        lead: impl FnOnce(&dyn Cells) -> Result<Verdict, InputError>,
    ) -> Result<Verdict, InputError> {
        let count = threads.current_num_threads();
        if self.link.rank() > 0 {
            self.begun.set(true);
            let ready = Reply::Ready { identity: identity.to_owned(), threads: count as u64 };
            let answer = |order: Order| match order {
                Order::Cells(numbers) => Ok(Reply::Cells(all(threads, compute, &numbers)?)),
                _ => Err(EvaluationError::new("an order of a training")),
            };
            return serve(&self.link, &ready, answer).map(|()| Verdict::Good).map_err(of_ranks);
        }
        let lead = |crew: &Crew<'_, L>| Ok(lead(&SharedCells { crew, threads, compute }));
        self.lead(identity, count, lead).map_err(of_ranks)?
    }
}

/// Computes cells on this rank's threads.
fn all(threads: &rayon::ThreadPool, compute: &Compute<'_>, numbers: &[u64]) -> Result<Vec<Vec<u8>>, EvaluationError> {
    threads.install(|| numbers.par_iter().map(|&number| compute(number).map_err(EvaluationError::new)).collect())
}

/// Returns an error of a study: an input's own, or that of a rank.
fn of_ranks(error: EvaluationError) -> InputError {
    match error.into_inner().downcast::<InputError>() {
        Ok(error) => *error,
        Err(error) => InputError::new("the ranks", Place::Whole, error.to_string(), "ranks that compute every cell"),
    }
}

/// The reason for an early end, not an error of its own.
#[derive(Debug)]
struct Stopped;

impl fmt::Display for Stopped {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("stopped")
    }
}

impl std::error::Error for Stopped {}

struct SharedCells<'c, 'l, L> {
    crew: &'c Crew<'l, L>,
    threads: &'c rayon::ThreadPool,
    compute: &'c Compute<'c>,
}

impl<L: Link> Cells for SharedCells<'_, '_, L> {
    fn compute(&self, open: &[u64], stop: &AtomicBool, done: &mut Done<'_>) -> Result<(), InputError> {
        let numbers = |jobs: &[usize]| jobs.iter().map(|&job| open[job]).collect::<Vec<_>>();
        let order = |_: usize, jobs: &[usize]| encode(&Order::Cells(numbers(jobs)));
        let read = |rank: usize, reply: Reply| match reply {
            Reply::Cells(cells) => Ok(cells),
            _ => Err(EvaluationError::new(format!("rank {rank}: another answer than cells"))),
        };
        let (threads, compute) = (self.threads, self.compute);
        let local = |jobs: &[usize]| all(threads, compute, &numbers(jobs));
        let mut done = |job: usize, cell: Vec<u8>| {
            done(open[job], cell).map_err(EvaluationError::new)?;
            if stop.load(Ordering::Relaxed) { Err(EvaluationError::new(Stopped)) } else { Ok(()) }
        };
        let jobs = Jobs { costs: &vec![1; open.len()], order: &order, read: &read, local: &local, done: &mut done };
        match self.crew.distribute(jobs) {
            Err(error) if !error.is::<Stopped>() => Err(of_ranks(error)),
            _ => Ok(()),
        }
    }
}
