//! The book's page of this program.

use std::path::Path;
use tpg_testing::book::{manual, page};

#[test]
fn the_page_of_the_command_line_is_fresh() {
    let lead = "Finds the most instructions and bytes of stack that compiled code for a Cortex-M can take: \
                [From a graph to code](codegen.md).";
    page("cortex-bound.md", &manual(Path::new(env!("CARGO_BIN_EXE_cortex-bound")), "cortex-bound", lead));
}
