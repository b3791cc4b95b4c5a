//! Names that C or C++ give a meaning: keywords, and every macro of the headers that generated code includes. A source, an output or a
//! value of the memory may have one; the field in C has an underscore more.

use crate::common::{code, options, run};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use std::process::Command;
use tpg_codegen::emit::{self, Language, Options, Profile, Style};
use tpg_codegen::verify::{self, Workshop};
use tpg_graph::Graph;
use tpg_graph::engine::Engine;

/// Compilers of C and C++, the Debian package of each, and its language.
const COMPILERS: [(&str, &str, &str); 6] = [
    ("gcc", "gcc", "c"),
    ("g++", "g++", "c++"),
    ("clang", "clang", "c"),
    ("clang++", "clang", "c++"),
    ("arm-none-eabi-gcc", "gcc-arm-none-eabi", "c"),
    ("avr-gcc", "gcc-avr", "c"),
];

/// The headers that generated code and the programs around it include.
const HEADERS: &str =
    "#include <float.h>\n#include <math.h>\n#include <stdint.h>\n#include <stdio.h>\n#include <string.h>\n";

/// Words of the languages; Rust's name no field in any language.
const KEYWORDS: [&str; 24] = [
    "int",
    "double",
    "struct",
    "if",
    "union",
    "typeof",
    "class",
    "new",
    "this",
    "xor_eq",
    "co_await",
    "char8_t",
    "concept",
    "nullptr",
    "constexpr",
    "final",
    "bool",
    "true",
    "fn",
    "impl",
    "match",
    "self",
    "crate",
    "unsafe",
];

/// Macros in lower case of a compiler's headers.
fn macros(compiler: &str, language: &str) -> BTreeSet<String> {
    let folder = tempfile::tempdir().expect("a folder");
    fs::write(folder.path().join("headers.h"), HEADERS).expect("written");
    let mut command = Command::new(compiler);
    command.current_dir(folder.path()).args(["-x", language, "-dM", "-E", "headers.h"]);
    let text = run(&mut command).unwrap_or_else(|error| panic!("{error}"));
    let name = |line: &str| line.strip_prefix("#define ")?.split([' ', '(']).next().map(str::to_owned);
    let is_lower =
        |name: &String| name.starts_with(|c: char| c.is_ascii_lowercase()) && !name.contains(char::is_uppercase);
    text.lines().filter_map(name).filter(is_lower).collect()
}

/// Kinds of things that have names.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Role {
    Sources,
    /// And sources.
    Outputs,
    Memory,
}

const ROLES: [Role; 3] = [Role::Sources, Role::Outputs, Role::Memory];

/// A graph with these names.
fn named(names: &[String], role: Role) -> Graph {
    let source = |name: &str| json!({ "name": name, "length": 1, "unit": "", "ranges": [[-1.0, 1.0]] });
    let lines: Vec<Value> =
        names.iter().map(|name| json!({ "to": 0, "op": "add", "args": ["r0", format!("{name}[0]")] })).collect();
    let halves = [0, 1].map(|half| lines.iter().skip(half).step_by(2).cloned().collect::<Vec<_>>());
    let mut document = json!({
        "format": "tpg-graph", "version": 1, "scalar": "f32", "maths": "own", "registers": 1,
        "sources": names.iter().map(|name| source(name)).collect::<Vec<_>>(), "instructions": ["add"],
        "actions": [{ "id": 0, "name": "left" }, { "id": 1, "name": "right" }],
        "root": 0,
        "teams": [{ "id": 0, "edges": [{ "program": 0, "action": 0 }, { "program": 1, "action": 1 }] }],
        "programs": [{ "id": 0, "lines": halves[0] }, { "id": 1, "lines": halves[1] }]
    });
    if role == Role::Sources {
        return Graph::from_json("named", &document.to_string()).expect("a valid graph");
    }
    let output = |name: &str| json!({ "name": name, "unit": "", "min": -1, "max": 1, "nan": 0 });
    let carried = |name: &String| json!({ "name": name, "min": -1, "max": 1, "initial": 0 });
    let programs: Vec<usize> = (0..names.len()).map(|place| place % 2).collect();
    let leaf = |id: usize| match role {
        Role::Memory => json!({ "id": id, "programs": [id], "memory": programs }),
        _ => json!({ "id": id, "programs": programs }),
    };
    let object = document.as_object_mut().expect("an object");
    object.remove("actions");
    object["version"] = json!(2);
    object["teams"] = json!([{ "id": 0, "edges": [{ "program": 0, "leaf": 0 }, { "program": 1, "leaf": 1 }] }]);
    object.insert("leaves".into(), json!([leaf(0), leaf(1)]));
    if role == Role::Memory {
        object["sources"] = json!([source("angle")]);
        object.insert("outputs".into(), json!([output("torque")]));
        object.insert("memory".into(), names.iter().map(carried).collect());
    } else {
        object.insert("outputs".into(), names.iter().map(|name| output(name)).collect());
    }
    Graph::from_json("named", &document.to_string()).expect("a valid graph")
}

/// Compiles generated C behind the headers, as a user's file may include them, and by itself.
fn compiles(folder: &Path, compiler: &str, language: &str, graph: &Graph, options: &Options) {
    for file in emit::emit(graph, Language::C, options) {
        fs::write(folder.join(&file.name), &file.text).expect("written");
    }
    fs::write(folder.join("user.c"), format!("{HEADERS}#include \"named.h\"\n")).expect("written");
    let mut command = Command::new(compiler);
    command.current_dir(folder).args([
        "-x",
        language,
        "-O1",
        "-Wall",
        "-Werror",
        "-fno-builtin",
        "-c",
        "-o",
        "named.o",
        "named.c",
    ]);
    run(&mut command).unwrap_or_else(|error| panic!("{error}"));
    let mut command = Command::new(compiler);
    command.current_dir(folder).args(["-x", language, "-fsyntax-only", "user.c"]);
    run(&mut command).unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn every_macro_and_keyword_names_a_source_an_output_and_a_memory() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut all: BTreeSet<String> = KEYWORDS.map(str::to_owned).into();
    for (compiler, package, language) in COMPILERS {
        if !tpg_testing::tool(compiler, package, "names that are macros of its headers") {
            continue;
        }
        let own = macros(compiler, language);
        assert!(own.contains("stdout"), "{compiler} has macros");
        let names: Vec<String> =
            own.into_iter().chain(KEYWORDS.map(str::to_owned)).collect::<BTreeSet<_>>().into_iter().collect();
        for role in ROLES {
            let graph = named(&names, role);
            // A name has no other place in the other profiles.
            for &profile in tpg_testing::amount(&[Profile::Fast][..], &Profile::ALL) {
                let options = Options { profile: Some(profile), ..options("named", Style::Pure) };
                compiles(folder.path(), compiler, language, &graph, &options);
            }
        }
        compiles(folder.path(), compiler, language, &named(&names, Role::Sources), &options("named", Style::Gegelati));
        all.extend(names);
    }
    // What the interpreter answers, C and Rust answer.
    let all: Vec<String> = all.into_iter().collect();
    let workshop = Workshop::new().expect("a temporary folder");
    for role in ROLES {
        let graph = named(&all, role);
        let options = options("named", Style::Pure);
        let mut programs =
            [Language::C, Language::Rust].map(|it| workshop.start(&code(it, &graph, &options)).expect("it compiles"));
        let mut engines: Vec<&mut dyn Engine> = programs.iter_mut().map(|program| program as &mut dyn Engine).collect();
        for comparison in verify::compare(&graph, &mut engines, 500, 1).expect("the programs run") {
            assert_eq!((comparison.states, comparison.differences), (500, 0), "{comparison:?}");
        }
    }
}

/// `math_errhandling` is an expression in `<math.h>`; the graph has it as a name.
#[test]
fn a_source_is_called_math_errhandling() {
    let names = ["math_errhandling", "math_errhandling_", "x"].map(str::to_owned);
    let graph = named(&names, Role::Sources);
    let files = emit::emit(&graph, Language::C, &options("named", Style::Pure));
    assert!(files[0].text.contains("float math_errhandling__; /* math_errhandling: "), "{}", files[0].text);
    assert!(files[0].text.contains("float math_errhandling_; /* "), "{}", files[0].text);
    assert!(graph.to_json().contains("\"math_errhandling\""), "its own name stays");
    let rust = emit::emit(&graph, Language::Rust, &options("named", Style::Pure));
    assert!(rust[0].text.contains("`s[0..1]`: math_errhandling, "), "{}", rust[0].text);
}
