//! Pages of the book that are made from the programs: compared with what is committed, or written.

use crate::library::top;
use std::{env, fs};

/// Environment variable: if it is `1`, pages are written instead of compared.
pub const UPDATE: &str = "TPG_UPDATE_BOOK";

/// Compares a page of `docs/` with its text, or writes it where [`UPDATE`] is `1`.
///
/// # Panics
/// If the committed page is another one.
pub fn page(name: &str, text: &str) {
    let path = top().join("docs").join(name);
    if env::var(UPDATE).is_ok_and(|value| value == "1") {
        fs::write(&path, text).expect("the page can be written");
        return;
    }
    // Windows may have checked it out with its own line ends.
    let committed = fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    assert!(committed == text, "docs/{name} is stale: {UPDATE}=1 and the same command write it");
}
