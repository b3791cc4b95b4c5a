//! `tpg-codegen quantise`: a graph of floats into a graph of whole numbers.

use super::graph::GraphArgs;
use crate::quantise::{Request, quantise};
use clap::Args;
use std::path::PathBuf;
use tpg_graph::Counts;
use tpg_graph::command::{self, CommandError, Verdict};
use tpg_graph::output;
use tpg_graph::states::StateSet;

/// States compared where none are recorded.
const STATES: usize = 20_000;
/// The seed they are drawn with.
const SEED: u64 = 1;

/// Put a graph into integers.
///
/// The graph that comes out sees and answers counts; `generate` compiles it, and `tpg-train eval` plays it.
#[derive(Clone, Debug, Args)]
pub(super) struct QuantiseArgs {
    #[command(flatten)]
    graph: GraphArgs,
    /// The file to write; - for standard output
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// Bits of the inputs
    #[arg(long, value_name = "BITS", default_value_t = 16, value_parser = clap::value_parser!(u32).range(2..=16))]
    inputs: u32,
    /// Bits of the weights
    #[arg(long, value_name = "BITS", default_value_t = 16, value_parser = clap::value_parser!(u32).range(2..=16))]
    weights: u32,
    /// Ranges to scale the inputs to: those of recorded states, a CSV with a column for each value, named as in target[0]; or
    /// the `declared` ranges, which may be wide
    #[arg(long, value_name = "CSV", default_value = "declared")]
    ranges: PathBuf,
    /// Widen the ranges by this factor
    #[arg(long, value_name = "M", default_value_t = 1.0, value_parser = margin)]
    margin: f64,
    /// A value that a sensor delivers in counts of its own, of 16 bits: spin=raw*0.00107, or angle=(raw-2048)*0.0008
    #[arg(long, value_name = "VALUE=FORMULA", value_parser = adc)]
    adc: Vec<(String, Counts)>,
    /// Print the report as one JSON object
    #[arg(long)]
    json: bool,
}

fn margin(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|margin: &f64| *margin > 0.0 && margin.is_finite());
    number.ok_or_else(|| "accepted: a number above 0".to_owned())
}

/// Reads the worth of a sensor's counts.
fn adc(text: &str) -> Result<(String, Counts), String> {
    let parse = || {
        let (name, formula) = text.split_once('=')?;
        let (raw, scale) = formula.split_once('*')?;
        let offset = match raw.trim().strip_prefix('(').and_then(|raw| raw.strip_suffix(')')).unwrap_or(raw.trim()) {
            "raw" => 0.0,
            inner => {
                inner.strip_prefix("raw")?.trim_start().replacen("- ", "-", 1).parse::<f64>().ok().map(|sum| -sum)?
            }
        };
        let scale: f64 = scale.trim().parse().ok()?;
        let is_count = offset.fract() == 0.0 && offset.abs() <= 32_768.0;
        (scale > 0.0 && scale.is_finite() && is_count).then(|| (name.to_owned(), Counts { bits: 16, scale, offset }))
    };
    parse().ok_or_else(|| "accepted: VALUE=raw*SCALE or VALUE=(raw-OFFSET)*SCALE, the scale above 0".to_owned())
}

impl QuantiseArgs {
    pub(super) fn run(&self) -> Result<Verdict, CommandError> {
        let graph = self.graph.load()?;
        let states = match self.ranges.to_str() {
            Some("declared") => StateSet::sampled(&graph, STATES, SEED),
            _ => StateSet::recorded(&graph, &self.ranges)?,
        };
        let Self { inputs, weights, margin, ref adc, .. } = *self;
        let request = Request { inputs, weights, states: &states, margin, given: adc };
        let (whole, report) = quantise(&self.graph.name(), &graph, &request)?;
        let report = if self.json {
            serde_json::to_string(&report).map_err(CommandError::other)? + "\n"
        } else {
            report.to_string()
        };
        if !output::write_or_print(&self.output, &whole.to_json())? {
            command::note(report.trim_end());
        } else if self.json || !command::is_quiet() {
            command::print(report)?;
        }
        Ok(Verdict::Good)
    }
}
