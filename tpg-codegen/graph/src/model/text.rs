//! The canonical text of `graph.json`: one line for each source, action, team and program line, so that diffs of graphs
//! are readable.

use super::document::{Document, ProgramDocument};
use serde::Serialize;
use std::fmt::Write as _;

/// Writes a document. Equal documents give equal bytes.
pub(super) fn write(document: &Document) -> String {
    let mut out = String::from("{\n");
    let mut field = |name: &str, value: &str, last: bool| {
        let comma = if last { "" } else { "," };
        let _ = writeln!(out, "  \"{name}\": {value}{comma}");
    };
    field("format", &json(&document.format), false);
    field("version", &json(&document.version), false);
    field("scalar", &json(&document.scalar), false);
    field("maths", &json(&document.maths), false);
    field("registers", &json(&document.registers), false);
    field("sources", &list(document.sources.iter().map(json), 4), false);
    field("instructions", &json(&document.instructions), false);
    if document.outputs.is_empty() {
        field("actions", &list(document.actions.iter().map(json), 4), false);
    } else {
        field("outputs", &list(document.outputs.iter().map(json), 4), false);
    }
    if !document.memory.is_empty() {
        field("memory", &list(document.memory.iter().map(json), 4), false);
    }
    if let Some(root) = document.root {
        field("root", &json(&root), false);
        field("teams", &list(document.teams.iter().map(json), 4), false);
    }
    if !document.leaves.is_empty() {
        field("leaves", &list(document.leaves.iter().map(json), 4), false);
    }
    field("programs", &list(document.programs.iter().map(program), 4), false);
    field("provenance", &json(&document.provenance), true);
    out.push_str("}\n");
    out
}

fn program(program: &ProgramDocument) -> String {
    format!("{{\"id\":{},\"lines\":{}}}", program.id, list(program.lines.iter().map(json), 6))
}

fn list(items: impl ExactSizeIterator<Item = String>, indent: usize) -> String {
    if items.len() == 0 {
        return "[]".to_owned();
    }
    let items: Vec<String> = items.map(|item| format!("{:indent$}{item}", "")).collect();
    format!("[\n{}\n{:outer$}]", items.join(",\n"), "", outer = indent - 2)
}

fn json(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("the document has only strings as keys and finite numbers")
}
