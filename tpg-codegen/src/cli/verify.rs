//! `tpg-codegen verify`: interpreter = C = Rust, state by state.

use super::code::CodeArgs;
use super::expected::Expected;
use super::prove::proven;
use crate::emit::Code;
use crate::options::Options;
use crate::verify::{Comparison, Proof, Unproven};
use clap::Args;
use std::fmt::Write as _;
use std::num::NonZero;
use std::path::PathBuf;
use tpg_graph::command::{self, CommandError, Verdict};
use tpg_graph::progress::Bar;

/// Compile the generated code and compare it with the interpreter.
///
/// Without --lang, --style and --profile, all code that can be generated from the graph.
#[derive(Clone, Debug, Args)]
pub(super) struct VerifyArgs {
    #[command(flatten)]
    code: CodeArgs,
    /// The number of states to compare: in the declared ranges, at their ends, and beyond, with NaN, infinities and
    /// denormals
    #[arg(long, default_value_t = NonZero::new(100_000).expect("a number above 0"), value_name = "N")]
    states: NonZero<usize>,
    /// The seed of the states
    #[arg(long, default_value_t = 1, value_name = "S")]
    seed: u64,
    /// A CSV file with states and the actions that another tool took for them: the interpreter must take the same. A
    /// column for each value of the state by its name, `x[0]`, and a column `action`, or one for each output
    #[arg(long, value_name = "CSV")]
    expect: Option<PathBuf>,
    /// Print one JSON object
    #[arg(long)]
    json: bool,
}

impl VerifyArgs {
    pub(super) fn run(&self) -> Result<Verdict, CommandError> {
        let (graph, options) = self.code.load()?;
        let expected = self.expect.as_deref().map(|path| Expected::check(path, &graph)).transpose()?;
        let codes: Vec<Code<'_>> = (self.code.shapes(&graph).into_iter())
            .map(|(language, style, profile)| {
                self.code.code(&graph, &Options { style, profile, ..options.clone() }, language)
            })
            .collect::<Result<_, _>>()?;
        let proof = prove(&codes, self.states.get(), self.seed)?;
        if self.json {
            let Proof { comparisons, unproven } = &proof;
            let sha256 = codes.first().map(|code| code.program.graph_sha256());
            let text = serde_json::json!({
                "graph_sha256": sha256, "expected": expected, "comparisons": comparisons, "unproven": unproven,
            });
            command::print(format!("{text}\n"))?;
        } else {
            let expected = expected.as_ref().filter(|expected| expected.differences > 0 || !command::is_quiet());
            let expected = expected.map_or_else(String::new, |expected| format!("{expected}\n"));
            command::print(expected + &sentences(&proof))?;
        }
        let as_recorded = expected.is_none_or(|expected| expected.differences == 0);
        Ok(if as_recorded { verdict(&proof) } else { Verdict::Failed })
    }
}

/// Compares code with the interpreter, and reports code that could not be compared on stderr.
fn prove(codes: &[Code<'_>], states: usize, seed: u64) -> Result<Proof, CommandError> {
    let bar = Bar::begin();
    let watch = |done: usize, next: String| bar.show(done as u64, codes.len() as u64, || next);
    let proof = Proof::of_watched(codes, states, seed, &watch);
    drop(bar);
    let proof = proof.map_err(|error| CommandError::Failed(format!("not verified: {error}")))?;
    for Unproven { engine, error } in &proof.unproven {
        eprintln!("not verified: {engine}: {error}");
    }
    Ok(proof)
}

/// States compared after writing code; `verify` compares more.
const FEW: usize = 10_000;
/// The seed they are drawn with.
const SEED: u64 = 1;

/// Compares and proves the texts that were written, and no others: sentences about them, and the verdict.
pub(super) fn checked(codes: &[Code<'_>]) -> Result<(String, Verdict), CommandError> {
    let proof = prove(codes, FEW, SEED)?;
    let (proven, of_all) = proven(codes);
    let told = if of_all == Verdict::Failed || !command::is_quiet() { &*proven } else { "" };
    let verdict = if of_all == Verdict::Failed { of_all } else { verdict(&proof) };
    Ok((sentences(&proof) + told, verdict))
}

fn verdict(proof: &Proof) -> Verdict {
    if proof.holds() { Verdict::Good } else { Verdict::Failed }
}

/// A line for each comparison; if the program shall be quiet, for each that found a difference.
fn sentences(proof: &Proof) -> String {
    let told = proof.comparisons.iter().filter(|comparison| comparison.differences > 0 || !command::is_quiet());
    told.fold(String::new(), |mut text, comparison| {
        let _ = writeln!(text, "{}", sentence(comparison));
        text
    })
}

fn sentence(comparison: &Comparison) -> String {
    let Comparison { engine, states, differences, first } = comparison;
    match first {
        None => format!("{engine} = interpreter on {states} states"),
        Some(first) => format!(
            "{engine} differs from the interpreter on {differences} of {states} states; the first, number {}: \
             {} instead of {} for [{}]",
            first.index,
            first.found,
            first.expected,
            first.state.join(", ")
        ),
    }
}
