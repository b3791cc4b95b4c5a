//! Links between documents lead to files and headings that exist.

use pulldown_cmark::{Event, Parser, Tag, TagEnd};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use tpg_testing::library::top;

/// The documents under a folder; not those of dependencies and build folders, nor templates, whose text stands elsewhere.
fn documents(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path()) {
        let name = entry.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        if entry.is_dir() && !name.starts_with('.') && !["target", "runs", "templates"].contains(&name) {
            documents(&entry, found);
        } else if name.ends_with(".md") {
            found.push(entry);
        }
    }
}

/// Heading as an anchor: lower case, without punctuation, hyphens for spaces.
fn anchor(heading: &str) -> String {
    let kept = heading.to_lowercase().replace(' ', "-");
    kept.chars().filter(|letter| letter.is_alphanumeric() || "-_".contains(*letter)).collect()
}

fn anchors(text: &str) -> BTreeSet<String> {
    let (mut all, mut heading) = (BTreeSet::new(), None);
    for event in Parser::new(text) {
        match event {
            Event::Start(Tag::Heading { .. }) => heading = Some(String::new()),
            Event::End(TagEnd::Heading(_)) => all.extend(heading.take().map(|heading| anchor(&heading))),
            Event::Text(part) | Event::Code(part) => {
                if let Some(heading) = &mut heading {
                    heading.push_str(&part);
                }
            }
            _ => {}
        }
    }
    all
}

/// Returns what is wrong with a link.
fn problem(document: &Path, text: &str, link: &str) -> Option<String> {
    if link.contains("://") || link.starts_with("mailto:") {
        return None;
    }
    let (file, heading) = link.split_once('#').unwrap_or((link, ""));
    let target = document.parent()?.join(file);
    if !file.is_empty() && !target.exists() {
        return Some(format!("{}: {link}: no such file", document.display()));
    }
    let there = if file.is_empty() { anchors(text) } else { anchors(&fs::read_to_string(&target).unwrap_or_default()) };
    (!heading.is_empty() && !there.contains(heading))
        .then(|| format!("{}: {link}: no such heading", document.display()))
}

#[test]
fn links_between_documents_lead_somewhere() {
    let mut all = Vec::new();
    documents(&top(), &mut all);
    let documents = all;
    assert!(documents.len() > 10, "{documents:?}");
    let mut problems = Vec::new();
    for document in &documents {
        let text = fs::read_to_string(document).expect("a document");
        for event in Parser::new(&text) {
            if let Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) = event {
                problems.extend(problem(document, &text, &dest_url));
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

#[test]
fn the_book_has_every_page_of_its_folder() {
    let summary = fs::read_to_string(top().join("docs/SUMMARY.md")).expect("the book's contents");
    let mut all = Vec::new();
    documents(&top().join("docs"), &mut all);
    let names = all.iter().filter_map(|page| page.file_name()?.to_str());
    let missing: Vec<_> =
        names.filter(|name| *name != "SUMMARY.md" && !summary.contains(&format!("]({name})"))).collect();
    assert!(all.len() > 10 && missing.is_empty(), "not in docs/SUMMARY.md: {missing:?}");
}

/// mdBook would make a link to a page of it, which there is not.
#[test]
fn the_book_links_to_no_document_outside() {
    let mut pages = Vec::new();
    documents(&top().join("docs"), &mut pages);
    for page in pages {
        let text = fs::read_to_string(&page).expect("a page");
        for event in Parser::new(&text) {
            let Event::Start(Tag::Link { dest_url, .. }) = event else { continue };
            let leaves =
                dest_url.starts_with("..") && dest_url.split('#').next().is_some_and(|file| file.ends_with(".md"));
            assert!(!leaves, "{}: {dest_url}", page.display());
        }
    }
}

#[test]
fn a_broken_link_is_found() {
    let here = top().join("README.md");
    assert_eq!(problem(&here, "# A heading", "#a-heading"), None);
    assert!(problem(&here, "# A heading", "#another").is_some());
    assert!(problem(&here, "", "docs/none.md").is_some());
    assert_eq!(anchor("`graph.json`, version 2"), "graphjson-version-2");
}
