//! A product and a sum are never fused, in no dialect of C or C++, on no machine with such an instruction.

use std::fs;
use std::process::Command;
use tpg_codegen::compile;
use tpg_codegen::emit::{Code, Language, Options, Profile};
use tpg_graph::Graph;

/// Products whose sums any compiler would like to fuse.
const GRAPH: &str = r#"{
    "format": "tpg-graph", "version": 1, "scalar": "f32", "maths": "own", "registers": 2,
    "sources": [{ "name": "x", "length": 3, "unit": "", "ranges": [[-9, 9], [-9, 9], [-9, 9]] }],
    "instructions": ["add", "sub", "mul", "multiply_add", "sin", "exp"],
    "actions": [{ "id": 0, "name": "left" }, { "id": 1, "name": "right" }],
    "root": 0,
    "teams": [{ "id": 0, "edges": [{ "program": 0, "action": 0 }, { "program": 1, "action": 1 }] }],
    "programs": [
        { "id": 0, "lines": [
            { "to": 0, "op": "multiply_add", "args": ["x[0]", 2.5] },
            { "to": 0, "op": "multiply_add", "args": ["x[1]", "x[2]"] },
            { "to": 1, "op": "mul", "args": ["r0", "x[2]"] },
            { "to": 0, "op": "sub", "args": ["r1", "x[0]"] }
        ] },
        { "id": 1, "lines": [
            { "to": 1, "op": "sin", "args": ["x[1]"] },
            { "to": 0, "op": "exp", "args": ["x[2]"] },
            { "to": 0, "op": "multiply_add", "args": ["r1", 0.75] }
        ] }
    ]
}"#;

/// A compiler that fuses across statements, its Debian package, its flags for a machine that can fuse.
type Machine = (&'static str, &'static str, &'static [&'static str]);

const MACHINES: [Machine; 4] = [
    ("gcc", "gcc", &["-mfma"]),
    ("arm-none-eabi-gcc", "gcc-arm-none-eabi", &["-mcpu=cortex-m4", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"]),
    ("arm-none-eabi-gcc", "gcc-arm-none-eabi", &["-mcpu=cortex-m33", "-mfloat-abi=hard", "-mfpu=fpv5-sp-d16"]),
    (
        "riscv64-unknown-elf-gcc",
        "picolibc-riscv64-unknown-elf",
        &["--specs=picolibc.specs", "-march=rv32imafc", "-mabi=ilp32f"],
    ),
];

const DIALECTS: [[&str; 3]; 4] = [
    ["c", "-std=c99", "-O2"],
    ["c", "-std=gnu11", "-O2"],
    ["c++", "-std=c++11", "-O3"],
    ["c++", "-std=gnu++17", "-Os"],
];

/// Counts the fused instructions in the assembly of `source`.
fn fused((compiler, _, flags): Machine, [language, standard, level]: [&str; 3], header: &str, source: &str) -> usize {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("arm.h"), header).expect("written");
    fs::write(folder.path().join("arm.c"), source).expect("written");
    let mut command = Command::new(compiler);
    command.current_dir(folder.path()).args(flags).args(["-x", language, standard, level, "-S", "-o", "-", "arm.c"]);
    let output = command.output().expect("the compiler starts");
    assert!(output.status.success(), "{compiler} {standard}: {}", String::from_utf8_lossy(&output.stderr));
    let assembly = String::from_utf8(output.stdout).expect("text");
    // vfmadd, vfnmadd … of x86; vfma, vfms, vfnma, vfnms of Arm; fmadd, fmsub, fnmadd, fnmsub of RISC-V.
    let fused = ["vfm", "vfnm", "fmadd.", "fmsub.", "fnmadd.", "fnmsub."];
    assembly.lines().filter(|line| fused.iter().any(|name| line.trim_start().starts_with(name))).count()
}

#[test]
fn no_dialect_fuses_a_product_and_a_sum() {
    let graph = Graph::from_json("graph.json", GRAPH).expect("a graph");
    let options = Options { profile: Some(Profile::Fast), ..Options::new("arm".parse().expect("a prefix")) };
    let code = Code::of(compile(&graph, &options, Language::C));
    let (header, guarded) = (&code.files[0].text, &code.files[1].text);
    let lines = guarded.lines().filter(|line| !line.contains("#pragma"));
    let unguarded: String = lines.map(|line| format!("{line}\n")).collect();
    for machine in MACHINES {
        let (compiler, package, flags) = machine;
        if !tpg_testing::tool(compiler, package, "fused instructions in generated C") {
            continue;
        }
        let count = |source: &str| DIALECTS.map(|dialect| fused(machine, dialect, header, source));
        assert_eq!(count(guarded), [0; DIALECTS.len()], "{compiler} {flags:?}");
        assert_ne!(count(&unguarded), [0; DIALECTS.len()], "{compiler} {flags:?} fuses nothing to begin with");
    }
}
