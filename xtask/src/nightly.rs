//! Checks that need a nightly compiler: Miri, and sanitizers. Without their tools they are skipped loudly.

use std::path::PathBuf;
use std::process::{Command, Stdio};
use tpg_testing::library;

/// The tests that Miri interprets.
///
/// It is some thousand times slower, so tests are left out that compute a great many numbers in safe code, as they do
/// without it. A machine without SIMD takes the kernels' portable form, and the crate `libm` without inline assembly, which
/// Miri does not know; the kernels run on x86-64 too, by SSE2.
const MIRI: [&[&str]; 4] = [
    &[
        "--target",
        PLAIN,
        "-p",
        "tpg-runtime",
        "--lib",
        "--",
        "--skip",
        "cycle::",
        "--skip",
        "ops::",
        "--skip",
        "a_million_inputs",
        "--skip",
        "a_multiplier_is_its_rescale",
        "--skip",
        "it_is_near_tanh",
        "--skip",
        "inputs_are_rounded",
    ],
    &["--target", PLAIN, "-p", "tpg-kernels"],
    &["--target", "x86_64-unknown-linux-gnu", "-p", "tpg-kernels"],
    &["--target", PLAIN, "-p", "tpg-runtime-capi", "--test", "all", "calls::"],
];

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
        println!("\n==== Miri: {}", arguments.join(" "));
        let mut cargo = Command::new("cargo");
        cargo.args(["+nightly", "miri", "test"]).args(*arguments).env_remove("RUSTC").env_remove("RUSTDOC");
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
    match MEMORY.driver("calls.c", &["widowx-sac/widowx_sac"]) {
        Ok(program) => (0..seeds).all(|seed| {
            let mut calls = Command::new(&program);
            run(calls.args([&seed.to_string(), ROUNDS]).env("ASAN_OPTIONS", "detect_leaks=0"), seed)
        }),
        Err(message) => {
            eprintln!("{what}: {message}");
            false
        }
    }
}

/// Runs what has threads under ThreadSanitizer: evolution's evaluator, and tasks that call the C interface side by side.
/// Returns true if nothing was found.
pub(crate) fn threads() -> bool {
    let what = "threads under ThreadSanitizer";
    if !standard_library_there(what) || !tpg_testing::tool("gcc", "gcc", what) {
        return !tpg_testing::required();
    }
    let mut engine = THREADS.cargo("test");
    engine.args(["-p", "tpg-engine", "--lib", "--test", "all"]);
    let good = engine.stdin(Stdio::null()).status().is_ok_and(|status| status.success());
    match THREADS.driver("threads.c", &["widowx-sac/widowx_sac", "widowx-rs/widowx_rs"]) {
        Ok(program) => (0..3).all(|seed| run(Command::new(&program).arg(seed.to_string()), seed)) && good,
        Err(message) => {
            eprintln!("{what}: {message}");
            false
        }
    }
}

/// A sanitizer, for the compilers of Rust and of C.
struct Sanitizer {
    /// Folder below cargo's target folder.
    folder: &'static str,
    rust: &'static str,
    /// Flags of cargo: the standard library instrumented, too, where threads are.
    cargo: &'static [&'static str],
    c: &'static [&'static str],
    /// The runtime in the nightly compiler's folder, where gcc's lacks what Rust calls; else gcc links its own.
    runtime: Option<&'static str>,
}

const MEMORY: Sanitizer = Sanitizer {
    folder: "sanitize",
    rust: "-Zsanitizer=address -Coverflow-checks=on -Cdebug-assertions=on",
    cargo: &[],
    c: &["-fsanitize=address,undefined", "-fno-sanitize-recover=all"],
    runtime: None,
};

/// Crossbeam's fences are unknown to ThreadSanitizer: by this name it takes others.
const THREADS: Sanitizer = Sanitizer {
    folder: "threads",
    rust: "-Zsanitizer=thread --cfg crossbeam_sanitize_thread",
    cargo: &["-Zbuild-std"],
    c: &["-fsanitize=thread"],
    runtime: Some("librustc-nightly_rt.tsan.a"),
};

impl Sanitizer {
    fn folder(&self) -> PathBuf {
        library::target_folder().join(self.folder)
    }

    /// Returns a command of cargo that instruments what it builds.
    fn cargo(&self, command: &str) -> Command {
        let mut cargo = Command::new("cargo");
        cargo.args(["+nightly", command]).args(self.cargo).args(["--target", library::host()]);
        cargo.env("RUSTFLAGS", self.rust).env("CARGO_TARGET_DIR", self.folder());
        cargo.env_remove("RUSTC").env_remove("RUSTUP_TOOLCHAIN").current_dir(library::top());
        cargo
    }

    /// Builds the library and a C program of the interface's tests, with generated policies; returns the program.
    fn driver(&self, name: &str, policies: &[&str]) -> Result<PathBuf, String> {
        let mut cargo = self.cargo("build");
        cargo.args(["-p", "tpg-runtime-capi", "--lib"]);
        library::output(&mut cargo).map_err(|error| format!("{error:?}"))?;
        let (capi, generated) = (library::top().join("tpg-runtime-nostd/capi"), library::top().join("generated"));
        let policies = policies.iter().map(|policy| generated.join(policy).with_extension("c"));
        let sources: Vec<PathBuf> = policies.chain([capi.join("tests/c").join(name)]).collect();
        let mut include = vec![format!("-I{}", capi.join("include").display())];
        include.extend(sources.iter().map(|source| format!("-I{}", source.with_file_name("").display())));
        let mut objects = Vec::new();
        for source in &sources {
            let object = self.folder().join(source.with_extension("o").file_name().unwrap_or_default());
            let mut gcc = Command::new("gcc");
            gcc.args(["-std=c99", "-O1", "-g", "-c"]).args(self.c).args(&include).arg(source).arg("-o").arg(&object);
            library::output(&mut gcc).map_err(|error| format!("{error:?}"))?;
            objects.push(object);
        }
        let program = self.folder().join("driver");
        let mut gcc = Command::new("gcc");
        gcc.args(&objects).arg(self.folder().join(library::host()).join("debug/libtpg_runtime_capi.a"));
        match self.runtime {
            Some(name) => {
                let runtime = library_of_rust().join(name);
                gcc.arg("-Wl,--whole-archive").arg(runtime).arg("-Wl,--no-whole-archive");
            }
            None => drop(gcc.args(self.c)),
        }
        gcc.args(["-lm", "-lpthread", "-ldl", "-o"]).arg(&program);
        library::output(&mut gcc).map_err(|error| format!("{error:?}"))?;
        Ok(program)
    }
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

/// True if the source of the nightly standard library is there; otherwise that `what` is skipped is reported.
fn standard_library_there(what: &str) -> bool {
    let found = sysroot().join("lib/rustlib/src/rust/library/Cargo.toml").exists();
    if !found {
        tpg_testing::skip(&format!("{what}: not installed (rustup component add --toolchain nightly rust-src)"));
    }
    found
}

/// Returns the folder of the nightly compiler; an empty path without one.
fn sysroot() -> PathBuf {
    let mut rustc = Command::new("rustc");
    rustc.args(["+nightly", "--print", "sysroot"]).env_remove("RUSTUP_TOOLCHAIN").stderr(Stdio::null());
    rustc.output().map(|output| String::from_utf8_lossy(&output.stdout).trim().into()).unwrap_or_default()
}

/// Returns the folder of the nightly compiler's libraries for this machine.
fn library_of_rust() -> PathBuf {
    sysroot().join("lib/rustlib").join(library::host()).join("lib")
}

/// True if cargo answers so; otherwise that `what` is skipped is reported, with the command that installs it.
fn there(arguments: &[&str], remedy: &str, what: &str) -> bool {
    let mut cargo = Command::new("cargo");
    cargo
        .args(arguments)
        .env_remove("RUSTUP_TOOLCHAIN")
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    let found = cargo.status().is_ok_and(|status| status.success());
    if !found {
        tpg_testing::skip(&format!("{what}: not installed ({remedy})"));
    }
    found
}
