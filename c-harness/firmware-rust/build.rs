//! Tells the linker the folder of the board's memories, which TPG_BOARD names.

use std::env;
use std::path::PathBuf;

fn main() {
    let harness = PathBuf::from(env::var("CARGO_MANIFEST_DIR").unwrap_or_default());
    println!("cargo::rerun-if-env-changed=TPG_BOARD");
    let board = env::var("TPG_BOARD").map_or_else(|_| harness.join("../boards"), PathBuf::from);
    println!("cargo::rustc-link-search={}", board.display());
    println!("cargo::rustc-link-arg-bins=-Tlink.x");
    println!("cargo::rustc-link-arg-bins=--nmagic");
}
