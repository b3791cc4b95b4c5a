//! The command line: results on stdout, everything else on stderr.

use crate::arm_import::{ArmArgs, execute as execute_arm};
use crate::configuration::print::{ConfigArgs, print_config};
use crate::evaluate::{EvalArgs, eval};
use crate::evolution::command::{TpgArgs, execute as execute_tpg};
use crate::hybrid::command::{HybridArgs, execute as execute_hybrid};
use crate::problems::print_problems;
use crate::quantise::{QuantiseArgs, quantise};
use crate::report::{ReportArgs, report_with};
use crate::run_args::RunArgs;
use crate::sac::command::execute as execute_sac;
use crate::sac::import::{ImportArgs, import};
use clap::{CommandFactory as _, Parser, Subcommand};
use std::process::ExitCode;
use tpg_codegen::shell::{CompletionsArgs, ManArgs};
use tpg_graph::command::{CommandError, Verdict, be_quiet, exit_code};
use tpg_graph::error::InputError;

/// Trains policies for control problems: tangled program graphs, soft actor-critics, and hybrids of both.
///
/// Exit status: 0 good, 1 a check failed, 2 bad input, 130 stopped by Ctrl-C (the run can be resumed).
#[derive(Debug, Parser)]
#[command(
    version,
    after_help = "Examples:
  tpg-train problems
  tpg-train tpg --problem cartpole --target 475 --out runs/pole
  tpg-train report runs/pole"
)]
pub struct Cli {
    #[command(subcommand)]
    command: Command,
    /// Print results, warnings and errors only: no progress, no notes
    #[arg(long, short, global = true)]
    quiet: bool,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// List the built-in problems, with what they observe and do
    #[command(after_help = "Examples:
  tpg-train problems")]
    Problems,
    /// Evolve a tangled program graph
    #[command(after_help = "Examples:
  tpg-train tpg --problem cartpole --target 475 --out runs/pole
  tpg-train tpg --problem pendulum --seeds 1..6 --out runs/pendulum
  tpg-train tpg --problem cartpole --preset quick --set tpg.nb_roots=40 --max-steps 1000000 --out runs/quick
  tpg-train tpg --config my.toml --generations 400 --out runs/mine --resume")]
    Tpg(TpgArgs),
    /// Train a soft actor-critic
    #[command(after_help = "Examples:
  tpg-train sac --problem pendulum --out runs/sac")]
    Sac(RunArgs),
    /// Find the best hybrid of graphs and networks
    #[command(after_help = "Examples:
  tpg-train hybrid --problem rs --tpg runs/graph/graph.json --policy runs/sac/policy.safetensors --out runs/study")]
    Hybrid(HybridArgs),
    /// Convert an actor of Stable-Baselines3 or CleanRL to a policy
    #[command(after_help = "Examples:
  tpg-train import actor.safetensors --problem pendulum --out policy.safetensors")]
    Import(ImportArgs),
    /// Put a policy into integers: a network, or a graph with the fewest bits that keep its return
    #[command(after_help = "Examples:
  tpg-train quantise runs/pole/graph.json --out whole.json
  tpg-train quantise runs/sac/policy.safetensors --out policy.q.json")]
    Quantise(QuantiseArgs),
    /// Run a policy and count how its episodes end
    #[command(after_help = "Examples:
  tpg-train eval --problem cartpole --tpg runs/pole/graph.json
  tpg-train eval --problem fs --policy planner --episodes 100 --json")]
    Eval(EvalArgs),
    /// Write one HTML report about runs
    #[command(after_help = "Examples:
  tpg-train report runs/pole runs/pendulum --out report.html")]
    Report(ReportArgs),
    /// Print a commented configuration
    #[command(after_help = "Examples:
  tpg-train config quick
  tpg-train config --list")]
    Config(ConfigArgs),
    /// Describe arms, from their URDF
    #[command(after_help = "Examples:
  tpg-train arm import so101.urdf --tip gripper_frame_link --fix wrist_roll=0 -o arm.toml")]
    Arm(ArmArgs),
    /// Print completions for a shell
    #[command(after_help = "Examples:
  tpg-train completions bash
  tpg-train completions fish")]
    Completions(CompletionsArgs),
    /// Print a manual page
    #[command(after_help = "Examples:
  tpg-train man
  tpg-train man tpg")]
    Man(ManArgs),
}

impl Cli {
    /// Runs the command and prints errors to stderr.
    pub fn run(self) -> ExitCode {
        be_quiet(self.quiet);
        exit_code(match self.command {
            Command::Problems => good(print_problems()),
            Command::Tpg(args) => execute_tpg(&args, None).map_err(CommandError::other),
            Command::Sac(args) => execute_sac(&args).map_err(CommandError::other),
            Command::Hybrid(args) => execute_hybrid(&args).map_err(CommandError::from),
            Command::Import(args) => good(import(&args)),
            Command::Quantise(args) => good(quantise(&args)),
            Command::Eval(args) => good(eval(&args)),
            Command::Report(args) => good(report_with(&args, None)),
            Command::Config(args) => good(print_config(&args)),
            Command::Arm(args) => good(execute_arm(&args)),
            Command::Completions(args) => args.run(Self::command()),
            Command::Man(args) => args.run(Self::command()),
        })
    }
}

fn good(result: Result<(), InputError>) -> Result<Verdict, CommandError> {
    result.map(|()| Verdict::Good).map_err(CommandError::from)
}

#[cfg(test)]
mod tests {
    use super::Cli;
    use clap::{CommandFactory as _, Parser as _};
    use tpg_codegen::shell;

    #[test]
    fn every_command_has_examples_and_each_is_accepted() {
        for line in shell::examples(&Cli::command()) {
            let parsed = Cli::try_parse_from(line.split_whitespace());
            assert!(parsed.is_ok(), "{line}: {}", parsed.err().map(|error| error.to_string()).unwrap_or_default());
        }
    }
}
