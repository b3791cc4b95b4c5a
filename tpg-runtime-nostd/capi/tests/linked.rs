//! C programs that link the library.

use std::path::{Path, PathBuf};
use std::process::Command;
use tpg_testing::library;

/// Builds the library; none where a tool is missing, which is said.
pub(crate) fn archive(subject: &str) -> Option<PathBuf> {
    let archive = library::make(library::host(), &library::dist()).expect("it builds")?;
    tpg_testing::tool("gcc", "gcc", subject).then_some(archive)
}

/// Compiles a program of `tests/c` with headers and `sources` of a folder, links the library and returns what it prints.
pub(crate) fn output_of(program: &str, folder: &Path, sources: &[&str], archive: &Path) -> String {
    let include = library::dist().join("include");
    let main = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/c").join(program);
    let built = folder.join("program");
    let mut gcc = Command::new("gcc");
    gcc.args(["-std=c99", "-O1", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]);
    gcc.arg(format!("-I{}", include.display())).arg(format!("-I{}", folder.display()));
    gcc.arg(main).args(sources.iter().map(|source| folder.join(source)));
    gcc.arg(archive).arg("-lm").arg("-o").arg(&built);
    let output = gcc.output().expect("gcc starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(&built).output().expect("it starts");
    assert!(output.status.success(), "{program}: {:?}", output.status);
    String::from_utf8(output.stdout).expect("text")
}
