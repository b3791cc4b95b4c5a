//! The command line: results on stdout, everything else on stderr.

mod code;
mod convert;
mod examples;
mod expected;
mod generate;
mod graph;
mod limits;
mod numbers;
mod package;
mod policy;
mod prove;
mod quantise;
mod report;
pub mod shell;
mod verify;

use Command::*;
use clap::{CommandFactory, Parser, Subcommand};
use std::ffi::OsString;
use std::path::Path;
use std::process::ExitCode;
use tpg_graph::command::{CommandError, Verdict, be_quiet, exit_code, print};
use tpg_graph::import::Sidecar;

/// Compiles tangled program graphs into C and no_std Rust, and proves the C equal to the graph.
///
/// `tpg-codegen GRAPH` is short for `tpg-codegen generate GRAPH`.
/// Exit status: 0 good, 1 a check failed, 2 bad input, 3 not decided.
#[derive(Debug, Parser)]
#[command(version, arg_required_else_help = true, after_help = examples::ALL)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
    /// Print results and errors only: no progress, no notes, no sentences about success
    #[arg(long, short, global = true)]
    quiet: bool,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Generate code, say how big it is, compare it with the interpreter, and prove the C
    #[command(after_help = examples::GENERATE)]
    Generate(generate::GenerateArgs),
    /// Compile the generated code and compare it with the interpreter
    #[command(after_help = examples::VERIFY)]
    Verify(verify::VerifyArgs),
    /// Report the flash, RAM, stack and operations of a graph's code
    #[command(after_help = examples::REPORT)]
    Report(report::ReportArgs),
    /// Prove that C or machine code decides like the graph, for every input
    #[command(after_help = examples::PROVE)]
    Prove(prove::ProveArgs),
    /// Convert a graph to graph.json
    #[command(after_help = examples::CONVERT)]
    Convert(convert::ConvertArgs),
    /// Write a quantised network, a policy.q.json, as constants of C and Rust
    #[command(after_help = examples::POLICY)]
    Policy(policy::PolicyArgs),
    /// Convert a graph to integers: its inputs and outputs become counts
    #[command(after_help = examples::QUANTISE)]
    Quantise(quantise::QuantiseArgs),
    /// Write a package for Arduino, PlatformIO, ESP-IDF, Zephyr, CMake, Meson or Cargo
    #[command(after_help = examples::PACKAGE)]
    Package(package::PackageArgs),
    /// Print the JSON Schema of graph.json
    #[command(after_help = examples::SCHEMA)]
    Schema,
    /// Print an example sidecar, the description that a .dot file lacks, with a comment on each field
    #[command(after_help = examples::SIDECAR)]
    Sidecar,
    /// Print completions for a shell
    #[command(after_help = examples::COMPLETIONS)]
    Completions(shell::CompletionsArgs),
    /// Print a manual page
    #[command(after_help = examples::MAN)]
    Man(shell::ManArgs),
}

impl Cli {
    /// Reads the command line; `generate` is implied if the first word behind `--quiet` names a file. Another word is taken for a
    /// misspelt command.
    pub fn from_args(args: impl IntoIterator<Item = OsString>) -> Self {
        Self::parse_from(Self::completed(args))
    }

    /// The words of a command line with the command that they imply.
    fn completed(args: impl IntoIterator<Item = OsString>) -> Vec<OsString> {
        let mut args: Vec<OsString> = args.into_iter().collect();
        let command = Self::command();
        let known = |word: &OsString| {
            let names = command.get_subcommands().any(|sub| word.to_str() == Some(sub.get_name()));
            names || ["help", "-h", "--help", "-V", "--version"].iter().any(|&name| word == name)
        };
        let names_a_file = |word: &OsString| {
            let text = word.to_string_lossy();
            text.starts_with('-') || text.contains(['.', '/', '\\']) || Path::new(word).exists()
        };
        let is_quiet = |word: &&OsString| ["-q", "--quiet"].iter().any(|&name| *word == name);
        let first = 1 + args.iter().skip(1).take_while(is_quiet).count();
        if args.get(first).is_some_and(|word| !known(word) && names_a_file(word)) {
            args.insert(first, "generate".into());
        }
        args
    }

    /// Runs the command; errors go to stderr.
    pub fn run(self) -> ExitCode {
        be_quiet(self.quiet);
        exit_code(match self.command {
            Generate(args) => args.run(),
            Verify(args) => args.run(),
            Prove(args) => args.run(),
            Report(args) => args.run(),
            Convert(args) => args.run(),
            Policy(args) => args.run(),
            Package(args) => args.run(),
            Quantise(args) => args.run(),
            Schema => printed(tpg_graph::schema()),
            Command::Sidecar => printed(Sidecar::EXAMPLE),
            Completions(args) => args.run(Self::command()),
            Man(args) => args.run(Self::command()),
        })
    }
}

fn printed(text: impl AsRef<[u8]>) -> Result<Verdict, CommandError> {
    print(text)?;
    Ok(Verdict::Good)
}

#[cfg(test)]
mod tests {
    use super::{Cli, shell};
    use clap::{CommandFactory as _, Parser as _};

    #[test]
    fn every_command_has_examples_and_each_is_accepted() {
        for line in shell::examples(&Cli::command()) {
            let words = line.split_whitespace().map(Into::into);
            assert!(Cli::try_parse_from(Cli::completed(words)).is_ok(), "{line}");
        }
    }
}
