//! The built page, for tests of it.

use std::path::PathBuf;

/// Names the folder of the built page: `cargo xtask web` sets it.
const PAGE: &str = "TPG_PAGE";

/// Returns the folder of the page that `cargo xtask web` has built; `None`, reported, without it or one of the programs.
pub(crate) fn page(what: &str, programs: &[&str]) -> Option<PathBuf> {
    let Some(folder) = std::env::var_os(PAGE) else {
        tpg_testing::skip(&format!("{what}: run by cargo xtask web"));
        return None;
    };
    let missing = programs.iter().any(|program| !tpg_testing::tool(program, program_package(program), what));
    (!missing).then(|| folder.into())
}

fn program_package(program: &str) -> &str {
    if program == "node" { "nodejs" } else { "chromium" }
}
