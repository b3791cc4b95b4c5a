//! Runs over several processes: rank 0 leads, the others evaluate for it, and the results are the same bytes.
//!
//! Every rank is started with the same command line. Rank 0 breeds, selects and writes the files; it hands out roots, the
//! most expensive first, and takes the answers as they come. Nothing depends on who answers.
//!
//! | module | subject |
//! | --- | --- |
//! | [`workplace`] | the place where a command evaluates: [this process](workplace::ThisProcess) or [ranks](workplace::Ranks) |
//! | [`link`] | messages between ranks: what a transport such as MPI provides |
//! | `dealer` | the order and the size of what is handed out |
//! | `leader`, `worker` | both sides, and the messages between them |

mod dealer;
mod leader;
pub(crate) mod link;
mod worker;
pub(crate) mod workplace;
