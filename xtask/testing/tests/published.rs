//! The crates that users install, as they would come from a registry.

use serde_json::Value;
use std::fs;
use std::path::{Component, Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;
use tpg_testing::library::top;

/// The largest package, in bytes.
const LARGEST: u64 = 500_000;

fn cargo(words: &[&str]) -> String {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo).current_dir(top()).args(words).output().expect("cargo runs this test");
    let text = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "cargo {}: {text}", words.join(" "));
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Names and folders of the crates that are published.
fn published() -> Vec<(String, PathBuf)> {
    let text = cargo(&["metadata", "--format-version", "1", "--no-deps", "--offline"]);
    let metadata: Value = serde_json::from_str(&text).expect("cargo prints JSON");
    let packages = metadata["packages"].as_array().expect("a list").iter();
    let published = packages.filter(|package| package["publish"].is_null()).map(|package| {
        let text = |key: &str| package[key].as_str().unwrap_or_default().to_owned();
        for key in ["description", "license", "readme", "rust_version"] {
            assert!(!text(key).is_empty(), "{}: no {key}", text("name"));
        }
        (text("name"), Path::new(&text("manifest_path")).parent().expect("a folder").to_owned())
    });
    published.collect()
}

/// A path without `..`, as text says it.
fn plain(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::new(), |mut plain, part| {
        if part == Component::ParentDir {
            plain.pop();
        } else {
            plain.push(part);
        }
        plain
    })
}

/// The literal paths that a file's text includes.
fn included(text: &str) -> Vec<&str> {
    let marks = ["include_str!(\"", "include_bytes!(\"", "include!(\"", "#[path = \""];
    let after = |mark| text.split(mark).skip(1).filter_map(|rest| rest.split('"').next());
    marks.into_iter().flat_map(after).collect()
}

#[test]
fn every_package_is_whole() {
    let crates = published();
    let names: Vec<&str> = crates.iter().map(|(name, _)| name.as_str()).collect();
    for name in ["tpg-runtime", "tpg-graph", "tpg-codegen", "tpg-train", "tpg-generated", "cortex-bound"] {
        assert!(names.contains(&name), "{name} is not published: {names:?}");
    }
    let folder = TempDir::new().expect("a temporary folder");
    let target = folder.path().display().to_string();
    let mut words = vec!["package", "--no-verify", "--allow-dirty", "--offline", "--target-dir", &target];
    names.iter().for_each(|name| words.extend(["--package", name]));
    cargo(&words);
    for (name, place) in &crates {
        let package = folder.path().join(format!("package/{name}-{}.crate", env!("CARGO_PKG_VERSION")));
        let size = fs::metadata(&package).unwrap_or_else(|error| panic!("{}: {error}", package.display())).len();
        assert!(size < LARGEST, "{name} has {size} bytes");
        let list = cargo(&["package", "--list", "--allow-dirty", "--offline", "--package", name]);
        let files: Vec<&str> = list.lines().collect();
        for needed in ["Cargo.toml", "README.md", "LICENSE-MIT", "LICENSE-APACHE"] {
            assert!(files.contains(&needed), "{name} has no {needed}");
        }
        for license in ["LICENSE-MIT", "LICENSE-APACHE"] {
            assert_eq!(fs::read(place.join(license)).ok(), fs::read(top().join(license)).ok(), "{name}: {license}");
        }
        // A template is the text of another file.
        for file in files.iter().filter(|file| file.ends_with(".rs") && !file.starts_with("templates/")) {
            let Ok(text) = fs::read_to_string(place.join(file)) else { continue };
            for path in included(&text) {
                let path = plain(&place.join(file).parent().expect("a folder").join(path));
                let inside = path.strip_prefix(place).map(|path| path.display().to_string());
                let inside = inside.is_ok_and(|path| files.contains(&path.as_str()));
                assert!(inside, "{name}: {file} includes {}, which is not in the package", path.display());
            }
        }
    }
}

#[test]
fn an_include_from_outside_is_seen() {
    assert_eq!(included("let a = include_str!(\"../a.txt\");\n#[path = \"b.rs\"]\nmod b;"), ["../a.txt", "b.rs"]);
    assert_eq!(plain(Path::new("/top/crate/src/../../a.txt")), Path::new("/top/a.txt"));
}
