//! `libtpg_runtime.a` as delivered to users: one object file that exports only `tpg_*`.
//!
//! rustc creates an archive of some 5 MB with hundreds of members: the compiler's builtins, which could shadow libgcc's
//! or clash with another Rust library's, and LLVM bitcode. Linking it in advance and dropping unreachable code leaves
//! 20 to 30 KB without such conflicts.

use crate::tool;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::{env, fs, io};

/// Targets that a library is built for, in addition to the host.
pub const TARGETS: [&str; 10] = [
    "thumbv6m-none-eabi",
    "thumbv7m-none-eabi",
    "thumbv7em-none-eabi",
    "thumbv7em-none-eabihf",
    "thumbv8m.base-none-eabi",
    "thumbv8m.main-none-eabi",
    "thumbv8m.main-none-eabihf",
    "riscv32imc-unknown-none-elf",
    "riscv32imac-unknown-none-elf",
    "riscv32imafc-unknown-none-elf",
];

/// The binutils of a target.
struct Binutils {
    /// Before the names of its programs.
    prefix: &'static str,
    /// The Debian package.
    package: &'static str,
    /// Arguments of its linker.
    link: &'static [&'static str],
}

impl Binutils {
    fn new(target: &str) -> Self {
        if target == host() {
            Self { prefix: "", package: "binutils", link: &[] }
        } else if target.starts_with("riscv32") {
            // It is a linker of 64 bits, too.
            let link = &["-m", "elf32lriscv"];
            Self { prefix: "riscv64-unknown-elf-", package: "gcc-riscv64-unknown-elf", link }
        } else {
            Self { prefix: "arm-none-eabi-", package: "gcc-arm-none-eabi", link: &[] }
        }
    }
}

/// Returns the repository's top folder.
pub fn top() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).map(Path::to_owned).unwrap_or_default()
}

/// Returns the host's triple.
pub fn host() -> &'static str {
    env!("XTASK_HOST")
}

/// Returns cargo's target folder.
pub fn target_folder() -> PathBuf {
    env::var_os("CARGO_TARGET_DIR").map_or_else(|| top().join("target"), PathBuf::from)
}

/// Returns the cargo that runs this program, in the repository's top folder.
pub fn cargo(arguments: &[&str]) -> Command {
    let mut cargo = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
    cargo.current_dir(top()).args(arguments);
    cargo
}

/// Returns the default installation folder of a target's libraries.
pub fn dist() -> PathBuf {
    target_folder().join("tpg_runtime")
}

/// Builds the library for a target (or [`host`]) in `folder`, with header, CMake and pkg-config files; returns its
/// location, or `None` if a tool or the target is not installed: the skip has been reported.
///
/// # Errors
/// If it is no target of the library, a command fails, or a file cannot be written.
pub fn make(target: &str, folder: &Path) -> io::Result<Option<PathBuf>> {
    let what = format!("libtpg_runtime.a for {target}");
    if target != host() && !TARGETS.contains(&target) {
        let accepted = TARGETS.into_iter().chain([host()]).collect::<Vec<_>>().join(", ");
        return Err(io::Error::other(format!("no target of the library; accepted: {accepted}")));
    }
    let Binutils { prefix, package, link } = Binutils::new(target);
    if !tool(&format!("{prefix}ld"), package, &what) || (target != host() && !rust_target(target, &what)) {
        return Ok(None);
    }
    let library = folder.join("lib").join(target);
    let objects = folder.join("objects").join(target);
    for folder in [&library, &objects] {
        at(folder, fs::create_dir_all(folder))?;
    }
    // Tests make the same library at the same time; the lock ends with the file.
    let lock = objects.join("lock");
    let _locked = at(&lock, fs::File::create(&lock).and_then(|file| file.lock().map(|()| file)))?;
    let package = ["build", "--quiet", "--package", "tpg-runtime-capi", "--profile", "firmware"];
    output(cargo(&package).args(["--target", target, "--lib"]))?;
    let made = target_folder().join(target).join("firmware/libtpg_runtime_capi.a");

    let run = |program: &str, arguments: &[&str]| {
        output(Command::new(format!("{prefix}{program}")).current_dir(&objects).args(arguments))
    };
    let path = made.to_string_lossy();
    // Debian's linker aborts on bitcode when linking in advance.
    run("objcopy", &["--strip-debug", "-R", ".llvmbc", "-R", ".llvmcmd", &path, "all.a"])?;
    let symbols = run("nm", &["--defined-only", "--extern-only", "--format=posix", "all.a"])?;
    let mut names: Vec<&str> =
        symbols.lines().filter_map(|line| line.split(' ').next()).filter(|name| name.starts_with("tpg_")).collect();
    names.sort_unstable();
    names.dedup();
    let wanted = names.iter().flat_map(|name| ["-u", name]);
    let relocatable = ["-r", "--gc-sections", "-o", "tpg_runtime.o"];
    let link: Vec<&str> = link.iter().copied().chain(relocatable).chain(wanted).chain(["all.a"]).collect();
    run("ld", &link)?;
    run("objcopy", &["--wildcard", "--keep-global-symbol=tpg_*", "--strip-unneeded", "tpg_runtime.o"])?;
    // Whoever links meanwhile sees the old archive or the new one.
    let (archive, made) = (library.join("libtpg_runtime.a"), objects.join("libtpg_runtime.a"));
    let _ = fs::remove_file(&made);
    run("ar", &["rcsD", "libtpg_runtime.a", "tpg_runtime.o"])?;
    at(&archive, fs::rename(&made, &archive))?;
    install(target, folder)?;
    Ok(Some(archive))
}

/// Names the file of an error.
fn at<T>(path: &Path, result: io::Result<T>) -> io::Result<T> {
    result.map_err(|error| io::Error::other(format!("{}: {error}", path.display())))
}

/// Copies the files that accompany the library.
fn install(target: &str, folder: &Path) -> io::Result<()> {
    let source = top().join("tpg-runtime-nostd/capi");
    let filled = |name: &str| {
        let text = fs::read_to_string(source.join(name));
        text.map(|text| text.replace("@VERSION@", env!("CARGO_PKG_VERSION")).replace("@TARGET@", target))
    };
    let put = |to: &str, text: io::Result<String>| {
        let path = folder.join(to);
        let written = text.and_then(|text| {
            fs::create_dir_all(path.parent().unwrap_or(folder))?;
            // Whoever compiles meanwhile, for another target, sees a whole file.
            let part = path.with_extension(format!("{target}.part"));
            fs::write(&part, text)?;
            fs::rename(&part, &path)
        });
        at(&path, written)
    };
    put("include/tpg_runtime.h", fs::read_to_string(source.join("include/tpg_runtime.h")))?;
    put("lib/cmake/tpg_runtime/tpg_runtime-config.cmake", fs::read_to_string(source.join("tpg_runtime-config.cmake")))?;
    let version = "lib/cmake/tpg_runtime/tpg_runtime-config-version.cmake";
    put(version, filled("tpg_runtime-config-version.cmake.in"))?;
    put(&format!("lib/{target}/pkgconfig/tpg_runtime.pc"), filled("tpg_runtime.pc.in"))
}

/// True if the compiler in use has a target's core library.
pub fn has_target(target: &str) -> bool {
    let output = Command::new("rustc").args(["--print", "sysroot"]).current_dir(top()).output();
    let sysroot = output.map(|output| String::from_utf8_lossy(&output.stdout).trim().to_owned()).unwrap_or_default();
    Path::new(&sysroot).join("lib/rustlib").join(target).join("lib").is_dir()
}

/// True if the compiler in use has a target's core library; otherwise `what` is skipped, or fails.
///
/// # Panics
/// If the target is missing and missing tools must fail.
pub fn rust_target(target: &str, what: &str) -> bool {
    if has_target(target) {
        return true;
    }
    let message = format!("{what}: not installed (rustup target add {target})");
    assert!(!crate::required(), "{message}");
    crate::skip(&message);
    false
}

/// Returns a command's output.
///
/// # Errors
/// If the command fails: its arguments and its output.
pub fn output(command: &mut Command) -> io::Result<String> {
    let result = command.output();
    let failed = |text: String| io::Error::other(format!("{command:?}:\n{text}"));
    let Output { status, stdout, stderr } = result.map_err(|error| failed(error.to_string()))?;
    let [stdout, stderr] = [stdout, stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
    if status.success() { Ok(stdout) } else { Err(failed(stdout + &stderr)) }
}
