//! The shipped policies that the page shows.

use std::path::{Path, PathBuf};
use std::{fs, io};
use tpg_codegen::Options;
use tpg_graph::Graph;

/// A shipped policy of a problem of classic control.
pub(crate) struct Policy {
    /// The folder below `generated/`.
    pub(crate) folder: &'static str,
    /// The name for readers.
    pub(crate) title: &'static str,
}

/// The policies in the order of the module's problems.
pub(crate) const POLICIES: [Policy; 3] = [
    Policy { folder: "cartpole", title: "CartPole" },
    Policy { folder: "pendulum", title: "Pendulum" },
    Policy { folder: "mountain-car", title: "MountainCar" },
];

/// The graph of the arm.
pub(crate) const ARM: Policy = Policy { folder: "widowx-rs", title: "WidowX" };

/// The policy of the camera.
pub(crate) const EYE: Policy = Policy { folder: "eye", title: "Eye" };

/// The repository's top folder.
pub(crate) fn top() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().map(Path::to_owned).unwrap_or_default()
}

/// Reads a file of the repository.
pub(crate) fn read(path: &str) -> io::Result<String> {
    fs::read_to_string(top().join(path)).map_err(|error| io::Error::other(format!("{path}: {error}")))
}

impl Policy {
    /// The name of the generated files, and the prefix of what they define.
    pub(crate) fn prefix(&self) -> String {
        self.folder.replace('-', "_")
    }

    /// Reads the graph.
    pub(crate) fn graph(&self) -> io::Result<Graph> {
        let path = format!("generated/{}/graph.json", self.folder);
        Graph::from_json(&path, &read(&path)?).map_err(io::Error::other)
    }

    /// The options of the generated code.
    pub(crate) fn options(&self) -> io::Result<Options> {
        Ok(Options::new(self.prefix().parse().map_err(io::Error::other::<String>)?))
    }

    /// A line of the table in `PROVENANCE.md`, by its beginning.
    pub(crate) fn provenance(&self, beginning: &str) -> io::Result<String> {
        let path = format!("generated/{}/PROVENANCE.md", self.folder);
        let text = read(&path)?;
        let found = text.lines().find_map(|line| line.strip_prefix(beginning));
        let missing = || io::Error::other(format!("{path}: no line that begins with {beginning:?}"));
        Ok(found.ok_or_else(missing)?.trim_matches(['|', ' ']).replace('`', ""))
    }

    /// The C of the repository.
    pub(crate) fn code(&self) -> io::Result<String> {
        read(&format!("generated/{}/{}.c", self.folder, self.prefix()))
    }
}
