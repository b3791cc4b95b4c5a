//! `cargo xtask wcet`.

use clap::Args;
use std::path::PathBuf;
use xtask::wcet::{Analyser, Listing, LoopBounds, disassemble};

/// Print the worst case of functions of a Cortex-M object or image: instructions and bytes of stack, callees included.
#[derive(Clone, Debug, Args)]
pub(crate) struct WcetArgs {
    /// An object file or a linked image for a Cortex-M
    object: PathBuf,
    /// The functions; without one, every function of the object
    functions: Vec<String>,
    /// No loop of this function turns more than N times
    #[arg(long, value_name = "FUNCTION=N", value_parser = loop_bound)]
    loop_bound: Vec<(String, u64)>,
    /// Fail where anything decides by data what runs: branches, predicated blocks, tables
    #[arg(long)]
    constant_time: bool,
    /// Print one JSON object for each function
    #[arg(long)]
    json: bool,
}

impl WcetArgs {
    /// Analyses; whether every function that was asked for has a bound.
    pub(crate) fn run(&self) -> bool {
        match disassemble(&self.object) {
            Ok(listing) => self.report(&listing),
            Err(error) => {
                eprintln!("{}: {error}", self.object.display());
                false
            }
        }
    }

    fn report(&self, listing: &Listing) -> bool {
        let bounds: LoopBounds = self.loop_bound.iter().cloned().collect();
        let mut analyser = Analyser::new(listing, &bounds);
        let all = || listing.functions().iter().map(|function| function.name.clone()).collect();
        let names: Vec<String> = if self.functions.is_empty() { all() } else { self.functions.clone() };
        let mut good = true;
        for name in names {
            match analyser.bound(&name) {
                Ok(bound) if self.json => {
                    println!(
                        "{{\"function\":{name:?},\"instructions\":{},\"stack_bytes\":{}}}",
                        bound.instructions, bound.stack
                    );
                }
                Ok(bound) => println!("{name}: {} instructions, {} bytes of stack", bound.instructions, bound.stack),
                Err(refusal) => {
                    eprintln!("{name}: no bound: {refusal}");
                    // Of all functions, some have none: their callers say whether that matters.
                    good &= self.functions.is_empty();
                }
            }
            if self.constant_time {
                match analyser.decisions(&name) {
                    Ok(sites) => {
                        good &= sites.is_empty();
                        for site in sites {
                            eprintln!(
                                "{name}: not constant: {} at {:#x} in {}",
                                site.text, site.address, site.function
                            );
                        }
                    }
                    Err(refusal) => {
                        eprintln!("{name}: {refusal}");
                        good = false;
                    }
                }
            }
        }
        good
    }
}

fn loop_bound(text: &str) -> Result<(String, u64), String> {
    let accepted = || format!("{text:?}; accepted: FUNCTION=N, N a whole number from 1");
    let (function, number) = text.rsplit_once('=').ok_or_else(accepted)?;
    let number: u64 = number.parse().ok().filter(|&number| number > 0).ok_or_else(accepted)?;
    Ok((function.to_owned(), number))
}
