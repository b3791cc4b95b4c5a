//! The committed results have the template's prose, in lines that a person can read.

use std::fs;
use tpg_testing::library::top;

const LONGEST: usize = 150;

#[test]
fn the_prose_of_the_results_is_the_templates() {
    let template = fs::read_to_string(top().join("benches/paper/templates/results.md")).expect("the template");
    let page = fs::read_to_string(top().join("docs/results.md")).expect("the results");
    let prose: Vec<&str> = template.lines().filter(|line| !line.contains('{')).collect();
    assert!(prose.len() > 30);
    for line in prose {
        assert!(page.lines().any(|other| other == line), "docs/results.md lacks {line:?}");
    }
    let long: Vec<&str> =
        page.lines().filter(|line| !line.starts_with('|') && line.chars().count() > LONGEST).collect();
    assert!(long.is_empty() && !page.contains("{{") && !page.contains("\n\n\n"), "{long:#?}");
}
