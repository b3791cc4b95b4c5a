//! Fields of generated structs: a source, an output or a value of the memory, by its name in the graph.
//!
//! A name that C, C++ or a header gives a meaning cannot name a field. It gets an underscore behind it, or as many as make it no other
//! name of the graph. Rust names no field after them.

use tpg_graph::{Graph, Input};

/// Keywords of C and C++, two words that compilers in GNU mode define as 1, and the macros in lower case of the headers that generated
/// code and its harnesses include, those of AVR's C library among them.
const TAKEN: [&str; 10] = [
    "acosf alignas alignof and and_eq asinf asm atan2f atanf auto bitand bitor bool break case catch cbrtf ceilf",
    "char char16_t char32_t char8_t class co_await co_return co_yield compl concept const const_cast consteval",
    "constexpr constinit continue copysignf cosf coshf decltype default delete do double dynamic_cast else enum",
    "errno expf explicit export extern fabsf false fdimf float floorf fmaf fmaxf fminf fmodf for frexpf friend",
    "goto hypotf if inline int isfinitef isinff isnanf ldexpf linux log10f logf long lrintf lroundf",
    "math_errhandling mutable namespace new noexcept noreturn not not_eq nullptr operator or or_eq powf private",
    "protected public register reinterpret_cast requires restrict return roundf short signbitf signed signgam",
    "sinf sinhf sizeof squaref static static_assert static_cast stderr stdin stdout struct switch tanf tanhf",
    "template this thread_local throw true truncf try typedef typeid typename typeof typeof_unqual union unix",
    "unsigned using virtual void volatile wchar_t while xor xor_eq",
];

/// Tests for a name that means something to C, C++ or a header.
pub(super) fn is_taken(name: &str) -> bool {
    TAKEN.iter().any(|words| words.split(' ').any(|word| word == name))
}

/// The field of a name.
pub(crate) fn field(graph: &Graph, name: &str) -> String {
    let mut field = name.to_owned();
    if !is_taken(name) {
        return field;
    }
    let sources = graph.sources().iter().map(|source| &source.name);
    let names: Vec<&String> = sources.chain(graph.outputs().iter().map(|output| &output.name)).collect();
    while names.contains(&&field) {
        field.push('_');
    }
    field
}

/// The value of an input in the state that a function is given.
pub(crate) fn member(graph: &Graph, input: Input) -> String {
    let (source, place) = graph.source_of(input);
    let field = field(graph, &source.name);
    if source.ranges.len() == 1 { format!("state->{field}") } else { format!("state->{field}[{place}]") }
}

#[cfg(test)]
mod tests {
    use super::{TAKEN, field};
    use tpg_graph::Graph;

    #[test]
    fn taken_names_are_sorted_to_be_searched() {
        assert!(TAKEN.is_sorted());
    }

    #[test]
    fn a_field_is_no_other_name() {
        let text = include_str!("../../../tests/fixtures/all_instructions.json");
        let named = |names: [&str; 3]| {
            let mut text = text.to_owned();
            for (was, name) in ["target", "difference", "motors"].into_iter().zip(names) {
                text = text
                    .replace(&format!("{was}["), &format!("{name}["))
                    .replace(&format!("{was}\""), &format!("{name}\""));
            }
            Graph::from_json("named", &text).expect("a valid graph")
        };
        let graph = named(["int", "int_", "x"]);
        assert_eq!(["int", "int_", "x"].map(|name| field(&graph, name)), ["int__", "int_", "x"]);
        let graph = named(["int", "math_errhandling", "fn"]);
        assert_eq!(
            ["int", "math_errhandling", "fn"].map(|name| field(&graph, name)),
            ["int_", "math_errhandling_", "fn"]
        );
    }
}
