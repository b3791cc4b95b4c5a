//! The book's page of this program.

use std::path::Path;
use tpg_testing::book::{manual, page};

#[test]
fn the_page_of_the_command_line_is_fresh() {
    let lead = "Compiles a graph to C and Rust, measures and proves the code: [From a graph to code](codegen.md).";
    page("tpg-codegen.md", &manual(Path::new(env!("CARGO_BIN_EXE_tpg-codegen")), "tpg-codegen", lead));
}
