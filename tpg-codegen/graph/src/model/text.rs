//! The canonical text of `graph.json`: one line for each source, action, team and program line, so that diffs of graphs
//! are readable.

use super::document::{Document, ProgramDocument};
use serde::Serialize;

/// Writes a document. Equal documents give equal bytes.
pub(super) fn write(document: &Document) -> String {
    let Document { format, version, scalar, maths, registers, sources, instructions, actions, outputs, .. } = document;
    let Document { memory, root, teams, leaves, programs, provenance, .. } = document;
    let mut fields = vec![
        ("format", json(format)),
        ("version", json(version)),
        ("scalar", json(scalar)),
        ("maths", json(maths)),
        ("registers", json(registers)),
        ("sources", list(sources, json, 4)),
        ("instructions", json(instructions)),
    ];
    fields.push(if outputs.is_empty() {
        ("actions", list(actions, json, 4))
    } else {
        ("outputs", list(outputs, json, 4))
    });
    if !memory.is_empty() {
        fields.push(("memory", list(memory, json, 4)));
    }
    if let Some(root) = root {
        fields.extend([("root", json(root)), ("teams", list(teams, json, 4))]);
    }
    if !leaves.is_empty() {
        fields.push(("leaves", list(leaves, json, 4)));
    }
    fields.extend([("programs", list(programs, program, 4)), ("provenance", json(provenance))]);
    let fields: Vec<String> = fields.iter().map(|(name, value)| format!("  \"{name}\": {value}")).collect();
    format!("{{\n{}\n}}\n", fields.join(",\n"))
}

fn program(program: &ProgramDocument) -> String {
    format!("{{\"id\":{},\"lines\":{}}}", program.id, list(&program.lines, json, 6))
}

fn list<T>(items: &[T], text: impl Fn(&T) -> String, indent: usize) -> String {
    if items.is_empty() {
        return "[]".to_owned();
    }
    let items: Vec<String> = items.iter().map(|item| format!("{:indent$}{}", "", text(item))).collect();
    format!("[\n{}\n{:outer$}]", items.join(",\n"), "", outer = indent - 2)
}

fn json(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("the document has only strings as keys and finite numbers")
}
