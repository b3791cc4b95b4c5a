//! From a finished [`Program`] to text. Decisions are made before; here they are only written down.

pub(crate) mod banner;
pub(crate) mod block;
pub(crate) mod c;
mod cases;
mod choice;
pub(crate) mod file;
mod helpers;
pub(crate) mod integers;
pub(crate) mod interface;
pub(crate) mod layout;
mod leaves;
mod look;
mod moves;
pub(crate) mod names;
mod rust;
mod syntax;
pub(crate) mod team;
pub(crate) mod vectors;

pub use file::File;

pub use crate::options::{Language, Options, Prefix, Profile, Style};

use crate::program::{Program, compile, compile_integers};
use tpg_graph::Graph;
use tpg_graph::error::InputError;

/// A program and its text: what is written is what is measured and proven.
#[derive(Clone, Debug, PartialEq)]
pub struct Code<'g> {
    /// The program.
    pub program: Program<'g>,
    /// The text.
    pub files: Vec<File>,
}

impl<'g> Code<'g> {
    /// Prints a program.
    pub fn of(program: Program<'g>) -> Self {
        let files = match program.language {
            Language::C => c::files(&program),
            Language::Rust => rust::files(&program),
        };
        Self { files, program }
    }

    /// Compiles a graph and prints it, in integers if it is one of counts; `file` is its name in messages.
    ///
    /// # Errors
    /// The first value of a graph of counts that is not known to be whole.
    pub fn of_graph(file: &str, graph: &'g Graph, options: &Options, language: Language) -> Result<Self, InputError> {
        match graph.has_counts() {
            true => compile_integers(file, graph, options, language).map(Self::of),
            false => Ok(Self::of(compile(graph, options, language))),
        }
    }
}

/// Compiles and prints a graph, if nothing but the text is needed. The same graph and options give the same bytes.
///
/// ```
/// use tpg_codegen::emit::{self, Language, Options};
/// use tpg_graph::sample::{self, Shape};
///
/// let graph = sample::graph(&Shape::default(), 7);
/// let options = Options::new("arm".parse()?);
/// let files = emit::emit(&graph, Language::C, &options);
/// assert_eq!([&*files[0].name, &*files[1].name], ["arm.h", "arm.c"]);
/// assert!(files[0].text.contains("arm_action_t arm_infer(const arm_state_t *state);"));
/// assert_eq!(files, emit::emit(&graph, Language::C, &options));
/// # Ok::<(), String>(())
/// ```
pub fn emit(graph: &Graph, language: Language, options: &Options) -> Vec<File> {
    Code::of(compile(graph, options, language)).files
}
