//! Downloads for users: `cargo xtask dist`.
//!
//! | module | subject |
//! | --- | --- |
//! | [`bill`] | the bill of materials: every crate in what is shipped |

mod bill;

use crate::check::step;
use clap::Args;
use sha2::{Digest as _, Sha256};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{fs, io};
use tpg_testing::library::{self, cargo};

/// The target of programs that need nothing of the machine but Linux.
const STATIC: &str = "x86_64-unknown-linux-musl";
/// The programs, each of a crate with its name.
const PROGRAMS: [&str; 3] = ["tpg-codegen", "tpg-train", "cortex-bound"];
/// Files beside programs and libraries.
const BESIDE: [&str; 3] = ["LICENSE-MIT", "LICENSE-APACHE", "CHANGELOG.md"];

/// Make what users download.
#[derive(Clone, Debug, Args)]
pub(crate) struct DistArgs {
    /// Output folder; by default `dist` in cargo's target folder
    #[arg(short, long)]
    out: Option<PathBuf>,
    /// Leave the programs out: they take minutes to build
    #[arg(long)]
    without_programs: bool,
}

impl DistArgs {
    /// Makes everything. What lacks a tool or target is skipped, loudly.
    pub(crate) fn run(&self) -> io::Result<()> {
        let out = &self.out.clone().unwrap_or_else(|| library::target_folder().join("dist"));
        fs::create_dir_all(out)?;
        let mut made = Vec::new();
        if !self.without_programs {
            made.extend(programs(out)?);
        }
        made.extend(libraries(out)?);
        let bill = out.join("tpg.cdx.json");
        fs::write(&bill, bill::text()?)?;
        made.push(bill);
        let sums = out.join("SHA256SUMS");
        fs::write(&sums, checksums(&made)?)?;
        made.push(sums);
        for path in made {
            println!("{}", path.display());
        }
        Ok(())
    }
}

/// The programs in an archive; `None` where their target is missing.
fn programs(out: &Path) -> io::Result<Option<PathBuf>> {
    if !library::rust_target(STATIC, "static programs for Linux") {
        return Ok(None);
    }
    let mut build = cargo(&["build", "--quiet", "--release", "--locked", "--target", STATIC]);
    for name in PROGRAMS {
        build.args(["--package", name, "--bin", name]);
    }
    step(build)?;
    let name = format!("tpg-{}-{STATIC}", env!("CARGO_PKG_VERSION"));
    let folder = empty(out.join(&name))?;
    for program in PROGRAMS {
        let (from, to) = (library::target_folder().join(STATIC).join("release").join(program), folder.join(program));
        fs::copy(from, &to)?;
        let mut strip = Command::new("strip");
        strip.arg(&to);
        step(strip)?;
    }
    beside(&folder)?;
    archive(out, &name).map(Some)
}

/// The libraries of every target that is installed, in one archive.
fn libraries(out: &Path) -> io::Result<Option<PathBuf>> {
    let name = format!("tpg_runtime-{}", env!("CARGO_PKG_VERSION"));
    let folder = empty(out.join(&name))?;
    let mut count = 0;
    for target in library::TARGETS.into_iter().chain([library::host()]) {
        count += usize::from(library::make(target, &folder)?.is_some());
    }
    if count == 0 {
        return Ok(None);
    }
    // What they were made of.
    fs::remove_dir_all(folder.join("objects"))?;
    beside(&folder)?;
    archive(out, &name).map(Some)
}

/// A folder with nothing in it.
fn empty(folder: PathBuf) -> io::Result<PathBuf> {
    if folder.exists() {
        fs::remove_dir_all(&folder)?;
    }
    fs::create_dir_all(&folder)?;
    Ok(folder)
}

fn beside(folder: &Path) -> io::Result<()> {
    BESIDE.iter().try_for_each(|name| fs::copy(library::top().join(name), folder.join(name)).map(|_| ()))
}

/// Packs a folder of `out`: the same files give the same bytes.
fn archive(out: &Path, name: &str) -> io::Result<PathBuf> {
    let file = format!("{name}.tar.gz");
    let mut tar = Command::new("tar");
    tar.current_dir(out).args(["--sort=name", "--mtime=@0", "--owner=0", "--group=0", "--numeric-owner"]);
    tar.args(["--mode=u=rwX,go=rX", "--use-compress-program=gzip -n", "-cf", &file, name]);
    step(tar)?;
    Ok(out.join(file))
}

/// The lines that `sha256sum --check` reads.
fn checksums(files: &[PathBuf]) -> io::Result<String> {
    let mut text = String::new();
    for path in files {
        let digest = Sha256::digest(fs::read(path)?);
        let name = path.file_name().unwrap_or_default().display();
        digest.iter().for_each(|byte| {
            let _ = write!(text, "{byte:02x}");
        });
        let _ = writeln!(text, "  {name}");
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::{archive, checksums};
    use std::fs;
    use std::path::Path;
    use std::process::Command;

    #[test]
    fn archives_are_the_same_bytes_and_their_checksums_are_those_of_sha256sum() {
        // A relative path, as a user may name one.
        let folder = tempfile::TempDir::new_in(".").expect("a temporary folder");
        let out = Path::new(folder.path().file_name().expect("it has one"));
        let write = |name: &str| fs::write(folder.path().join("it").join(name), name).expect("writable");
        fs::create_dir(folder.path().join("it")).expect("writable");
        write("b");
        write("a");
        let first = archive(out, "it").expect("tar is there");
        let bytes = fs::read(&first).expect("an archive");
        write("a");
        archive(out, "it").expect("tar is there");
        assert!(fs::read(&first).expect("an archive") == bytes);
        let sums = checksums(&[first]).expect("readable");
        fs::write(folder.path().join("SHA256SUMS"), sums).expect("writable");
        let mut check = Command::new("sha256sum");
        assert!(
            check.current_dir(folder.path()).args(["--check", "SHA256SUMS"]).status().expect("it starts").success()
        );
    }
}
