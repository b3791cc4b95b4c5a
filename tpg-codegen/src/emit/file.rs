//! A file, and text that its comments can hold.

/// A file to write.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct File {
    /// Its name, without folder.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// Text that may stand in a C comment: in one line, with a space in the midst of what would begin or end a comment.
pub(crate) fn comment(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars().map(|c| if c.is_control() { ' ' } else { c }) {
        if matches!((safe.chars().next_back(), c), (Some('/'), '*' | '/') | (Some('*'), '/')) {
            safe.push(' ');
        }
        safe.push(c);
    }
    safe
}

/// Text in one line.
pub(crate) fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::comment;

    #[test]
    fn only_what_begins_or_ends_a_comment_is_taken_apart() {
        assert_eq!(comment("rad/s, N*m"), "rad/s, N*m");
        assert_eq!(comment("a */ b /* c // d"), "a * / b / * c / / d");
        assert_eq!(comment("/*/**//"), "/ * / ** / /");
        assert_eq!(comment("a\n*\r/"), "a * /");
    }
}
