//! Writes what the page shows beside the module: the policies as formulas, their bids as tables, and measured costs.

mod data;
mod policies;

use clap::Parser;
use std::path::PathBuf;
use std::process::ExitCode;
use std::{fs, io};

/// Writes what the page shows of the shipped policies: formulas and measured costs, as JSON.
#[derive(Debug, Parser)]
struct PageCli {
    /// The file
    #[arg(long, short)]
    out: PathBuf,
}

fn main() -> ExitCode {
    let PageCli { out } = PageCli::parse();
    let place = |error| io::Error::other(format!("{}: {error}", out.display()));
    match data::text().and_then(|text| fs::write(&out, text).map_err(place)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}
