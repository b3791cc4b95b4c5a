//! The lines that firmwares print: words, then `name=value`.

use crate::Failure;
use crate::record::Hash;
use std::collections::BTreeMap;

/// One line of output.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Line {
    /// The words before the first value.
    pub(crate) words: Vec<String>,
    /// The values, by name.
    pub(crate) values: BTreeMap<String, String>,
}

impl Line {
    /// Splits a line.
    pub(crate) fn parse(text: &str) -> Self {
        let mut line = Self { words: vec![], values: BTreeMap::new() };
        for word in text.split_whitespace() {
            match word.split_once('=') {
                Some((name, value)) => {
                    line.values.insert(name.to_owned(), value.to_owned());
                }
                None => line.words.push(word.to_owned()),
            }
        }
        line
    }

    /// True if the first word is this one.
    pub(crate) fn starts_with(&self, word: &str) -> bool {
        self.words.first().is_some_and(|first| first == word)
    }

    /// A value as a number; 0 where there is none.
    pub(crate) fn number(&self, name: &str) -> u64 {
        self.values.get(name).and_then(|value| value.parse().ok()).unwrap_or(0)
    }

    /// The same line without values that the host cannot know.
    pub(crate) fn without(mut self, names: &[&str]) -> Self {
        self.values.retain(|name, _| !names.contains(&name.as_str()));
        self
    }
}

/// Finds the line with these words and checks its number of actions and its hash; `place` is what printed it.
pub(crate) fn check<'a>(
    place: &str,
    lines: &'a [Line],
    words: &str,
    actions: u64,
    hash: &Hash,
) -> Result<&'a Line, Failure> {
    let expected = Line::parse(&format!("{words} actions={actions} hash={:016x}", hash.0));
    let found = lines.iter().find(|line| line.words == expected.words);
    let found = found.ok_or_else(|| Failure(format!("{place}: no line {words:?}")))?;
    if found.clone().without(&["instructions", "worst"]) != expected {
        return Err(Failure(format!("{place} is not the host: {found:?}, not {expected:?}")));
    }
    Ok(found)
}
