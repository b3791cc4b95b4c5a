//! The lines that firmwares print: words, then `name=value`.

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

    /// A value as a number; 0 where there is none.
    pub(crate) fn number(&self, name: &str) -> u64 {
        self.values.get(name).and_then(|value| value.parse().ok()).unwrap_or(0)
    }

    /// The same line without values that the host cannot know.
    pub(crate) fn without(&self, names: &[&str]) -> Self {
        let values = self.values.iter().filter(|(name, _)| !names.contains(&name.as_str()));
        Self { words: self.words.clone(), values: values.map(|(n, v)| (n.clone(), v.clone())).collect() }
    }
}
