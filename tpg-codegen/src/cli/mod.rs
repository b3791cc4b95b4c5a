//! The command line: results on stdout, everything else on stderr.

mod code;
mod convert;
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
#[command(
    version,
    arg_required_else_help = true,
    after_help = "Examples:
  tpg-codegen runs/pole/graph.json --prefix pole -o out
  tpg-codegen report runs/pole/graph.json"
)]
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
    #[command(after_help = "Examples:
  tpg-codegen generate graph.json --lang c --profile small -o firmware
  tpg-codegen generate graph.json --fixed 16 -o firmware
  tpg-codegen generate graph.json --explain
  tpg-codegen generate graph.json -o firmware --check")]
    Generate(generate::GenerateArgs),
    /// Compile the generated code and compare it with the interpreter
    #[command(after_help = "Examples:
  tpg-codegen verify graph.json
  tpg-codegen verify graph.json --lang c --profile fast --states 1000000
  tpg-codegen verify policy.dot --sidecar policy.toml --expect recorded.csv")]
    Verify(verify::VerifyArgs),
    /// Report the flash, RAM, stack and operations of a graph's code
    #[command(after_help = "Examples:
  tpg-codegen report graph.json
  tpg-codegen report graph.json --target m0,esp32-c3 --fixed 16
  tpg-codegen report graph.json --target rp2040 --max-flash 4096 --max-instructions 5000")]
    Report(report::ReportArgs),
    /// Prove that C or machine code decides like the graph, for every input
    #[command(after_help = "Examples:
  tpg-codegen prove graph.json
  tpg-codegen prove graph.json --source firmware/pole.c --certificate pole.proof.json
  tpg-codegen prove graph.json --object pole.o --symbol pole_infer")]
    Prove(prove::ProveArgs),
    /// Convert a graph to graph.json
    #[command(after_help = "Examples:
  tpg-codegen convert policy.dot --sidecar policy.toml graph.json")]
    Convert(convert::ConvertArgs),
    /// Write a quantised network, a policy.q.json, as constants of C and Rust
    #[command(after_help = "Examples:
  tpg-codegen policy policy.q.json --lang c --prefix actor -o firmware")]
    Policy(policy::PolicyArgs),
    /// Convert a graph to integers: its inputs and outputs become counts
    #[command(after_help = "Examples:
  tpg-codegen quantise graph.json -o whole.json
  tpg-codegen quantise graph.json --inputs 12 --weights 8 --ranges visited.csv -o whole.json
  tpg-codegen generate whole.json --lang c -o firmware")]
    Quantise(quantise::QuantiseArgs),
    /// Write a package for Arduino, PlatformIO, ESP-IDF, Zephyr, CMake, Meson or Cargo
    #[command(after_help = "Examples:
  tpg-codegen package graph.json --for cmake --prefix arm -o arm
  tpg-codegen package graph.json --for arduino --prefix arm --author Ada -o libraries/arm
  tpg-codegen package graph.json --for cargo --prefix arm --license MIT --license-file LICENSE -o arm")]
    Package(package::PackageArgs),
    /// Print the JSON Schema of graph.json
    #[command(after_help = "Examples:
  tpg-codegen schema")]
    Schema,
    /// Print an example sidecar, the description that a .dot file lacks, with a comment on each field
    #[command(after_help = "Examples:
  tpg-codegen sidecar")]
    Sidecar,
    /// Print completions for a shell
    #[command(after_help = "Examples:
  tpg-codegen completions bash
  tpg-codegen completions zsh")]
    Completions(shell::CompletionsArgs),
    /// Print a manual page
    #[command(after_help = "Examples:
  tpg-codegen man
  tpg-codegen man report")]
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
