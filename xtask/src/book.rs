//! The book: `docs/` by mdBook, beside it the files outside of `docs/` that its pages link to. A test checks the links.

use crate::venv::{environment, interpreter};
use pulldown_cmark::{CowStr, Event, Options, Parser, Tag, html};
use std::collections::BTreeSet;
use std::ffi::OsStr;
use std::path::{Component, Path, PathBuf};
use std::process::Command;
use std::{fs, io};
use tpg_testing::library::{target_folder, top};

/// Returns the mdBook to build with: the pinned one in a virtual environment, which PyPI has built, or else an installed one;
/// `None`, if there is neither a Python for the first nor the second.
///
/// # Errors
/// If there is a Python, but mdBook can neither be installed nor found.
pub(crate) fn mdbook() -> io::Result<Option<PathBuf>> {
    let installed = || tpg_testing::exists("mdbook").then(|| PathBuf::from("mdbook"));
    let Some(python) = interpreter() else { return Ok(installed()) };
    let requirements = top().join("xtask/requirements-book.txt");
    match environment(&python, &target_folder().join("mdbook"), &requirements) {
        Ok(venv) => Ok(Some(venv.join("bin/mdbook"))),
        Err(error) => installed().map(Some).ok_or(error),
    }
}

/// Builds the book into `target/book`, with its first page at `docs/index.html`; returns true if mdBook could build it.
///
/// # Errors
/// If mdBook cannot be started, or a file cannot be read or written.
pub(crate) fn build(mdbook: &Path) -> io::Result<bool> {
    let place = top().join("target/book");
    if place.exists() {
        fs::remove_dir_all(&place)?;
    }
    let built = Command::new(mdbook).arg("build").arg(top().join("docs")).status()?.success();
    if !built {
        return Ok(false);
    }
    add_what_is_linked(&place)?;
    Ok(true)
}

/// Copies the files outside of `docs/` that pages link to, and those that these link to; documents become pages.
fn add_what_is_linked(place: &Path) -> io::Result<()> {
    let mut waiting = Vec::new();
    files(&top().join("docs"), &mut waiting)?;
    waiting.retain(|file| is_document(file));
    let mut seen: BTreeSet<PathBuf> = waiting.iter().cloned().collect();
    while let Some(document) = waiting.pop() {
        let text = fs::read_to_string(&document)?;
        let folder = document.parent().unwrap_or(Path::new(""));
        for link in local_links(&text) {
            let target = plain(&folder.join(link));
            let Ok(inside) = target.strip_prefix(top()) else { continue };
            if inside.starts_with("docs") || !seen.insert(target.clone()) {
                continue;
            }
            let copy = place.join(inside);
            if is_document(&target) {
                write(&copy.with_extension("html"), page(&fs::read_to_string(&target)?).as_bytes())?;
                waiting.push(target);
            } else if target.is_dir() {
                let mut all = Vec::new();
                files(&target, &mut all)?;
                for file in all {
                    write(&place.join(file.strip_prefix(top()).unwrap_or(&file)), &fs::read(&file)?)?;
                }
            } else {
                write(&copy, &fs::read(&target)?)?;
            }
        }
    }
    Ok(())
}

fn write(file: &Path, content: &[u8]) -> io::Result<()> {
    fs::create_dir_all(file.parent().unwrap_or(Path::new("")))?;
    fs::write(file, content)
}

fn is_document(file: &Path) -> bool {
    file.extension() == Some(OsStr::new("md"))
}

/// Lists the files under a folder, without build folders.
fn files(folder: &Path, found: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if !path.is_dir() {
            found.push(path);
        } else if path.file_name() != Some(OsStr::new("target")) {
            files(&path, found)?;
        }
    }
    Ok(())
}

/// Removes `.` and `..` from a path.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => drop(plain.pop()),
            Component::CurDir => {}
            other => plain.push(other),
        }
    }
    plain
}

/// True if a link leads out of the book, as to a web site.
fn leads_out(link: &str) -> bool {
    link.contains("://") || link.starts_with("mailto:") || link.starts_with("data:") || link.starts_with("javascript:")
}

/// Splits a link into file and place in it.
fn split(link: &str) -> (&str, &str) {
    link.split_once('#').unwrap_or((link, ""))
}

/// Returns the files that a document's links name.
fn local_links(text: &str) -> Vec<String> {
    let link = |event| match event {
        Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => Some(dest_url),
        _ => None,
    };
    let links = Parser::new_ext(text, Options::all()).filter_map(link).filter(|link| !leads_out(link));
    links.map(|link| split(&link).0.to_owned()).filter(|file| !file.is_empty()).collect()
}

/// Renders a document as a page; its links to documents lead to their pages.
fn page(text: &str) -> String {
    let to_page = |event| match event {
        Event::Start(Tag::Link { link_type, dest_url, title, id }) if !leads_out(&dest_url) => {
            let (file, place) = split(&dest_url);
            // Each page has the book's contents; mdBook makes no page of them alone.
            let page = match file.strip_suffix("SUMMARY.md") {
                Some(folder) => Some(format!("{folder}index.html")),
                None => file.strip_suffix(".md").map(|name| format!("{name}.html")),
            };
            let hash = if place.is_empty() { "" } else { "#" };
            let dest_url = page.map_or(dest_url.clone(), |page| CowStr::from(format!("{page}{hash}{place}")));
            Event::Start(Tag::Link { link_type, dest_url, title, id })
        }
        other => other,
    };
    let mut body = String::new();
    html::push_html(&mut body, Parser::new_ext(text, Options::ENABLE_TABLES).map(to_page));
    format!(
        "<!doctype html>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width\">\n{body}"
    )
}

#[cfg(test)]
mod tests {
    use super::{local_links, page, plain};
    use std::path::Path;

    #[test]
    fn a_document_becomes_a_page_whose_links_lead_to_pages() {
        let text = "# A\n[b](docs/b.md#there) [c](c.toml) [d](https://example.org/d.md)";
        assert_eq!(local_links(text), ["docs/b.md", "c.toml"]);
        let page = page(text);
        assert!(page.contains("href=\"docs/b.html#there\"") && page.contains("href=\"c.toml\""), "{page}");
        assert_eq!(plain(Path::new("/a/docs/../b/./c")), Path::new("/a/b/c"));
    }
}
