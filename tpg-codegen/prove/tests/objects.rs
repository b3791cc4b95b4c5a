//! Objects of the shipped policies, changed ones, and files that are none.

use crate::emulator::{Forms, Operands, run, tools};
use object::{Object as _, ObjectSection as _, ObjectSymbol as _};
use std::fs;
use std::path::{Path, PathBuf};
use tpg_prove::execute::Object;
use tpg_prove::graph::Graph;
use tpg_prove::input::Missing;
use tpg_prove::product::{Comparison, Effort};
use tpg_prove::term::Terms;

/// Policies that are proven in milliseconds.
const SMALL: [&str; 13] = [
    "acrobot",
    "bipedal-walker",
    "cartpole",
    "dodge",
    "half-cheetah",
    "hopper",
    "inverted-double-pendulum",
    "lunar-lander",
    "lunar-lander-continuous",
    "mountain-car",
    "mountain-car-continuous",
    "pendulum",
    "swimmer",
];
const CORE: [&str; 4] = ["-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"];

fn shipped(policy: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../generated").join(policy)
}

fn graph(policy: &str) -> Graph {
    let path = shipped(policy).join("graph.json");
    Graph::read("graph.json", &fs::read_to_string(path).expect("a shipped graph")).expect("a valid graph")
}

/// Compiles a shipped policy; returns the object and the name of its function.
fn compiled(folder: &Path, policy: &str, level: &str) -> (Vec<u8>, String) {
    let prefix = policy.replace('-', "_");
    let source = shipped(policy).join(format!("{prefix}.c"));
    let no_selftest = format!("-D{}_NO_SELFTEST", prefix.to_uppercase());
    let source = source.to_str().expect("a path in UTF-8");
    run(folder, "arm-none-eabi-gcc", &[&CORE[..], &[level, &no_selftest, "-c", source, "-o", "policy.o"]].concat());
    (fs::read(folder.join("policy.o")).expect("it was written"), format!("{prefix}_infer"))
}

fn prove(file: &[u8], symbol: &str, graph: &Graph) -> Result<(), String> {
    let mut object = Object::new(file, symbol, graph.interface().clone()).map_err(|error| error.to_string())?;
    // What takes long is not decided.
    let effort = Effort { cases: 100_000, pairs: 2_000 };
    Comparison::new(graph, &mut object, Terms::new(), &[], effort)
        .prove()
        .map_err(|missing: Missing| missing.to_string())
}

#[test]
fn shipped_policies_are_proven_at_every_level() {
    if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "proofs of objects for a Cortex-M4F") {
        return;
    }
    let folder = tempfile::TempDir::new().expect("a temporary folder");
    let levels = tpg_testing::amount(&["-Os", "-O2"][..], &["-Os", "-O1", "-O2", "-O3"]);
    for policy in SMALL {
        for level in levels {
            let (file, symbol) = compiled(folder.path(), policy, level);
            assert_eq!(prove(&file, &symbol, &graph(policy)), Ok(()), "{policy} {level}");
        }
    }
}

/// The place of a function's bytes in a file.
fn bytes_of(file: &[u8], symbol: &str) -> std::ops::Range<usize> {
    let object = object::File::parse(file).expect("an object");
    let function = object.symbol_by_name(symbol).expect("the function");
    let section = object.section_by_index(function.section_index().expect("it is defined")).expect("its section");
    let (start, _) = section.file_range().expect("it is in the file");
    let start = (start + (function.address() & !1)) as usize;
    start..start + function.size() as usize
}

/// Numbers of random results of a function under QEMU; none if it does not end, or faults.
fn results(folder: &Path, file: &[u8], symbol: &str, graph: &Graph) -> Option<Vec<u32>> {
    fs::write(folder.join("mutant.o"), file).expect("the folder can be written");
    run(folder, "arm-none-eabi-objcopy", &["--redefine-sym", &format!("{symbol}=form_0"), "mutant.o", "form.o"]);
    let interface = graph.interface();
    let (operands, results) = (interface.state_length() as usize, interface.outputs.len());
    let form = Forms { objects: &["form.o"], count: 1, operands, results, states: tpg_testing::amount(5_000, 20_000) };
    Some(form.emulated(folder, None))
}

/// Every bit of code and constants is turned; what is called proven answers as the original does.
#[test]
fn changed_objects_are_proven_only_where_they_are_equal() {
    if !tools("changed objects against QEMU") {
        return;
    }
    let folder = tempfile::TempDir::new().expect("a temporary folder");
    let stride = tpg_testing::amount(149, 37);
    let (mut turned, mut proven) = (0, 0);
    for policy in SMALL {
        let graph = graph(policy);
        let (file, symbol) = compiled(folder.path(), policy, "-Os");
        let original = results(folder.path(), &file, &symbol, &graph);
        let bytes = bytes_of(&file, &symbol);
        for bit in (0..8 * bytes.len()).step_by(stride) {
            let mut changed = file.clone();
            changed[bytes.start + bit / 8] ^= 1 << (bit % 8);
            turned += 1;
            if prove(&changed, &symbol, &graph).is_ok() {
                proven += 1;
                let found = results(folder.path(), &changed, &symbol, &graph);
                assert_eq!(found, original, "{policy}, byte {:#x}, bit {}", bit / 8, bit % 8);
            }
        }
    }
    println!("{turned} bits turned, {proven} of them proven to change nothing");
    assert!(proven * 10 < turned, "{proven} of {turned}");
}

#[test]
fn code_that_never_answers_is_not_proven() {
    if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "code that never ends") {
        return;
    }
    let folder = tempfile::TempDir::new().expect("a temporary folder");
    let (mut file, symbol) = compiled(folder.path(), "cartpole", "-Os");
    let bytes = bytes_of(&file, &symbol);
    // b .
    file[bytes.start..bytes.start + 2].copy_from_slice(&[0xfe, 0xe7]);
    assert!(prove(&file, &symbol, &graph("cartpole")).is_err());
}

#[test]
fn what_an_interrupt_may_overwrite_is_not_read() {
    if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "loads below the stack pointer") {
        return;
    }
    let folder = tempfile::TempDir::new().expect("a temporary folder");
    let prefix = "-DCARTPOLE_NO_SELFTEST";
    let source = shipped("cartpole").join("cartpole.c");
    let source = source.to_str().expect("a path in UTF-8");
    run(folder.path(), "arm-none-eabi-gcc", &[&CORE[..], &["-Os", prefix, "-S", source, "-o", "policy.s"]].concat());
    let text = fs::read_to_string(folder.path().join("policy.s")).expect("it was written");
    for (lines, is_read) in [("push {r0}\npop {r0}", true), ("str r0, [sp, #-4]\nldr r0, [sp, #-4]", false)] {
        let text = text.replacen("cartpole_infer:", &format!("cartpole_infer:\n{lines}"), 1);
        fs::write(folder.path().join("other.s"), text).expect("the folder can be written");
        run(folder.path(), "arm-none-eabi-gcc", &[&CORE[..], &["-c", "other.s", "-o", "policy.o"]].concat());
        let file = fs::read(folder.path().join("policy.o")).expect("it was written");
        assert_eq!(prove(&file, "cartpole_infer", &graph("cartpole")).is_ok(), is_read, "{lines}");
    }
}

#[test]
fn files_that_are_no_objects_are_refused() {
    if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "damaged objects") {
        return;
    }
    let folder = tempfile::TempDir::new().expect("a temporary folder");
    let graph = graph("cartpole");
    let (file, symbol) = compiled(folder.path(), "cartpole", "-Os");
    assert!(prove(b"", &symbol, &graph).is_err());
    assert!(prove(&file, "nothing", &graph).is_err_and(|text| text.contains("there are: cartpole_infer")));
    let mut random = Operands(7);
    for _ in 0..tpg_testing::amount(500, 2_000) {
        let mut damaged = file.clone();
        for _ in 0..1 + random.next() % 8 {
            let at = random.next() as usize % damaged.len();
            damaged[at] = random.next() as u8;
        }
        damaged.truncate(damaged.len() - random.next() as usize % 64);
        // Whatever comes out, nothing panics.
        let _ = prove(&damaged, &symbol, &graph);
    }
}

#[test]
fn random_code_is_executed_or_refused() {
    if !tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", "random code") {
        return;
    }
    let folder = tempfile::TempDir::new().expect("a temporary folder");
    let graph = graph("dodge");
    let (file, symbol) = compiled(folder.path(), "dodge", "-Os");
    let bytes = bytes_of(&file, &symbol);
    let mut random = Operands(9);
    for _ in 0..tpg_testing::amount(500, 2_000) {
        let mut changed = file.clone();
        let from = bytes.start + random.next() as usize % (bytes.len() / 2) / 2 * 2;
        let count = random.next() as usize % 64;
        for byte in changed[from..bytes.end].iter_mut().take(count) {
            *byte = random.next() as u8;
        }
        let _ = prove(&changed, &symbol, &graph);
    }
}
