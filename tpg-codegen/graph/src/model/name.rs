//! Rules for names in a graph.

/// Keywords of C, C++ and Rust, two words that compilers in GNU mode define as 1, and the macros in lower case of the
/// headers that generated code includes: none of them can name a field of a generated struct.
#[rustfmt::skip] // a line for each word otherwise
const KEYWORDS: [&str; 136] = [
    "abstract", "alignas", "alignof", "and", "and_eq", "as", "asm", "async", "auto", "await", "become", "bitand",
    "bitor", "bool", "box", "break", "case", "catch", "char", "char16_t", "char32_t", "char8_t", "class", "co_await",
    "co_return", "co_yield", "compl", "concept", "const", "const_cast", "consteval", "constexpr", "constinit",
    "continue", "crate", "decltype", "default", "delete", "do", "double", "dyn", "dynamic_cast", "else", "enum",
    "errno", "explicit", "export", "extern", "false", "final", "float", "fn", "for", "friend", "gen", "goto", "if", "impl", "in",
    "inline", "int", "let", "linux", "long", "loop", "macro", "match", "math_errhandling", "mod", "move", "mut", "mutable", "namespace",
    "new", "noexcept", "noreturn", "not", "not_eq", "nullptr", "operator", "or", "or_eq", "override", "priv", "private",
    "protected", "pub", "public", "ref", "register", "reinterpret_cast", "requires", "restrict", "return", "self",
    "short", "signed", "signgam", "sizeof", "static", "static_assert", "static_cast", "stderr", "stdin", "stdout", "struct", "super", "switch", "template",
    "this", "thread_local", "throw", "trait", "true", "try", "type", "typedef", "typeid", "typename", "typeof",
    "typeof_unqual", "union", "unix", "unsafe", "unsigned", "unsized", "use", "using", "virtual", "void", "volatile",
    "wchar_t", "where", "while", "xor", "xor_eq",
];

/// The names accepted by [`is_source`], for messages.
pub(super) const SOURCE: &str = "a lower-case letter, then lower-case letters, digits and underscores; \
                                 not r and digits, no keyword of C, C++ or Rust, no macro of the C library";

/// The texts accepted by [`is_text`], for messages.
pub(super) const TEXT: &str = "one line of text without /* or */";

/// True if the name is valid for a source, in the graph and as a field in C and Rust.
pub(super) fn is_source(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_lowercase())
        && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
        && !is_register(name)
        && KEYWORDS.binary_search(&name).is_err()
}

/// True for `r` followed by digits: the written form of a register, which no source may be called.
pub(super) fn is_register(name: &str) -> bool {
    name.strip_prefix('r').is_some_and(is_number)
}

/// True if the text consists of digits only: `str::parse` would accept a sign.
pub(super) fn is_number(text: &str) -> bool {
    !text.is_empty() && text.bytes().all(|byte| byte.is_ascii_digit())
}

/// True if a text can be placed in a comment of generated code without ending it.
pub(super) fn is_text(text: &str) -> bool {
    let breaks = |c: char| c.is_control() || matches!(c, '\u{2028}' | '\u{2029}');
    !text.chars().any(breaks) && !text.contains("/*") && !text.contains("*/") && !text.ends_with(['\\', '/', '*'])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keywords_are_sorted_to_be_searched() {
        assert!(KEYWORDS.is_sorted());
    }

    #[test]
    fn names_of_sources_and_outputs() {
        for good in ["target", "s0", "r", "rx", "r0x", "hand_tip", "register_0"] {
            assert!(is_source(good), "{good}");
        }
        for bad in [
            "",
            "r0",
            "r12",
            "Target",
            "0s",
            "_x",
            "hand tip",
            "é",
            "int",
            "fn",
            "class",
            "while",
            "xor",
            "abstract",
            "math_errhandling",
        ] {
            assert!(!is_source(bad), "{bad}");
        }
    }

    #[test]
    fn texts_in_comments() {
        for good in ["", "mm", "base +3", "m/s²", "a * b / c"] {
            assert!(is_text(good), "{good}");
        }
        for bad in ["a\nb", "a */ b", "a /* b", "\t", "back\\", "a/", "a*", "\u{2028}"] {
            assert!(!is_text(bad), "{bad}");
        }
    }
}
