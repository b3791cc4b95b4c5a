//! The example `own_environment`, from training to a C program that controls the same cart.

#[allow(dead_code, reason = "it is a program")]
#[path = "../examples/own_environment.rs"]
mod example;

use assert_cmd::Command;
use example::Cart;
use std::fmt::Write as _;
use std::fs;
use std::path::{Path, PathBuf};
use tpg_codegen::emit::{self, Language, Prefix};
use tpg_engine::{DEFAULT_LANES, Environment, Lanes, Plan, PolicyGraph};
use tpg_graph::Graph;
use tpg_runtime::ops::Own;

const STARTS: i16 = 33;

/// The same cart in C; prints a line of actions for every start.
const MAIN: &str = r#"
#include "cart.h"
#include <stdio.h>

int main(void)
{
    if (cart_selftest() != 0U) {
        return 1;
    }
    for (int start = 0; start < 33; start++) {
        cart_state_t state = { { 0.125F * (float)(start - 16), 0.0F } };
        for (int step = 0; step < 100; step++) {
            const unsigned action = cart_infer(&state);
            state.cart[1] += (action == 0U) ? 0.1F : -0.1F;
            state.cart[0] += 0.1F * state.cart[1];
            printf("%u", action);
        }
        printf("\n");
    }
    return 0;
}
"#;

fn c_program(folder: &Path, graph: &Graph) -> PathBuf {
    let prefix = "cart".parse::<Prefix>().expect("a name");
    for file in emit::emit(graph, Language::C, &emit::Options::new(prefix)) {
        fs::write(folder.join(file.name), file.text).expect("it can be written");
    }
    fs::write(folder.join("main.c"), MAIN).expect("it can be written");
    let flags = ["-std=c99", "-O2", "-ffp-contract=off", "-Wall", "-Wextra", "-Werror"];
    Command::new("cc")
        .current_dir(folder)
        .args(flags)
        .args(["main.c", "cart.c", "-o", "drive", "-lm"])
        .assert()
        .success();
    folder.join("drive")
}

#[test]
fn from_training_to_a_c_program_that_drives_the_same_cart() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    example::train(folder.path()).expect("it trains");
    let report = fs::read_to_string(folder.path().join("report.html")).expect("training leaves a report");
    assert!(report.contains("<svg"), "it has pictures");
    let text = fs::read_to_string(folder.path().join("graph.json")).expect("training leaves a graph");
    let graph = Graph::from_json("graph.json", &text).expect("a good one");

    let tasks: Vec<f32> = (0..STARTS).map(|start| 0.125 * f32::from(start - 16)).collect();
    let sources = Environment::<f32>::sources(&Cart);
    let plan = Plan::new::<Own>(&PolicyGraph::from(&graph), &sources);
    let mut actions = vec![String::new(); tasks.len()];
    let mut lanes = Lanes::<f32, Own, _>::new(&Cart, DEFAULT_LANES);
    let endings = lanes.run_watched(&plan, &tasks, |task, act| {
        let _ = write!(actions[task], "{}", act.choice());
    });
    let endings = endings.expect("no episode can fail");
    let stopped = endings.iter().filter(|ending| ending.success == Some(true)).count();
    assert!(stopped > 25, "it learned: {stopped} of {STARTS} carts stop");

    if !tpg_testing::tool("cc", "gcc", "the cart in C") {
        return;
    }
    let output = Command::new(c_program(folder.path(), &graph)).assert().success();
    let printed = String::from_utf8(output.get_output().stdout.clone()).expect("digits");
    assert!(printed.lines().eq(actions.iter().map(String::as_str)), "the C program acts differently");
}

#[test]
fn the_example_is_short() {
    let lines = include_str!("../examples/own_environment.rs").lines().count();
    assert!(lines < 80, "{lines} lines");
}
