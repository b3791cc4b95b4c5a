//! `tpg-codegen GRAPH`: writes code, reports its size, compares it and proves it.

use super::code::CodeArgs;
use super::verify::checked;
use crate::emit::{Code, File};
use crate::options::Language;
use crate::{explain, size};
use Verdict::*;
use clap::Args;
use std::fs;
use std::path::{Path, PathBuf};
use tpg_graph::command::{self, CommandError, Verdict};
use tpg_graph::output;

/// Generate code.
#[derive(Clone, Debug, Args)]
pub(crate) struct GenerateArgs {
    #[command(flatten)]
    code: CodeArgs,
    /// The output folder, created if it does not exist; - for standard output
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
    /// Write nothing; exit with status 1 if the files in the output folder differ from those that would be written
    #[arg(long)]
    check: bool,
    /// Instead of generating, print the policy as formulas, on standard output or to a file
    #[arg(
        long,
        value_name = "FILE",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "-",
        conflicts_with_all = ["check", "style"]
    )]
    explain: Option<PathBuf>,
    /// Do not compile the code and compare it with the interpreter
    #[arg(long)]
    no_verify: bool,
}

impl GenerateArgs {
    /// Generates.
    ///
    /// # Errors
    /// Bad input, or an output that cannot be written.
    pub(crate) fn run(&self) -> Result<Verdict, CommandError> {
        let (graph, options) = self.code.load()?;
        if let Some(path) = &self.explain {
            return explain_to(path, &explain::explain(&graph, &options));
        }
        let codes: Vec<Code<'_>> = (self.code.lang.languages().iter())
            .map(|&language| self.code.code(&graph, &options, language))
            .collect::<Result<_, _>>()?;
        let files: Vec<&File> = codes.iter().flat_map(|code| &code.files).collect();
        if self.check {
            return Ok(self.stale(&files));
        }
        if self.to_stdout() {
            command::print(joined(&files))?;
        } else {
            let files: Vec<(PathBuf, &str)> =
                files.iter().map(|file| (self.output.join(&file.name), file.text.as_str())).collect();
            output::write_folder(&self.output, &files)?;
            command::print(report(&codes, &files))?;
        }
        if self.no_verify { Ok(Good) } else { self.prove(&codes) }
    }

    fn to_stdout(&self) -> bool {
        self.output == Path::new("-")
    }

    fn prove(&self, codes: &[Code<'_>]) -> Result<Verdict, CommandError> {
        let (sentences, verdict) = checked(codes)?;
        // Standard output holds either the code or the report, never both.
        if self.to_stdout() {
            eprint!("{sentences}");
        } else {
            command::print(sentences)?;
        }
        Ok(verdict)
    }

    fn stale(&self, files: &[&File]) -> Verdict {
        let mut verdict = Good;
        for file in files {
            let path = self.output.join(&file.name);
            match fs::read(&path) {
                Ok(bytes) if bytes == file.text.as_bytes() => {}
                Ok(_) => {
                    eprintln!("{}: stale: not what this graph and these options give", path.display());
                    verdict = Failed;
                }
                Err(error) => {
                    eprintln!("{}: {error}", path.display());
                    verdict = Failed;
                }
            }
        }
        verdict
    }
}

fn explain_to(path: &Path, text: &str) -> Result<Verdict, CommandError> {
    output::write_or_print(path, text)?;
    Ok(Good)
}

/// Tells the change of scalar type, if there was one, the files, and the size of the C; nothing if it shall be quiet.
fn report(codes: &[Code<'_>], files: &[(PathBuf, &str)]) -> String {
    let program = codes.first().map(|code| &code.program);
    let change = program.and_then(|program| Some((program, program.options.conversion.as_ref()?)));
    let change = change.map(|(program, was)| {
        format!("{} instead of {}: {}", program.graph().scalar().name(), was.from.name(), was.agreement)
    });
    let wrote = |(path, text): &(PathBuf, &str)| format!("wrote {} ({} lines)", path.display(), text.lines().count());
    let c = codes.iter().filter(|code| code.program.language == Language::C);
    let sizes = c.flat_map(size::describe_c);
    if command::is_quiet() {
        return String::new();
    }
    change.into_iter().chain(files.iter().map(wrote)).chain(sizes).map(|line| line + "\n").collect()
}

/// The text of one file as it is, of several with a separator that is a comment in C and Rust.
fn joined(files: &[&File]) -> String {
    match files {
        [file] => file.text.clone(),
        _ => files.iter().map(|file| format!("/* ---- {} ---- */\n{}", file.name, file.text)).collect(),
    }
}
