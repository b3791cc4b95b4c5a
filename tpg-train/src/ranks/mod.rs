//! Runs over several processes: rank 0 leads, the others evaluate for it, and the results are the same bytes.
//!
//! Every rank is started with the same command line. Rank 0 breeds, selects and writes the files; it hands out roots, the
//! most expensive first, and takes the answers as they come. Nothing depends on who answers.
//!
//! | module | subject |
//! | --- | --- |
//! | (root) | a command on one of several [`Ranks`] |
//! | [`link`] | messages between ranks: what a transport such as MPI provides |
//! | `dealer` | the order and the size of what is handed out |
//! | `leader`, `worker` | both sides, and the messages between them |

mod dealer;
mod leader;
pub(crate) mod link;
mod worker;

use crate::evolution::command::{TpgArgs, execute};
use crate::evolution::run::RunError;
use leader::{Leader, dismiss, gather};
use link::Link;
use serde::{Serialize, de::DeserializeOwned};
use std::cell::Cell;
use std::process::ExitCode;
use tpg_engine::Evaluator;
use tpg_graph::command::{CommandError, Verdict, exit_code};
use worker::{Reply, encode, serve};

/// Runs `tpg-train tpg` on this rank of several, with the results of a single process: rank 0 leads and writes the files.
pub fn evolve(args: &TpgArgs, link: impl Link) -> ExitCode {
    let ranks = Ranks::new(&link);
    exit_code(ranks.close(execute(args, Some(&ranks)).map_err(CommandError::other)))
}

/// Several ranks: rank 0 leads, the others evaluate.
pub(crate) struct Ranks<'l> {
    link: &'l dyn Link,
    /// True once this rank has told the others, or has heard from them.
    begun: Cell<bool>,
}

impl<'l> Ranks<'l> {
    /// Joins ranks by a link.
    pub(crate) fn new(link: &'l dyn Link) -> Self {
        Self { link, begun: Cell::new(false) }
    }

    /// Trains with the evaluator of all ranks; `local` is this one's, on so many threads, and `identity` is everything that must
    /// be equal on all ranks. What one rank alone does (reading checkpoints, breeding, writing files) stands in `lead`, which
    /// the other ranks do not run.
    ///
    /// # Errors
    /// Those of `lead`, and ranks that are lost.
    pub(crate) fn train<Task: Clone + Serialize + DeserializeOwned + Sync>(
        &self,
        identity: &str,
        threads: usize,
        local: &(dyn Evaluator<Task> + Sync),
        lead: impl FnOnce(&dyn Evaluator<Task>) -> Result<Verdict, RunError>,
    ) -> Result<Verdict, RunError> {
        self.begun.set(true);
        if self.link.rank() > 0 {
            let ready = Reply::Ready { identity: identity.to_owned(), threads: threads as u64 };
            serve(self.link, &ready, local)?;
            return Ok(Verdict::Good);
        }
        let threads = gather(self.link, identity, threads)?;
        let result = lead(&Leader { link: self.link, local, threads });
        dismiss(self.link, 1..self.link.ranks())?;
        result
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
        let _ = gather(self.link, "", 0);
        result
    }
}
