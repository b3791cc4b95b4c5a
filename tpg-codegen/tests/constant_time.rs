//! The profile `constant-time`, compiled for a Cortex-M4: nothing in the object of C decides by data what runs, and under QEMU
//! every state takes exactly the instructions of the static bound. In the object of Rust nothing branches; LLVM makes IT
//! blocks, whose instructions take their time whether they act or not.

mod common;

use common::{fixture, run, shaped};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;
use tpg_codegen::emit::{self, Language, Profile, Style};
use tpg_codegen::graph::{Graph, MathsProvider, ScalarType};
use tpg_codegen::sample::{self, Shape};
use tpg_codegen::{import, interpret, states, verify};
use tpg_runtime::standalone;
use xtask::wcet::{Analyser, Listing, LoopBounds, disassemble};

const STATES: usize = 10_000;
const CORE: [&str; 4] = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"];

/// This project's policies, the graph with every instruction, and random ones: all in f32 with own maths, which is what a
/// Cortex-M4F computes in itself.
fn graphs() -> Vec<(String, Graph)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../generated");
    let own = ["widowx-fs", "widowx-rs"].map(|name| {
        let graph = import::load(&folder.join(name).join("graph.json"), None, None).expect("a committed graph");
        (name.to_owned(), graph)
    });
    let random = (0..6).map(|seed| {
        let shape = Shape { teams: 12, scalar: ScalarType::F32, maths: MathsProvider::Own, ..Shape::random(seed) };
        (format!("random {seed}"), sample::graph(&shape, seed))
    });
    let all = ("every instruction".to_owned(), fixture(ScalarType::F32, MathsProvider::Own));
    own.into_iter().chain([all]).chain(random).collect()
}

fn tools(what: &str, programs: &[(&str, &str)]) -> bool {
    programs.iter().all(|(program, package)| xtask::tool(program, package, what))
}

/// Emits a graph into a folder.
fn emit(folder: &Path, graph: &Graph, profile: Profile) {
    for file in emit::emit(graph, Language::C, &shaped("ct", (Style::Pure, Some(profile)))) {
        fs::write(folder.join(&file.name), file.text).expect("the folder can be written");
    }
}

fn gcc(folder: &Path, level: &str, arguments: &[&str]) {
    let mut command = Command::new("arm-none-eabi-gcc");
    command.current_dir(folder).args(CORE).args(["-std=gnu99", "-ffp-contract=off", "-DCT_NO_SELFTEST", level]);
    run(command.args(arguments)).unwrap_or_else(|message| panic!("{message}"));
}

fn object(graph: &Graph, profile: Profile, level: &str) -> Listing {
    let folder = TempDir::new().expect("a temporary folder");
    emit(folder.path(), graph, profile);
    gcc(folder.path(), level, &["-c", "ct.c", "-o", "ct.o"]);
    disassemble(&folder.path().join("ct.o")).expect("a listing")
}

#[test]
fn nothing_in_the_object_decides_by_data_what_runs() {
    let binutils = [("arm-none-eabi-gcc", "gcc-arm-none-eabi"), ("arm-none-eabi-objdump", "gcc-arm-none-eabi")];
    if !tools("branches of constant-time C on a Cortex-M4", &binutils) {
        return;
    }
    let bounds = LoopBounds::new();
    for (name, graph) in graphs() {
        for level in ["-O2", "-Os"] {
            let listing = object(&graph, Profile::ConstantTime, level);
            let mut analyser = Analyser::new(&listing, &bounds);
            let sites = analyser.decisions("ct_infer").unwrap_or_else(|refusal| panic!("{name} {level}: {refusal}"));
            assert!(sites.is_empty(), "{name} {level}: {sites:?}");
            analyser.bound("ct_infer").unwrap_or_else(|refusal| panic!("{name} {level}: {refusal}"));
        }
    }
    // The check finds what is there: a fast policy decides.
    let (_, graph) = &graphs()[0];
    let listing = object(graph, Profile::Fast, "-O2");
    let sites = Analyser::new(&listing, &bounds).decisions("ct_infer").expect("a fast policy has no loop");
    assert!(!sites.is_empty());
}

/// Compiles the Rust of a profile for a Cortex-M4.
fn rust_object(graph: &Graph, profile: Profile) -> Listing {
    let folder = TempDir::new().expect("a temporary folder");
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().expect("a folder")).expect("the folder can be written");
        fs::write(path, text).expect("the folder can be written");
    };
    let compile = |arguments: &[&str]| {
        let mut command = verify::rustc(folder.path());
        command.args(["--target=thumbv7em-none-eabihf", "-Ctarget-cpu=cortex-m4", "-Coverflow-checks=off"]);
        run(command.args(arguments)).unwrap_or_else(|message| panic!("{message}"));
    };
    // The runtime names the crate libm for the platform's maths, which these graphs do not use.
    let stub = |scalar: &str, names: [&str; 4]| {
        names.map(|name| format!("pub fn {name}(x: {scalar}) -> {scalar} {{ x }}\n")).concat()
    };
    let single = stub("f32", ["sinf", "cosf", "logf", "expf"]);
    let double = stub("f64", ["sin", "cos", "log", "exp"]);
    write("libm.rs", &format!("#![no_std]\n{single}{double}"));
    compile(&["--crate-type=rlib", "--crate-name=libm", "libm.rs"]);
    for (name, text) in standalone::FILES {
        write(&format!("runtime/{name}"), &text.replace("extern crate std;\n", ""));
    }
    let library = ["--crate-type=rlib", "--crate-name=tpg_runtime", "--extern=libm=liblibm.rlib", "runtime/lib.rs"];
    compile(&library);
    for file in emit::emit(graph, Language::Rust, &shaped("ct", (Style::Pure, Some(profile)))) {
        write(&file.name, &file.text);
    }
    let length = graph.state_length();
    write(
        "lib.rs",
        &format!(
            "#![no_std]\n#[path = \"ct.rs\"]\nmod policy;\nuse tpg_runtime::policy::{{ActionId, Policy}};\n\
             #[unsafe(no_mangle)]\npub fn ct_infer(state: &[f32; {length}]) -> u16 {{\n    \
             let ActionId(action) = policy::Ct.decide(state);\n    action\n}}\n"
        ),
    );
    let object = ["--crate-type=lib", "--crate-name=ct_object", "--emit=obj", "-o", "ct.o", "-L", "."];
    compile(&[&object[..], &["--extern=tpg_runtime=libtpg_runtime.rlib", "lib.rs"]].concat());
    disassemble(&folder.path().join("ct.o")).expect("a listing")
}

#[test]
fn nothing_in_the_object_of_rust_branches() {
    if !tools("branches of constant-time Rust on a Cortex-M4", &[("arm-none-eabi-objdump", "gcc-arm-none-eabi")]) {
        return;
    }
    let bounds = LoopBounds::new();
    let branches = |listing: &Listing| -> Vec<String> {
        let sites = Analyser::new(listing, &bounds).decisions("ct_infer").unwrap_or_else(|refusal| panic!("{refusal}"));
        sites.into_iter().map(|site| site.text).filter(|text| !text.starts_with("it")).collect()
    };
    for (name, graph) in graphs() {
        let listing = rust_object(&graph, Profile::ConstantTime);
        let found = branches(&listing);
        assert!(found.is_empty(), "{name}: {found:?}");
        Analyser::new(&listing, &bounds).bound("ct_infer").unwrap_or_else(|refusal| panic!("{name}: {refusal}"));
    }
    // The check finds what is there.
    let (_, graph) = &graphs()[0];
    assert!(!branches(&rust_object(graph, Profile::Fast)).is_empty());
}

/// Links an image that decides `states`.
fn image(folder: &Path, graph: &Graph, states: &[f64], level: &str) -> PathBuf {
    emit(folder, graph, Profile::ConstantTime);
    let bytes: Vec<u8> = states.iter().flat_map(|&value| (value as f32).to_le_bytes()).collect();
    fs::write(folder.join("states"), bytes).expect("the folder can be written");
    let fixtures = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures/cortex-m4");
    for file in ["main.c", "image.s", "image.ld"] {
        fs::copy(fixtures.join(file), folder.join(file)).expect("the folder can be written");
    }
    let count = format!("-DSTATES={}U", states.len() / graph.state_length());
    let sources =
        [&count, "ct.c", "main.c", "image.s", "-nostdlib", "-nostartfiles", "-T", "image.ld", "-o", "image.elf"];
    gcc(folder, level, &sources);
    folder.join("image.elf")
}

#[test]
fn every_state_takes_the_instructions_of_the_static_bound() {
    let emulator = [("arm-none-eabi-gcc", "gcc-arm-none-eabi"), ("qemu-system-arm", "qemu-system-arm")];
    if !tools("instructions of constant-time C under QEMU", &emulator) {
        return;
    }
    for (name, graph) in graphs() {
        for level in ["-O2", "-Os"] {
            let folder = TempDir::new().expect("a temporary folder");
            let states = states::sample(&graph, STATES, 1);
            let image = image(folder.path(), &graph, &states, level);
            let listing = disassemble(&image).expect("a listing");
            let bounds = LoopBounds::new();
            let bound = Analyser::new(&listing, &bounds).bound("ct_infer").expect("a bound");

            let mut command = Command::new("qemu-system-arm");
            command.args(["-machine", "mps2-an386", "-nographic", "-monitor", "none", "-serial", "none"]);
            command.args(["-icount", "shift=10,align=off,sleep=off"]);
            command.args(["-semihosting-config", "enable=on,target=native", "-kernel"]).arg(&image);
            let text = run(&mut command).unwrap_or_else(|message| panic!("{name} {level}: {message}"));
            let numbers: Vec<u32> = text.lines().filter_map(|line| line.trim().parse().ok()).collect();
            let [nothing, least, most, hash] = numbers[..] else { panic!("{name} {level}: {text}") };

            let expected = interpret::actions(&graph, &states)
                .iter()
                .fold(2_166_136_261_u32, |hash, action| (hash ^ u32::from(action.0)).wrapping_mul(16_777_619));
            assert_eq!(hash, expected, "{name} {level}: other actions than the interpreter's");
            // Less the call of nothing, whose only instruction is its return.
            let instructions = |ticks: u32| ((f64::from(ticks) - f64::from(nothing)) / 25.6).round() as u64 + 1;
            assert_eq!(instructions(least), bound.instructions, "{name} {level}");
            assert_eq!(instructions(most), bound.instructions, "{name} {level}");
        }
    }
}
