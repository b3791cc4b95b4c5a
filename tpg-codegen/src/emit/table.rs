//! Tables of unsigned integers in the least type that holds them.

use super::syntax::Syntax;
use crate::passes::bytecode::{Bytecode, Width};

/// A table: its type, and its values as a language writes them.
pub(super) struct Table {
    pub(super) kind: String,
    pub(super) values: Vec<String>,
}

pub(super) fn table(syntax: &impl Syntax, values: &[u64]) -> Table {
    let width = Width::covering(values);
    let value = |value: &u64| format!("{value}{}", syntax.suffix(width));
    Table { kind: syntax.unsigned(width), values: values.iter().map(value).collect() }
}

/// The operations of tables, by number: expressions of `a` and `b`.
pub(super) fn cases(syntax: &impl Syntax, code: &Bytecode) -> Vec<(u32, String)> {
    let operands = ["a".to_owned(), "b".to_owned()];
    let expression = |operation: Option<_>| match operation {
        Some(instruction) => syntax.instruction(instruction, &operands),
        None => "a".to_owned(),
    };
    (0..).zip(&code.used).map(|(number, &operation)| (number, expression(operation))).collect()
}
