//! C99 in integers: counts in, counts out.

use super::body::body;
use super::dense::{Dense, Table};
use super::spelling::{Function, IntegerHelpers, IntegerSpelling};
use super::view::{self, FieldView, VectorView, sources};
use crate::emit::file::{File, comment};
use crate::emit::interface::{self, actions};
use crate::emit::look::{self, LookView};
use crate::emit::vectors::vectors;
use crate::emit::{banner, layout};
use crate::integers::{Integers, input_bits};
use crate::program::Program;
use askama::Template;
use tpg_graph::Input;

#[derive(Template)]
#[template(path = "integers/header.h", escape = "none")]
struct IntegerHeader<'a> {
    banner: &'a [String],
    prefix: &'a str,
    upper: &'a str,
    sources: Vec<FieldView>,
    /// The constant of each action, and its name where that says more.
    actions: Vec<(String, String)>,
    outputs: Vec<FieldView>,
    memory: Vec<FieldView>,
    look: Option<&'a LookView>,
    /// The quality of the self-test.
    quality: Option<String>,
}

#[derive(Template)]
#[template(path = "integers/source.c", escape = "none")]
struct IntegerSource<'a> {
    banner: &'a [String],
    prefix: &'a str,
    upper: &'a str,
    helpers: [IntegerHelpers; 2],
    table: Option<Table>,
    outputs: Vec<FieldView>,
    memory: Vec<FieldView>,
    body: String,
    /// The function that reads an image.
    look: String,
    vectors: Vec<VectorView>,
}

/// The two files.
pub(super) fn files(program: &Program<'_>, integers: &Integers) -> Vec<File> {
    let graph = program.graph();
    let (prefix, upper) = (program.options.prefix.lower(), program.options.prefix.upper());
    let spelling = IntegerSpelling::new(program);
    let dense = Dense::find(&program.module, integers);
    let (mut body, called) = match &dense {
        Some(dense) => dense.body(prefix),
        None => body(&program.module, integers, &spelling),
    };
    // What no walk reads may still be a node.
    if !body.contains("state->") {
        body.insert_str(0, "    (void)state;\n");
    }
    let banner = banner::lines(program);
    let chosen = vectors(graph);
    let kind = |input: usize| format!("int{}_t", input_bits(graph, Input(input as u16)));
    let seen_image = LookView::new(graph, &interface::sources(graph, comment), &kind);
    let header = IntegerHeader {
        banner: &banner,
        prefix,
        upper: &upper,
        sources: sources(graph),
        actions: actions(graph, &upper),
        outputs: view::outputs(graph, false),
        memory: view::outputs(graph, true),
        look: seen_image.as_ref(),
        quality: chosen.quality(),
    };
    let source = IntegerSource {
        banner: &banner,
        prefix,
        upper: &upper,
        helpers: spelling.helpers(&called),
        table: dense.map(|dense| dense.table()),
        outputs: view::outputs(graph, false),
        memory: view::outputs(graph, true),
        body,
        look: seen_image.as_ref().map_or_else(String::new, |view| look::c(view, prefix)),
        vectors: view::views(graph, &upper, &chosen),
    };
    let text = |text: askama::Result<String>| layout::tidy(&text.expect("the template renders"));
    vec![
        File { name: format!("{prefix}.h"), text: text(header.render()) },
        File { name: format!("{prefix}.c"), text: text(source.render()) },
    ]
}
