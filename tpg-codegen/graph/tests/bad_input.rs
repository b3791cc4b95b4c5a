//! Rejected inputs and their messages: file, place, what was found, what is accepted.
//!
//! The messages are snapshots; whoever changes one should read it.

use std::fmt::Write as _;
use tpg_graph::Graph;
use tpg_graph::error::{InputError, Place};
use tpg_graph::import::{self, Sidecar};

/// A test case: its name, and the replacements that spoil a good text.
type Case<'c> = (&'c str, &'c [(&'c str, &'c str)]);

/// Applies each case to `good` and lists the resulting messages of `read`.
fn messages(good: &str, cases: &[Case<'_>], read: impl Fn(&str) -> Result<Graph, InputError>) -> String {
    read(good).unwrap_or_else(|error| panic!("the good text: {error}"));
    let mut list = String::new();
    for (name, changes) in cases {
        let bad = changes.iter().fold(good.to_owned(), |text, (from, to)| {
            assert_eq!(text.matches(from).count(), 1, "{name}: {from:?} must occur exactly once");
            text.replace(from, to)
        });
        let error = read(&bad).expect_err(name);
        assert_complete(name, &error);
        writeln!(list, "{name}:\n  {error}").expect("a string can be written to");
    }
    list
}

/// Checks that an error is complete and fits one line. An error about a file as a whole has no place.
fn assert_complete(name: &str, error: &InputError) {
    let InputError { file, found, accepted, .. } = error;
    assert!([file, found, accepted].iter().all(|part| !part.is_empty()), "{name}: {error:?}");
    assert!(!error.to_string().contains('\n'), "{name}: {error}");
}

const JSON: &str = r#"{
  "format": "tpg-graph", "version": 1, "scalar": "f32", "maths": "own", "registers": 4,
  "sources": [
    {"name":"target","length":2,"unit":"mm","ranges":[[-1.0,1.0],[0.0,4095.0]]},
    {"name":"motors","length":1,"unit":"ticks","ranges":[[0.0,8.0]]}
  ],
  "instructions": ["add","cos"],
  "actions": [{"id":0,"name":"left"},{"id":1,"name":"right","move":[3,0,0,0]}],
  "root": 7,
  "teams": [
    {"id":7,"edges":[{"program":1,"action":0},{"program":2,"team":9}]},
    {"id":9,"edges":[{"program":3,"action":1}]}
  ],
  "programs": [
    {"id":1,"lines":[{"to":3,"op":"add","args":["r0","motors[0]"]},{"to":0,"op":"cos","args":[0.5]}]},
    {"id":2,"lines":[]},
    {"id":3,"lines":[]}
  ]
}
"#;

const IMAGE: &str = r#"{
  "format": "tpg-graph", "version": 2, "scalar": "f32", "maths": "own", "registers": 1,
  "sources": [{"name":"ball","length":3,"unit":"","ranges":[[-1,9],[0,1],[0,255]],"image":{"shape":[24,32,2],"features":[
    {"row":{"first":0}}, {"cell":{"channel":1,"down":-2,"right":3,"from":{"last":0}}}, {"contrast":{"darkest":{"channel":1,"size":5}}}]}}],
  "instructions": ["add"],
  "actions": [{"id":0,"name":"left"}],
  "root": 0,
  "teams": [{"id":0,"edges":[{"program":0,"action":0}]}],
  "programs": [{"id":0,"lines":[]}]
}
"#;

#[test]
fn images() {
    let cases: &[Case<'_>] = &[
        ("version 1", &[("\"version\": 2", "\"version\": 1")]),
        ("no cells", &[("[24,32,2]", "[24,0,2]")]),
        ("too many cells", &[("[24,32,2]", "[65536,65536,2]")]),
        ("two values", &[("{\"row\":{\"first\":0}}, ", "")]),
        ("an unknown feature", &[("{\"row\":", "{\"diagonal\":")]),
        ("no such channel", &[("{\"channel\":1,\"down\"", "{\"channel\":2,\"down\"")]),
        ("no such channel to look in", &[("{\"last\":0}", "{\"last\":2}")]),
        ("far away", &[("\"down\":-2", "\"down\":-24")]),
        ("an even window", &[("\"size\":5", "\"size\":4")]),
        ("a window of more than the image", &[("[24,32,2]", "[4,32,2]")]),
        ("the contrast of a cell", &[("{\"darkest\":{\"channel\":1,\"size\":5}}", "{\"first\":0}")]),
        (
            "a window outside",
            &[(
                "{\"row\":{\"first\":0}}",
                "{\"sum\":{\"channel\":0,\"row\":20,\"column\":0,\"height\":5,\"width\":1}}",
            )],
        ),
        (
            "too few bits",
            &[(
                "\"image\":",
                "\"counts\":[{\"bits\":16,\"scale\":1},{\"bits\":8,\"scale\":1},{\"bits\":16,\"scale\":1}],\"image\":",
            )],
        ),
        (
            "half a row",
            &[(
                "\"image\":",
                "\"counts\":[{\"bits\":16,\"scale\":0.5},{\"bits\":16,\"scale\":1},{\"bits\":16,\"scale\":1}],\"image\":",
            )],
        ),
    ];
    insta::assert_snapshot!(messages(IMAGE, cases, |text| Graph::from_json("eye.json", text)));
}

const OUTPUTS: &str = r#"{
  "format": "tpg-graph", "version": 2, "scalar": "f32", "maths": "own", "registers": 4,
  "sources": [{"name":"angle","length":2,"unit":"rad","ranges":[[-1.0,1.0],[-8.0,8.0]]}],
  "instructions": ["add","cos"],
  "outputs": [
    {"name":"torque","unit":"N*m","min":-2.0,"max":2.0,"nan":0.0},
    {"name":"brake","unit":"1","min":0.0,"max":1.0,"nan":1.0}
  ],
  "root": 7,
  "teams": [{"id":7,"edges":[{"program":1,"leaf":4},{"program":2,"leaf":5}]}],
  "leaves": [{"id":4,"programs":[2,3]},{"id":5,"programs":[3,3]}],
  "programs": [
    {"id":1,"lines":[{"to":0,"op":"add","args":["r0","angle[0]"]}]},
    {"id":2,"lines":[]},
    {"id":3,"lines":[{"to":0,"op":"cos","args":["angle[1]"]}]}
  ]
}
"#;

#[test]
fn outputs_and_leaves() {
    let leaves = r#"  "leaves": [{"id":4,"programs":[2,3]},{"id":5,"programs":[3,3]}],
"#;
    let teams = r#"  "root": 7,
  "teams": [{"id":7,"edges":[{"program":1,"leaf":4},{"program":2,"leaf":5}]}],
"#;
    let cases: &[Case<'_>] = &[
        ("outputs in version 1", &[("\"version\": 2", "\"version\": 1")]),
        ("an unknown version", &[("\"version\": 2", "\"version\": 3")]),
        ("actions and outputs", &[("\"root\": 7,", "\"actions\": [{\"id\":0,\"name\":\"left\"}], \"root\": 7,")]),
        ("a name of no field", &[("\"torque\"", "\"Torque\"")]),
        ("the same name twice", &[("\"brake\"", "\"torque\"")]),
        ("a unit that ends a comment", &[("N*m", "N*/m")]),
        ("no bound", &[("\"min\":-2.0,", "")]),
        ("ends in the wrong order", &[("\"max\":2.0", "\"max\":-3.0")]),
        ("an end that f32 does not have", &[("\"max\":2.0", "\"max\":2.1")]),
        ("a value for NaN outside the range", &[("\"nan\":0.0", "\"nan\":2.5")]),
        ("no leaves", &[(leaves, "")]),
        (
            "leaves without outputs",
            &[
                ("\"outputs\": [", "\"actions\": [{\"id\":0,\"name\":\"left\"}],\n  \"outputs\": ["),
                ("{\"name\":\"torque\",\"unit\":\"N*m\",\"min\":-2.0,\"max\":2.0,\"nan\":0.0},", ""),
                ("{\"name\":\"brake\",\"unit\":\"1\",\"min\":0.0,\"max\":1.0,\"nan\":1.0}", ""),
            ],
        ),
        ("too few programs", &[("\"programs\":[2,3]", "\"programs\":[2]")]),
        ("a program that does not exist", &[("\"programs\":[2,3]", "\"programs\":[2,9]")]),
        ("two leaves of one id", &[("{\"id\":5,\"programs\"", "{\"id\":4,\"programs\"")]),
        ("a leaf that does not exist", &[("\"leaf\":5", "\"leaf\":6")]),
        ("a leaf that no edge leads to", &[("\"leaf\":5", "\"leaf\":4")]),
        ("an action of a policy with outputs", &[("\"leaf\":5", "\"action\":0")]),
        ("two destinations", &[("\"leaf\":5", "\"leaf\":5,\"team\":7")]),
        ("no destination", &[(",\"leaf\":5", "")]),
        ("no team to choose a leaf", &[(teams, "")]),
        ("a root without teams", &[(teams, "  \"root\": 7,\n"), (",{\"id\":5,\"programs\":[3,3]}", "")]),
        ("no root", &[("\"root\": 7,", "")]),
        ("a program that nothing uses", &[("\"programs\":[2,3]", "\"programs\":[2,2]"), ("[3,3]", "[2,2]")]),
    ];
    insta::assert_snapshot!(messages(OUTPUTS, cases, |text| Graph::from_json("x.json", text)));
}

#[test]
fn memory() {
    let text = OUTPUTS
        .replace(
            "\"root\": 7,",
            "\"memory\": [{\"name\":\"last\",\"min\":-1.0,\"max\":1.0,\"initial\":0.0}],\n  \"root\": 7,",
        )
        .replace("[2,3]}", "[2,3],\"memory\":[3]}")
        .replace("[3,3]}", "[3,3],\"memory\":[2]}")
        .replace("\"r0\",", "\"last[0]\",");
    Graph::from_json("x.json", &text).expect("a graph with memory");
    let cases: &[Case<'_>] = &[
        ("memory in version 1", &[("\"version\": 2", "\"version\": 1")]),
        ("a name of no field", &[("\"last\"", "\"Last\"")]),
        ("the name of a source", &[("\"last\"", "\"angle\""), ("last[0]", "angle[0]")]),
        ("the name of an output", &[("\"last\"", "\"brake\""), ("last[0]", "brake[0]")]),
        ("no bound", &[("\"min\":-1.0,", "")]),
        ("ends in the wrong order", &[("\"max\":1.0,\"initial", "\"max\":-3.0,\"initial")]),
        ("a first value outside the range", &[("\"initial\":0.0", "\"initial\":2.5")]),
        ("a second value that is read", &[("last[0]", "last[1]")]),
        ("a leaf without memory", &[(",\"memory\":[3]", "")]),
        ("too many programs", &[("\"memory\":[3]", "\"memory\":[3,2]")]),
        ("a program that does not exist", &[("\"memory\":[3]", "\"memory\":[9]")]),
        (
            "no outputs",
            &[
                ("\"outputs\": [", "\"actions\": [{\"id\":0,\"name\":\"left\"}],\n  \"outputs\": ["),
                ("{\"name\":\"torque\",\"unit\":\"N*m\",\"min\":-2.0,\"max\":2.0,\"nan\":0.0},", ""),
                ("{\"name\":\"brake\",\"unit\":\"1\",\"min\":0.0,\"max\":1.0,\"nan\":1.0}", ""),
            ],
        ),
    ];
    insta::assert_snapshot!(messages(&text, cases, |text| Graph::from_json("x.json", text)));
}

#[test]
fn json() {
    let cases: &[Case<'_>] = &[
        ("not JSON", &[("\"root\": 7,", "\"root\": seven,")]),
        ("truncated", &[("{\"id\":2,\"lines\":[]},\n    {\"id\":3,\"lines\":[]}\n  ]\n}\n", "{\"id\":2,\"li")]),
        ("something after the end", &[("  ]\n}\n", "  ]\n}\n{}\n")]),
        ("another version", &[("\"version\": 1", "\"version\": 3")]),
        ("another version with other fields", &[("\"version\": 1", "\"version\": 3, \"memory\": []")]),
        ("another format", &[("tpg-graph", "tpg-tree")]),
        ("an unknown field", &[("\"root\": 7", "\"rot\": 7")]),
        ("a missing field", &[("  \"root\": 7,\n", "")]),
        ("a field a second time", &[("\"root\": 7", "\"root\": 7, \"root\": 9")]),
        ("a value of another type", &[("\"root\": 7", "\"root\": \"seven\"")]),
        ("an unknown scalar", &[("f32", "f16")]),
        ("no registers", &[("\"registers\": 4", "\"registers\": 0")]),
        ("too many registers", &[("\"registers\": 4", "\"registers\": 257")]),
        ("an unknown instruction in the set", &[("[\"add\",\"cos\"]", "[\"add\",\"cosine\",\"cos\"]")]),
        ("an instruction twice in the set", &[("[\"add\",\"cos\"]", "[\"add\",\"cos\",\"add\"]")]),
        ("an unknown instruction", &[("\"op\":\"cos\"", "\"op\":\"tan\"")]),
        ("an instruction outside the set", &[("\"op\":\"cos\"", "\"op\":\"sin\"")]),
        ("too few operands", &[("[\"r0\",\"motors[0]\"]", "[\"r0\"]")]),
        ("too many operands", &[("[0.5]", "[0.5, 0.5]")]),
        ("a register out of range", &[("\"to\":3", "\"to\":4")]),
        ("a register out of range as an operand", &[("\"r0\"", "\"r4\"")]),
        ("a register out of any range", &[("\"r0\"", "\"r99999999999999999999\"")]),
        ("an unknown source", &[("motors[0]", "motor[0]")]),
        ("a source out of range", &[("motors[0]", "motors[1]")]),
        ("a source with a sign", &[("motors[0]", "motors[+0]")]),
        ("an invalid operand", &[("motors[0]", "motors")]),
        ("an operand of another type", &[("\"motors[0]\"", "true")]),
        ("a constant that does not fit f32", &[("[0.5]", "[1e39]")]),
        ("a constant that does not fit f64", &[("[0.5]", "[1e309]")]),
        ("a source named like a register", &[("\"target\"", "\"r2\"")]),
        ("a source with a capital letter", &[("\"target\"", "\"Target\"")]),
        ("a source twice", &[("\"target\"", "\"motors\"")]),
        ("a unit that ends a comment", &[("\"mm\"", "\"*/ m\"")]),
        ("a source of another length", &[("\"length\":2", "\"length\":3")]),
        ("an inverted range", &[("[-1.0,1.0]", "[1.0,-1.0]")]),
        ("a range that is not exact in f32", &[("[-1.0,1.0]", "[-0.1,1.0]")]),
        (
            "no sources",
            &[(
                "    {\"name\":\"target\",\"length\":2,\"unit\":\"mm\",\"ranges\":[[-1.0,1.0],[0.0,4095.0]]},\n    {\"name\":\"motors\",\"length\":1,\"unit\":\"ticks\",\"ranges\":[[0.0,8.0]]}\n",
                "",
            )],
        ),
        ("an action with another id", &[("\"id\":1,\"name\":\"right\"", "\"id\":2,\"name\":\"right\"")]),
        ("effects of two lengths", &[("\"left\"", "\"left\",\"move\":[3,0,0]")]),
        (
            "an action with two effects",
            &[("\"move\":[3,0,0,0]", "\"move\":[3],\"effect\":{\"name\":\"f\",\"values\":[1]}")],
        ),
        ("an action that asks nobody", &[("\"left\"", "\"left\",\"ask\":\"\"")]),
        ("an action that asks beside an effect", &[("\"move\":[3,0,0,0]", "\"move\":[3,0,0,0],\"ask\":\"network\"")]),
        (
            "actions that all ask",
            &[("\"left\"", "\"left\",\"ask\":\"network\""), ("\"move\":[3,0,0,0]", "\"ask\":\"planner\"")],
        ),
        (
            "two actions that ask the same",
            &[
                ("\"left\"", "\"left\",\"ask\":\"network\""),
                ("\"move\":[3,0,0,0]}", "\"ask\":\"network\"},{\"id\":2,\"name\":\"up\"}"),
            ],
        ),
        ("an effect that is not finite", &[("[3,0,0,0]", "[3,0,0,1e999]")]),
        ("an edge to a missing team", &[("\"team\":9", "\"team\":8")]),
        ("an edge to a missing action", &[("\"action\":1", "\"action\":2")]),
        ("an edge of a missing program", &[("\"program\":3", "\"program\":4")]),
        ("an edge to nowhere", &[(",\"team\":9", "")]),
        ("an edge to two places", &[("\"team\":9", "\"team\":9,\"action\":0")]),
        ("a team without edges", &[("[{\"program\":3,\"action\":1}]", "[]")]),
        (
            "no teams",
            &[(
                "    {\"id\":7,\"edges\":[{\"program\":1,\"action\":0},{\"program\":2,\"team\":9}]},\n    {\"id\":9,\"edges\":[{\"program\":3,\"action\":1}]}\n",
                "",
            )],
        ),
        ("a cycle", &[("\"program\":3,\"action\":1", "\"program\":3,\"team\":9")]),
        (
            "a cycle of two",
            &[
                ("\"program\":3,\"action\":1}", "\"program\":3,\"team\":8}"),
                (
                    "]}\n  ],\n  \"programs\"",
                    "]},\n    {\"id\":8,\"edges\":[{\"program\":4,\"team\":9}]}\n  ],\n  \"programs\"",
                ),
                ("{\"id\":3,\"lines\":[]}", "{\"id\":3,\"lines\":[]},{\"id\":4,\"lines\":[]}"),
            ],
        ),
        ("a missing root", &[("\"root\": 7", "\"root\": 8")]),
        ("no root", &[("\"program\":3,\"action\":1", "\"program\":3,\"team\":7")]),
        ("two roots", &[(",{\"program\":2,\"team\":9}", ",{\"program\":2,\"action\":0}")]),
        ("two destinations of a program", &[("\"program\":3,\"action\":1", "\"program\":1,\"action\":1")]),
        (
            "a program that no edge uses",
            &[
                (",{\"program\":2,\"team\":9}", ",{\"program\":3,\"team\":9}"),
                ("{\"program\":3,\"action\":1}", "{\"program\":1,\"action\":0}"),
            ],
        ),
        ("a team twice", &[("{\"id\":9", "{\"id\":7")]),
        ("a program twice", &[("{\"id\":3", "{\"id\":1")]),
        (
            "counts of one source",
            &[
                ("\"version\": 1", "\"version\": 2"),
                ("[0.0,4095.0]]", "[0.0,4095.0]],\"counts\":[{\"bits\":16,\"scale\":1},{\"bits\":13,\"scale\":0.1}]"),
            ],
        ),
        (
            "counts in version 1",
            &[
                ("[0.0,4095.0]]", "[0.0,4095.0]],\"counts\":[{\"bits\":16,\"scale\":1},{\"bits\":13,\"scale\":0.1}]"),
                ("\"ranges\":[[0.0,8.0]]", "\"ranges\":[[0.0,8.0]],\"counts\":[{\"bits\":16,\"scale\":1}]"),
            ],
        ),
        (
            "counts of too many bits",
            &[
                ("\"version\": 1", "\"version\": 2"),
                ("[0.0,4095.0]]", "[0.0,4095.0]],\"counts\":[{\"bits\":16,\"scale\":1},{\"bits\":13,\"scale\":0.1}]"),
                ("\"ranges\":[[0.0,8.0]]", "\"ranges\":[[0.0,8.0]],\"counts\":[{\"bits\":17,\"scale\":1}]"),
            ],
        ),
        (
            "counts of no worth",
            &[
                ("\"version\": 1", "\"version\": 2"),
                ("[0.0,4095.0]]", "[0.0,4095.0]],\"counts\":[{\"bits\":16,\"scale\":1},{\"bits\":13,\"scale\":0.1}]"),
                ("\"ranges\":[[0.0,8.0]]", "\"ranges\":[[0.0,8.0]],\"counts\":[{\"bits\":16,\"scale\":0}]"),
            ],
        ),
        (
            "a range beyond its counts",
            &[
                ("\"version\": 1", "\"version\": 2"),
                ("[0.0,4095.0]]", "[0.0,4095.0]],\"counts\":[{\"bits\":16,\"scale\":1},{\"bits\":13,\"scale\":0.1}]"),
                ("\"ranges\":[[0.0,8.0]]", "\"ranges\":[[0.0,8.0]],\"counts\":[{\"bits\":4,\"scale\":1}]"),
            ],
        ),
    ];
    insta::assert_snapshot!("json", messages(JSON, cases, |text| import::from_text("x.json", text, None)));
}

const DOT: &str = r##"// File exported with GEGELATI v1.3.1
digraph{
	graph[pad = "0.212, 0.055" bgcolor = lightgray]
	node[shape=circle style = filled label = ""]
		T7 [fillcolor="#1199bb"]
		T9 [fillcolor="#66ddff"]
		P1 [fillcolor="#cccccc" shape=point] //5|6|
		I1 [shape=box style=invis label="0|3&0|0#3|0&#92;n1|0&1|0#0|0&#92;n"]
		P1 -> I1[style=invis]
		A0 [fillcolor="#ff3366" shape=box margin=0.03 width=0 height=0 label="0"]
		T7 -> P1 -> A0
		P2 [fillcolor="#cccccc" shape=point] //7|8|
		I2 [shape=box style=invis label=""]
		P2 -> I2[style=invis]
		T7 -> P2 -> T9
		P3 [fillcolor="#cccccc" shape=point] //9|0|
		I3 [shape=box style=invis label=""]
		P3 -> I3[style=invis]
		A1 [fillcolor="#ff3366" shape=box margin=0.03 width=0 height=0 label="1"]
		T9 -> P3 -> A1
		T9 -> P1
		{ rank= same T7 }
}
"##;

const SIDECAR: &str = r#"scalar = "f32"
maths = "own"
registers = 4
sources = [
    { name = "target", length = 2, unit = "mm", ranges = [[-1, 1], [0, 4095]] },
    { name = "motors", length = 1, unit = "ticks", range = [0, 8] },
]
instructions = ["add", "cos"]
actions = [
    { id = 0, name = "left" },
    { id = 1, name = "right", move = [3, 0, 0, 0] },
]
"#;

fn read_dot(text: &str) -> Result<Graph, InputError> {
    import::from_text("x.dot", text, Some(&Sidecar::from_toml("x.toml", SIDECAR).expect("a good sidecar")))
}

#[test]
fn dot() {
    let cases: &[Case<'_>] = &[
        ("truncated between lines", &[("\t\tT9 -> P3 -> A1\n\t\tT9 -> P1\n\t\t{ rank= same T7 }\n}\n", "")]),
        (
            "truncated in a line",
            &[(
                "box margin=0.03 width=0 height=0 label=\"1\"]\n\t\tT9 -> P3 -> A1\n\t\tT9 -> P1\n\t\t{ rank= same T7 }\n}\n",
                "box mar",
            )],
        ),
        ("a label without end", &[("\"]\n\t\tP1 -> I1[style=invis]\n", "")]),
        ("truncated before its graph", &[("digraph{\n", "")]),
        ("something after the end", &[("T7 }\n}\n", "T7 }\n}\nT1 []\n")]),
        ("an unknown statement", &[("{ rank= same T7 }", "subgraph cluster_0 {")]),
        ("another character", &[("T9 -> P1\n", "T9 -> P1;\n")]),
        ("an edge of GEGELATI 2's action programs", &[("T9 -> P1\n", "A0 -> P1\n")]),
        ("a program of neither kind", &[("shape=point] //9", "shape=point label=\"2\"] //9")]),
        ("an action of GEGELATI 2", &[("label=\"1\"", "label=\"0-1\"")]),
        ("an edge between teams", &[("T9 -> P1\n", "T9 -> T7\n")]),
        ("a number that does not fit", &[("T9 -> P1\n", "T9 -> P4294967296\n")]),
        ("a node without label", &[(" label=\"1\"", "")]),
        ("attributes without end", &[("label=\"1\"]", "label=\"1\"")]),
        ("a link to another program's lines", &[("P2 -> I2", "P2 -> I3")]),
        ("a link of a missing program", &[("P2 -> I2[", "P4 -> I4[")]),
        ("a program without lines", &[("\t\tI2 [shape=box style=invis label=\"\"]\n", "")]),
        ("a line without end", &[("0|0&#92;n\"", "0|0\"")]),
        ("an invalid line", &[("0|3&0|0#3|0&", "0|3&0|0#3&")]),
        ("a line with a name", &[("0|3&0|0#3|0&", "add|3&0|0#3|0&")]),
        ("an unknown instruction", &[("0|3&0|0#3|0&", "2|3&0|0#3|0&")]),
        ("a register out of range", &[("0|3&0|0#3|0&", "0|4&0|0#3|0&")]),
        ("a source out of range", &[("0|3&0|0#3|0&", "0|3&0|0#4|0&")]),
        ("too few operands", &[("0|3&0|0#3|0&", "0|3&0|0&")]),
        ("a constant that is not a number", &[("//9|", "//nine|")]),
        ("a constant that does not fit f64", &[("//9|", "//1e999|")]),
        ("a constant without end", &[("//9|0|", "//9|0")]),
        ("another number of constants", &[("//9|0|", "//9|")]),
        ("constants in two places", &[("label=\"\"]\n\t\tP2", "label=\"\"] //0.5|0.5|\n\t\tP2")]),
        (
            "a real constant that does not fit f32",
            &[
                ("//5|6|", "//"),
                ("n\"]\n", "n\"] //1e39|1|\n"),
                ("//7|8|", "//"),
                ("label=\"\"]\n\t\tP2", "label=\"\"] //1|1|\n\t\tP2"),
                ("//9|0|", "//"),
                ("label=\"\"]\n\t\tP3", "label=\"\"] //1|1|\n\t\tP3"),
            ],
        ),
        ("an edge to a missing team", &[("P2 -> T9", "P2 -> T8")]),
        ("an edge of a missing team", &[("T9 -> P1\n", "T8 -> P1\n")]),
        ("an edge to a missing action", &[("P3 -> A1", "P3 -> A2")]),
        ("an edge of a missing program", &[("T9 -> P1\n", "T9 -> P4\n")]),
        ("an action out of range", &[("label=\"1\"", "label=\"2\"")]),
        ("a program that never leads anywhere", &[("T7 -> P1 -> A0", "T7 -> P1")]),
        ("two destinations of a program", &[("T9 -> P1\n", "T9 -> P1 -> A1\n")]),
        ("a program that no edge uses", &[("T9 -> P3 -> A1\n", "\n")]),
        ("a team without edges", &[("T9 -> P3 -> A1\n", "T7 -> P3 -> A1\n"), ("T9 -> P1\n", "\n")]),
        ("a cycle", &[("T9 -> P3 -> A1", "T9 -> P3 -> T9")]),
        ("no root", &[("T9 -> P3 -> A1", "T9 -> P3 -> T7")]),
        ("two roots", &[("P2 -> T9", "P2 -> A0")]),
        ("two roots named", &[("same T7", "same T7 T9")]),
        ("no root named", &[("same T7", "same ")]),
        ("another root named", &[("same T7", "same T9")]),
        ("a missing team named as the root", &[("same T7", "same T8")]),
        ("an action as the root", &[("same T7", "same A0")]),
        ("roots named twice", &[("\t\t{ rank= same T7 }\n", "\t\t{ rank= same T7 }\n\t\t{ rank= same T7 }\n")]),
        ("a team twice", &[("T9 [", "T7 [")]),
        ("a program twice", &[("P3 [", "P1 [")]),
        ("lines twice", &[("I3 [", "I1 [")]),
        ("an action's node twice", &[("A1 [", "A0 [")]),
    ];
    insta::assert_snapshot!("dot", messages(DOT, cases, read_dot));
    insta::assert_snapshot!("dot_empty", read_dot("digraph{\n}\n").expect_err("nothing in it").to_string());
    for (name, changes) in cases {
        let bad = changes.iter().fold(DOT.to_owned(), |text, (from, to)| text.replace(from, to));
        assert!(matches!(read_dot(&bad).expect_err(name).place, Place::Line(_)), "{name}");
    }
}

/// Truncation or a missing line must never cause a panic: reads every prefix, and every text with one of its lines
/// removed.
#[test]
fn parts_of_a_file_are_errors_or_graphs() {
    for (text, read) in [(DOT, read_dot as fn(&str) -> _), (JSON, |text: &str| import::from_text("x", text, None))] {
        let whole = text.trim_end().len();
        for end in 0..whole {
            read(&text[..end]).expect_err("a part of a file");
        }
        let lines: Vec<&str> = text.lines().collect();
        for without in 0..lines.len() {
            let rest = [&lines[..without], &lines[without + 1..]].concat().join("\n");
            if let Err(error) = read(&rest) {
                assert_complete(&rest, &error);
            }
        }
    }
}

#[test]
fn sidecar() {
    let cases: &[Case<'_>] = &[
        ("not TOML", &[("registers = 4", "registers: 4")]),
        (
            "truncated",
            &[(
                "actions = [\n    { id = 0, name = \"left\" },\n    { id = 1, name = \"right\", move = [3, 0, 0, 0] },\n]\n",
                "actions = [\n    { id",
            )],
        ),
        ("an unknown field", &[("registers = 4", "regs = 4")]),
        ("a missing field", &[("registers = 4\n", "")]),
        ("an unknown field of a source", &[("range = [0, 8]", "range = [0, 8], scale = 2")]),
        ("a value of another type", &[("registers = 4", "registers = \"four\"")]),
        ("a value out of range", &[("registers = 4", "registers = -4")]),
        ("too many registers", &[("registers = 4", "registers = 257")]),
        ("an unknown instruction", &[("\"cos\"", "\"cosine\"")]),
        ("a composition of an unknown word", &[("\"cos\"", "{ name = \"cos\", is = \"cosine(a)\" }")]),
        ("a composition without its end", &[("\"cos\"", "{ name = \"cos\", is = \"cos(a\" }")]),
        ("a composition that is a number", &[("\"cos\"", "{ name = \"cos\", is = 3 }")]),
        ("an instruction twice", &[("\"cos\"", "{ name = \"add\" }")]),
        ("both range and ranges", &[("range = [0, 8]", "range = [0, 8], ranges = [[0, 8]]")]),
        ("neither range nor ranges", &[(", range = [0, 8]", "")]),
        ("too few ranges", &[("[[-1, 1], [0, 4095]]", "[[-1, 1]]")]),
        ("an infinite range", &[("[0, 8]", "[0, inf]")]),
        ("a range that is not exact in f32", &[("[-1, 1]", "[-1, 0.1]")]),
        ("a source too long", &[("length = 1", "length = 4000000000")]),
        ("a source with a capital letter", &[("\"target\"", "\"Target\"")]),
        ("an action with another id", &[("id = 1", "id = 2")]),
        ("an action's move that is not a number", &[("[3, 0, 0, 0]", "[nan, 0, 0, 0]")]),
    ];
    let read = |text: &str| import::from_text("x.dot", DOT, Some(&Sidecar::from_toml("x.toml", text)?));
    insta::assert_snapshot!("sidecar", messages(SIDECAR, cases, read));
}

#[test]
fn whole_files() {
    let sidecar = Sidecar::from_toml("x.toml", SIDECAR).expect("a good sidecar");
    let mut list = String::new();
    for (name, text, description) in [
        ("empty", "", None),
        ("empty with a sidecar", "", Some(&sidecar)),
        ("blank", " \n\t\n", None),
        ("something else", "hello", None),
        ("a JSON list", "[1, 2]", None),
        ("a .dot without description", DOT, None),
        ("JSON with a description", JSON, Some(&sidecar)),
    ] {
        let error = import::from_text("x", text, description).expect_err(name);
        assert_complete(name, &error);
        writeln!(list, "{name}:\n  {error}").expect("a string can be written to");
    }
    insta::assert_snapshot!("whole_files", list);
}

/// Editors on Windows write a byte order mark at the start and two characters at the end of each line.
#[test]
fn files_of_windows_are_as_good() {
    let windows = |text: &str| format!("\u{feff}{}", text.replace('\n', "\r\n"));
    assert_eq!(read_dot(&windows(DOT)), read_dot(DOT));
    let read = |text: &str| import::from_text("x.json", text, None);
    assert_eq!(read(&windows(JSON)), read(JSON));
}
