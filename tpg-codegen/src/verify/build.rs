//! Compiles generated code into small programs that decide over a pipe.

use super::process::Process;
use crate::emit::c::field::field;
use crate::emit::integers::state_bits;
use crate::emit::{Code, File};
use crate::integers::source_bits;
use crate::options::Language;
use crate::shape::Shape;
use askama::Template;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{env, fs, io, slice};
use tempfile::TempDir;
use tpg_graph::image::Vision;
use tpg_graph::{Graph, ScalarType, SourceDocument};
use tpg_runtime::standalone;

/// The program around generated C.
#[derive(Template)]
#[template(path = "c/harness.c", escape = "none")]
struct CHarness {
    policies: Vec<PolicyView>,
}

/// The program around generated Rust.
#[derive(Template)]
#[template(path = "rust/harness.rs", escape = "none")]
struct RustHarness {
    policies: Vec<PolicyView>,
}

struct PolicyView {
    prefix: String,
    name: String,
    state_length: usize,
    /// The observed sources: their fields, lengths and types.
    sources: Vec<(String, usize, String)>,
    /// The type of every value of a state in Rust.
    kind: String,
    outputs: usize,
    /// The fields of the answer's values.
    answers: Vec<String>,
    /// Those of the memory.
    memory: Vec<(String, usize, String)>,
    gegelati: bool,
    /// The bytes of an image that the policy sees, and of a row.
    image: Option<[usize; 2]>,
}

impl PolicyView {
    fn new(code: &Code<'_>) -> Self {
        let (graph, prefix) = (code.program.graph(), &code.program.options.prefix);
        let is_integers = matches!(code.program.shape, Shape::Integers(_));
        let kind = |source: &SourceDocument| match graph.scalar() {
            _ if is_integers => format!("int{}_t", source_bits(source)),
            ScalarType::F32 => "float".to_owned(),
            ScalarType::F64 => "double".to_owned(),
        };
        let view = |source: &SourceDocument| (field(graph, &source.name), source.ranges.len(), kind(source));
        let (observed, memory) = graph.sources().split_at(graph.observed().len());
        Self {
            prefix: prefix.to_string(),
            name: prefix.camel(),
            state_length: graph.state_length(),
            sources: observed.iter().map(view).collect(),
            kind: if is_integers { format!("i{}", state_bits(graph)) } else { graph.scalar().name().to_owned() },
            outputs: graph.outputs().len(),
            answers: graph.split_outputs().0.iter().map(|output| field(graph, &output.name)).collect(),
            memory: memory.iter().map(view).collect(),
            gegelati: code.program.shape == Shape::Gegelati,
            image: Vision::new(graph.sources()).map(|vision| {
                let [_, columns, channels] = vision.shape();
                [vision.bytes(), columns * channels]
            }),
        }
    }
}

/// A program that holds some policies: one compiler run for all of them, so that thousands can be compared.
#[derive(Debug)]
pub struct Batch {
    program: PathBuf,
    language: Language,
}

impl Batch {
    /// Starts the program as one of its policies, by the order in which they were given.
    ///
    /// # Errors
    /// When it cannot be started.
    pub fn start(&self, policy: usize, graph: &Graph) -> io::Result<Process> {
        let name = format!("{} policy {policy}", self.language.name());
        Process::start(&self.program, policy, name, graph)
    }
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
        let program = self.build(slice::from_ref(code), None)?;
        Ok(Process::start(&program, 0, code.program.name(), code.program.graph())?)
    }

    /// As [`start`](Self::start), for the function that reads an image: it gets bytes as numbers, and answers the values of a state.
    pub(super) fn start_looking(&self, code: &Code<'_>, vision: &Vision) -> Result<Process, BuildError> {
        let program = self.build(slice::from_ref(code), None)?;
        let graph = code.program.graph();
        let process = Process::start(&program, 1, code.program.name(), graph)?;
        Ok(process.looking(vision, graph.observed_length()))
    }

    /// Compiles policies of one language, each with a prefix of its own and without GEGELATI's style, into one program; by another
    /// compiler, if one is given: its command in a folder, with every option that generated code needs.
    ///
    /// # Errors
    /// See [`BuildError`].
    ///
    /// # Panics
    /// Without any policy.
    pub fn batch(&self, codes: &[Code<'_>], compiler: Option<&dyn Fn(&Path) -> Command>) -> Result<Batch, BuildError> {
        Ok(Batch { program: self.build(codes, compiler)?, language: codes[0].program.language })
    }

    /// Compiles code of one language into a program.
    fn build(&self, codes: &[Code<'_>], compiler: Option<&dyn Fn(&Path) -> Command>) -> Result<PathBuf, BuildError> {
        let language = codes[0].program.language;
        let folder = self.write("policies", codes.iter().flat_map(|code| &code.files))?;
        let command = || match (compiler, language) {
            (Some(compiler), _) => Ok(compiler(&folder)),
            (None, Language::C) => proving_c_command(&folder),
            (None, Language::Rust) => Ok(rustc(&folder)),
        };
        let policies = codes.iter().map(PolicyView::new).collect();
        let program = folder.join("policies");
        let mut compiling = command()?;
        compiling.arg("-o").arg(&program);
        // No prefix has a hyphen: no policy's file has these names.
        let text = match language {
            Language::C => {
                compiling.args(["main-policies.c", "-lm"]);
                CHarness { policies }.render()
            }
            Language::Rust => {
                runtime_library_by(&folder, command()?)?;
                compiling.args(["--extern=tpg_runtime=libtpg_runtime.rlib", "main-policies.rs"]);
                RustHarness { policies }.render()
            }
        };
        let extension = if language == Language::C { "c" } else { "rs" };
        fs::write(folder.join(format!("main-policies.{extension}")), text.map_err(io::Error::other)?)?;
        compile(language.name(), compiling)?;
        Ok(program)
    }

    /// Writes files to a new folder of the workshop.
    pub(crate) fn write<'f>(&self, name: &str, files: impl IntoIterator<Item = &'f File>) -> io::Result<PathBuf> {
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

/// The host's C compiler, as the crate `cc` finds it (`CC` is honoured).
pub(crate) fn c_compiler() -> Result<cc::Tool, BuildError> {
    let host = env!("TPG_HOST");
    let mut build = cc::Build::new();
    build.target(host).host(host).opt_level(2).debug(false).warnings(false).cargo_metadata(false).cargo_warnings(false);
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
fn proving_c_command(folder: &Path) -> Result<Command, BuildError> {
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
fn runtime_library_by(folder: &Path, mut library: Command) -> Result<(), BuildError> {
    write_runtime(folder, str::to_owned)?;
    library.args(["--crate-type=rlib", "--crate-name=tpg_runtime", "--cfg=feature=\"std\"", "runtime/lib.rs"]);
    compile("Rust", library)
}

/// Writes the runtime's files to a folder in a folder.
pub(crate) fn write_runtime(folder: &Path, changed: impl Fn(&str) -> String) -> io::Result<()> {
    for (name, text) in standalone::FILES {
        let path = folder.join("runtime").join(name);
        fs::create_dir_all(path.parent().unwrap_or(folder))?;
        fs::write(path, changed(text))?;
    }
    Ok(())
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
