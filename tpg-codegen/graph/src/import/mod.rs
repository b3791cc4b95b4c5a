//! Import of graphs: `graph.json`, or GEGELATI's `.dot` with a description of what that format leaves out.

mod composed;
mod dot;
mod profile;
mod sidecar;

pub use composed::{Expression, Reading};
pub use profile::Profile;
pub use sidecar::Sidecar;

use crate::error::{InputError, Place};
use crate::model::Graph;
use std::fs;
use std::io::{self, Read};
use std::path::Path;

/// The name of standard input on the command line.
const STDIN: &str = "-";

/// Reads a graph from a file, or from standard input if the path is `-`.
///
/// Text that begins with `{` is a `graph.json`; text that begins with `//` or `digraph` is a GEGELATI `.dot`. The
/// latter does not describe sources, instructions and actions, so a built-in `profile` or a `sidecar` file must.
///
/// # Errors
/// Any error in the file, its sidecar or the choice between the two.
pub fn load(path: &Path, profile: Option<Profile>, sidecar: Option<&Path>) -> Result<Graph, InputError> {
    let (file, text) = read(path)?;
    let description = match (profile, sidecar) {
        (None, None) => None,
        (Some(profile), None) => Some(profile.sidecar()),
        (None, Some(sidecar)) => {
            let (file, text) = read(sidecar)?;
            Some(Sidecar::from_toml(&file, &text)?)
        }
        (Some(_), Some(sidecar)) => {
            let file = sidecar.display().to_string();
            return Err(InputError::new(file, Place::Whole, "a sidecar and --profile-of", "one of the two"));
        }
    };
    from_text(&file, &text, description.as_ref())
}

/// Reads a graph from text: see [`load`]. `file` is its name in messages.
///
/// ```
/// use tpg_graph::import::{self, Sidecar};
///
/// let sidecar = r#"
///     scalar = "f64"
///     maths = "system"
///     registers = 1
///     sources = [{ name = "x", length = 1, unit = "mm", range = [-1, 1] }]
///     instructions = ["add"]
///     actions = [{ id = 0, name = "left" }]
/// "#;
/// // One team and one program, whose only line is r0 = r0 + x[0].
/// let dot = r#"digraph{
///     T0 []
///     P0 [] //
///     I0 [label="0|0&0|0#1|0&#92;n"]
///     P0 -> I0[]
///     A0 [label="0"]
///     T0 -> P0 -> A0
///     { rank= same T0 }
/// }
/// "#;
/// let graph = import::from_text("small.dot", dot, Some(&Sidecar::from_toml("small.toml", sidecar)?))?;
/// assert_eq!(graph.program(graph.teams()[0].edges[0].program).lines.len(), 1);
/// # Ok::<(), tpg_graph::error::InputError>(())
/// ```
///
/// # Errors
/// As [`load`].
pub fn from_text(file: &str, text: &str, description: Option<&Sidecar>) -> Result<Graph, InputError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text); // the byte order mark that some editors write
    let whole = |found, accepted| Err(InputError::new(file, Place::Whole, found, accepted));
    let start = text.trim_start();
    let is_dot = start.starts_with("//") || start.starts_with("digraph");
    match description {
        _ if start.is_empty() => whole("an empty file", "a graph.json or a GEGELATI .dot file"),
        None if start.starts_with('{') => Graph::from_json(file, text),
        Some(_) if start.starts_with('{') => {
            whole("a graph.json with --profile-of or --sidecar", "neither: a graph.json is complete in itself")
        }
        Some(description) if is_dot => dot::read(file, text, description),
        None if is_dot => whole(
            "a .dot file, which does not say what its sources, instructions and actions are",
            "--profile-of ecta24 for the paper's own graphs, --sidecar FILE for any other",
        ),
        _ => whole(
            "neither JSON nor .dot",
            "a graph.json, which begins with {, or a GEGELATI .dot, which begins with // or digraph",
        ),
    }
}

/// Returns a file's name for messages, and its text.
pub(crate) fn read(path: &Path) -> Result<(String, String), InputError> {
    let (file, bytes) = if path == Path::new(STDIN) {
        let mut bytes = Vec::new();
        ("<stdin>".to_owned(), io::stdin().lock().read_to_end(&mut bytes).map(|_| bytes))
    } else {
        (path.display().to_string(), fs::read(path))
    };
    let bytes =
        bytes.map_err(|error| InputError::new(&file, Place::Whole, error.to_string(), "a file that can be read"))?;
    String::from_utf8(bytes).map(|text| (file.clone(), text)).map_err(|error| {
        let place = error.utf8_error().valid_up_to();
        let line = error.as_bytes()[..place].iter().filter(|&&byte| byte == b'\n').count() + 1;
        InputError::new(file, Place::Line(line), "bytes that are not UTF-8", "text")
    })
}
