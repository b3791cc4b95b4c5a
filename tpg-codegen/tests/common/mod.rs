//! Parts that several tests share: the fixture graph in every scalar and maths, and its code in a folder.

use std::path::Path;
use std::process::Command;
use tpg_codegen::emit::{self, Code, File, Language, Options, Profile, Style};
use tpg_graph::{Document, Graph, MathsProvider, ScalarType};

/// Every scalar with every maths.
pub(crate) const COMBINATIONS: [(ScalarType, MathsProvider); 4] = [
    (ScalarType::F32, MathsProvider::Own),
    (ScalarType::F32, MathsProvider::System),
    (ScalarType::F64, MathsProvider::Own),
    (ScalarType::F64, MathsProvider::System),
];

/// An interface of C, and a profile where it has one.
pub(crate) type Shape = (Style, Option<Profile>);

/// Every shape of C.
pub(crate) const SHAPES: [Shape; 5] = [
    (Style::Pure, Some(Profile::Fast)),
    (Style::Pure, Some(Profile::Balanced)),
    (Style::Pure, Some(Profile::Small)),
    (Style::Pure, Some(Profile::ConstantTime)),
    (Style::Gegelati, None),
];

/// The graph that has every instruction.
pub(crate) fn fixture(scalar: ScalarType, maths: MathsProvider) -> Graph {
    let text = include_str!("../fixtures/all_instructions.json");
    let document: Document = serde_json::from_str(text).expect("the fixture is a document");
    Graph::from_document("all_instructions.json", Document { scalar, maths, ..document }).expect("a valid graph")
}

/// Options with a prefix.
pub(crate) fn options(prefix: &str, style: Style) -> Options {
    shaped(prefix, (style, None))
}

/// Options with a prefix and a shape.
pub(crate) fn shaped(prefix: &str, (style, profile): Shape) -> Options {
    Options { style, profile, ..Options::new(prefix.parse().expect("a prefix")) }
}

/// Code of a graph.
pub(crate) fn code<'g>(language: Language, graph: &'g Graph, options: &Options) -> Code<'g> {
    Code::of_graph("the graph", graph, options, language).expect("a graph that has code")
}

/// Code of several graphs.
pub(crate) fn codes<'g>(language: Language, policies: &[(&'g Graph, Options)]) -> Vec<Code<'g>> {
    policies.iter().map(|(graph, options)| code(language, graph, options)).collect()
}

/// Emits code and writes it to a folder.
pub(crate) fn emit_into(folder: &Path, graph: &Graph, language: Language, options: &Options) -> Vec<File> {
    let files = emit::emit(graph, language, options);
    for file in &files {
        std::fs::write(folder.join(&file.name), &file.text).expect("the folder can be written");
    }
    files
}

/// Runs a command and returns what it printed, stdout before stderr; where it fails, that is the `Err`.
pub(crate) fn run(command: &mut Command) -> Result<String, String> {
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
    if output.status.success() { Ok(text) } else { Err(format!("{command:?}: {}\n{text}", output.status)) }
}
