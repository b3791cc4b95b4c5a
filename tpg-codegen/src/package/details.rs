//! The ecosystems, and what a manifest says beside the policy.

use crate::options::Language;
use crate::size::Target;

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
    /// The chip that its README gives figures of.
    pub(crate) const fn target(self) -> Target {
        match self {
            Self::Arduino => Target::Atmega328p,
            Self::EspIdf => Target::Esp32C3,
            _ => Target::M4f,
        }
    }

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
