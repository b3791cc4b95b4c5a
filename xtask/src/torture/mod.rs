//! `cargo xtask torture`: runs that are killed, started twice, or whose disk or files fail must end with the
//! bytes of an undisturbed run, or refuse with exit status 2 and lose nothing.
//!
//! | module | subject |
//! | --- | --- |
//! | (root) | the command |
//! | [`subject`] | the three runs: `tpg`, `sac`, `hybrid` |
//! | [`kills`] | SIGKILL at random moments, and while files are written |
//! | [`faults`] | two processes, damaged checkpoints |
//! | [`disk`] | a full disk |
//! | [`table`] | the counts |

mod disk;
mod faults;
mod kills;
mod subject;
mod table;

use rand::SeedableRng as _;
use rand_chacha::ChaCha8Rng;
use std::path::PathBuf;
use subject::Subject;
use table::{Row, Table};

/// Arguments of the command.
#[derive(Clone, Copy, Debug, clap::Args)]
pub(crate) struct TortureArgs {
    /// Kills in all: two fifths each of tpg and sac, one fifth of hybrid
    #[arg(long, value_name = "N", default_value_t = 200)]
    kills: u32,
    /// The seed of the moments
    #[arg(long, value_name = "S", default_value_t = 1)]
    seed: u64,
}

impl TortureArgs {
    /// Tortures all trainers and prints a table; returns true if nothing failed.
    pub(crate) fn run(self) -> bool {
        // On a disk: a file takes long to reach it, so that many kills strike before it is whole.
        let place = match tempfile::tempdir() {
            Ok(place) => place,
            Err(error) => return complain(&format!("no temporary folder: {error}")),
        };
        let subjects = match subject::all(place.path()) {
            Ok(subjects) => subjects,
            Err(error) => return complain(&error),
        };
        let mut table = Table::default();
        for (subject, share) in subjects.iter().zip([2, 2, 1]) {
            let mut random = ChaCha8Rng::seed_from_u64(self.seed);
            println!("{}: {:.2} s undisturbed", subject.name, subject.time.as_secs_f64());
            table.add(kills::kills(subject, self.kills * share / 5, &mut random));
            for fault in [faults::two_processes, disk::full] {
                table.add(fault(subject, &mut random));
            }
            if subject.saves_often {
                table.add(faults::damaged(subject, &mut random));
            }
        }
        table.print();
        table.good()
    }
}

/// A check of one subject: the row, or the reason why it was skipped.
type CheckedRun = Result<Row, String>;

fn complain(message: &str) -> bool {
    eprintln!("torture: {message}");
    false
}

/// Returns a new folder for a run of a subject.
fn fresh(subject: &Subject, name: &str) -> PathBuf {
    subject.place.join(format!("{}-{name}", subject.name))
}
