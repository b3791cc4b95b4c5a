//! Checks that need a nightly compiler: Miri, and sanitizers. Without their tools they are skipped loudly.

use crate::check::answers;
use std::path::PathBuf;
use std::process::{Command, Stdio};
use tpg_testing::library::{self, Missing};

/// The tests that Miri interprets.
///
/// It is some thousand times slower, so tests are left out that compute a great many numbers in safe code, as they do
/// without it. A machine without SIMD takes the kernels' portable form, and the crate `libm` without inline assembly, which
/// Miri does not know.
const MIRI: [&str; 3] = [RUNTIME, "-p tpg-kernels", "-p tpg-runtime-capi --test all calls::"];
const RUNTIME: &str = "-p tpg-runtime --lib -- --skip cycle:: --skip ops:: --skip a_million_inputs --skip it_is_near_tanh --skip a_multiplier_is_its_rescale --skip inputs_are_rounded";

/// A machine without SIMD and without inline assembly in `libm`.
const PLAIN: &str = "riscv64gc-unknown-linux-gnu";

/// Rounds of random calls for each seed, some 57,000 calls.
const ROUNDS: &str = "20000";

/// Runs Miri on the runtime, the kernels and the C interface; returns true if it found nothing.
pub(crate) fn miri() -> bool {
    if !there(&["+nightly", "miri", "--version"], "rustup component add --toolchain nightly miri rust-src", "Miri") {
        return !tpg_testing::required();
    }
    MIRI.iter().fold(true, |good, arguments| {
        println!("\n==== Miri: {arguments}");
        let mut cargo = Command::new("cargo");
        cargo.args(["+nightly", "miri", "test", "--target", PLAIN]).args(arguments.split(' '));
        cargo.env_remove("RUSTC").env_remove("RUSTDOC");
        // Few cases of each property; files of earlier failures are not read in isolation.
        cargo.env("PROPTEST_CASES", "4").env("MIRIFLAGS", "-Zmiri-disable-isolation");
        cargo.env("CARGO_TARGET_DIR", library::target_folder().join("miri")).env_remove("RUSTUP_TOOLCHAIN");
        cargo.current_dir(library::top()).stdin(Stdio::null()).status().is_ok_and(|status| status.success()) && good
    })
}

/// Runs random calls of the C interface with the library and its caller instrumented: addresses, undefined behaviour,
/// overflow checks. Returns true if nothing was found.
pub(crate) fn sanitize(seeds: u32) -> bool {
    let what = "the C interface under ASan and UBSan";
    if !there(&["+nightly", "--version"], "rustup toolchain install nightly", what)
        || !tpg_testing::tool("gcc", "gcc", what)
    {
        return !tpg_testing::required();
    }
    match calls() {
        Ok(program) => (0..seeds).all(|seed| {
            let mut calls = Command::new(&program);
            run(calls.args([&seed.to_string(), ROUNDS]).env("ASAN_OPTIONS", "detect_leaks=0"), seed)
        }),
        Err(error) => {
            eprintln!("{what}: {error:?}");
            false
        }
    }
}

/// Returns a command of cargo that instruments what it builds.
fn instrumented() -> Command {
    let mut cargo = Command::new("cargo");
    cargo.args(["+nightly", "build", "--target", library::host(), "-p", "tpg-runtime-capi", "--lib"]);
    cargo.env("RUSTFLAGS", "-Zsanitizer=address -Coverflow-checks=on -Cdebug-assertions=on");
    cargo.env("CARGO_TARGET_DIR", folder()).env_remove("RUSTC").env_remove("RUSTUP_TOOLCHAIN");
    cargo.current_dir(library::top());
    cargo
}

fn folder() -> PathBuf {
    library::target_folder().join("sanitize")
}

/// Builds the library and the random calls in C, with a generated network, all of it instrumented; returns the program.
fn calls() -> Result<PathBuf, Missing> {
    library::output(&mut instrumented())?;
    let (capi, generated) =
        (library::top().join("tpg-runtime-nostd/capi"), library::top().join("generated/widowx-sac"));
    let program = folder().join("calls");
    let mut gcc = Command::new("gcc");
    gcc.args(["-std=c99", "-O1", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]);
    gcc.arg("-I").arg(capi.join("include")).arg("-I").arg(&generated);
    gcc.arg(capi.join("tests/c/calls.c")).arg(generated.join("widowx_sac.c"));
    gcc.arg(folder().join(library::host()).join("debug/libtpg_runtime_capi.a"));
    library::output(gcc.args(["-lm", "-lpthread", "-ldl", "-o"]).arg(&program))?;
    Ok(program)
}

/// Runs a program and prints its text; returns true if it succeeded.
fn run(program: &mut Command, seed: u32) -> bool {
    match library::output(program) {
        Ok(text) => {
            print!("seed {seed}: {text}");
            true
        }
        Err(error) => {
            eprintln!("seed {seed}: {error:?}");
            false
        }
    }
}

/// True if cargo answers so; otherwise that `what` is skipped is reported, with the command that installs it.
fn there(arguments: &[&str], remedy: &str, what: &str) -> bool {
    let found = answers("cargo", arguments);
    if !found {
        tpg_testing::skip(&format!("{what}: not installed ({remedy})"));
    }
    found
}
