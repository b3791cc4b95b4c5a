//! Records what runs ask their evaluator, and simulates them on up to thousands of ranks.
//!
//! `scaling record --name N -o TRACE -- --problem P --generations 10` runs `tpg-train tpg` on one thread; `scaling simulate
//! TRACE…` prints a table of efficiencies: the time on one thread, divided by ranks and by the time on them.

use clap::{Parser, Subcommand};
use std::path::PathBuf;
use std::process::ExitCode;
use tpg_benches::ranks::{Dealing, Network, alone, simulate};
use tpg_benches::trace::{Recorder, Trace};
use tpg_train::evolution::command::{TpgArgs, execute};

/// Simulates runs on many ranks from recorded costs.
#[derive(Debug, Parser)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Record a run on one thread
    Record {
        /// The name in tables
        #[arg(long)]
        name: String,
        /// The trace, JSON
        #[arg(short, long)]
        output: PathBuf,
        /// Arguments of `tpg-train tpg`
        #[arg(last = true)]
        run: Vec<String>,
    },
    /// Simulate recorded runs
    Simulate {
        /// Traces
        #[arg(required = true)]
        traces: Vec<PathBuf>,
        /// Time of an environment step, microseconds, instead of the recorded time of the units
        #[arg(long)]
        step_us: Option<f64>,
        /// Latency of a message, microseconds
        #[arg(long, default_value_t = 20.0)]
        latency_us: f64,
        /// Bandwidth, gigabytes a second
        #[arg(long, default_value_t = 1.0)]
        bandwidth: f64,
        /// Rank 0's time for a message, microseconds
        #[arg(long, default_value_t = 10.0)]
        message_us: f64,
        /// Rank 0's time for a byte, nanoseconds
        #[arg(long, default_value_t = 10.0)]
        byte_ns: f64,
        /// Numbers of ranks
        #[arg(long, value_delimiter = ',', default_values_t = [1, 2, 4, 16, 64, 256, 1024, 4096])]
        ranks: Vec<usize>,
    },
}

#[derive(Parser)]
struct Run {
    #[command(flatten)]
    args: TpgArgs,
}

fn main() -> ExitCode {
    match run(Cli::parse().command) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(command: Command) -> Result<(), Box<dyn std::error::Error>> {
    match command {
        Command::Record { name, output, run } => {
            let words = ["tpg-train tpg", "--threads", "1"].map(str::to_owned).into_iter().chain(run);
            let Run { args } = Run::parse_from(words);
            let recorder = Recorder::default();
            execute(&args, &recorder)?;
            std::fs::write(output, serde_json::to_vec(&recorder.trace(&name))?)?;
        }
        Command::Simulate { traces, step_us, latency_us, bandwidth, message_us, byte_ns, ranks } => {
            let network = Network {
                latency: latency_us * 1e-6,
                bandwidth: bandwidth * 1e9,
                message: message_us * 1e-6,
                byte: byte_ns * 1e-9,
            };
            for file in traces {
                let trace: Trace = serde_json::from_slice(&std::fs::read(file)?)?;
                println!("{}", table(&with_step(trace, step_us), network, &ranks));
            }
        }
    }
    Ok(())
}

/// Replaces the units' times by their steps.
fn with_step(mut trace: Trace, step_us: Option<f64>) -> Trace {
    if let Some(step) = step_us {
        for unit in trace.questions.iter_mut().flat_map(|question| &mut question.units) {
            unit.seconds = unit.steps.iter().map(|&steps| f64::from(steps)).sum::<f64>() * step * 1e-6;
        }
    }
    trace
}

fn table(trace: &Trace, network: Network, ranks: &[usize]) -> String {
    let questions = trace.questions.len().max(1) as f64;
    let units: usize = trace.questions.iter().map(|question| question.units.len()).sum();
    let own: f64 = trace.questions.iter().map(|question| question.alone).sum();
    let whole = alone(trace, 1.0);
    let mut text = format!(
        "{}: {questions} questions of {:.0} units, {:.2} ms a unit; rank 0 alone {:.2} % of the time on one thread\n\n",
        trace.name,
        units as f64 / questions,
        1e3 * (whole - own) / units.max(1) as f64,
        100.0 * own / whole
    );
    text += "| ranks | time, s | efficiency | whole roots | handed out in advance | without rank 0's own time |\n| --- | --- | --- | --- | --- | --- |\n";
    for &count in ranks {
        let time = |dealing| simulate(trace, count, network, dealing, 1.0);
        let [dynamic, uncut, fixed] = [Dealing::Dynamic, Dealing::Whole, Dealing::Static].map(time);
        let part = |time: f64, whole: f64| 100.0 * whole / (time * count as f64);
        text += &format!(
            "| {count} | {dynamic:.3} | {:.1} % | {:.1} % | {:.1} % | {:.1} % |\n",
            part(dynamic, whole),
            part(uncut, whole),
            part(fixed, whole),
            part(dynamic - own, whole - own)
        );
    }
    text
}
