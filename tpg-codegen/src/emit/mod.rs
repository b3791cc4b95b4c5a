//! From the lowered graph to text. Decisions are made before; here they are only written down.

mod banner;
mod c;
mod layout;
mod name;
mod rust;

pub use name::Prefix;

use crate::graph::Graph;
use crate::ir::Module;

/// A language to emit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, clap::ValueEnum)]
pub enum Language {
    /// C99, compiling as C++11 too.
    C,
    /// Rust, `no_std`.
    Rust,
}

/// The interface of the C that is emitted.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum Style {
    /// A pure, reentrant function over a const state; every symbol prefixed.
    #[default]
    Pure,
    /// GEGELATI's own entry points, `inferenceTPG()` over the globals `in1`, `in2`, …: a drop-in for its output.
    Gegelati,
}

/// What to emit and what to call it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Options {
    /// The prefix of every name.
    pub prefix: Prefix,
    /// The interface of C.
    pub style: Style,
}

/// A file to write.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Its name, without folder.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// Emits a graph in one language. The same graph and options give the same bytes.
pub fn emit(graph: &Graph, language: Language, options: &Options) -> Vec<File> {
    let module = Module::lower(graph);
    match language {
        Language::C => c::emit(graph, &module, options),
        Language::Rust => rust::emit(graph, &module, options),
    }
}
