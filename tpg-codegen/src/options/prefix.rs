//! Names in generated code.

use std::fmt;
use std::path::Path;
use std::str::FromStr;

/// The prefix of every generated name: a lower-case identifier of C and Rust.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Prefix(String);

const LONGEST: usize = 40;

impl Prefix {
    /// A prefix that fits a graph's file: the file's name, or its folder's where that is just `graph`.
    pub fn of_file(path: &Path) -> Self {
        let text = |part: Option<&std::ffi::OsStr>| part.map(|part| part.to_string_lossy().into_owned());
        let stem = text(path.file_stem()).filter(|stem| stem != "-");
        let folder = || text(path.parent().and_then(Path::file_name));
        let name = match stem {
            Some(stem) if stem != "graph" => Some(stem),
            Some(stem) => folder().or(Some(stem)),
            None => None,
        };
        let name = name.unwrap_or_else(|| "policy".to_owned());
        let mut words: String =
            name.chars().map(|c| if c.is_ascii_alphanumeric() { c.to_ascii_lowercase() } else { '_' }).collect();
        words.truncate(LONGEST);
        if !words.starts_with(|c: char| c.is_ascii_lowercase()) {
            words.insert_str(0, "tpg_");
        }
        words.parse().unwrap_or_else(|_| Self("policy".to_owned()))
    }

    /// The prefix itself: for functions, types and files.
    pub fn lower(&self) -> &str {
        &self.0
    }

    /// In capitals: for macros.
    pub fn upper(&self) -> String {
        self.0.to_ascii_uppercase()
    }

    /// In camel case: for Rust types. Names that generated Rust imports, and `Self`, get a syllable more.
    pub fn camel(&self) -> String {
        let name: String = (self.0.split('_').filter(|word| !word.is_empty()))
            .flat_map(|word| word[..1].to_ascii_uppercase().chars().chain(word[1..].chars()).collect::<Vec<_>>())
            .collect();
        if TAKEN.split(' ').any(|word| word == name) { format!("{name}Tpg") } else { name }
    }
}

/// Headers of C, which a file of the same name would hide, and crates of Rust.
const LIBRARIES: &str = "assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign stdarg \
    stdatomic stdbool stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar wchar wctype \
    alloc core proc_macro std test";

/// Types and traits that generated Rust imports, and those of its prelude that it names.
const TAKEN: &str = "ActionId Clone Copy Debug Default Maths Move Own Policy Self Source System";

impl fmt::Display for Prefix {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl FromStr for Prefix {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if LIBRARIES.split(' ').any(|library| library == text) {
            return Err(format!("{text:?} names a header or crate of the standard library; accepted: another name"));
        }
        let starts = text.starts_with(|c: char| c.is_ascii_lowercase());
        let goes_on = text.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_');
        if starts && goes_on && text.len() <= LONGEST + 4 {
            Ok(Self(text.to_owned()))
        } else {
            Err(format!(
                "{text:?} cannot start a name; accepted: a lower-case letter, then lower-case letters, digits and \
                 underscores, at most {} in all",
                LONGEST + 4
            ))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Prefix;
    use std::path::Path;

    #[test]
    fn a_file_gives_a_prefix_whatever_it_is_called() {
        let cases = [
            ("generated/widowx-fs/graph.json", "widowx_fs"),
            ("graph.json", "graph"),
            ("fs_final_s0.cleaned.dot", "fs_final_s0_cleaned"),
            ("-", "policy"),
            ("math.json", "policy"),
            ("4 joints.json", "tpg_4_joints"),
            ("Ärm.json", "tpg__rm"),
        ];
        for (file, prefix) in cases {
            assert_eq!(Prefix::of_file(Path::new(file)).lower(), prefix, "{file}");
        }
    }

    #[test]
    fn camel_case_joins_words() {
        let prefix: Prefix = "widowx_fs2".parse().expect("a prefix");
        assert_eq!(prefix.camel(), "WidowxFs2");
        let prefix: Prefix = "policy".parse().expect("a prefix");
        assert_eq!(prefix.camel(), "PolicyTpg", "the trait has that name");
    }

    #[test]
    fn a_prefix_is_an_identifier() {
        for bad in ["", "1a", "Arm", "a-b", "a b", "_a"] {
            assert!(bad.parse::<Prefix>().is_err(), "{bad:?}");
        }
    }
}
