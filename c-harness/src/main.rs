//! The firmwares, checked: `cargo xtask qemu` and `cargo xtask size` run this.
//!
//! | module | subject |
//! | --- | --- |
//! | [`problems`] | which episodes, and how graph and network share the arm |
//! | [`build`] | the firmwares in C and Rust |
//! | [`models`] | networks of every kind and size, to count |
//! | [`network`] | a network of another problem than the arm's |
//! | [`closed_loop`] | policies and plants that are graphs |
//! | [`continuous`] | policies that answer with values, and a pendulum |
//! | [`cartpole`] | the shipped policy of CartPole and its plant |
//! | [`dodge`] | the control step among balls, on test scenes |
//! | [`profiles`] | what each profile of any graph takes |
//! | [`emulate`] | QEMU |
//! | [`expected`] | the host's trajectories |
//! | [`record`] | how an episode is written down, here and in the firmware |
//! | [`scenarios`], [`faults`], [`table`] | the table of sensor faults: the table, its run in Rust, its comparison |
//! | [`mod@cores`] | the shipped policies and the hybrid on every core |
//! | [`frameworks`] | the examples in RTIC and Embassy |
//! | [`costs`] | instructions beside `costs.toml` |
//! | [`symbols`] | what must not be in an image |
//! | [`mod@worst`], [`facts`] | the static worst case of a decision, and what it rests on |
//! | [`lint`] | linters on the C that is not generated |
//! | [`size`] | flash and RAM beside `sizes.toml` |

mod build;
mod cartpole;
mod closed_loop;
mod continuous;
mod cores;
mod costs;
mod dodge;
mod emulate;
mod expected;
mod facts;
mod faults;
mod frameworks;
mod line;
mod lint;
mod models;
mod network;
mod problems;
mod profiles;
mod record;
mod scenarios;
mod size;
mod symbols;
mod table;
mod worst;

use build::Board;
use clap::{Parser, Subcommand};
use costs::Costs;
use line::Line;
use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

/// A reason that a check failed or could not be done.
#[derive(Debug)]
pub(crate) struct Failure(String);

impl Failure {
    /// From whatever says why.
    pub(crate) fn new<E: Display>(error: E) -> Self {
        Self(error.to_string())
    }

    /// With the file.
    pub(crate) fn at<E: Display>(path: &Path, error: E) -> Self {
        Self(format!("{}: {error}", path.display()))
    }
}

/// Builds the firmwares, runs them under QEMU and compares them with the host and with committed figures.
#[derive(Debug, Parser)]
#[command(bin_name = "cargo xtask")]
struct Cli {
    #[command(subcommand)]
    command: Check,
}

#[derive(Debug, Subcommand)]
enum Check {
    /// Trajectories, instructions and stack of both firmwares
    Qemu {
        /// Write costs.toml instead of comparing with it
        #[arg(long)]
        update: bool,
    },
    /// Generated C and Rust and the hybrid on every core: as on the host, flash and instructions as in cores.toml
    Cores {
        /// Write cores.toml and docs/cores.md instead of comparing with them
        #[arg(long, conflicts_with = "only")]
        update: bool,
        /// Only cores and boards with this in their name
        #[arg(long, value_name = "TEXT", default_value = "", hide_default_value = true)]
        only: String,
    },
    /// Flash and RAM of the control loop
    Size,
    /// clang-tidy, and cppcheck with its MISRA addon, on the firmwares' and the example's C
    Lint,
    /// Print the parts of a decision's static worst case; runs nothing
    Worst,
    /// Print flash and instructions of every profile of policies on a Cortex-M4F, beside those of `small`
    Profiles {
        /// Policies with actions: graph.json or .dot
        #[arg(required = true)]
        graphs: Vec<PathBuf>,
        /// The artifact that .dot files are of
        #[arg(long, value_enum)]
        profile_of: Option<tpg_graph::import::Profile>,
    },
}

fn main() -> ExitCode {
    let result = match Cli::parse().command {
        Check::Qemu { update } => qemu(update),
        Check::Cores { update, only } => cores::check(update, &only),
        Check::Size => size::check(),
        Check::Lint => lint::sees_what_is_bad().and_then(|()| lint::check()),
        Check::Worst => worst(),
        Check::Profiles { graphs, profile_of } => profiles::table(&graphs, profile_of),
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure(message)) => {
            eprintln!("FAILED: {message}");
            ExitCode::FAILURE
        }
    }
}

/// Builder of a language's image.
type Builder = fn(&str, Board) -> Result<Option<PathBuf>, Failure>;

const LANGUAGES: [(&str, Builder); 2] = [("C", build::c), ("Rust", build::rust)];

fn qemu(update: bool) -> Result<(), Failure> {
    if !tpg_testing::tool("qemu-system-arm", "qemu-system-arm", "the firmwares under QEMU") {
        return Ok(());
    }
    let expected = expected::lines()?;
    if let Some(lines) = on_this_machine("control")? {
        compare("C on this machine", &expected, &lines)?;
    }
    let faults = expected::faults();
    table::check("Rust on this machine", &faults, &faults)?;
    if let Some(lines) = on_this_machine("faults")? {
        table::check("C on this machine", &faults, &lines)?;
    }
    let mut costs = Costs::new();
    let mut all = true;
    for (language, builder) in LANGUAGES {
        let Some(image) = builder("control", Board::Mps2An386)? else {
            all = false;
            continue;
        };
        symbols::check(&image)?;
        let lines = emulate::run(Board::Mps2An386, &image)?;
        compare(language, &expected, &lines)?;
        costs.add(language, &lines);
        size::stack(language, "control", &lines)?;
        worst::check(language, &image, &lines)?;
        if let Some(image) = builder("costs", Board::Mps2An386)? {
            let lines = emulate::run(Board::Mps2An386, &image)?;
            if language == "Rust" {
                let count = models::compare(&lines)?;
                println!("Rust: {count} preferences of networks of every kind: the same bits as on the host");
            }
            costs.add(language, &lines);
        }
        if let Some(image) = builder("faults", Board::Mps2An386)? {
            symbols::check(&image)?;
            let lines = emulate::run(Board::Mps2An386, &image)?;
            table::check(language, &faults, &lines)?;
            costs.add(language, &lines);
        }
        if let Some(image) = builder("network", Board::Mps2An386)? {
            symbols::check(&image)?;
            network::compare(language, &image, &emulate::run(Board::Mps2An386, &image)?)?;
        }
        if let Some(image) = builder("continuous", Board::Mps2An386)? {
            symbols::check(&image)?;
            let lines = emulate::run(Board::Mps2An386, &image)?;
            continuous::compare(language, &image, &lines)?;
            costs.add(language, &lines);
        }
        if let Some(image) = builder("cartpole", Board::Mps2An386)? {
            symbols::check(&image)?;
            let lines = emulate::run(Board::Mps2An386, &image)?;
            cartpole::compare(language, &image, &lines)?;
            costs.add(language, &lines);
        }
        if let Some(image) = builder("dodge", Board::Mps2An386)? {
            symbols::check(&image)?;
            let lines = emulate::run(Board::Mps2An386, &image)?;
            dodge::compare(language, &image, &lines)?;
            size::stack(language, "dodge", &lines)?;
            costs.add(language, &lines);
        }
        fits(language, builder)?;
    }
    frameworks::check()?;
    costs.print();
    if update && all {
        return costs.commit();
    }
    let differences = costs.differences()?;
    if differences.is_empty() { Ok(()) } else { Err(Failure::new(differences.join("\n"))) }
}

/// The lines of a firmware's program in C, run here; `None` where a tool is missing.
fn on_this_machine(program: &str) -> Result<Option<Vec<Line>>, Failure> {
    let Some(image) = build::host(program)? else { return Ok(None) };
    let text = tpg_testing::library::output(&mut Command::new(image)).map_err(|error| Failure(format!("{error:?}")))?;
    Ok(Some(text.lines().map(Line::parse).collect()))
}

/// The worst cases in parts.
fn worst() -> Result<(), Failure> {
    let mut failures = Vec::new();
    for (language, builder) in LANGUAGES {
        if let Some(image) = builder("control", Board::Mps2An386)? {
            println!("\n{language}: {}", image.display());
            failures.extend(worst::explain(language, &image).err().map(|Failure(message)| message));
        }
    }
    if failures.is_empty() { Ok(()) } else { Err(Failure(failures.join("\n"))) }
}

/// The board with little memory runs the same episodes to the same ends.
fn fits(language: &str, builder: Builder) -> Result<(), Failure> {
    let Some(image) = builder("control", Board::NetduinoPlus2)? else { return Ok(()) };
    let lines = emulate::run(Board::NetduinoPlus2, &image)?;
    compare(&format!("{language} on netduinoplus2"), &expected::lines()?, &lines)
}

/// Checks that every episode is as on the host: its end, the actions of each policy, and a hash of every motor position.
fn compare(language: &str, expected: &[Line], lines: &[Line]) -> Result<(), Failure> {
    let found = lines.iter().filter(|line| line.words.first().is_some_and(|word| word == "episode"));
    let found: Vec<Line> = found.map(|line| line.without(&["instructions", "worst"])).collect();
    if let Some((wanted, found)) = expected.iter().zip(&found).find(|(wanted, found)| wanted != found) {
        return Err(Failure::new(format!("{language} is not the host: {found:?}, not {wanted:?}")));
    }
    if found.len() != expected.len() {
        return Err(Failure::new(format!("{language}: {} episodes, not {}", found.len(), expected.len())));
    }
    let actions: u64 = found.iter().map(|line| line.number("actions")).sum();
    println!("{language}: {} episodes, {actions} actions: every position as on the host", found.len());
    Ok(())
}
