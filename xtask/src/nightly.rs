//! Checks that need a nightly compiler: Miri, and sanitizers. Without their tools they are skipped loudly.

use crate::check::Run;
use std::process::Command;
use tpg_testing::library::{host, target_folder, top};
use tpg_testing::{answers, exists};

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

/// Runs Miri on the runtime, the kernels and the C interface.
pub(crate) fn miri(run: &mut Run) {
    if !answers("cargo", &["+nightly", "miri", "--version"]) {
        return run.missing("Miri", "rustup component add --toolchain nightly miri rust-src");
    }
    for arguments in MIRI {
        let mut cargo = Command::new("cargo");
        cargo.args(["+nightly", "miri", "test", "--target", PLAIN]).args(arguments.split(' '));
        cargo.env_remove("RUSTC").env_remove("RUSTDOC");
        // Few cases of each property; files of earlier failures are not read in isolation.
        cargo.env("PROPTEST_CASES", "4").env("MIRIFLAGS", "-Zmiri-disable-isolation");
        cargo.env("CARGO_TARGET_DIR", target_folder().join("miri")).env_remove("RUSTUP_TOOLCHAIN");
        cargo.current_dir(top());
        run.tests("Miri", cargo);
    }
}

/// Runs random calls of the C interface with the library and its caller instrumented: addresses, undefined behaviour,
/// overflow checks.
pub(crate) fn sanitize(run: &mut Run, seeds: u32) {
    let what = "the C interface under ASan and UBSan";
    if !answers("cargo", &["+nightly", "--version"]) || !exists("gcc") {
        return run.missing(what, "rustup toolchain install nightly; cargo xtask setup installs gcc");
    }
    let folder = target_folder().join("sanitize");
    let mut cargo = Command::new("cargo");
    cargo.args(["+nightly", "build", "--target", host(), "-p", "tpg-runtime-capi", "--lib"]);
    cargo.env("RUSTFLAGS", "-Zsanitizer=address -Coverflow-checks=on -Cdebug-assertions=on");
    cargo.env("CARGO_TARGET_DIR", &folder).env_remove("RUSTC").env_remove("RUSTUP_TOOLCHAIN").current_dir(top());
    run.check("the library, instrumented", cargo);
    // The random calls in C, with a generated network.
    let (capi, generated) = (top().join("tpg-runtime-nostd/capi"), top().join("generated/widowx-sac"));
    let program = folder.join("calls");
    let mut gcc = Command::new("gcc");
    gcc.args(["-std=c99", "-O1", "-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"]);
    gcc.arg("-I").arg(capi.join("include")).arg("-I").arg(&generated);
    gcc.arg(capi.join("tests/c/calls.c")).arg(generated.join("widowx_sac.c"));
    gcc.arg(folder.join(host()).join("debug/libtpg_runtime_capi.a"));
    gcc.args(["-lm", "-lpthread", "-ldl", "-o"]).arg(&program);
    run.check("their caller, instrumented", gcc);
    for seed in 0..seeds {
        let mut calls = Command::new(&program);
        calls.args([&seed.to_string(), ROUNDS]).env("ASAN_OPTIONS", "detect_leaks=0");
        run.check(&format!("{what}, seed {seed}"), calls);
    }
}
