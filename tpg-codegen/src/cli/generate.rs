//! `tpg-codegen GRAPH`: writes the code and says what it is.

use super::scalar::{Chosen, ScalarArgs, StatesArgs};
use super::{CliError, GraphArgs, Verdict, verify};
use crate::emit::{self, File, Language, Options, Prefix, Profile, Style};
use crate::passes::interval::Assumption;
use crate::size::Target;
use crate::{explain, size};
use clap::{Args, ValueEnum};
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use tpg_graph::Graph;
use tpg_graph::output;

/// States compared after generating; `verify` compares more.
const STATES: usize = 10_000;

/// Generate code.
#[derive(Clone, Debug, Args)]
pub struct GenerateArgs {
    #[command(flatten)]
    graph: GraphArgs,
    /// The language to generate
    #[arg(long, value_enum, default_value_t = LanguageArg::All)]
    lang: LanguageArg,
    /// The interface of the C
    #[arg(long, value_enum, default_value_t = Style::Pure)]
    style: Style,
    /// What the code is good at [default: fast in C, constant-time in Rust]
    #[arg(long, value_enum)]
    profile: Option<Profile>,
    /// Believe the declared ranges of the inputs: a state outside of them may get another action than the interpreter's
    #[arg(long)]
    assume_ranges: bool,
    #[command(flatten)]
    scalar: ScalarArgs,
    #[command(flatten)]
    states: StatesArgs,
    /// What every generated name begins with [default: from the file's name]
    #[arg(long, value_name = "NAME")]
    prefix: Option<Prefix>,
    /// The folder to write to, made where it does not exist; - for standard output
    #[arg(short, long, value_name = "DIR", default_value = ".")]
    output: PathBuf,
    /// Write nothing; exit 1 when the files there are not what would be written
    #[arg(long)]
    check: bool,
    /// Refuse, with exit status 1, where the C compiled for a Cortex-M4F takes more flash
    #[arg(long, value_name = "BYTES")]
    max_flash: Option<u64>,
    /// Instead of generating, say what each pass removed and what every team computes, on standard output or in a file
    #[arg(
        long,
        value_name = "FILE",
        num_args = 0..=1,
        require_equals = true,
        default_missing_value = "-",
        conflicts_with_all = ["check", "max_flash", "style"]
    )]
    explain: Option<PathBuf>,
    /// Do not compile the code and compare it with the interpreter
    #[arg(long)]
    no_verify: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum LanguageArg {
    C,
    Rust,
    All,
}

impl GenerateArgs {
    /// Generates.
    ///
    /// # Errors
    /// Bad input, or an output that cannot be written.
    pub fn run(&self) -> Result<Verdict, CliError> {
        let Chosen { graph, conversion } = match self.scalar.choose(&self.graph, self.graph.load()?, &self.states)? {
            Ok(chosen) => chosen,
            Err(verdict) => return Ok(verdict),
        };
        let prefix = self.prefix.clone().unwrap_or_else(|| Prefix::of_file(&self.graph.graph));
        let assumption = if self.assume_ranges { Assumption::DeclaredRanges } else { Assumption::Nothing };
        let trace = self.states.recorded(&graph)?;
        let (style, profile) = (self.style, self.profile);
        let options = Options { style, profile, assumption, conversion, trace, ..Options::new(prefix) };
        if let Some(path) = &self.explain {
            let text = explain::explain(&graph, &options);
            if path == Path::new("-") {
                io::stdout().lock().write_all(text.as_bytes()).map_err(CliError::other)?;
            } else {
                output::write_atomically(path, text.as_bytes())?;
            }
            return Ok(Verdict::Good);
        }
        if let Some(limit) = self.max_flash {
            if self.lang == LanguageArg::Rust {
                return Err(CliError::Other(
                    "--max-flash measures the C; accepted with --lang c and --lang all".to_owned(),
                ));
            }
            if !fits(&graph, &options, Target::CortexM4, limit) {
                return Ok(Verdict::Failed);
            }
        }
        let files: Vec<File> =
            self.languages().iter().flat_map(|&language| emit::emit(&graph, language, &options)).collect();
        if self.output == Path::new("-") {
            print(&files).map_err(CliError::other)?;
            return Ok(Verdict::Good);
        }
        if self.check {
            return Ok(self.stale(&files));
        }
        let files: Vec<(PathBuf, &str)> =
            files.iter().map(|file| (self.output.join(&file.name), file.text.as_str())).collect();
        output::write_folder(&self.output, &files)?;
        self.tell(&graph, &options, &files)
    }

    fn languages(&self) -> &'static [Language] {
        match self.lang {
            LanguageArg::C => &[Language::C],
            LanguageArg::Rust => &[Language::Rust],
            LanguageArg::All => &[Language::C, Language::Rust],
        }
    }

    fn stale(&self, files: &[File]) -> Verdict {
        let mut verdict = Verdict::Good;
        for file in files {
            let path = self.output.join(&file.name);
            match fs::read(&path) {
                Ok(bytes) if bytes == file.text.as_bytes() => {}
                Ok(_) => {
                    eprintln!("{}: stale: not what this graph and these options give", path.display());
                    verdict = Verdict::Failed;
                }
                Err(error) => {
                    eprintln!("{}: {error}", path.display());
                    verdict = Verdict::Failed;
                }
            }
        }
        verdict
    }

    fn tell(&self, graph: &Graph, options: &Options, files: &[(PathBuf, &str)]) -> Result<Verdict, CliError> {
        if let Some(conversion) = &options.conversion {
            println!("{} instead of {}: {}", graph.scalar().name(), conversion.from.name(), conversion.agreement);
        }
        for (path, text) in files {
            println!("wrote {} ({} lines)", path.display(), text.lines().count());
        }
        if self.lang != LanguageArg::Rust {
            for line in size::of_c(graph, options) {
                println!("{line}");
            }
        }
        if self.no_verify {
            return Ok(Verdict::Good);
        }
        match verify::compare(graph, &options.prefix, STATES, 1) {
            Ok(comparisons) => {
                let mut verdict = Verdict::Good;
                for comparison in &comparisons {
                    println!("{}", verify::sentence(comparison));
                    if comparison.differences > 0 {
                        verdict = Verdict::Failed;
                    }
                }
                Ok(verdict)
            }
            Err(error) => {
                eprintln!("not verified: {error}");
                Ok(Verdict::Good)
            }
        }
    }
}

/// Whether the C is small enough, and says so where it is not, or where nobody can tell.
pub(super) fn fits(graph: &Graph, options: &Options, target: Target, limit: u64) -> bool {
    let name = target.name();
    match size::compile_c(graph, options, target).and_then(|object| size::measure(&object)) {
        Ok(size) if size.flash() <= limit => true,
        Ok(size) => {
            let flash = size.flash();
            eprintln!("refused: {flash} bytes of flash on {name}, {} more than --max-flash {limit}", flash - limit);
            false
        }
        Err(error) => {
            eprintln!("refused: whether --max-flash {limit} holds on {name} cannot be told: {error}");
            false
        }
    }
}

/// One file as it is; several with a line between them that is a comment in C and Rust.
fn print(files: &[File]) -> io::Result<()> {
    let mut out = io::stdout().lock();
    for file in files {
        if files.len() > 1 {
            writeln!(out, "/* ---- {} ---- */", file.name)?;
        }
        out.write_all(file.text.as_bytes())?;
    }
    out.flush()
}
