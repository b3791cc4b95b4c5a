//! Installs what is missing and prints each command before running it.

use crate::{check, web};
use std::path::Path;
use std::process::{Command, Stdio};
use tpg_testing::library::TARGETS;

/// Debian packages, each with a program or file that shows whether it is installed.
const PACKAGES: &[&str] = &[
    "gcc /usr/bin/gcc",
    "g++ /usr/bin/g++",
    "clang /usr/bin/clang",
    "tcc /usr/bin/tcc",
    "clang-tidy /usr/bin/clang-tidy",
    "cppcheck /usr/bin/cppcheck",
    "gcc-arm-none-eabi /usr/bin/arm-none-eabi-gcc",
    "libnewlib-arm-none-eabi /usr/lib/arm-none-eabi/include/newlib.h",
    "gcc-riscv64-unknown-elf /usr/bin/riscv64-unknown-elf-gcc",
    "picolibc-riscv64-unknown-elf /usr/lib/picolibc/riscv64-unknown-elf/include/math.h",
    "picolibc-arm-none-eabi /usr/lib/picolibc/arm-none-eabi/include/math.h",
    "gcc-avr /usr/bin/avr-gcc",
    "avr-libc /usr/lib/avr/include/avr/io.h",
    "gcc-powerpc-linux-gnu /usr/bin/powerpc-linux-gnu-gcc",
    "libc6-dev-powerpc-cross /usr/powerpc-linux-gnu/include/math.h",
    "lld /usr/bin/wasm-ld",
    "wasi-libc /usr/include/wasm32-wasi/math.h",
    "libclang-rt-14-dev-wasm32 /usr/lib/llvm-14/lib/clang/14.0.6/lib/wasi/libclang_rt.builtins-wasm32.a",
    "qemu-system-arm /usr/bin/qemu-system-arm",
    "qemu-system-misc /usr/bin/qemu-system-riscv32",
    "simavr /usr/bin/simavr",
    "qemu-user /usr/bin/qemu-ppc",
    "valgrind /usr/bin/valgrind",
    "cmake /usr/bin/cmake",
    "make /usr/bin/make",
    "meson /usr/bin/meson",
    "pkg-config /usr/bin/pkg-config",
    "frama-c-base /usr/bin/frama-c",
    "python3-venv /usr/lib/python3.11/ensurepip/__init__.py",
    "openmpi-bin /usr/bin/mpirun",
    "libopenmpi-dev /usr/bin/mpicc",
    "nodejs /usr/bin/node",
    "npm /usr/bin/npm",
    "chromium /usr/bin/chromium",
];

const COMPONENTS: [&str; 2] = ["rustfmt", "clippy"];

/// Rust targets beside this machine's. Not every mirror has Cortex-M23's, which no check needs.
fn targets() -> impl Iterator<Item = &'static str> {
    TARGETS.into_iter().filter(|target| *target != "thumbv8m.base-none-eabi").chain([web::TARGET])
}

/// Installs everything; returns true if all is present afterwards.
pub(crate) fn run() -> bool {
    let packages = packages();
    let rust = rust();
    packages && rust
}

fn packages() -> bool {
    let packages = PACKAGES.iter().filter_map(|line| line.split_once(' '));
    let missing: Vec<&str> =
        packages.filter(|(_, file)| !Path::new(file).exists()).map(|(package, _)| package).collect();
    if missing.is_empty() {
        println!("setup: compilers, linters and emulator are installed");
        return true;
    }
    if !Path::new("/usr/bin/apt-get").exists() {
        eprintln!(
            "setup: no apt-get; install these Debian packages, or their equivalents, by hand: {}",
            missing.join(" ")
        );
        return false;
    }
    // New machines usually have no package index, or an old one.
    let install = ["install", "-y", "--no-install-recommends"].into_iter().chain(missing).collect::<Vec<_>>();
    apt(&["update"]) && apt(&install)
}

fn apt(arguments: &[&str]) -> bool {
    let mut words = vec!["env", "DEBIAN_FRONTEND=noninteractive", "apt-get"];
    if !is_root() {
        words.insert(0, "sudo");
    }
    words.extend(arguments);
    step(&words)
}

fn is_root() -> bool {
    let id = Command::new("id").arg("-u").output();
    id.is_ok_and(|output| output.stdout.trim_ascii() == b"0")
}

fn rust() -> bool {
    let Some(installed) = listed(&["component", "list", "--installed"]) else {
        eprintln!(
            "setup: no rustup; make sure that {} and the targets {} are installed",
            COMPONENTS.join(", "),
            targets().collect::<Vec<_>>().join(", ")
        );
        return true;
    };
    let installed_targets = listed(&["target", "list", "--installed"]).unwrap_or_default();
    let mut good = true;
    // Component names are followed by the host's name.
    for component in COMPONENTS.iter().filter(|name| !installed.iter().any(|line| line.starts_with(**name))) {
        good &= step(&["rustup", "component", "add", component]);
    }
    for target in targets().filter(|name| !installed_targets.iter().any(|line| line == name)) {
        good &= step(&["rustup", "target", "add", target]);
    }
    if good {
        println!("setup: Rust's components and targets are installed");
    }
    good
}

/// Returns the items listed by rustup, one per line.
fn listed(arguments: &[&str]) -> Option<Vec<String>> {
    let output = Command::new("rustup").args(arguments).stderr(Stdio::inherit()).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout);
    output.status.success().then(|| text.lines().map(|line| line.trim().to_owned()).collect())
}

fn step(words: &[&str]) -> bool {
    let mut command = Command::new(words[0]);
    command.args(&words[1..]);
    check::step(command).inspect_err(|error| eprintln!("setup: {error}")).is_ok()
}
