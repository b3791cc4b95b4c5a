//! A graph with the rules' memory in C, beside the trainer, step by step.

use crate::hybrid_any::NETWORK;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;
use tpg_codegen::emit::{self, Language, Options, Prefix};
use tpg_codegen::policy::{QuantisedPolicy, to_c};
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Act, Choices, EngineOptions, Environment, Plan, Single, bind};
use tpg_graph::Graph;
use tpg_problems::Pendulum;
use tpg_runtime::ops::Own;
use tpg_testing::library::{self, Missing};
use tpg_train::course::Course;
use tpg_train::hybrid::asking::Asking;
use tpg_train::sac::network::decided;

/// Asks where the distance lies far above its least, or has fallen just now; else it pushes by the velocity, or rests for a
/// while after an ask.
const GRAPH: &str = r#"{
    "format": "tpg-graph", "version": 1, "scalar": "f32", "maths": "own", "registers": 2,
    "sources": [
        { "name": "cos_theta", "length": 1, "unit": "", "ranges": [[-1, 1]] },
        { "name": "sin_theta", "length": 1, "unit": "", "ranges": [[-1, 1]] },
        { "name": "omega", "length": 1, "unit": "rad/s", "ranges": [[-8, 8]] },
        { "name": "drift", "length": 1, "unit": "distance", "ranges": [[0, 20]] },
        { "name": "since_progress", "length": 1, "unit": "actions", "ranges": [[0, 200]] },
        { "name": "since_asked", "length": 1, "unit": "actions", "ranges": [[0, 200]] }
    ],
    "instructions": ["sub", "mul"],
    "actions": [
        { "id": 0, "name": "torque -2" }, { "id": 1, "name": "torque 0" }, { "id": 2, "name": "torque 2" },
        { "id": 3, "name": "ask", "ask": "network" }
    ],
    "root": 0,
    "teams": [{ "id": 0, "edges": [
        { "program": 0, "action": 0 }, { "program": 1, "action": 1 }, { "program": 2, "action": 2 },
        { "program": 3, "action": 3 }, { "program": 4, "action": 3 }
    ] }],
    "programs": [
        { "id": 0, "lines": [{ "to": 0, "op": "sub", "args": ["cos_theta[0]", "omega[0]"] }] },
        { "id": 1, "lines": [
            { "to": 0, "op": "sub", "args": ["since_progress[0]", "since_asked[0]"] },
            { "to": 0, "op": "mul", "args": ["r0", 0.25] }
        ] },
        { "id": 2, "lines": [{ "to": 0, "op": "sub", "args": ["omega[0]", "sin_theta[0]"] }] },
        { "id": 3, "lines": [{ "to": 0, "op": "sub", "args": ["drift[0]", 6] }] },
        { "id": 4, "lines": [{ "to": 0, "op": "sub", "args": [1.5, "since_progress[0]"] }] }
    ]
}"#;

/// Prints the memory before each action, and the torque, as bits.
const MAIN: &str = r#"
#include <stdio.h>
#include <string.h>
#include "steps.h"

static unsigned long bits(float value)
{
    uint32_t as_integer;
    memcpy(&as_integer, &value, sizeof as_integer);
    return (unsigned long)as_integer;
}

int main(void)
{
    if (drive_begin() != TPG_OK) {
        return 2;
    }
    for (unsigned at = 0U; at < sizeof steps / sizeof steps[0]; at++) {
        if (steps[at].begins != 0) {
            drive_from(INFINITY);
        }
        (void)printf("%08lx %08lx %08lx ", bits(recall.drift), bits(recall.since_progress), bits(recall.since_asked));
        (void)printf("%08lx\n", bits(drive(steps[at].seen)));
        drive_acted(steps[at].distance);
    }
    return 0;
}
"#;

/// The steps of episodes as the trainer has them: a C array of what is seen, and the lines that C must print.
fn episodes(graph: &Graph, network: &QuantisedPolicy, count: u64) -> (String, String, [u32; 4]) {
    let choices = Choices::new(Pendulum, Some(3)).expect("few actions");
    let asking = Asking::new::<f32>(&choices, |state: &[f32]| decided(network, state), 2.0).with_memory(true);
    let policy = bind("recall.json", graph, &asking).expect("a graph of the pendulum");
    let single = Single::<f32, Own>::new(Plan::new::<Own>(&policy, &asking.sources(), EngineOptions::default()));
    let (mut steps, mut lines, mut taken) = (String::new(), String::new(), [0; 4]);
    for index in 0..count {
        let task = Environment::<f32>::draw(&asking, &mut Stream::new(7, 0, Purpose::Test, index));
        // The plain problem goes the same way: its rewards have no price.
        let (mut course, mut plain) = (Course::new(&asking, &task), Course::<f32, _>::new(&choices, &task));
        for step in 0.. {
            let state = course.observe().to_vec();
            let action = single.decide(&state);
            taken[usize::from(action.0)] += 1;
            let torque = match action.0 {
                3 => network.values(&state[..3])[0],
                own => [-2.0, 0.0, 2.0][usize::from(own)],
            };
            let [drift, progress, asked] = [3, 4, 5].map(|place| state[place].to_bits());
            let _ = writeln!(lines, "{drift:08x} {progress:08x} {asked:08x} {:08x}", torque.to_bits());
            let ended = course.act(Act::Choice(action)).is_some();
            let asked = [torque];
            let act = if action.0 == 3 { Act::Values(&asked) } else { Act::Choice(action) };
            assert_eq!(plain.act(act).is_some(), ended);
            let (begins, distance) = (u8::from(step == 0), plain.distance());
            let [cosine, sine, velocity] = [0, 1, 2].map(|place| state[place]);
            let _ = writeln!(steps, "    {{ {begins}, {{ {cosine:?}F, {sine:?}F, {velocity:?}F }}, {distance:?}F }},");
            if ended {
                break;
            }
        }
    }
    (steps, lines, taken)
}

#[test]
fn the_guides_code_with_a_memory_acts_as_the_trainer_step_by_step() {
    let archive = match library::make(library::host(), &library::dist()) {
        Ok(archive) => archive,
        Err(Missing::Tool) => return,
        Err(Missing::Failed(message)) => panic!("{message}"),
    };
    if !tpg_testing::tool("gcc", "gcc", "a graph with a memory in C") {
        return;
    }
    let prefix = |name: &str| name.parse::<Prefix>().expect("a prefix");
    let graph = Graph::from_json("recall.json", GRAPH).expect("a good graph");
    let network = fs::read_to_string(NETWORK).expect("a file of the repository");
    let network = QuantisedPolicy::from_json("policy.q.json", &network).expect("a good network");
    let (steps, lines, taken) = episodes(&graph, &network, 20);
    assert!(taken.iter().all(|&count| count > 100), "actions that are hardly taken: {taken:?}");

    let folder = TempDir::new().expect("a temporary folder");
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("the folder can be written");
    for file in emit::emit(&graph, Language::C, &Options::new(prefix("swing"))) {
        write(&file.name, &file.text);
    }
    for file in to_c(&network, &prefix("torque"), false).expect("it packs") {
        write(&file.name, &file.text);
    }
    let guide = fs::read_to_string(library::top().join("docs/hybrid.md")).expect("a file of the repository");
    let snippet = guide.split("```c\n").nth(2).and_then(|text| text.split("```").next()).expect("a second block of C");
    write("main.c", &format!("{snippet}{MAIN}"));
    write(
        "steps.h",
        &format!("static const struct {{ int begins; float seen[3]; float distance; }} steps[] = {{\n{steps}}};\n"),
    );

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
    let printed = String::from_utf8_lossy(&output.stdout);
    assert_eq!(printed.lines().count(), lines.lines().count());
    for (step, (c, trainer)) in printed.lines().zip(lines.lines()).enumerate() {
        assert_eq!(c, trainer, "step {step}: drift, since_progress, since_asked, torque");
    }
}
