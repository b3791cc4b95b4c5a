//! Tables of numbers that the programs in C and in Rust share: a header, and a file to include.

use std::fmt::{Display, Write as _};
use tpg_codegen::emit::File;

/// The constants of a program in both languages.
pub(crate) struct Data {
    name: &'static str,
    c: String,
    rust: String,
}

impl Data {
    /// Starts the file of this name, with what the header needs first.
    pub(crate) fn new(name: &'static str, head: &str) -> Self {
        Self { name, c: head.to_owned(), rust: String::new() }
    }

    /// Adds a number, which a compiler's option may replace in C.
    pub(crate) fn number(&mut self, name: &str, value: usize) {
        let _ = writeln!(self.c, "#ifndef {name}\n#define {name} {value}U\n#endif");
        let _ = writeln!(self.rust, "#[allow(dead_code)]\nconst {name}: usize = {value};");
    }

    /// Adds text in Rust.
    pub(crate) fn rust(&mut self, text: &str) {
        self.rust.push_str(text);
    }

    /// Adds text in C.
    pub(crate) fn c(&mut self, text: &str) {
        self.c.push_str(text);
    }

    /// Adds a table by its declarations in C and Rust, and its rows in both.
    pub(crate) fn table<C: Display, R: Display>(
        &mut self,
        [c, rust]: [&str; 2],
        rows: impl IntoIterator<Item = (C, R)>,
    ) {
        let _ = writeln!(self.c, "{c} = {{");
        let _ = writeln!(self.rust, "{rust} = [");
        for (c, rust) in rows {
            let _ = writeln!(self.c, "    {c},");
            let _ = writeln!(self.rust, "    {rust},");
        }
        self.c.push_str("};\n");
        self.rust.push_str("];\n");
    }

    /// Adds a table of rows of numbers, and its length.
    pub(crate) fn floats<R: AsRef<[f32]>>(&mut self, name: &str, rows: &[R]) {
        let (upper, count) = (name.to_uppercase(), rows.len());
        let width = rows.first().map_or(0, |row| row.as_ref().len());
        self.number(&format!("{upper}_COUNT"), count);
        let c = format!("static const float {name}[{count}][{width}]");
        let rust = format!("static {upper}: [[f32; {width}]; {count}]");
        self.table([&c, &rust], rows.iter().map(|row| (list(row.as_ref()), format!("{:?}", row.as_ref()))));
    }

    /// Returns `name.h` and `name.rs`.
    pub(crate) fn files(self) -> [File; 2] {
        let Self { name, c, rust } = self;
        let guard = name.to_uppercase();
        let c = format!("#ifndef {guard}_H\n#define {guard}_H\n\n{c}\n#endif\n");
        [(format!("{name}.h"), c), (format!("{name}.rs"), rust)].map(|(name, text)| File { name, text })
    }
}

/// A list of numbers in C.
pub(crate) fn list(row: &[f32]) -> String {
    let values: Vec<String> = row.iter().map(|value| format!("{value:?}F")).collect();
    format!("{{ {} }}", values.join(", "))
}
