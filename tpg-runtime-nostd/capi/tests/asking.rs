//! The C of the guide to hybrids: a graph drives, and the network decides where the graph asks.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;
use tpg_codegen::emit::{self, Language, Options, Prefix};
use tpg_codegen::policy::{QuantisedPolicy, to_c};
use tpg_graph::{Graph, interpret};
use tpg_testing::library;
use tpg_testing::numbers::Numbers;

/// Asks where the velocity is negative; else pushes by the angle.
const GRAPH: &str = r#"{
    "format": "tpg-graph", "version": 1, "scalar": "f32", "maths": "own", "registers": 1,
    "sources": [
        { "name": "cos_theta", "length": 1, "unit": "", "ranges": [[-1, 1]] },
        { "name": "sin_theta", "length": 1, "unit": "", "ranges": [[-1, 1]] },
        { "name": "omega", "length": 1, "unit": "rad/s", "ranges": [[-8, 8]] }
    ],
    "instructions": ["sub"],
    "actions": [
        { "id": 0, "name": "torque -2" }, { "id": 1, "name": "torque 0" }, { "id": 2, "name": "torque 2" },
        { "id": 3, "name": "ask", "ask": "network" }
    ],
    "root": 0,
    "teams": [{ "id": 0, "edges": [
        { "program": 0, "action": 0 }, { "program": 1, "action": 1 }, { "program": 2, "action": 2 }, { "program": 3, "action": 3 }
    ] }],
    "programs": [
        { "id": 0, "lines": [{ "to": 0, "op": "sub", "args": [0, "sin_theta[0]"] }] },
        { "id": 1, "lines": [{ "to": 0, "op": "sub", "args": ["cos_theta[0]", 0.3] }] },
        { "id": 2, "lines": [{ "to": 0, "op": "sub", "args": ["sin_theta[0]", 0] }] },
        { "id": 3, "lines": [{ "to": 0, "op": "sub", "args": [0, "omega[0]"] }] }
    ]
}"#;

/// Prints the bits of each answer.
const MAIN: &str = r#"
#include <stdio.h>
#include <string.h>
#include "states.h"

int main(void)
{
    if (drive_begin() != TPG_OK) {
        return 2;
    }
    for (unsigned at = 0U; at < sizeof states / sizeof states[0]; at++) {
        const float value = drive(states[at]);
        uint32_t bits;
        memcpy(&bits, &value, sizeof bits);
        (void)printf("%08lx\n", (unsigned long)bits);
    }
    return 0;
}
"#;

#[test]
fn the_guides_code_asks_where_the_graph_does_and_answers_as_both() {
    let Some(archive) = library::make(library::host(), &library::dist()).expect("it builds") else { return };
    if !tpg_testing::tool("gcc", "gcc", "the C of the guide to hybrids") {
        return;
    }
    let read = |name: &str| fs::read_to_string(library::top().join(name)).expect("a file of the repository");
    let prefix = |name: &str| name.parse::<Prefix>().expect("a prefix");
    let graph = Graph::from_json("swing.json", GRAPH).expect("a good graph");
    let network = read("c-harness/pendulum/policy.q.json");
    let network = QuantisedPolicy::from_json("policy.q.json", &network).expect("a good network");
    let folder = TempDir::new().expect("a temporary folder");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("the folder can be written");
    for file in emit::emit(&graph, Language::C, &Options::new(prefix("swing"))) {
        write(&file.name, &file.text);
    }
    for file in to_c(&network, &prefix("torque")).expect("it packs") {
        write(&file.name, &file.text);
    }
    let guide = read("docs/hybrid.md");
    let snippet = guide.split("```c\n").nth(1).and_then(|text| text.split("```").next()).expect("a block of C");
    write("main.c", &format!("{snippet}{MAIN}"));

    let mut numbers = Numbers(11);
    let mut unit = || numbers.within(1 << 23) as f32 / (1 << 23) as f32;
    let states: Vec<[f32; 3]> = (0..500).map(|_| [unit(), unit(), 8.0 * unit()]).collect();
    let mut text = String::from("static const float states[][3] = {\n");
    for [cosine, sine, velocity] in &states {
        let _ = writeln!(text, "    {{ {cosine:?}F, {sine:?}F, {velocity:?}F }},");
    }
    write("states.h", &(text + "};\n"));

    let program = folder.path().join("program");
    let include = |folder: &Path| format!("-I{}", folder.display());
    let mut gcc = Command::new("gcc");
    gcc.args(["-std=c99", "-O1", "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Werror"]);
    gcc.arg(include(&library::dist().join("include"))).arg(include(folder.path()));
    gcc.args(["main.c", "swing.c", "torque.c"].map(|name| folder.path().join(name)));
    let output = gcc.arg(&archive).arg("-lm").arg("-o").arg(&program).output().expect("gcc starts");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let output = Command::new(&program).output().expect("it starts");
    assert!(output.status.success(), "{:?}", output.status);

    let flat: Vec<f64> = states.iter().flatten().map(|&value| value.into()).collect();
    let actions = interpret::actions(&graph, &flat);
    let own = [-2.0, 0.0, 2.0];
    let answer =
        |(action, state): (usize, &[f32; 3])| own.get(action).copied().unwrap_or_else(|| network.values(state)[0]);
    let expected: String = (actions.iter().map(|action| usize::from(action.0)).zip(&states))
        .map(|pair| format!("{:08x}\n", answer(pair).to_bits()))
        .collect();
    for action in 0..4 {
        assert!(actions.iter().any(|taken| taken.0 == action), "no state takes action {action}");
    }
    assert!(String::from_utf8_lossy(&output.stdout) == expected, "C and Rust answer differently");
}
