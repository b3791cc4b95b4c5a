//! Compiles generated code into small programs that decide over a pipe.

use super::Process;
use crate::emit::{Code, File, field};
use crate::options::{Language, Options};
use crate::program::{Shape, compile as compile_graph};
use askama::Template;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{env, fs, io};
use tempfile::TempDir;
use tpg_graph::{Graph, ScalarType};
use tpg_runtime::standalone;

/// The program around generated C.
#[derive(Template)]
#[template(path = "c/harness.c", escape = "none")]
struct CHarness<'a> {
    prefix: &'a str,
    scalar: &'a str,
    state_length: usize,
    /// The observed sources: their fields and lengths.
    sources: Vec<(String, usize)>,
    outputs: usize,
    /// The fields of the memory's values.
    memory: Vec<String>,
    gegelati: bool,
}

/// The program around generated Rust.
#[derive(Template)]
#[template(path = "rust/harness.rs", escape = "none")]
struct RustHarness<'a> {
    module: &'a str,
    name: String,
    scalar: &'a str,
    state_length: usize,
    outputs: usize,
    /// Values of the memory.
    memory: usize,
}

/// A failure to build generated code.
#[derive(Debug, thiserror::Error)]
pub enum BuildError {
    /// The compiler is missing.
    #[error("{language} compiler {command:?} cannot be started: {error}")]
    Missing {
        /// The language to compile.
        language: &'static str,
        /// The command.
        command: OsString,
        /// The system's error.
        error: io::Error,
    },
    /// The compiler rejected the code: a defect of the generator.
    #[error("the {language} compiler refused generated code:\n{message}")]
    Refused {
        /// The language.
        language: &'static str,
        /// The compiler's output.
        message: String,
    },
    /// The temporary folder or the program failed.
    #[error("cannot build generated code: {0}")]
    Io(#[from] io::Error),
}

/// A temporary folder for compiling generated code, deleted on drop.
#[derive(Debug)]
pub struct Workshop {
    folder: TempDir,
}

impl Workshop {
    /// An empty workshop.
    ///
    /// # Errors
    /// When no temporary folder can be made.
    pub fn new() -> io::Result<Self> {
        Ok(Self { folder: TempDir::new()? })
    }

    /// Compiles exactly the given text and starts the program.
    ///
    /// # Errors
    /// See [`BuildError`].
    pub fn start(&self, code: &Code<'_>) -> Result<Process, BuildError> {
        let program = match code.program.language {
            Language::C => self.build_c(code)?,
            Language::Rust => self.build_rust(code)?,
        };
        Ok(Process::start(&program, &code.program.name(), code.program.graph())?)
    }

    /// Generates C, compiles it and starts the program.
    ///
    /// # Errors
    /// See [`BuildError`].
    pub fn c(&self, graph: &Graph, options: &Options) -> Result<Process, BuildError> {
        self.start(&Code::of(compile_graph(graph, options, Language::C)))
    }

    /// Generates Rust, compiles it and starts the program.
    ///
    /// # Errors
    /// See [`BuildError`].
    pub fn rust(&self, graph: &Graph, options: &Options) -> Result<Process, BuildError> {
        self.start(&Code::of(compile_graph(graph, options, Language::Rust)))
    }

    fn build_c(&self, code: &Code<'_>) -> Result<PathBuf, BuildError> {
        let Code { program, files } = code;
        let (graph, options) = (program.graph(), &program.options);
        let folder = self.write("c", files)?;
        let prefix = options.prefix.lower();
        let harness = CHarness {
            prefix,
            scalar: if graph.scalar() == ScalarType::F32 { "float" } else { "double" },
            state_length: graph.state_length(),
            sources: observed(graph),
            outputs: graph.outputs().len(),
            memory: memory(graph),
            gegelati: program.shape == Shape::Gegelati,
        };
        fs::write(folder.join("harness.c"), harness.render().map_err(io::Error::other)?)?;
        let harness = folder.join("harness");
        let mut command = proving_c_command(&folder)?;
        command.arg("-o").arg(&harness).arg("harness.c").arg(format!("{prefix}.c")).arg("-lm");
        compile("C", command)?;
        Ok(harness)
    }

    fn build_rust(&self, code: &Code<'_>) -> Result<PathBuf, BuildError> {
        let Code { program, files } = code;
        let (graph, options) = (program.graph(), &program.options);
        let folder = self.write("rust", files)?;
        runtime_library(&folder)?;
        let harness = RustHarness {
            module: options.prefix.lower(),
            name: options.prefix.camel(),
            scalar: graph.scalar().name(),
            state_length: graph.state_length(),
            outputs: graph.outputs().len(),
            memory: graph.memory(),
        };
        fs::write(folder.join("harness.rs"), harness.render().map_err(io::Error::other)?)?;
        let harness = folder.join("harness");
        let mut command = rustc(&folder);
        command.args(["--extern=tpg_runtime=libtpg_runtime.rlib", "harness.rs", "-o"]).arg(&harness);
        compile("Rust", command)?;
        Ok(harness)
    }

    /// Writes files to a new folder of the workshop.
    pub(crate) fn write(&self, name: &str, files: &[File]) -> io::Result<PathBuf> {
        let folder = tempfile::Builder::new().prefix(name).tempdir_in(self.folder.path())?.keep();
        for file in files {
            fs::write(folder.join(&file.name), &file.text)?;
        }
        Ok(folder)
    }

    /// The path of the folder.
    pub fn path(&self) -> &Path {
        self.folder.path()
    }
}

/// The fields and lengths of the sources that a caller gives.
pub(super) fn observed(graph: &Graph) -> Vec<(String, usize)> {
    let sources = &graph.sources()[..graph.sources().len() - graph.memory()];
    sources.iter().map(|source| (field(graph, &source.name), source.ranges.len())).collect()
}

/// The fields of the memory's values.
pub(super) fn memory(graph: &Graph) -> Vec<String> {
    graph.outputs()[graph.outputs().len() - graph.memory()..].iter().map(|value| field(graph, &value.name)).collect()
}

/// The host's C compiler, as the crate `cc` finds it (`CC` is honoured).
pub(crate) fn c_compiler() -> Result<cc::Tool, BuildError> {
    let host = env!("TPG_HOST");
    let mut build = cc::Build::new();
    build.target(host).host(host).opt_level(2).debug(false).warnings(false).cargo_metadata(false);
    build.try_get_compiler().map_err(|error| BuildError::Missing {
        language: "C",
        command: env::var_os("CC").unwrap_or_else(|| "cc".into()),
        error: io::Error::other(error.to_string()),
    })
}

/// The C compiler at `-O2` in a folder, in its own dialect: generated code needs no flag.
///
/// # Errors
/// If there is none.
pub fn c_command(folder: &Path) -> Result<Command, BuildError> {
    let mut command = c_compiler()?.to_command();
    command.current_dir(folder);
    Ok(command)
}

/// As [`c_command`], for a machine that can fuse a product and a sum if this one can: what is proven is the text, which says
/// that nothing may.
///
/// # Errors
/// If there is no compiler.
pub(super) fn proving_c_command(folder: &Path) -> Result<Command, BuildError> {
    let tool = c_compiler()?;
    let mut command = tool.to_command();
    command.current_dir(folder);
    // tcc passes for GNU's, and knows no machines.
    let knows_machines = tool.is_like_clang() || tool.is_like_gnu() && !tool.path().ends_with("tcc");
    #[cfg(target_arch = "x86_64")]
    if knows_machines && std::is_x86_feature_detected!("fma") {
        command.arg("-mfma");
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (&mut command, knows_machines);
    Ok(command)
}

/// The Rust compiler in a folder. Overflow checks stay on: generated code must not need them.
pub fn rustc(folder: &Path) -> Command {
    let mut command = Command::new(env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()));
    command.current_dir(folder).args(["--edition=2024", "-O", "-Coverflow-checks=on", "-Awarnings"]);
    command
}

/// Compiles the runtime that generated Rust depends on: `libtpg_runtime.rlib` in a folder.
///
/// # Errors
/// When the compiler is missing or refuses.
pub fn runtime_library(folder: &Path) -> Result<(), BuildError> {
    runtime_library_by(folder, rustc(folder))
}

/// As [`runtime_library`], by a command that runs in the folder.
pub(super) fn runtime_library_by(folder: &Path, mut library: Command) -> Result<(), BuildError> {
    for (name, text) in standalone::FILES {
        let path = folder.join("runtime").join(name);
        fs::create_dir_all(path.parent().unwrap_or(folder))?;
        fs::write(path, text)?;
    }
    library.args(["--crate-type=rlib", "--crate-name=tpg_runtime", "--cfg=feature=\"std\"", "runtime/lib.rs"]);
    compile("Rust", library)
}

/// Runs a compiler.
///
/// # Errors
/// When it is missing or refuses.
pub fn compile(language: &'static str, mut command: Command) -> Result<(), BuildError> {
    let Output { status, stdout, stderr } = command.output().map_err(|error| BuildError::Missing {
        language,
        command: command.get_program().to_owned(),
        error,
    })?;
    if status.success() {
        return Ok(());
    }
    let message = [stdout, stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
    Err(BuildError::Refused { language, message })
}
