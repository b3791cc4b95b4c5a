//! A file of tests that its crate's `all.rs` does not name would never run.

use crate::nevers::crates;
use std::fs;
use std::path::Path;

/// Returns the names of the files beside an `all.rs` that it does not name.
fn unlisted(folder: &Path) -> Vec<String> {
    let text = fs::read_to_string(folder.join("all.rs")).expect("it can be read");
    let listed: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix("mod ")?.strip_suffix(';')).collect();
    let entries = fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let files = entries.filter(|path| path.extension().is_some_and(|end| end == "rs"));
    let names = files.filter_map(|path| Some(path.file_stem()?.to_str()?.to_owned()));
    names.filter(|name| name != "all" && !listed.contains(&name.as_str())).collect()
}

#[test]
fn every_file_of_tests_is_named() {
    let mut found = 0;
    for (top, _) in crates().into_values() {
        let folder = top.join("tests");
        if folder.join("all.rs").exists() {
            found += 1;
            assert_eq!(unlisted(&folder), [""; 0], "{}", folder.display());
            let manifest = fs::read_to_string(top.join("Cargo.toml")).expect("it can be read");
            assert!(manifest.contains("autotests = false"), "{}: its files would be tested twice", top.display());
        }
    }
    assert!(found > 8, "{found} crates with one program of tests");
}

#[test]
fn a_file_that_is_not_named_is_found() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("it can be written");
    write("all.rs", "mod here;\n");
    write("here.rs", "");
    assert_eq!(unlisted(folder.path()), [""; 0]);
    write("forgotten.rs", "");
    assert_eq!(unlisted(folder.path()), ["forgotten"]);
}
