//! Figures of shipped policies in the README and in the book are those of their PROVENANCE.md.

use std::collections::BTreeMap;
use std::fs;
use tpg_testing::library::top;

/// Returns the first text between two marks.
fn between<'a>(text: &'a str, start: &str, end: &str) -> Option<&'a str> {
    let (_, rest) = text.split_once(start)?;
    Some(rest.split_once(end)?.0)
}

fn number(text: &str) -> f64 {
    text.replace('−', "-").replace(',', "").parse().unwrap_or_else(|_| panic!("{text:?} is no number"))
}

/// Returns return, bytes and instructions of each shipped policy by its task of Gymnasium.
fn shipped() -> BTreeMap<String, [f64; 3]> {
    let folders = fs::read_dir(top().join("generated")).expect("a folder").map(|entry| entry.expect("an entry").path());
    let texts = folders.filter_map(|folder| fs::read_to_string(folder.join("PROVENANCE.md")).ok());
    let figures = texts.filter_map(|text| {
        let task = between(&text, ": Gymnasium's ", "\n")?;
        let code = between(&text, "| C, profile `fast` |", "\n")?;
        let size = between(code, " ", " bytes")?;
        let instructions = between(code, "at most ", " instructions")?;
        let mean = between(&text, "**", " ± ")?;
        Some((task.to_owned(), [mean, size, instructions].map(number)))
    });
    figures.collect()
}

/// Compares the rows of a document's table: the columns with return, bytes and instructions.
fn compare(document: &str, header: &str, columns: [usize; 3]) {
    let text = fs::read_to_string(top().join(document)).expect("a document");
    let table = text.lines().skip_while(|line| !line.starts_with(header)).skip(2);
    let mut expected = shipped();
    assert!(expected.len() >= 11, "{expected:?}");
    for row in table.take_while(|line| line.starts_with('|')) {
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        let figures = expected.remove(cells[1]).unwrap_or_else(|| panic!("{document}: no shipped policy: {row}"));
        for (column, figure) in columns.into_iter().zip(figures) {
            let said = cells[column].split(" ± ").next().unwrap_or_default();
            let decimals = said.split_once('.').map_or(0, |(_, decimals)| decimals.len());
            let rounded = format!("{figure:.decimals$}");
            assert_eq!(said.replace('−', "-").replace(',', ""), rounded, "{document}: {row}");
        }
    }
    assert!(expected.is_empty(), "{document} lacks {expected:?}");
}

#[test]
fn figures_of_shipped_policies_are_those_of_their_provenance() {
    compare("README.md", "| task | ours, by default |", [5, 6, 7]);
    compare("docs/experiments.md", "| task | return | minimum |", [2, 4, 5]);
}
