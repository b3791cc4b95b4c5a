//! The program `cortex-bound`.

use clap::Parser;
use cortex_bound::{Analyser, Calls, Listing, LoopBounds, Turns, disassemble};
use std::path::PathBuf;
use std::process::ExitCode;

/// Print the worst case of functions of a Cortex-M object or image, or of a RISC-V or AVR image: instructions, of an AVR cycles, and
/// bytes of stack, including callees.
#[derive(Debug, Parser)]
#[command(version)]
struct Cli {
    /// An object file or a linked image for a Cortex-M, a linked image for a RISC-V or an AVR
    object: PathBuf,
    /// The functions; by default every function of the object
    functions: Vec<String>,
    /// No loop of this function iterates more than N times; several numbers are bounds for each of its loops, in the
    /// order of their first instructions
    #[arg(long, value_name = "FUNCTION=N[,N…]", value_parser = loop_bound)]
    loop_bound: Vec<(String, Turns)>,
    /// Calls through a register in this function reach only these functions
    #[arg(long, value_name = "FUNCTION=CALLEE[,CALLEE…]", value_parser = calls)]
    calls: Vec<(String, Vec<String>)>,
    /// Fail if control flow depends on data: branches, predicated blocks, tables
    #[arg(long)]
    constant_time: bool,
    /// Print one JSON object for each function
    #[arg(long)]
    json: bool,
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    match disassemble(&cli.object) {
        Ok(listing) if cli.report(&listing) => return ExitCode::SUCCESS,
        Ok(_) => {}
        Err(error) => eprintln!("{}: {error}", cli.object.display()),
    }
    ExitCode::FAILURE
}

impl Cli {
    /// Prints the analysis; returns true if every requested function has a bound.
    fn report(&self, listing: &Listing) -> bool {
        let bounds: LoopBounds = self.loop_bound.iter().cloned().collect();
        let calls: Calls = self.calls.iter().cloned().collect();
        let mut analyser = Analyser::new(listing, &bounds).calling(&calls);
        let all = || listing.functions().iter().map(|function| function.name.clone()).collect();
        let names: Vec<String> = if self.functions.is_empty() { all() } else { self.functions.clone() };
        let mut good = true;
        for name in names {
            match analyser.bound(&name) {
                Ok(bound) if self.json => {
                    println!(
                        "{{\"function\":{name:?},\"{}\":{},\"stack_bytes\":{}}}",
                        listing.unit(),
                        bound.instructions,
                        bound.stack
                    );
                }
                Ok(bound) => {
                    println!("{name}: {} {}, {} bytes of stack", bound.instructions, listing.unit(), bound.stack)
                }
                Err(refusal) => {
                    eprintln!("{name}: no bound: {refusal}");
                    // If all functions are analysed, some may lack a bound: their callers show whether that matters.
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

fn loop_bound(text: &str) -> Result<(String, Turns), String> {
    let accepted = || format!("{text:?}; accepted: FUNCTION=N or FUNCTION=N,N,…, whole numbers from 1");
    let (function, numbers) = text.rsplit_once('=').ok_or_else(accepted)?;
    let number = |number: &str| number.parse().ok().filter(|&number| number > 0).ok_or_else(accepted);
    let turns = match numbers.split(',').map(number).collect::<Result<Vec<u64>, _>>()?[..] {
        [every] => Turns::Every(every),
        ref each => Turns::Each(each.to_vec()),
    };
    Ok((function.to_owned(), turns))
}

fn calls(text: &str) -> Result<(String, Vec<String>), String> {
    let accepted = || format!("{text:?}; accepted: FUNCTION=CALLEE or FUNCTION=CALLEE,CALLEE,…");
    let (function, callees) = text.split_once('=').ok_or_else(accepted)?;
    let callees: Vec<String> = callees.split(',').map(str::to_owned).collect();
    if function.is_empty() || callees.iter().any(String::is_empty) {
        Err(accepted())
    } else {
        Ok((function.to_owned(), callees))
    }
}
