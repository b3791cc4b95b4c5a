//! GEGELATI 2's `.dot` files of policies that answer with values, and of programs that read windows of arrays.

use tpg_graph::Graph;
use tpg_graph::error::InputError;
use tpg_graph::import::{self, Sidecar};
use tpg_graph::interpret::{Answer, Interpreter};
use tpg_runtime::ops::Own;

const SIDECAR: &str = r#"
scalar = "f64"
maths = "own"
registers = 4
sources = [{ name = "x", length = 3, unit = "m", range = [-9, 9] }]
instructions = ["add", "mul", "copy"]
outputs = [
    { name = "left", unit = "N", min = -1, max = 1, nan = -1 },
    { name = "right", unit = "N", min = -1, max = 1, nan = -1 },
]
"#;

/// Two teams' worth of bids over actions whose programs compute both values, or one of them. Constants are source 1.
const PROGRAMS: &str = r##"// File exported with GEGELATI v2.0.0
digraph{
	graph[pad = "0.212, 0.055" bgcolor = lightgray]
	node[shape=circle style = filled label = ""]
		T5 [fillcolor="#1199bb"]
		P1 [fillcolor="#cccccc" shape=point label="0"] //0.5|
		I1 [shape=box style=invis label="2|0&2|0#0|0&#92;n1|1&2|1#1|0&#92;n2|2&2|2#0|0&#92;n"]
		P1 -> I1[style=invis]
		A8 [fillcolor="#ff3366" shape=box margin=0.03 width=0 height=0 label="1-0"]
		T5 -> P1 -> A8
		P2 [fillcolor="#cccccc" shape=point label="0"] //0.25|
		I2 [shape=box style=invis label="0|2&2|1#2|2&#92;n"]
		P2 -> I2[style=invis]
		A9 [fillcolor="#ff3366" shape=box margin=0.03 width=0 height=0 label="1"]
		T5 -> P2 -> A9
		P3 [fillcolor="#cccccc" shape=point label="1"] //0.5|
		I3 [shape=box style=invis label="1|0&2|1#1|0&#92;n0|1&2|2#0|0&#92;n"]
		P3 -> I3[style=invis]
		A8 -> P3
		P4 [fillcolor="#cccccc" shape=point label="1"] //0.125|
		I4 [shape=box style=invis label="2|0&1|0#0|0&#92;n"]
		P4 -> I4[style=invis]
		A8 -> P4
		A9 -> P3
		{ rank= same T5 }
}
"##;

fn read(text: &str, sidecar: &str) -> Result<Graph, InputError> {
    import::from_text("x.dot", text, Some(&Sidecar::from_toml("x.toml", sidecar)?))
}

fn graph(text: &str, sidecar: &str) -> Graph {
    read(text, sidecar).unwrap_or_else(|error| panic!("{error}"))
}

fn answer(graph: &Graph, state: &[f64]) -> Vec<f64> {
    match Interpreter::<f64, Own>::new(graph).answer(state) {
        Answer::Values(values) => values,
        Answer::Action(action) => panic!("{action:?}"),
    }
}

/// The file without the programs of its actions.
fn without_programs() -> String {
    let lines = PROGRAMS.lines().filter(|line| !["P3", "P4", "I3", "I4"].iter().any(|name| line.contains(name)));
    lines.map(|line| format!("{line}\n")).collect()
}

#[test]
fn each_value_has_a_program_or_is_0() {
    let graph = graph(PROGRAMS, SIDECAR);
    assert_eq!(graph.leaves().iter().map(|leaf| leaf.label).collect::<Vec<_>>(), [8, 9]);
    // A8: right is P3, left is P4; A9: right is P3, left has no program.
    assert_eq!(answer(&graph, &[3.0, 1.5, 0.0]), [0.125, 0.75]);
    assert_eq!(answer(&graph, &[-3.0, 1.5, 0.0]), [0.0, 0.75], "P2 bids 0");
    assert_eq!(answer(&graph, &[3.0, f64::NAN, 0.0]), [0.125, -1.0], "NaN counts as minus infinity in GEGELATI");
    assert_eq!(answer(&graph, &[3.0, f64::INFINITY, 0.0]), [0.125, 1.0]);
}

#[test]
fn values_are_registers_of_one_program() {
    let sidecar = format!("values = \"registers\"\n{SIDECAR}");
    let one = PROGRAMS.replace("label=\"1-0\"", "label=\"0\"").replace("\t\tA8 -> P4\n", "");
    let one: String =
        one.lines().filter(|line| !line.contains("P4") && !line.contains("I4")).collect::<Vec<_>>().join("\n");
    let graph = graph(&one, &sidecar);
    // P3: r0 = x[1] · 0.5, r1 = x[2] + r0
    assert_eq!(answer(&graph, &[3.0, 1.0, 0.25]), [0.5, 0.75]);
    let error = read(PROGRAMS, &sidecar).expect_err("two programs").to_string();
    assert!(error.contains("line 9: A8 with 2 programs; accepted: one, whose registers are the values"), "{error}");
}

#[test]
fn values_are_registers_of_the_winning_bid() {
    let sidecar = format!("values = \"bid\"\n{SIDECAR}");
    let graph = graph(&without_programs(), &sidecar);
    // P1: r0 = x[0], r1 = x[1] · 0.5, r2 = x[2]; P2: r2 = x[1] + x[2]
    assert_eq!(answer(&graph, &[3.0, 1.0, 0.25]), [0.5, 0.25]);
    assert_eq!(answer(&graph, &[-3.0, 0.5, 0.25]), [0.0, 0.75]);
    let error = read(PROGRAMS, &sidecar).expect_err("programs").to_string();
    assert!(error.contains("line 9: A8 with 2 programs; accepted: actions without programs"), "{error}");
    let few = sidecar.replace("registers = 4", "registers = 2");
    let error = read(&without_programs(), &few).expect_err("too few registers").to_string();
    assert!(error.contains("2 registers for 2 outputs; accepted: at least 3"), "{error}");
}

#[test]
fn an_activation_follows_the_program() {
    // The logistic function, as GEGELATI 2 computes it.
    let sidecar = SIDECAR
        .replace("\"copy\"", "\"copy\", \"exp\"")
        .replace("nan = -1 },\n]", "nan = 0, is = \"div(1, add(1, exp(mul(a, -1))))\" },\n]");
    let graph = graph(PROGRAMS, &sidecar);
    let logistic = |value: f64| 1.0 / (1.0 + <Own as tpg_runtime::ops::Maths<f64>>::exp(-value));
    assert_eq!(answer(&graph, &[3.0, 1.0, 0.0]), [0.125, logistic(0.5)], "the other output is as it was");
    let error = read(PROGRAMS, &sidecar.replace("mul(a, -1)", "mul(a, b)")).expect_err("b").to_string();
    assert!(error.contains("accepted: a call on the value a alone"), "{error}");
}

#[test]
fn a_file_without_teams_is_a_formula() {
    let text: String = PROGRAMS
        .lines()
        .filter(|line| !["T5", "P1", "I1", "P2", "I2", "A9"].iter().any(|name| line.contains(name)))
        .map(|line| format!("{line}\n"))
        .collect();
    let node = "\t\tA8 [fillcolor=\"#ff3366\" shape=box label=\"1-0\"]\n\t\tP3 [";
    let text = text.replacen("\t\tP3 [", node, 1).replacen("\n}", "\n\t\t{ rank= same A8 }\n}", 1);
    for text in [text.clone(), text.replace("\t\t{ rank= same A8 }\n", "")] {
        let formula = graph(&text, SIDECAR);
        assert!(formula.is_formula());
        assert_eq!(answer(&formula, &[0.0, 1.5, 0.0]), [0.125, 0.75]);
    }
    let error = read(&text.replace("same A8", "same A9"), SIDECAR).expect_err("another root").to_string();
    assert!(error.contains("A9 as the root; accepted: one team, or the one action of a file without teams"), "{error}");
}

#[test]
fn what_the_programs_of_actions_must_be() {
    let cases = [
        ("label=\"1-0\"", "label=\"2-0\"", "A8 computes value 2; accepted: 0 to 1"),
        ("label=\"1-0\"", "label=\"1-1\"", "A8 computes value 1 a second time"),
        ("label=\"1-0\"", "label=\"1\"", "A8 with 2 programs and 1 number in its label"),
        ("\t\tA9 -> P3\n", "", "A9 with 0 programs and 1 number in its label"),
        ("A9 -> P3", "A9 -> P7", "P7, which does not exist"),
        ("A9 -> P3", "A7 -> P3", "A7, which no line before declares"),
        ("shape=point label=\"1\"] //0.125", "shape=point label=\"2\"] //0.125", "P4 with the label \"2\""),
        ("label=\"1-0\"", "label=\"1-\"", "A8 with the label \"1-\""),
    ];
    for (from, to, expected) in cases {
        let text = PROGRAMS.replace(from, to);
        assert_ne!(text, PROGRAMS, "{from}");
        let error = read(&text, SIDECAR).expect_err(expected).to_string();
        assert!(error.contains(expected) && error.contains("x.dot: line "), "{error}");
    }
    let actions = "actions = [{ id = 0, name = \"left\" }, { id = 1, name = \"right\" }]";
    let discrete = format!("{}{actions}\n", &SIDECAR[..SIDECAR.find("outputs").expect("outputs")]);
    let error = read(PROGRAMS, &discrete).expect_err("values").to_string();
    assert!(error.contains("line 9: A8, whose programs compute values; accepted: actions without programs"), "{error}");
}

/// Source 1 is 2 by 4 values, source 2 three of them; instruction 0 reads a window of 2 by 2, instruction 1 one of two.
const WINDOWS: &str = r##"// File exported with GEGELATI v2.0.0
digraph{
		T5 [fillcolor="#1199bb"]
		P1 [shape=point label="0"] //
		I1 [label="0|0&1|4#0|0&#92;n"]
		P1 -> I1[style=invis]
		A1 [label="0"]
		T5 -> P1 -> A1
		P2 [shape=point label="0"] //
		I2 [label="1|3&2|3#0|0&#92;n1|0&0|6#0|0&#92;n"]
		P2 -> I2[style=invis]
		A2 [label="1"]
		T5 -> P2 -> A2
		{ rank= same T5 }
}
"##;

const WINDOWED: &str = r#"
scalar = "f64"
maths = "own"
registers = 4
sources = [
    { name = "image", length = 8, shape = [2, 4], unit = "", range = [0, 1] },
    { name = "row", length = 3, unit = "", range = [0, 1] },
]
instructions = [
    { name = "corner", is = "sub(a[0][0], a[1][1])", windows = { a = [2, 2] } },
    { name = "slope", is = "sub(a[1], a[0])", windows = { a = [2] } },
]
actions = [{ id = 0, name = "left" }, { id = 1, name = "right" }]
"#;

#[test]
fn windows_are_numbered_row_by_row_and_wrap() {
    let graph = graph(WINDOWS, WINDOWED);
    let state = [0.0, 1.0, 2.0, 3.0, 10.0, 20.0, 40.0, 80.0, 5.0, 7.0, 11.0];
    let interpreter = Interpreter::<f64, Own>::new(&graph);
    let bids: Vec<f64> = graph.programs().iter().map(|program| interpreter.run(program, &state)).collect();
    // One row of three windows: number 4 is the second, 1 and 40. Of `row` two: number 3 is the second. Of the registers
    // three: number 6 is the first, of two zeros.
    assert_eq!(bids, [1.0 - 40.0, 0.0]);
    let last = WINDOWS.replace("1|0&0|6", "1|0&0|5");
    let graph = self::graph(&last, WINDOWED);
    let interpreter = Interpreter::<f64, Own>::new(&graph);
    assert_eq!(interpreter.run(&graph.programs()[1], &state), 4.0, "the third of the registers: r3 - r2");
}

#[test]
fn a_window_must_fit() {
    let cases = [
        ("a = [2, 2]", "a = [3, 2]", "a window of 3 by 2 on 2 by 4 values"),
        ("a = [2] }", "a = [2], b = [0] }", "a window of [0]"),
        ("a = [2] }", "g = [2] }", "a window \"g\""),
        ("a[1][1]", "a[1][2]", "a[1][2] of a window of 2 by 2"),
        ("a[1][1]", "a", "a of a window of 2 by 2"),
        ("windows = { a = [2] }", "windows = {}", "a[1] of a number"),
        ("shape = [2, 4]", "shape = [2, 3]", "2 by 3; accepted: two numbers whose product is the length, 8"),
    ];
    for (from, to, expected) in cases {
        let sidecar = WINDOWED.replace(from, to);
        assert_ne!(sidecar, WINDOWED, "{from}");
        let error = read(WINDOWS, &sidecar).expect_err(expected).to_string();
        assert!(error.contains(expected), "{error}");
    }
    let constants = WINDOWS.replace("] //", "] //1|");
    let error = read(&constants.replace("label=\"0|0&1|4", "label=\"0|0&1|0"), WINDOWED).expect_err("constants");
    assert!(error.to_string().contains("a window on the constants"), "{error}");
}
