//! Rules for names in a graph.

/// The names accepted by [`is_source`], for messages.
pub(super) const SOURCE: &str = "a lower-case letter, then lower-case letters, digits and underscores; \
                                 not r and digits";

/// The texts accepted by [`is_text`], for messages.
pub(super) const TEXT: &str = "one line of text without /* or */";

/// True if the name is valid for a source. Generated code writes one that means something to its language another way.
pub(super) fn is_source(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_lowercase())
        && name.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_')
        && !is_register(name)
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
    fn names_of_sources_and_outputs() {
        for good in ["target", "s0", "r", "rx", "r0x", "hand_tip", "register_0", "int", "math_errhandling"] {
            assert!(is_source(good), "{good}");
        }
        for bad in ["", "r0", "r12", "Target", "0s", "_x", "hand tip", "é"] {
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
