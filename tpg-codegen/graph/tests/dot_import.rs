//! GEGELATI's `.dot` files become graphs.

use std::path::PathBuf;
use tpg_graph::Word;
use tpg_graph::error::InputError;
use tpg_graph::import::{self, Profile, Sidecar};
use tpg_graph::interpret::{Answer, Interpreter};
use tpg_graph::{Destination, Graph, Line, Operand};
use tpg_runtime::ops::{Instruction, Maths, Own};

const SIDECAR: &str = r#"
scalar = "f64"
maths = "system"
registers = 4
sources = [
    { name = "target", length = 3, unit = "mm", range = [-600, 600] },
    { name = "motors", length = 2, unit = "ticks", ranges = [[0, 4095], [512, 512]] },
]
instructions = ["sub", "cos"]
actions = [{ id = 0, name = "left" }, { id = 1, name = "right" }]
"#;

fn read(text: &str) -> Result<Graph, InputError> {
    import::from_text("x.dot", text, Some(&Sidecar::from_toml("x.toml", SIDECAR)?))
}

fn graph(text: &str) -> Graph {
    read(text).unwrap_or_else(|error| panic!("{error}"))
}

/// Two teams, a shared program whose destination a later line states, an unused operand, a location that wraps.
const SMALL: &str = r##"// File exported with GEGELATI v1.3.1
// On the 2024-07-06 16:48:11
// With the File::TPGGraphDotExporter
digraph{
	graph[pad = "0.212, 0.055" bgcolor = lightgray]
	node[shape=circle style = filled label = ""]
		T70 [fillcolor="#66ddff"]
		T5 [fillcolor="#1199bb"]
		P3 [fillcolor="#cccccc" shape=point] //
		I3 [shape=box style=invis label="0|1&2|3#0|6&#92;n1|0&1|4#9|9&#92;n"]
		P3 -> I3[style=invis]
		T5 -> P3
		P1 [fillcolor="#cccccc" shape=point] //
		I1 [shape=box style=invis label=""]
		P1 -> I1[style=invis]
		A900 [fillcolor="#ff3366" shape=box margin=0.03 width=0 height=0 label="1"]
		T70 -> P3 -> A900
		T5 -> P1 -> T70
		A901 [fillcolor="#ff3366" shape=box margin=0.03 width=0 height=0 label="1"]
		T70 -> P3 -> A901
		{ rank= same T5 }
}
"##;

#[test]
fn numbers_become_names() {
    let graph = graph(SMALL);
    let labels: Vec<u32> = graph.teams().iter().map(|team| team.label).collect();
    assert_eq!(labels, [70, 5]);
    assert_eq!(graph.team(graph.root()).label, 5);
    let edges: Vec<(u32, Destination)> = (graph.teams().iter().flat_map(|team| &team.edges))
        .map(|edge| (graph.program(edge.program).label, edge.to))
        .collect();
    let [(3, Destination::Action(right)), (3, again), (3, shared), (1, Destination::Team(inner))] = edges[..] else {
        panic!("{edges:?}")
    };
    assert_eq!((right.0, again, shared), (1, Destination::Action(right), Destination::Action(right)));
    assert_eq!(graph.team(inner).label, 70);
    let [minus, cosine] = graph.programs()[0].lines[..] else { panic!("two lines") };
    assert_eq!(written(&graph, &minus), (Instruction::Sub.into(), 1, vec!["motors[1]".to_owned(), "r2".to_owned()]));
    assert_eq!(written(&graph, &cosine), (Instruction::Cos.into(), 0, vec!["target[1]".to_owned()]));
    assert!(graph.programs()[1].lines.is_empty());
    assert_eq!(graph.provenance().tool.as_deref(), Some("GEGELATI"));
    assert_eq!(graph.provenance().version.as_deref(), Some("1.3.1"));
}

fn written(graph: &Graph, line: &Line) -> (Word, usize, Vec<String>) {
    let operands = line.operands[..line.instruction.arity()].iter().map(|operand| match *operand {
        Operand::Register(register) => format!("r{}", register.index()),
        Operand::Input(input) => graph.input_name(input),
        Operand::Constant(value) => format!("{value:?}"),
    });
    (line.instruction, line.to.index(), operands.collect())
}

/// Constants take source 1 and shift the environment's sources up by one.
#[test]
fn constants_of_gegelati_1_and_2() {
    let program = |p: &str, i: &str| {
        format!(
            "digraph{{\nT0 [a=b]\nP0 [a=b] //{p}\nI0 [label=\"0|0&1|4#2|1&#92;n0|0&1|0#3|0&#92;n\"] //{i}\n\
             A0 [label=\"0\"]\nT0 -> P0 -> A0\n}}\n"
        )
    };
    for (p, i, constants) in [("7|-3|9|", "", ["-3.0", "7.0"]), ("", "0.63|-0.40|1e-3|", ["-0.4", "0.63"])] {
        let graph = graph(&program(p, i));
        let lines = &graph.programs()[0].lines;
        assert_eq!(written(&graph, &lines[0]).2, [constants[0], "target[1]"]);
        assert_eq!(written(&graph, &lines[1]).2, [constants[1], "motors[0]"]);
    }
}

/// GEGELATI's own reader fails on lines of more than 4,096 characters.
#[test]
fn a_line_may_be_long() {
    let label = "0|1&2|3#0|6&#92;n".repeat(100_000);
    let long = SMALL.replace("label=\"\"]\n\t\tP1", &format!("label=\"{label}\"]\n\t\tP1"));
    assert_eq!(graph(&long).programs()[1].lines.len(), 100_000);
}

/// The authors' graphs carry no licence and are not part of this project; `TPG_CONFORMANCE` names their folder.
#[test]
fn the_papers_graphs() {
    let folder = std::env::var_os("TPG_CONFORMANCE").map_or_else(
        || PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../shared/conformance")),
        PathBuf::from,
    );
    if !folder.is_dir() {
        tpg_testing::skip(&format!("the paper's graphs: no folder {}", folder.display()));
        return;
    }
    let mut read = 0;
    for part in ["tpg", "tpg_traced"] {
        for entry in folder.join(part).read_dir().expect("a folder of graphs") {
            let path = entry.expect("an entry").path();
            if path.extension().is_some_and(|extension| extension == "dot") {
                let graph = import::load(&path, Some(Profile::Ecta24), None).unwrap_or_else(|error| panic!("{error}"));
                assert_eq!(graph.state_length(), 15);
                read += 1;
            }
        }
    }
    assert_eq!(read, 26);
}

/// As GEGELATI 2 writes it: action nodes repeated, a label for programs, real constants.
const SECOND: &str = r##"// File exported with GEGELATI v2.0.0
// With the class File::TPGGraphDotExporter
digraph{
	graph[pad = "0.212, 0.055" bgcolor = lightgray]
	node[shape=circle style = filled label = ""]
		T5 [fillcolor="#1199bb"]
		P1 [fillcolor="#cccccc" shape=point label="0"] //-2.884066|13.5|
		I1 [shape=box style=invis label="2|0&2|1#1|3&#92;n"]
		P1 -> I1[style=invis]
		A100 [fillcolor="#ff3366" shape=box margin=0.03 width=0 height=0 label="0"]
		T5 -> P1 -> A100
		P2 [fillcolor="#cccccc" shape=point label="0"] //0.25|-1.5|
		I2 [shape=box style=invis label="1|3&3|0#0|0&#92;n0|0&0|7#1|0&#92;n3|0&0|0#9|9&#92;n"]
		P2 -> I2[style=invis]
		A101 [fillcolor="#ff3366" shape=box margin=0.03 width=0 height=0 label="1"]
		T5 -> P2 -> A101
		P3 [fillcolor="#cccccc" shape=point label="0"] //0.25|1.5|
		I3 [shape=box style=invis label="0|0&3|1#2|2&#92;n"]
		P3 -> I3[style=invis]
		A101 [fillcolor="#ff3366" shape=box margin=0.03 width=0 height=0 label="1"]
		T5 -> P3 -> A101
		{ rank= same T5 }
}
"##;

/// The words of [`SECOND`]: two known ones, two composed, and one that no program uses.
const COMPOSED: &str = r#"instructions = ["std_max", "cos", { name = "scale", is = "mul(a, div(b, 10))" },
    { name = "turn", is = "add(sin(a), copy(3.5))" }, { name = "tan" }]"#;

fn read_second(text: &str) -> Result<Graph, InputError> {
    let sidecar = SIDECAR.replace("instructions = [\"sub\", \"cos\"]", COMPOSED);
    import::from_text("x.dot", text, Some(&Sidecar::from_toml("x.toml", &sidecar)?))
}

#[test]
fn gegelati_2_is_read_and_composed_instructions_become_lines() {
    let graph = read_second(SECOND).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(graph.registers(), 6, "four in the file, and two for intermediate values");
    // Constants are source 1, `target` source 2, `motors` source 3; locations wrap, r7 is r3.
    let state = [1.5, 2.0, f64::NAN, 900.0, 512.0];
    let interpreter = Interpreter::<f64, Own>::new(&graph);
    let bids: Vec<f64> = graph.programs().iter().map(|program| interpreter.run(program, &state)).collect();
    let cosine = <Own as Maths<f64>>::cos(900.0);
    let turned = <Own as Maths<f64>>::sin(cosine.max(0.25)) + 3.5;
    assert_eq!(bids, [2.0 * (13.5 / 10.0), turned, 512.0], "and std::max(512, NaN) is 512");
    assert_eq!(graph.provenance().version.as_deref(), Some("2.0.0"));
}

#[test]
fn a_program_that_uses_what_the_sidecar_does_not_explain_is_refused() {
    let error = read_second(&SECOND.replace("label=\"2|0", "label=\"4|0")).expect_err("tan is only named");
    let expected =
        "x.dot: line 8: program line 1: instruction 4, tan, whose meaning the sidecar does not give; accepted: ";
    assert!(error.to_string().starts_with(expected), "{error}");
}

#[test]
fn an_action_node_repeated_with_another_action_is_refused() {
    let text = SECOND.replacen(
        "A101 [fillcolor=\"#ff3366\" shape=box margin=0.03 width=0 height=0 label=\"1\"]",
        "A101 [label=\"0\"]",
        1,
    );
    assert!(read_second(&text).expect_err("two actions").to_string().contains("A101 a second time"));
}

/// A distance in space, an angle and a constant, as instructions of a robot's programs have them.
#[test]
fn instructions_of_six_operands_have_roots() {
    let instructions = r#"instructions = ["sub", "cos",
    { name = "distance", is = "sqrt(add(add(mul(sub(a, b), sub(a, b)), mul(sub(c, d), sub(c, d))), mul(sub(e, f), sub(e, f))))" },
    { name = "angle", is = "atan(div(a, b))" }]"#;
    let sidecar = SIDECAR.replace("instructions = [\"sub\", \"cos\"]", instructions);
    let sidecar = Sidecar::from_toml("x.toml", &sidecar).unwrap_or_else(|error| panic!("{error}"));
    let lines = "2|1&1|0#1|1#1|2#2|0#2|1#0|3&#92;n3|2&1|0#1|1#1|0#1|0#1|0#1|0&#92;n0|0&0|1#0|2#1|0#1|0#1|0#1|0&#92;n";
    let text = SMALL.replace("0|1&2|3#0|6&#92;n1|0&1|4#9|9&#92;n", lines);
    let graph = import::from_text("x.dot", &text, Some(&sidecar)).unwrap_or_else(|error| panic!("{error}"));
    let program = graph.programs().iter().find(|program| !program.lines.is_empty()).expect("a program");
    let [a, b, c, d, e] = [3.5_f64, -0.25, 7.0, 1e3, 512.0];
    let distance = ((a - b) * (a - b) + (c - d) * (c - d) + (e - 0.0) * (e - 0.0)).sqrt();
    let expected = distance - <Own as Maths<f64>>::atan(a / b);
    assert_eq!(Interpreter::<f64, Own>::new(&graph).run(program, &[a, b, c, d, e]), expected);

    let five = text.replace("#2|0#2|1#0|3&#92;n3", "#2|0#2|1&#92;n3");
    let error = import::from_text("x.dot", &five, Some(&sidecar)).expect_err("an operand is missing");
    assert!(error.to_string().contains("program line 1: 5 operands of distance; accepted: at least 6"), "{error}");
}

/// A formula without a team, as MAPLE exports it: each line has constants of its own, the value is squashed.
const MAPLE: &str = r##"// File exported with GEGELATI v1.4.0
digraph{
	graph[pad = "0.212, 0.055" bgcolor = lightgray]
	node[shape=circle style = filled label = ""]
		A7 [fillcolor="#ff3366" shape=box margin=0.03 width=0 height=0 label="0"]
		P3 [fillcolor="#cccccc" shape=point label="1"] //
		I3 [shape=box style=invis label="0|1&1|0#1|1&#92;n1|0&0|1#1|5&#92;n"] //0.5|-0.25|0.75|0.125|
		P3 -> I3[style=invis]
		A7 -> P3
}
"##;

const MAPLE_SIDECAR: &str = r#"
scalar = "f64"
maths = "own"
registers = 8
sources = [{ name = "obs", length = 2, unit = "", range = [-1, 1] }]
instructions = [{ name = "minus", is = "sub(mul(a, k0), mul(b, k1))" }, { name = "sine", is = "sin(mul(a, k0))" }]
outputs = [{ name = "torque", unit = "", min = -1, max = 1, nan = -1, is = "tanh(a)" }]
"#;

#[test]
fn constants_of_lines_are_those_of_their_line() {
    let read =
        |text: &str, sidecar: &str| import::from_text("x.dot", text, Some(&Sidecar::from_toml("x.toml", sidecar)?));
    let graph = read(MAPLE, MAPLE_SIDECAR).unwrap_or_else(|error| panic!("{error}"));
    let interpreter = Interpreter::<f64, Own>::new(&graph);
    let state = [0.75, -3.0];
    let difference = state[0] * 0.5 - state[1] * -0.25;
    let expected = <Own as Maths<f64>>::tanh(<Own as Maths<f64>>::sin(difference * 0.75));
    assert_eq!(interpreter.answer(&state), Answer::Values(vec![expected]));

    let refused = |text: &str, sidecar: &str| read(text, sidecar).expect_err("refused").to_string();
    let odd = refused(&MAPLE.replace("0.75|0.125|", "0.75|"), MAPLE_SIDECAR);
    assert!(odd.starts_with("x.dot: line 7: 3 constants on 2 lines; accepted: as many for each line"), "{odd}");
    let one = refused(&MAPLE.replace("0.5|-0.25|0.75|0.125|", "0.5|0.75|"), MAPLE_SIDECAR);
    assert!(one.contains("program line 1: 1 constant of a line for minus; accepted: at least 2"), "{one}");
    for of_another in ["sin(mul(a, k0))", "sin(a)"] {
        let operands = MAPLE_SIDECAR.replace("k0), mul(b, k1)", "c), mul(b, d)").replace("sin(mul(a, k0))", of_another);
        let missing = refused(MAPLE, &operands);
        let hint =
            "program line 1: 2 operands of minus; accepted: at least 4; constants of the line itself are k0 to k3";
        assert!(missing.contains(hint), "{missing}");
    }
    let output = refused(MAPLE, &MAPLE_SIDECAR.replace("tanh(a)", "tanh(mul(a, k0))"));
    assert!(output.contains("accepted: a call on the value a alone"), "{output}");
}

/// The guards of GEGELATI's own programs, for every kind of number: the compositions that docs/graph-json.md gives for them.
#[test]
fn guards_are_composed_of_words() {
    let text = &graph_json_page();
    let remainder = "gate(fmod(a, b), b) + gate(2.2250738585072014e-308, 1 - gate(1, b))";
    assert!(text.contains(remainder) && text.contains("and a guarded division is the same with `a / b`"));
    let specials = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, -7.5, 5e-324, 3.0, 0.1, -1.0, 0.0, -0.0];
    let quotient = remainder.replace("fmod(a, b)", "a / b").replace("2.2250738585072014e-308", "-0.0");
    type Operation = fn(f64, f64) -> f64;
    let cases: [(&str, Operation, f64); 2] =
        [(remainder, |a, b| a % b, f64::MIN_POSITIVE), (&quotient, |a, b| a / b, -0.0)];
    for (composition, operation, otherwise) in cases {
        let sidecar = SIDECAR.replace("\"cos\"", &format!("{{ name = \"guarded\", is = \"{composition}\" }}"));
        let small = SMALL.replace("0|1&2|3#0|6&#92;n1|0&1|4#9|9&#92;n", "1|0&1|0#1|1&#92;n");
        let sidecar = Sidecar::from_toml("x.toml", &sidecar).unwrap_or_else(|error| panic!("{error}"));
        let graph = import::from_text("x.dot", &small, Some(&sidecar)).unwrap_or_else(|error| panic!("{error}"));
        let guarded = graph.programs().iter().find(|program| !program.lines.is_empty()).expect("a program");
        for a in specials {
            for b in specials {
                let found = Interpreter::<f64, Own>::new(&graph).run(guarded, &[a, b, 0.0, 0.0, 0.0]);
                let expected = if b != 0.0 { operation(a, b) } else { otherwise };
                let same = found.to_bits() == expected.to_bits() || (found.is_nan() && expected.is_nan());
                assert!(same, "{composition} of {a:e} and {b:e}: {found:e}, not {expected:e}");
            }
        }
    }
}

/// Tests of GEGELATI's own programs, for every kind of number: the compositions that docs/graph-json.md gives for them.
#[test]
fn comparisons_are_composed_of_words() {
    let text = &graph_json_page();
    type Test = fn(f64) -> bool;
    let cases: [(&str, Test); 3] = [
        ("min(0 / min(abs(a), 1), 10)", |a| a == 0.0),
        ("min(0 / min(abs(a - 1), 1), 10)", |a| a == 1.0),
        ("min(0 / abs(min(max(a - 15, -1), 0)), 10)", |a| a >= 15.0),
    ];
    let next = |a: f64| [a.next_down(), a, a.next_up()];
    let specials = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, -0.0, -7.5, 5e-324, 1e300];
    let values: Vec<f64> = specials.into_iter().chain([0.0, 1.0, 15.0].into_iter().flat_map(next)).collect();
    for (composition, is_true) in cases {
        assert!(text.contains(composition), "{composition} is documented");
        let sidecar = SIDECAR.replace("\"cos\"", &format!("{{ name = \"test\", is = \"{composition}\" }}"));
        let small = SMALL.replace("0|1&2|3#0|6&#92;n1|0&1|4#9|9&#92;n", "1|0&1|0#0|0&#92;n");
        let graph =
            import::from_text("x.dot", &small, Some(&Sidecar::from_toml("x.toml", &sidecar).expect("a sidecar")));
        let graph = graph.unwrap_or_else(|error| panic!("{error}"));
        let interpreter = Interpreter::<f64, Own>::new(&graph);
        let tested = graph.programs().iter().find(|program| !program.lines.is_empty()).expect("a program");
        for &a in &values {
            let found = interpreter.run(tested, &[a, 0.0, 0.0, 0.0, 0.0]);
            let expected: f64 = if is_true(a) { 10.0 } else { 0.0 };
            assert_eq!(found.to_bits(), expected.to_bits(), "{composition} of {a:e}");
        }
    }
}

/// The page about the format. It is read, not included: a package holds no file from outside of its folder.
fn graph_json_page() -> String {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/graph-json.md");
    std::fs::read_to_string(path).expect("the repository has it")
}
