//! A policy as a package of an ecosystem: manifest, sources, an example that compiles, licence, README.
//!
//! | module | subject |
//! | --- | --- |
//! | `facts` | what templates say about a policy |
//! | `layout` | the files of each ecosystem |

mod facts;
mod layout;

use crate::emit::Code;
use crate::options::{Language, Options};
use crate::program::compile;
use facts::Facts;
use tpg_graph::Graph;

/// An ecosystem that takes packages.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, clap::ValueEnum)]
pub(crate) enum Ecosystem {
    /// A library for the Arduino IDE: `library.properties`.
    Arduino,
    /// A library for PlatformIO: `library.json`.
    Platformio,
    /// A component of ESP-IDF: `idf_component.yml`.
    EspIdf,
    /// A module of Zephyr: `zephyr/module.yml`.
    Zephyr,
    /// A CMake project, for `FetchContent` and `find_package`.
    Cmake,
    /// A Meson project, for `subprojects`.
    Meson,
    /// A `no_std` crate, for Cargo.
    Cargo,
}

impl Ecosystem {
    /// The language of its packages.
    pub(crate) const fn language(self) -> Language {
        match self {
            Self::Cargo => Language::Rust,
            _ => Language::C,
        }
    }
}

/// A licence: its SPDX expression, and its texts by file name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct License {
    /// For example `MIT`.
    pub spdx: String,
    /// File names and texts; at least one.
    pub files: Vec<(String, String)>,
}

impl Default for License {
    /// That of this project.
    fn default() -> Self {
        let files = [
            ("LICENSE-MIT", include_str!("../../LICENSE-MIT")),
            ("LICENSE-APACHE", include_str!("../../LICENSE-APACHE")),
        ];
        Self { spdx: "MIT OR Apache-2.0".to_owned(), files: files.map(|(n, t)| (n.to_owned(), t.to_owned())).into() }
    }
}

/// Entries of a manifest beside the policy.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Details {
    /// The package's version: three numbers.
    pub version: String,
    /// Its publisher.
    pub author: String,
    /// The address at which it is published, if it is.
    pub url: Option<String>,
    /// Its licence.
    pub license: License,
}

/// A package: the code that it holds, and all of its files by path in the package.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Package<'g> {
    /// The code.
    pub code: Code<'g>,
    /// Paths with `/`, and texts.
    pub files: Vec<(String, String)>,
}

/// Makes the package of a graph. The same graph and options give the same bytes but for the figures in its README, which depend
/// on the compilers that are installed.
pub(crate) fn package<'g>(graph: &'g Graph, options: &Options, ecosystem: Ecosystem, details: &Details) -> Package<'g> {
    let code = Code::of(compile(graph, options, ecosystem.language()));
    let facts = Facts::new(&code, graph, options, details);
    let files = layout::files(&facts, ecosystem, &code);
    Package { code, files }
}
