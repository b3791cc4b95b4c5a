//! Names of actions in generated code.

use super::block::unused;
use std::collections::BTreeSet;
use tpg_graph::Graph;

/// The constants that generated code defines beside those of the actions.
const TAKEN: &str =
    "actions depth h initial inline leader moves no_selftest outputs source_count sources state teams words";

/// An identifier in lower case for each action: its name, or as much of it as an identifier can hold.
pub(crate) fn actions(graph: &Graph) -> Vec<String> {
    let mut taken: BTreeSet<String> = TAKEN.split(' ').map(str::to_owned).collect();
    let asks = graph.actions().iter().filter_map(|action| Some(format!("asks_{}", action.ask.as_ref()?)));
    taken.extend(asks);
    graph.actions().iter().map(|action| unused(identifier(&action.name), &mut taken)).collect()
}

/// A name as an identifier. Signs of numbers are words.
fn identifier(name: &str) -> String {
    let mut out = String::new();
    let mut rest = name.chars().peekable();
    while let Some(c) = rest.next() {
        let signs_number = rest.peek().is_some_and(char::is_ascii_digit);
        let word = match c {
            '-' if signs_number => "_minus_",
            '+' if signs_number => "_plus_",
            _ => "_",
        };
        if c.is_ascii_alphanumeric() {
            out.push(c.to_ascii_lowercase());
        } else {
            // One underscore at a time, and none in front.
            let word = if out.is_empty() || out.ends_with('_') { word.trim_start_matches('_') } else { word };
            out.push_str(word);
        }
    }
    let out = out.trim_end_matches('_');
    if out.starts_with(|c: char| c.is_ascii_lowercase()) { out.to_owned() } else { format!("action_{out}") }
}

#[cfg(test)]
mod tests {
    use super::identifier;

    #[test]
    fn any_name_becomes_an_identifier() {
        let cases = [
            ("left", "left"),
            ("torque -1", "torque_minus_1"),
            ("torque +0.5", "torque_plus_0_5"),
            ("Push Left!", "push_left"),
            ("a--b", "a_b"),
            ("-2", "minus_2"),
            ("12", "action_12"),
            ("", "action_"),
            ("Größe", "gr_e"),
        ];
        for (name, expected) in cases {
            assert_eq!(identifier(name), expected, "{name}");
        }
    }
}
