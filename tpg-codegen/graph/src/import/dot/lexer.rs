//! Tokens of one line.

use super::fault::{Fault, refuse};

/// A token.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Token<'t> {
    /// Letters, digits, `_` and `.`: `T12`, `rank`, `0.03`.
    Word(&'t str),
    /// The text between quotes.
    Text(&'t str),
    /// `->`
    Arrow,
    /// One of `[ ] { } = ,`
    Mark(char),
    /// The text after `//`, up to the end of the line.
    Comment(&'t str),
}

/// Splits one line into tokens and appends them to `tokens`.
pub(super) fn tokens<'t>(line: &'t str, tokens: &mut Vec<Token<'t>>) -> Result<(), Fault> {
    let mut rest = line.trim();
    while let Some(first) = rest.chars().next() {
        let (token, length) = if let Some(comment) = rest.strip_prefix("//") {
            (Token::Comment(comment.trim()), rest.len())
        } else if rest.starts_with("->") {
            (Token::Arrow, 2)
        } else if let Some(text) = rest.strip_prefix('"') {
            let length = text.find('"').ok_or_else(|| Fault::new(quote(rest), "a quote where the text ends"))?;
            (Token::Text(&text[..length]), length + 2)
        } else if "[]{}=,".contains(first) {
            (Token::Mark(first), 1)
        } else if is_word(first) {
            let length = rest.find(|c| !is_word(c)).unwrap_or(rest.len());
            (Token::Word(&rest[..length]), length)
        } else {
            return refuse(quote(rest), "a statement of GEGELATI's .dot format");
        };
        tokens.push(token);
        rest = rest[length..].trim_start();
    }
    Ok(())
}

fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_' || c == '.'
}

/// Quotes text of the file for messages and shortens it if it is long.
pub(super) fn quote(text: &str) -> String {
    const MOST: usize = 60;
    let text = text.trim();
    let shown: String = text.chars().take(MOST).collect();
    if shown.len() < text.len() { format!("`{shown}…`") } else { format!("`{shown}`") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_of_every_token() {
        let mut found = Vec::new();
        tokens("\tP1 -> I1[a=\"x [y]\" b = .5]{,} // 1|-2|  \r", &mut found).expect("tokens");
        use Token::*;
        let expected = [
            Word("P1"),
            Arrow,
            Word("I1"),
            Mark('['),
            Word("a"),
            Mark('='),
            Text("x [y]"),
            Word("b"),
            Mark('='),
            Word(".5"),
            Mark(']'),
            Mark('{'),
            Mark(','),
            Mark('}'),
            Comment("1|-2|"),
        ];
        assert_eq!(found, expected);
    }

    #[test]
    fn faults_are_quoted_short() {
        let fault = |line: &str| tokens(line, &mut Vec::new()).expect_err("a fault").found;
        assert_eq!(fault("T1 ; T2"), "`; T2`");
        let long = format!("label=\"{}", "é".repeat(100));
        assert_eq!(fault(&long), format!("`\"{}…`", "é".repeat(59)));
    }
}
