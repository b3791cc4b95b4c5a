//! The place where a command evaluates roots.

use super::leader::{Leader, dismiss, gather};
use super::link::Link;
use super::worker::{Reply, encode, serve};
use crate::evolution::command::{TpgArgs, execute};
use crate::evolution::run::RunError;
use std::cell::Cell;
use std::process::ExitCode;
use tpg_engine::{Environment, Evaluator, LocalThreads};
use tpg_graph::command::{CommandError, Verdict, exit_code};
use tpg_runtime::ops::Maths;
use tpg_runtime::scalar::Scalar;

/// The place where a command evaluates: the threads of one process, or several ranks. What one rank alone does (reading
/// checkpoints, breeding, writing files) stands in `lead`, which the other ranks do not run.
pub(crate) trait Workplace {
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
}

/// This process alone.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct ThisProcess;

impl Workplace for ThisProcess {
    fn train<S: Scalar, M: Maths<S>, E: Environment<S>>(
        &self,
        _: &str,
        local: &LocalThreads<'_, S, M, E>,
        lead: impl FnOnce(&dyn Evaluator<E::Task>) -> Result<Verdict, RunError>,
    ) -> Result<Verdict, RunError> {
        lead(local)
    }
}

/// Runs `tpg-train tpg` on this rank of several, with the results of a single process: rank 0 leads and writes the files.
pub fn evolve(args: &TpgArgs, link: impl Link) -> ExitCode {
    let place = Ranks::new(link);
    exit_code(place.close(execute(args, &place).map_err(CommandError::other)))
}

/// Several ranks: rank 0 leads, the others evaluate.
#[derive(Debug)]
pub(crate) struct Ranks<L> {
    link: L,
    /// True once this rank has told the others, or has heard from them.
    begun: Cell<bool>,
}

impl<L: Link> Ranks<L> {
    /// Joins ranks by a link.
    pub(crate) fn new(link: L) -> Self {
        Self { link, begun: Cell::new(false) }
    }

    /// Ends a command on this rank: a rank that failed before the others began, or that leads and failed, tells them.
    /// Only rank 0 has a result; what went wrong elsewhere is in it.
    ///
    /// # Errors
    /// Rank 0's, or ranks that are lost.
    pub(crate) fn close(&self, result: Result<Verdict, CommandError>) -> Result<Verdict, CommandError> {
        if self.begun.get() {
            return result;
        }
        if self.link.rank() > 0 {
            let text = result.as_ref().map_or_else(ToString::to_string, |_| "nothing to do".to_owned());
            let told = encode(&Reply::Failed(text)).and_then(|bytes| self.link.send(0, &bytes));
            return told.map(|()| Verdict::Good).map_err(CommandError::other);
        }
        // No run has this identity: all that are ready are dismissed.
        let _ = gather(&self.link, "", 0);
        result
    }
}

impl<L: Link> Workplace for Ranks<L> {
    fn train<S: Scalar, M: Maths<S>, E: Environment<S>>(
        &self,
        identity: &str,
        local: &LocalThreads<'_, S, M, E>,
        lead: impl FnOnce(&dyn Evaluator<E::Task>) -> Result<Verdict, RunError>,
    ) -> Result<Verdict, RunError> {
        self.begun.set(true);
        if self.link.rank() > 0 {
            let ready = Reply::Ready { identity: identity.to_owned(), threads: local.threads() as u64 };
            serve(&self.link, &ready, local)?;
            return Ok(Verdict::Good);
        }
        let threads = gather(&self.link, identity, local.threads())?;
        let result = lead(&Leader::new(&self.link, local, threads));
        dismiss(&self.link, 1..self.link.ranks())?;
        result
    }
}
