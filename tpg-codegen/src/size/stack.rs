//! The stack that generated C needs: the deepest chain of calls in GCC's call graph (`-fcallgraph-info=su`).

use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// The stack of an entry point.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Stack {
    /// Bytes of the deepest chain of calls.
    pub bytes: u64,
    /// Functions of libraries that are called, whose own stack comes on top.
    pub without: Vec<String>,
}

/// Reads the call graph of one file, in GCC's VCG, and follows it from `entry`.
///
/// `None` if the entry is missing, a frame has no fixed size, or there is recursion.
pub(super) fn deepest(text: &str, entry: &str) -> Option<Stack> {
    let mut frames: BTreeMap<&str, Option<u64>> = BTreeMap::new();
    let mut calls: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
    let mut libraries = BTreeSet::new();
    for line in text.lines() {
        if line.starts_with("node: ") {
            let title = quoted(line, "title: ")?;
            if line.contains("shape : ellipse") {
                libraries.insert(title);
            } else {
                frames.insert(title, frame(quoted(line, "label: ")?));
            }
        } else if line.starts_with("edge: ") {
            calls.entry(quoted(line, "sourcename: ")?).or_default().insert(quoted(line, "targetname: ")?);
        }
    }
    let mut depth: BTreeMap<&str, u64> = BTreeMap::new();
    let mut on_the_way = BTreeSet::new();
    let mut without = BTreeSet::new();
    let mut open = vec![entry];
    while let Some(&function) = open.last() {
        if depth.contains_key(function) {
            open.pop();
            continue;
        }
        if libraries.contains(function) {
            without.insert(function.to_owned());
            depth.insert(function, 0);
            continue;
        }
        let callees: Vec<&str> = calls.get(function).into_iter().flatten().copied().collect();
        let missing: Vec<&str> = callees.iter().copied().filter(|callee| !depth.contains_key(callee)).collect();
        if missing.is_empty() {
            let below = callees.iter().map(|callee| depth[callee]).max().unwrap_or(0);
            let frame = match frames.get(function) {
                Some(frame) => (*frame)?,
                None if function == entry => return None,
                // Inlined everywhere: its frame is its callers'.
                None => 0,
            };
            depth.insert(function, frame + below);
        } else if on_the_way.insert(function) {
            open.extend(missing);
        } else {
            return None;
        }
    }
    Some(Stack { bytes: depth[entry], without: without.into_iter().collect() })
}

/// The quoted text after a key.
fn quoted<'a>(line: &'a str, key: &str) -> Option<&'a str> {
    let (_, rest) = line.split_once(key)?;
    rest.strip_prefix('"')?.split('"').next()
}

/// The frame in a label: `name\nfile:line:column\n24 bytes (static)`. A bounded dynamic one has a bound, too.
fn frame(label: &str) -> Option<u64> {
    let words = label.rsplit("\\n").find(|part| part.contains(" bytes ("))?;
    let fixed = words.ends_with("(static)") || words.ends_with("bounded)");
    fixed.then(|| words.split(' ').next()?.parse().ok()).flatten()
}

#[cfg(test)]
mod tests {
    use super::{Stack, deepest};

    const GRAPH: &str = r#"graph: { title: "t.c"
node: { title: "t.c:f" label: "f\nt.c:2:15\n24 bytes (static)" }
node: { title: "sin" label: "sin\nmath.h:88:15" shape : ellipse }
edge: { sourcename: "t.c:f" targetname: "sin" label: "t.c:2:35" }
node: { title: "h" label: "h\nt.c:9:8\n100 bytes (static)" }
node: { title: "g" label: "g\nt.c:3:8\n16 bytes (static)" }
edge: { sourcename: "g" targetname: "t.c:f" label: "t.c:3:28" }
edge: { sourcename: "g" targetname: "t.c:f" label: "t.c:3:33" }
edge: { sourcename: "g" targetname: "t.c:inlined" label: "t.c:3:35" }
}
"#;

    #[test]
    fn the_deepest_chain_counts() {
        assert_eq!(deepest(GRAPH, "g"), Some(Stack { bytes: 40, without: vec!["sin".to_owned()] }));
        assert_eq!(deepest(GRAPH, "h"), Some(Stack { bytes: 100, without: Vec::new() }), "what it calls, and no more");
        assert_eq!(deepest(GRAPH, "missing"), None);
    }

    #[test]
    fn what_has_no_bound_has_no_number() {
        let circle = format!("{GRAPH}edge: {{ sourcename: \"t.c:f\" targetname: \"g\" }}\n");
        assert_eq!(deepest(&circle, "g"), None);
        assert_eq!(deepest(&GRAPH.replace("24 bytes (static)", "24 bytes (dynamic)"), "g"), None);
        let bounded = GRAPH.replace("24 bytes (static)", "24 bytes (dynamic,bounded)");
        assert_eq!(deepest(&bounded, "g").map(|stack| stack.bytes), Some(40));
    }
}
