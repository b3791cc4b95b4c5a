//! Many policies compiled at once: one compiler run instead of one for each, so that thousands can be compared.

use super::build::{self, BuildError, Workshop, compile, proving_c_command, runtime_library_by, rustc};
use super::process::{self, Process};
use crate::emit;
use crate::options::{Language, Options};
use askama::Template;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, io};
use tpg_graph::{Graph, ScalarType};

#[derive(Template)]
#[template(path = "c/batch.c", escape = "none")]
struct CBatch {
    policies: Vec<PolicyView>,
}

#[derive(Template)]
#[template(path = "rust/batch.rs", escape = "none")]
struct RustBatch {
    policies: Vec<PolicyView>,
}

struct PolicyView {
    prefix: String,
    name: String,
    scalar: &'static str,
    state_length: usize,
    sources: Vec<(String, usize)>,
    outputs: usize,
    memory: Vec<String>,
}

/// A program that holds many policies.
#[derive(Debug)]
pub struct Batch {
    program: PathBuf,
    language: &'static str,
}

impl Batch {
    /// Starts the program as one of its policies, by the order they were given in.
    ///
    /// # Errors
    /// When it cannot be started.
    pub fn start(&self, policy: usize, graph: &Graph) -> io::Result<Process> {
        let name = format!("{} policy {policy}", self.language);
        process::start(&self.program, &[policy.to_string()], &name, graph)
    }
}

impl Workshop {
    /// Emits policies, each with a prefix of its own and without GEGELATI's style, and compiles them into one program.
    ///
    /// # Errors
    /// See [`BuildError`].
    pub fn batch(&self, language: Language, policies: &[(&Graph, Options)]) -> Result<Batch, BuildError> {
        match language {
            Language::C => self.batch_by(language, policies, proving_c_command),
            Language::Rust => self.batch_by(language, policies, |folder| Ok(rustc(folder))),
        }
    }

    /// As [`Workshop::batch`], with another compiler: `compiler` makes its command in a folder, with every option that
    /// generated code needs.
    ///
    /// # Errors
    /// See [`BuildError`].
    pub fn batch_by(
        &self,
        language: Language,
        policies: &[(&Graph, Options)],
        compiler: impl Fn(&Path) -> Result<Command, BuildError>,
    ) -> Result<Batch, BuildError> {
        let files: Vec<emit::File> =
            policies.iter().flat_map(|(graph, options)| emit::emit(graph, language, options)).collect();
        let folder = self.write("batch", &files)?;
        let views = policies.iter().map(|(graph, options)| view(graph, options, language)).collect();
        let program = folder.join("batch");
        let mut command = compiler(&folder)?;
        command.arg("-o").arg(&program);
        match language {
            Language::C => {
                let text = CBatch { policies: views }.render().map_err(io::Error::other)?;
                fs::write(folder.join("batch_main.c"), text)?;
                command.args(["batch_main.c", "-lm"]);
            }
            Language::Rust => {
                runtime_library_by(&folder, compiler(&folder)?)?;
                let text = RustBatch { policies: views }.render().map_err(io::Error::other)?;
                fs::write(folder.join("batch_main.rs"), text)?;
                command.args(["--extern=tpg_runtime=libtpg_runtime.rlib", "batch_main.rs"]);
            }
        }
        compile(language.name(), command)?;
        Ok(Batch { program, language: language.name() })
    }
}

fn view(graph: &Graph, options: &Options, language: Language) -> PolicyView {
    PolicyView {
        prefix: options.prefix.to_string(),
        name: options.prefix.camel(),
        scalar: match (language, graph.scalar()) {
            (Language::C, ScalarType::F32) => "float",
            (Language::C, ScalarType::F64) => "double",
            (Language::Rust, scalar) => scalar.name(),
        },
        state_length: graph.state_length(),
        sources: build::observed(graph),
        outputs: graph.outputs().len(),
        memory: build::memory(graph),
    }
}
