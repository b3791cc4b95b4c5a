//! The header is what cbindgen makes of the source today, and compilers take it without a warning.

use std::path::{Path, PathBuf};
use std::process::Command;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).into()
}

/// The header's text, made anew.
#[cfg(feature = "cbindgen")]
fn made() -> String {
    let config = cbindgen::Config::from_file(folder().join("cbindgen.toml")).expect("cbindgen.toml");
    // It follows the modules from there.
    let builder = cbindgen::Builder::new().with_config(config).with_src(folder().join("src/lib.rs"));
    let mut text = Vec::new();
    builder.generate().expect("bindings").write(&mut text);
    String::from_utf8(text).expect("UTF-8")
}

#[cfg(feature = "cbindgen")]
#[test]
fn the_header_is_fresh() {
    let path = folder().join("include/tpg_runtime.h");
    let made = made();
    if std::env::var_os("TPG_UPDATE_HEADER").is_some() {
        // By another name first: the test beside this one compiles it.
        let new = path.with_extension("new");
        std::fs::write(&new, &made).and_then(|()| std::fs::rename(&new, &path)).expect("the header can be written");
    }
    let found = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(found == made, "TPG_UPDATE_HEADER=1 cargo test -p tpg-runtime-capi --all-features header");
}

#[test]
fn compilers_take_the_header_as_c99_and_cpp11() {
    const WARNINGS: [&str; 10] = [
        "-Wall",
        "-Wextra",
        "-Wpedantic",
        "-Wconversion",
        "-Wsign-conversion",
        "-Wshadow",
        "-Wcast-qual",
        "-Wundef",
        "-Werror",
        "-fsyntax-only",
    ];
    const C99: &[&str] = &["-x", "c", "-std=c99", "-Wstrict-prototypes"];
    const CPP11: &[&str] = &["-x", "c++", "-std=c++11", "-Wold-style-cast"];
    let header = folder().join("include/tpg_runtime.h");
    for (program, package, language) in [
        ("gcc", "gcc", C99),
        ("g++", "g++", CPP11),
        ("clang", "clang", C99),
        ("clang++", "clang", CPP11),
        ("arm-none-eabi-gcc", "gcc-arm-none-eabi", C99),
    ] {
        if !tpg_testing::tool(program, package, "tpg_runtime.h as C99 and C++11") {
            continue;
        }
        // Included, so that a `static` or a definition in it would be seen as unused.
        let source = folder().join("tests/c/header_only.c");
        let output = Command::new(program)
            .args(language)
            .args(WARNINGS)
            .arg(format!("-I{}", header.parent().expect("a folder").display()))
            .arg(source)
            .output()
            .expect("it starts");
        assert!(output.status.success(), "{program}: {}", String::from_utf8_lossy(&output.stderr));
    }
}
