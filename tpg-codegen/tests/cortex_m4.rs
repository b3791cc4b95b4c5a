//! Generated C on a core whose FPU has no doubles: no double creeps in, and own maths needs no library.

use crate::common::{SHAPES, Shape, code, fixture, shaped};
use object::{Object as _, ObjectSymbol as _};
use tpg_codegen::compile;
use tpg_codegen::emit::{Code, Language};
use tpg_codegen::size::{self, Target};
use tpg_graph::{Graph, MathsProvider, ScalarType};

/// Symbols that the object file needs from elsewhere, without GEGELATI's own inputs.
fn undefined(graph: &Graph, shape: Shape) -> Vec<String> {
    let object =
        size::build_c(&code(Language::C, graph, &shaped("arm", shape)), Target::M4f).expect("it compiles").object;
    let file = object::File::parse(&*object).expect("an object file");
    let names = file.symbols().filter(|symbol| symbol.is_undefined()).map(|symbol| symbol.name().expect("a name"));
    let input = |name: &str| name.strip_prefix("in").is_some_and(|number| number.parse::<u32>().is_ok());
    names.filter(|name| !name.is_empty() && !input(name)).map(str::to_owned).collect()
}

fn compiler(what: &str) -> bool {
    tpg_testing::tool("arm-none-eabi-gcc", "gcc-arm-none-eabi", what)
}

#[test]
fn own_maths_in_f32_asks_for_nothing() {
    if compiler("symbols of generated C on a Cortex-M4") {
        for shape in SHAPES {
            let graph = fixture(ScalarType::F32, MathsProvider::Own);
            assert_eq!(undefined(&graph, shape), Vec::<String>::new(), "{shape:?}");
        }
    }
}

#[test]
fn the_systems_maths_in_f32_asks_for_its_functions() {
    if compiler("symbols of generated C with the system's maths on a Cortex-M4") {
        for shape in SHAPES {
            let mut names = undefined(&fixture(ScalarType::F32, MathsProvider::System), shape);
            names.sort_unstable();
            assert_eq!(names, ["atanf", "cosf", "expf", "logf", "sinf", "sqrtf", "tanf", "tanhf"], "{shape:?}");
        }
    }
}

#[test]
fn a_double_would_be_noticed() {
    if compiler("symbols of f64 C on a Cortex-M4") {
        for shape in SHAPES {
            let names = undefined(&fixture(ScalarType::F64, MathsProvider::Own), shape);
            assert!(names.iter().any(|name| name.starts_with("__aeabi_d")), "{shape:?}: {names:?}");
        }
    }
}

#[test]
fn the_size_has_a_line_for_each_target() {
    let graph = fixture(ScalarType::F32, MathsProvider::Own);
    let lines = size::describe_c(&Code::of(compile(&graph, &shaped("arm", SHAPES[0]), Language::C)));
    assert!(lines[0].starts_with("size on this machine (-Os): "), "{lines:?}");
    assert!(lines[1].starts_with("size on Cortex-M4F"), "{lines:?}");
    let code = lines[0].split_whitespace().find_map(|word| word.parse::<u64>().ok());
    assert!(code.is_some_and(|code| code > 500), "{lines:?}");
    assert!(lines[0].ends_with("0 of data, 0 of bss"), "a policy has no variables: {lines:?}");
}
