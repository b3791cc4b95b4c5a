//! Writes what the page shows beside the module: the policies as formulas, measured costs, and the tables behind lit bids.

mod bids;
mod data;
mod policies;

use clap::{Parser, Subcommand};
use policies::top;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::{fs, io};

/// Writes what the page shows of the shipped policies.
#[derive(Debug, Parser)]
struct PageCli {
    #[command(subcommand)]
    command: PageCommand,
}

#[derive(Debug, Subcommand)]
enum PageCommand {
    /// Write `web/src/bids.rs`: the bids of the policies as tables
    Bids {
        /// The file [default: that of the repository]
        #[arg(long, short)]
        out: Option<PathBuf>,
    },
    /// Write the policies as formulas and the measured costs, as JSON
    Data {
        /// The file
        #[arg(long, short)]
        out: PathBuf,
    },
}

fn main() -> ExitCode {
    let written = match PageCli::parse().command {
        PageCommand::Bids { out } => write(&out.unwrap_or_else(|| top().join("web/src/bids.rs")), bids::text()),
        PageCommand::Data { out } => write(&out, data::text()),
    };
    match written {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn write(path: &Path, text: io::Result<String>) -> io::Result<()> {
    fs::write(path, text?).map_err(|error| io::Error::other(format!("{}: {error}", path.display())))
}
