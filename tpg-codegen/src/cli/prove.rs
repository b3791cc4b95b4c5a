//! `tpg-codegen prove`: code decides like the graph, for every input.

use super::graph::GraphArgs;
use crate::emit::{Code, Language, Options, Prefix, Profile, Style};
use Verdict::*;
use clap::Args;
use std::cell::RefCell;
use std::fs;
use std::path::{Path, PathBuf};
use tpg_graph::command::{self, CommandError, Verdict};
use tpg_graph::error::{InputError, Place};
use tpg_graph::output;
use tpg_prove::c;
use tpg_prove::execute::Object;
use tpg_prove::graph::Graph;
use tpg_prove::input::Missing;
use tpg_prove::product::{Effort, Queries};
use tpg_prove::proof::{self, Proof};

/// Prove that code decides like the graph, for every input, NaN and infinities included.
///
/// The prover shares nothing with the compiler: it reads the graph, the C and the machine code by itself. Without --source and
/// --object, the C that `generate` writes is proven, in every profile.
/// Exit status: 0 proven, 1 different (a state is printed), 2 bad input, 3 not decided (what is missing is printed).
#[derive(Clone, Debug, Args)]
pub(super) struct ProveArgs {
    #[command(flatten)]
    graph: GraphArgs,
    /// A file of C with the policy's function
    #[arg(long, value_name = "C", conflicts_with = "object")]
    source: Option<PathBuf>,
    /// An object for a Cortex-M with single-precision floating point
    #[arg(long, value_name = "O", requires = "symbol")]
    object: Option<PathBuf>,
    /// The name of the function [default in C: the one that ends in _infer]
    #[arg(long, value_name = "S")]
    symbol: Option<String>,
    /// Prove it only for states in the declared ranges
    #[arg(long)]
    assume_ranges: bool,
    /// Write a certificate as JSON: file hashes, proof statistics, applied rules and assumptions
    #[arg(long, value_name = "FILE")]
    certificate: Option<PathBuf>,
    /// Write each step of the proof as a question to solvers, in SMT-LIB: all that is proven is `unsat`
    #[arg(long, value_name = "DIR")]
    smt_lib: Option<PathBuf>,
}

/// Files by their names, for a certificate.
type Files = Vec<(String, Vec<u8>)>;

impl ProveArgs {
    pub(super) fn run(&self) -> Result<Verdict, CommandError> {
        if self.symbol.is_some() && self.source.is_none() && self.object.is_none() {
            let accepted = "it with --source or --object";
            return Err(InputError::new("--symbol", Place::Whole, "no code", accepted).into());
        }
        let loaded = self.graph.load()?;
        let text = loaded.to_json();
        let name = self.graph.name();
        let graph = match Graph::read(&name, &text) {
            Ok(graph) => graph,
            Err(error) => {
                command::print(format!("not decided: {error}\n"))?;
                return Ok(Undecided);
            }
        };
        let mut proofs: Vec<(String, Proof, Files)> = Vec::new();
        // Numbered, over all proofs.
        let questions = RefCell::new(Vec::new());
        let ask = |script: String| {
            let mut questions = questions.borrow_mut();
            let name = PathBuf::from(format!("{:05}.smt2", questions.len()));
            questions.push((name, script));
        };
        let queries: Queries<'_> = self.smt_lib.as_ref().map(|_| &ask as &dyn Fn(String));
        // A long proof says what it has found so far.
        let mut add = |code: String, proof: Proof, files: Files| {
            command::print(format!("{code}: {proof}\n"))?;
            proofs.push((code, proof, [vec![(name.clone(), text.clone().into_bytes())], files].concat()));
            Ok::<(), CommandError>(())
        };
        match (&self.source, &self.object) {
            (Some(path), _) => {
                let bytes = read(path)?;
                let source = String::from_utf8_lossy(&bytes);
                let read = || c::read(path, &source, self.symbol.as_deref(), graph.interface());
                let proof = proof::prove(&graph, &read, self.assume_ranges, Effort::default(), queries);
                let file = path.display().to_string();
                add(file.clone(), proof, vec![(file, bytes)])?;
            }
            (None, Some(path)) => {
                let bytes = read(path)?;
                let file = path.display().to_string();
                let symbol = self.symbol.as_deref().unwrap_or_default();
                let object = || Object::new(&bytes, symbol, graph.interface().clone());
                let accepted = "an object for ARM with that function";
                object().map_err(|error| InputError::new(&*file, Place::Whole, error.to_string(), accepted))?;
                let read = || object().map_err(|error| Missing::new(&*file, error.to_string()));
                let proof = proof::prove(&graph, &read, self.assume_ranges, Effort::default(), queries);
                add(file.clone(), proof, vec![(file.clone(), bytes.clone())])?;
            }
            (None, None) => {
                for profile in Profile::ALL {
                    let prefix = Prefix::of_file(&self.graph.graph);
                    let options = Options { style: Style::Pure, profile: Some(profile), ..Options::new(prefix) };
                    let code = Code::of_graph(&name, &loaded, &options, Language::C)?;
                    let proof = of_code(&code, &graph, self.assume_ranges, Effort::default(), queries);
                    let files = code.files.iter().map(|file| (file.name.clone(), file.text.clone().into_bytes()));
                    add(code.program.name(), proof, files.collect())?;
                }
            }
        }
        if let Some(path) = &self.certificate {
            self.certify(path, &proofs)?;
        }
        if let Some(folder) = &self.smt_lib {
            let files: Vec<_> =
                questions.take().into_iter().map(|(name, script)| (folder.join(name), script)).collect();
            output::write_folder(folder, &files)?;
        }
        let verdicts = proofs.iter().map(|(_, proof, _)| match proof.verdict {
            proof::Verdict::Proven => Good,
            proof::Verdict::Different(_) => Failed,
            proof::Verdict::Undecided(_) => Undecided,
        });
        Ok(verdicts
            .max_by_key(|verdict| match verdict {
                Failed => 2,
                Undecided => 1,
                _ => 0,
            })
            .unwrap_or(Good))
    }

    fn certify(&self, path: &Path, proofs: &[(String, Proof, Files)]) -> Result<(), CommandError> {
        let more: &[&str] = if self.object.is_some() {
            &["the processor executes instructions as the ARM v7-M manual says, with the default FPSCR"]
        } else {
            &[
                "the C compiler keeps to C99 and IEEE 754, has an int of 32 bits, of counts 16 or more, and defines no macro that the text asks for",
            ]
        };
        let certificates: Vec<_> = (proofs.iter())
            .map(|(_, proof, files)| {
                let files: Vec<_> = files.iter().map(|(name, bytes)| (name.as_str(), bytes.as_slice())).collect();
                proof.certificate(&files, more)
            })
            .collect();
        let text = match &certificates[..] {
            [only] => format!("{only:#}\n"),
            all => format!("{:#}\n", serde_json::Value::from(all.to_vec())),
        };
        Ok(output::write_atomically(path, text.as_bytes())?)
    }
}

fn read(path: &Path) -> Result<Vec<u8>, InputError> {
    fs::read(path).map_err(|error| InputError::io(path, &error, "a file that can be read"))
}

/// Proves generated C.
fn of_code(code: &Code<'_>, graph: &Graph, assume_ranges: bool, effort: Effort, queries: Queries<'_>) -> Proof {
    let text = |name: &str| code.files.iter().find(|file| file.name == name).map(|file| file.text.clone());
    let read = || {
        let source = code.files.iter().find(|file| file.name.ends_with(".c"));
        let source = source.ok_or_else(|| Missing::new(code.program.name(), "a file of C"))?;
        c::read_with(&source.name, &source.text, &text, None, graph.interface())
    };
    proof::prove(graph, &read, assume_ranges, effort, queries)
}

/// The work that `generate` and `package` do for a proof: that of some seconds at most.
const QUICK: Effort = Effort { cases: 200_000, pairs: 5_000 };

/// Sentences about generated code: proven for all inputs, or different. Nothing where that is not decided.
pub(super) fn proven(codes: &[Code<'_>]) -> (String, Verdict) {
    let (mut text, mut verdict) = (String::new(), Good);
    for code in codes {
        let options = &code.program.options;
        if code.program.language != Language::C || options.style != Style::Pure {
            continue;
        }
        let Ok(graph) = Graph::read("graph.json", &code.program.graph().to_json()) else { continue };
        let proof = of_code(code, &graph, false, QUICK, None);
        match proof.verdict {
            proof::Verdict::Undecided(_) => continue,
            proof::Verdict::Different(_) => verdict = Failed,
            proof::Verdict::Proven => {}
        }
        let images = if code.program.graph().sees() { "; what it reads from images is compared" } else { "" };
        text += &format!("{}: {proof}{images}\n", code.program.name());
    }
    (text, verdict)
}
