//! Tables of numbers that the programs share with this machine: a header.

use std::fmt::{Display, Write as _};
use tpg_codegen::emit::File;

/// The constants of a program.
pub(crate) struct Data {
    name: &'static str,
    text: String,
}

impl Data {
    /// Starts the header of this name, with what it needs first.
    pub(crate) fn new(name: &'static str, head: &str) -> Self {
        Self { name, text: head.to_owned() }
    }

    /// Adds a number, which a compiler's option may replace.
    pub(crate) fn number(&mut self, name: &str, value: usize) {
        let _ = writeln!(self.text, "#ifndef {name}\n#define {name} {value}U\n#endif");
    }

    /// Adds text.
    pub(crate) fn text(&mut self, text: &str) {
        self.text.push_str(text);
    }

    /// Adds a table by its declaration and its rows.
    pub(crate) fn table(&mut self, declaration: &str, rows: impl IntoIterator<Item = impl Display>) {
        let _ = writeln!(self.text, "{declaration} = {{");
        for row in rows {
            let _ = writeln!(self.text, "    {row},");
        }
        self.text.push_str("};\n");
    }

    /// Returns `name.h`.
    pub(crate) fn file(self) -> File {
        let Self { name, text } = self;
        let guard = name.to_uppercase();
        let text = format!("#ifndef {guard}_H\n#define {guard}_H\n\n{text}\n#endif\n");
        File { name: format!("{name}.h"), text }
    }
}

/// A list of numbers in C.
pub(crate) fn list(row: &[f32]) -> String {
    let values: Vec<String> = row.iter().map(|value| format!("{value:?}F")).collect();
    format!("{{ {} }}", values.join(", "))
}
