//! The library as C and C++ programs see it: every code, what it exports, and that another float ABI does not link.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Mutex, PoisonError};
use tempfile::TempDir;
use tpg_generated::widowx_sac;
use tpg_testing::library;

/// Targets that are looked at: both cores of Arm, with floats in hardware and without, and one of RISC-V. `cargo xtask cores`
/// links and runs more.
const TESTED: [&str; 4] =
    ["thumbv6m-none-eabi", "thumbv7em-none-eabi", "thumbv7em-none-eabihf", "riscv32imac-unknown-none-elf"];

/// The library for a target; `None` where a tool is missing, which has been said.
fn made(target: &str) -> Option<PathBuf> {
    // Made once: tests run side by side, and none may read what another writes.
    static MADE: Mutex<BTreeMap<String, Option<PathBuf>>> = Mutex::new(BTreeMap::new());
    let mut made = MADE.lock().unwrap_or_else(PoisonError::into_inner);
    let make = || library::make(target, &library::dist()).expect("it builds");
    made.entry(target.to_owned()).or_insert_with(make).clone()
}

fn include() -> String {
    format!("-I{}", library::dist().join("include").display())
}

fn source(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/c").join(name)
}

/// Runs a command; returns true if it succeeded, and the text that it prints.
fn run(command: &mut Command) -> (bool, String) {
    let output = command.output().expect("it starts");
    let text = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
    (output.status.success(), text)
}

/// The shipped network as C.
fn write_model(folder: &Path) {
    let words = widowx_sac::MODEL;
    let mut text = format!(
        "#define MODEL_WORDS {}U\n#define MODEL_SCRATCH {}U\nstatic const uint32_t model[MODEL_WORDS] = {{\n",
        words.len(),
        widowx_sac::SCRATCH
    );
    for word in words {
        let _ = writeln!(text, "    {word}U,");
    }
    text.push_str("};\n");
    fs::write(folder.join("model.h"), text).expect("the folder can be written");
}

#[test]
fn every_code_in_c99_and_cpp11() {
    let Some(archive) = made(library::host()) else { return };
    let folder = TempDir::new().expect("a temporary folder");
    write_model(folder.path());
    const C99: &[&str] = &["-std=c99", "-Wstrict-prototypes"];
    const CPP11: &[&str] = &["-x", "c++", "-std=c++11"];
    for (program, language) in [("gcc", C99), ("g++", CPP11)] {
        if !tpg_testing::tool(program, program, "the C interface") {
            continue;
        }
        let mut command = Command::new(program);
        command.args(language).args(["-g", "-O1", "-fsanitize=undefined", "-fno-sanitize-recover=all"]);
        command.args(["-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wshadow", "-Werror"]);
        command.arg(include()).arg(format!("-I{}", folder.path().display())).arg(source("codes.c"));
        command.args(["-x", "none"]).arg(&archive).arg("-lm").arg("-o").arg(folder.path().join(program));
        let (good, text) = run(&mut command);
        assert!(good, "{program}: {text}");
        let (good, text) = run(&mut Command::new(folder.path().join(program)));
        assert!(good, "{program}: {text}");
    }
}

#[test]
fn random_calls_are_answered_by_codes() {
    let Some(archive) = made(library::host()) else { return };
    if !tpg_testing::tool("gcc", "gcc", "random calls of the C interface") {
        return;
    }
    let folder = TempDir::new().expect("a temporary folder");
    let (program, generated) = (folder.path().join("calls"), library::top().join("generated/widowx-sac"));
    let mut gcc = Command::new("gcc");
    gcc.args(["-std=c99", "-O1", "-g", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]);
    // The library itself is instrumented by `cargo xtask sanitize`, with a nightly compiler.
    gcc.args(["-fsanitize=address,undefined", "-fno-sanitize-recover=all"]);
    gcc.arg(include()).arg(format!("-I{}", generated.display())).arg(source("calls.c"));
    gcc.arg(generated.join("widowx_sac.c")).arg(&archive).arg("-lm").arg("-o").arg(&program);
    let (good, text) = run(&mut gcc);
    assert!(good, "{text}");
    for seed in 0..tpg_testing::amount(2, 20) {
        let mut calls = Command::new(&program);
        let (good, text) = run(calls.args([&seed.to_string(), "20000"]).env("ASAN_OPTIONS", "detect_leaks=0"));
        assert!(good, "seed {seed}: {text}");
        // Codes are reached, or the driver tests nothing. Behind a wrong checksum no other damage of a model is looked for.
        let reached: Vec<&str> = text.split_whitespace().filter(|word| word.contains(':')).collect();
        let unreached: Vec<&str> = reached.iter().copied().filter(|word| word.ends_with(":0")).collect();
        assert!(reached.len() == 14 && unreached == ["8:0", "9:0"], "seed {seed}: {text}");
    }
}

/// The line of a mode of `sensors.c`, by name: steps OK, bad targets, bad sensors, stuck.
fn steps(text: &str, name: &str) -> [u32; 4] {
    let line = text.lines().find(|line| line.starts_with(&format!("{name} "))).expect("every mode has a line");
    let mut values = line.split(['=', ' ']).filter_map(|word| word.parse().ok());
    std::array::from_fn(|_| values.next().expect("four numbers"))
}

#[test]
fn the_shipped_hybrids_move_nothing_on_readings_that_cannot_be() {
    let Some(archive) = made(library::host()) else { return };
    if !tpg_testing::tool("gcc", "gcc", "the shipped hybrids on bad readings") {
        return;
    }
    let folder = TempDir::new().expect("a temporary folder");
    write_model(folder.path());
    let program = folder.path().join("sensors");
    let mut gcc = Command::new("gcc");
    gcc.args(["-std=c99", "-O1", "-g", "-ffp-contract=off", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]);
    gcc.args(["-fsanitize=undefined", "-fno-sanitize-recover=all"]);
    gcc.arg(include()).arg(format!("-I{}", folder.path().display())).arg(source("sensors.c"));
    for name in ["fs", "rs"] {
        let generated = library::top().join(format!("generated/widowx-{name}"));
        gcc.arg(format!("-I{}", generated.display())).arg(generated.join(format!("widowx_{name}.c")));
    }
    let (good, text) = run(gcc.arg(&archive).arg("-lm").arg("-o").arg(&program));
    assert!(good, "{text}");
    let episodes = tpg_testing::amount(60, 2_000);
    let (good, text) = run(Command::new(&program).args(["1", &episodes.to_string()]));
    assert!(good, "{text}");
    for hybrid in ["fs", "rs"] {
        let of = |mode: &str| steps(&text, &format!("{hybrid} {mode}"));
        let [_, target, sensor, stuck] = of("clean");
        assert_eq!([target, sensor, stuck], [0; 3], "good readings are good: {text}");
        let each = |mode: &str, place: usize| assert!(of(mode)[place] > 100, "{mode}: {text}");
        each("stuck", 3);
        each("pose-jumps", 3);
        each("any-pose", 2);
        each("any-target", 1);
        assert!(of("stuck")[0] < 45 * episodes, "{text}");
    }
}

#[test]
fn only_the_interface_is_exported() {
    for target in TESTED.into_iter().chain([library::host()]) {
        let Some(archive) = made(target) else { continue };
        let (good, text) = run(Command::new("nm").args(["--format=posix", "--extern-only"]).arg(&archive));
        assert!(good, "{text}");
        let header = fs::read_to_string(library::dist().join("include/tpg_runtime.h")).expect("the header");
        let mut functions = 0;
        for line in text.lines().filter(|line| line.split(' ').count() > 1) {
            let mut words = line.split(' ');
            let (name, kind) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
            // The host's C library gives these two; a microcontroller's image needs nothing.
            if kind == "U" && target == library::host() && ["memcpy", "memset"].contains(&name) {
                continue;
            }
            assert!(kind == "T" && name.starts_with("tpg_"), "{target}: {line}");
            assert!(header.contains(&format!(" {name}(")), "{target}: {name} is not in the header");
            functions += 1;
        }
        assert_eq!(functions, header.matches("\nint32_t tpg_").count() + 1, "{target}");
    }
}

#[test]
fn nothing_in_the_library_can_panic_or_allocate() {
    for target in TESTED {
        let Some(archive) = made(target) else { continue };
        let (good, text) = run(Command::new("nm").arg(&archive));
        assert!(good, "{text}");
        for forbidden in ["panic", "unwrap_failed", "alloc", "__aeabi_d", "__adddf3", "__muldf3"] {
            assert!(!text.contains(forbidden), "{target}: {forbidden}\n{text}");
        }
    }
}

#[test]
fn another_float_abi_does_not_link() {
    if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "float ABIs at link time") {
        return;
    }
    let folder = TempDir::new().expect("a temporary folder");
    let main = folder.path().join("main.c");
    // A function with a float in a register: what the two ABIs disagree on.
    fs::write(
        &main,
        "#include \"tpg_runtime.h\"\nfloat f(float x);\nfloat f(float x) { return x + 1.0F; }\n\
         int main(void) { return (f(1.0F) > 0.0F) ? (int)tpg_version() : 0; }\n",
    )
    .expect("the folder can be written");
    let link = |target: &str, float: &str| {
        let archive = made(target)?;
        let mut command = Command::new("arm-none-eabi-gcc");
        command.args(["-mcpu=cortex-m4", "-mthumb", "-mfpu=fpv4-sp-d16", &format!("-mfloat-abi={float}"), "-nostdlib"]);
        command.args(["-Wl,-e,main", "-Wl,-u,tpg_version"]).arg(include()).arg(&main).arg(archive).arg("-lgcc");
        Some(run(command.arg("-o").arg(folder.path().join("image"))))
    };
    for (target, right, wrong) in [("thumbv7em-none-eabihf", "hard", "soft"), ("thumbv7em-none-eabi", "soft", "hard")] {
        let (Some((good, text)), Some((bad, refusal))) = (link(target, right), link(target, wrong)) else { return };
        assert!(good, "{target} with -mfloat-abi={right}: {text}");
        assert!(!bad && refusal.contains("uses VFP register arguments"), "{target}, {wrong}: {refusal}");
    }
}

#[test]
fn cmake_and_pkg_config_find_it() {
    let Some(_) = made(library::host()) else { return };
    let folder = TempDir::new().expect("a temporary folder");
    let main = "#include \"tpg_runtime.h\"\nint main(void) { return (tpg_version() == TPG_VERSION) ? 0 : 1; }\n";
    fs::write(folder.path().join("main.c"), main).expect("the folder can be written");
    let pkg_config = [("pkg-config", "pkg-config"), ("gcc", "gcc")];
    if pkg_config.into_iter().all(|(program, package)| tpg_testing::tool(program, package, "tpg_runtime.pc")) {
        let search = library::dist().join("lib").join(library::host()).join("pkgconfig");
        let mut command = Command::new("pkg-config");
        let (good, flags) = run(command.env("PKG_CONFIG_PATH", search).args(["--cflags", "--libs", "tpg_runtime"]));
        assert!(good, "{flags}");
        let mut gcc = Command::new("gcc");
        gcc.current_dir(folder.path()).args(["main.c", "-o", "with-pkg-config"]).args(flags.split_whitespace());
        let (good, text) = run(&mut gcc);
        assert!(good, "{text}");
        assert!(run(&mut Command::new(folder.path().join("with-pkg-config"))).0);
    }
    if tpg_testing::tool("cmake", "cmake", "tpg_runtime-config.cmake") {
        let lists = "cmake_minimum_required(VERSION 3.16)\nproject(example C)\n\
                     find_package(tpg_runtime 0.1 CONFIG REQUIRED)\nadd_executable(with-cmake main.c)\n\
                     target_link_libraries(with-cmake tpg_runtime::tpg_runtime)\n";
        fs::write(folder.path().join("CMakeLists.txt"), lists).expect("the folder can be written");
        let prefix = format!("-DCMAKE_PREFIX_PATH={}", library::dist().display());
        let (good, text) =
            run(Command::new("cmake").current_dir(folder.path()).args(["-S", ".", "-B", "build", &prefix]));
        assert!(good, "{text}");
        let (good, text) = run(Command::new("cmake").current_dir(folder.path()).args(["--build", "build"]));
        assert!(good, "{text}");
        assert!(run(&mut Command::new(folder.path().join("build/with-cmake"))).0);
        let versions = [("0.1.0", true), ("0.0", false), ("0.1.1", false), ("0.2", false), ("1", false)];
        let asked = versions.map(|(version, _)| {
            format!(
                "find_package(tpg_runtime {version} QUIET CONFIG)\nmessage(\"{version}=${{tpg_runtime_FOUND}}.\")\n"
            )
        });
        let lists = format!("cmake_minimum_required(VERSION 3.16)\nproject(versions NONE)\n{}", asked.concat());
        fs::write(folder.path().join("CMakeLists.txt"), lists).expect("the folder can be written");
        let target = format!("-DTPG_RUNTIME_TARGET={}", library::host());
        let (_, text) =
            run(Command::new("cmake").current_dir(folder.path()).args(["-S", ".", "-B", "versions", &prefix, &target]));
        for (version, accepted) in versions {
            assert_eq!(text.contains(&format!("{version}=1.")), accepted, "{version}: {text}");
        }
    }
}

/// Returns cmake's answer to a list of commands, with variables set before; no compiler is asked.
fn cmake_script(folder: &Path, commands: &str, variables: &[(&str, &str)]) -> String {
    let lists = folder.join("script.cmake");
    let set = |(name, value): &(&str, &str)| format!("set({name} \"{value}\")\n");
    let text: String = variables.iter().map(set).collect();
    let prefix = format!("set(CMAKE_PREFIX_PATH \"{}\")\n", library::dist().display());
    fs::write(&lists, format!("cmake_minimum_required(VERSION 3.16)\n{prefix}{text}{commands}")).expect("writable");
    run(Command::new("cmake").current_dir(folder).arg("-P").arg(&lists)).1
}

#[test]
fn cmake_knows_the_core() {
    if !tpg_testing::tool("cmake", "cmake", "the core of tpg_runtime-config.cmake") {
        return;
    }
    let config = Path::new(env!("CARGO_MANIFEST_DIR")).join("tpg_runtime-config.cmake");
    let folder = TempDir::new().expect("a temporary folder");
    let cases = [
        ("cortex-m0plus", "", "thumbv6m-none-eabi"),
        ("Cortex-M3", "", "thumbv7m-none-eabi"),
        ("cortex-m4", "", "thumbv7em-none-eabihf"),
        ("cortex-m7", "-mfloat-abi=soft", "thumbv7em-none-eabi"),
        ("cortex-m23", "", "thumbv8m.base-none-eabi"),
        ("cortex-m33", "-mfloat-abi=softfp", "thumbv8m.main-none-eabi"),
        ("cortex-m55", "", "thumbv8m.main-none-eabihf"),
        ("arm", "-mcpu=cortex-m0plus -mthumb", "thumbv6m-none-eabi"),
        ("arm", "-mthumb -mcpu=cortex-m33+nodsp -mfloat-abi=hard", "thumbv8m.main-none-eabihf"),
        ("riscv", "-march=rv32imc", "riscv32imc-unknown-none-elf"),
        ("riscv32", "-march=rv32imac_zicsr -mabi=ilp32", "riscv32imac-unknown-none-elf"),
        ("riscv", "-march=rv32imafc -mabi=ilp32f", "riscv32imafc-unknown-none-elf"),
        ("riscv", "-march=rv32imafc -mabi=ilp32", "riscv32imac-unknown-none-elf"),
    ];
    let commands = format!("include(\"{}\")\nmessage(\"target=${{TPG_RUNTIME_TARGET}}.\")\n", config.display());
    let found = |variables: &[(&str, &str)]| {
        let common = [("CMAKE_CROSSCOMPILING", "TRUE"), ("CMAKE_SYSTEM_NAME", "Generic")];
        cmake_script(folder.path(), &commands, &[&common, variables].concat())
    };
    for (processor, flags, target) in cases {
        let text = found(&[("CMAKE_SYSTEM_PROCESSOR", processor), ("CMAKE_C_FLAGS", flags)]);
        assert!(text.contains(&format!("target={target}.")), "{processor} {flags}: {text}");
        assert!(library::TARGETS.contains(&target), "{target}");
    }
    for (platform, target) in [("rp2040", "thumbv6m-none-eabi"), ("rp2350-arm-s", "thumbv8m.main-none-eabi")] {
        let text = found(&[("CMAKE_SYSTEM_PROCESSOR", "arm"), ("PICO_PLATFORM", platform)]);
        assert!(text.contains(&format!("target={target}.")), "{platform}: {text}");
    }
    assert!(found(&[("CMAKE_SYSTEM_PROCESSOR", "xtensa")]).contains("target=."));
}
