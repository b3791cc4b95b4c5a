//! The functions that expressions call.

/// Keeps the functions that a text calls, or another one that stays. Each is a paragraph with its comment, behind those that it calls;
/// a paragraph that defines no function stays. A function that nothing calls would be a warning.
pub(super) fn called(functions: &str, text: &str) -> String {
    let mut kept = String::new();
    for paragraph in paragraphs(functions).iter().rev() {
        if name(paragraph).is_none_or(|name| calls(text, name) || calls(&kept, name)) {
            kept.insert_str(0, &format!("{paragraph}\n"));
        }
    }
    kept
}

/// The parts between blank lines outside of braces. A comment that stands alone is part of what follows.
fn paragraphs(text: &str) -> Vec<String> {
    let (mut paragraphs, mut open, mut depth) = (Vec::new(), String::new(), 0);
    for line in text.lines() {
        depth += line.matches('{').count();
        depth -= line.matches('}').count();
        open += &format!("{line}\n");
        if line.is_empty() && depth == 0 && !open.trim_end().ends_with("*/") {
            paragraphs.push(std::mem::take(&mut open));
        }
    }
    paragraphs.push(open);
    paragraphs
}

/// The name of the function that a paragraph defines.
fn name(paragraph: &str) -> Option<&str> {
    let head = paragraph.lines().find(|line| line.starts_with(|c: char| c.is_ascii_alphabetic()))?;
    head.split_once('(')?.0.rsplit(' ').next()
}

/// Tests for a call of a function, not of another's method.
fn calls(text: &str, function: &str) -> bool {
    let ends = |before: &str| !before.ends_with(|c: char| c.is_ascii_alphanumeric() || "_:.".contains(c));
    text.match_indices(&format!("{function}(")).any(|(place, _)| ends(&text[..place]))
}
