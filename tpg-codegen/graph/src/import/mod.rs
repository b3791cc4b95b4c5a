//! Reading graphs: `graph.json`, or GEGELATI's `.dot` with a description of what that format leaves out.

mod dot;
mod profile;
mod sidecar;

pub use profile::Profile;
pub use sidecar::Sidecar;

use crate::error::{InputError, Place};
use crate::model::Graph;
use std::fs;
use std::io::{self, Read};
use std::path::Path;

/// The name of standard input on the command line.
const STDIN: &str = "-";

/// Reads a graph from a file, or from standard input where the path is `-`.
///
/// What begins with `{` is a `graph.json`, what begins with `//` or `digraph` a GEGELATI `.dot`. The latter says nothing
/// of sources, instructions and actions: a built-in `profile` or a `sidecar` file must.
///
/// # Errors
/// Whatever is wrong with the file, its sidecar or the choice between the two.
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

/// Reads a graph from text: see [`load`]. `file` is what messages call it.
///
/// # Errors
/// As [`load`].
pub fn from_text(file: &str, text: &str, description: Option<&Sidecar>) -> Result<Graph, InputError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text); // the byte order mark that some editors write
    let whole = |found, accepted| Err(InputError::new(file, Place::Whole, found, accepted));
    match (Format::of(text), description) {
        (Format::Empty, _) => whole("an empty file", "a graph.json or a GEGELATI .dot file"),
        (Format::Json, None) => Graph::from_json(file, text),
        (Format::Json, Some(_)) => {
            whole("a graph.json with --profile-of or --sidecar", "neither: a graph.json says everything itself")
        }
        (Format::Dot, Some(description)) => dot::read(file, text, description),
        (Format::Dot, None) => whole(
            "a .dot file, which does not say what its sources, instructions and actions are",
            "--profile-of ecta24 for the paper's own graphs, --sidecar FILE for any other",
        ),
        (Format::Other, _) => whole(
            "neither JSON nor .dot",
            "a graph.json, which begins with {, or a GEGELATI .dot, which begins with // or digraph",
        ),
    }
}

/// What a text is, by its beginning.
enum Format {
    Empty,
    Json,
    Dot,
    Other,
}

impl Format {
    fn of(text: &str) -> Self {
        let start = text.trim_start();
        match start {
            "" => Self::Empty,
            _ if start.starts_with('{') => Self::Json,
            _ if start.starts_with("//") || start.starts_with("digraph") => Self::Dot,
            _ => Self::Other,
        }
    }
}

/// A file's name for messages, and its text.
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
