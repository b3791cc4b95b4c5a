//! `mpirun -n N tpg-mpi tpg …`: the flags, the files and the bytes of `tpg-train tpg`, on as many ranks as MPI starts.
//!
//! Rank 0 leads: it breeds, selects, and writes the files. MPI has no way to go on without a lost rank, so the job ends
//! with it; the checkpoint is whole, and `--resume` continues it on any number of ranks.

mod link;

use clap::{Parser, Subcommand};
use link::World;
use std::process::ExitCode;
use tpg_train::{Link, TpgArgs, evolve};

/// `tpg-train` on the ranks of an MPI job: every rank reads the same command line, rank 0 writes the files.
#[derive(Debug, Parser)]
#[command(version)]
struct MpiCli {
    #[command(subcommand)]
    command: MpiCommand,
}

#[derive(Debug, Subcommand)]
enum MpiCommand {
    /// Evolve a tangled program graph; every rank evaluates roots. --threads is the number of each rank
    Tpg(TpgArgs),
}

fn main() -> ExitCode {
    let Some((universe, _)) = mpi::initialize_with_threading(mpi::Threading::Funneled) else {
        eprintln!("error: MPI could not be initialised");
        return ExitCode::from(2);
    };
    let world = World(universe.world());
    let (rank, ranks) = (world.rank(), world.ranks());
    let cli = match MpiCli::try_parse() {
        Ok(cli) => cli,
        Err(error) => {
            if rank == 0 {
                // Help goes to stdout, errors to stderr; a closed pipe changes nothing.
                let _ = error.print();
            }
            return ExitCode::from(error.exit_code() as u8);
        }
    };
    abort_on_panic(rank, ranks);
    let MpiCommand::Tpg(args) = &cli.command;
    evolve(args, world)
}

/// Ends the whole job where a rank panics: the others would wait for it for ever.
fn abort_on_panic(rank: usize, ranks: usize) {
    let default = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |info| {
        default(info);
        eprintln!("rank {rank} of {ranks} panicked, and the job ends; --resume continues from the checkpoint");
        std::process::abort();
    }));
}
