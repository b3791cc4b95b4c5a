//! The page: the module as WebAssembly, its data, and tests under Node and in a browser.

use crate::check::{Run, program, step};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, io};
use tpg_testing::library::{cargo, has_target, target_folder, top};

/// The target of the module.
pub(crate) const TARGET: &str = "wasm32-unknown-unknown";

/// Names the folder of the page to its tests.
pub(crate) const PAGE: &str = "TPG_PAGE";

/// Builds the page into `web` in cargo's target folder, and tests it.
pub(crate) fn check(run: &mut Run) {
    if let Some(page) = page(run) {
        let mut tests = cargo(&["test", "--package", "tpg-web", "--features", "page", "--no-fail-fast"]);
        tests.env(PAGE, page);
        run.tests("page", tests);
    }
}

/// Builds the page and returns its folder; `None` where that failed or its target is missing.
pub(crate) fn page(run: &mut Run) -> Option<PathBuf> {
    if !has_target(TARGET) {
        run.missing("page", &format!("rustup target add {TARGET}"));
        return None;
    }
    let folder = target_folder().join("web");
    let size = build(&folder).and_then(|size| browser_driver().map(|()| size));
    match size {
        Ok(size) => println!("{}: module of {size} bytes", folder.display()),
        Err(error) => {
            run.failed("page", &error);
            return None;
        }
    }
    Some(folder)
}

/// Builds the page into a folder; returns the module's size, which is within its limit.
fn build(folder: &Path) -> io::Result<u64> {
    // Only this crate type: beside a Rust library nothing would be optimised across crates.
    let kind = ["--lib", "--crate-type", "cdylib", "--profile", "web", "--target", TARGET];
    step(cargo(&[&["rustc", "--quiet", "--package", "tpg-web"], &kind[..]].concat()))?;
    let module = target_folder().join(TARGET).join("web/tpg_web.wasm");
    let (size, limit) = (fs::metadata(&module)?.len(), limit()?);
    if size > limit {
        return Err(io::Error::other(format!("a module of {size} bytes; accepted: up to {limit} (web/sizes.toml)")));
    }
    // Nothing of an earlier page may stay.
    let _ = fs::remove_dir_all(folder);
    fs::create_dir_all(folder)?;
    for entry in fs::read_dir(top().join("web/www"))? {
        let path = entry?.path();
        fs::copy(&path, folder.join(path.file_name().unwrap_or_default()))?;
    }
    fs::copy(module, folder.join("tpg_web.wasm"))?;
    let mut data = program("tpg-page")?;
    data.arg("--out").arg(folder.join("data.json"));
    step(data)?;
    Ok(size)
}

/// The greatest size of the module, bytes.
fn limit() -> io::Result<u64> {
    let path = top().join("web/sizes.toml");
    let text = fs::read_to_string(&path)?;
    let limit = text.lines().find_map(|line| line.strip_prefix("wasm = ")?.trim().parse().ok());
    limit.ok_or_else(|| io::Error::other(format!("{}: no line `wasm = BYTES`", path.display())))
}

/// Installs the browser's driver as its lock file says, unless it is there or npm is not: then the test says what it lacks.
fn browser_driver() -> io::Result<()> {
    let web = top().join("web");
    let stamp: PathBuf = web.join("node_modules/.package-lock.json");
    let newer =
        |a: &Path, b: &Path| Some(fs::metadata(a).ok()?.modified().ok()? >= fs::metadata(b).ok()?.modified().ok()?);
    if newer(&stamp, &web.join("package-lock.json")) == Some(true) || !tpg_testing::exists("npm") {
        return Ok(());
    }
    let mut npm = Command::new("npm");
    npm.args(["ci", "--no-audit", "--no-fund", "--ignore-scripts"]).current_dir(web);
    step(npm)
}
