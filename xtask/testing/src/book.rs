//! Pages of the book that are made from the programs: compared with what is committed, or written.

use crate::library::top;
use std::path::Path;
use std::process::Command;
use std::{env, fs};

/// Environment variable: if it is `1`, pages are written instead of compared.
pub const UPDATE: &str = "TPG_UPDATE_BOOK";

/// Compares a page of `docs/` with its text, or writes it where [`UPDATE`] is `1`.
///
/// # Panics
/// If the committed page is another one.
pub fn page(name: &str, text: &str) {
    let path = top().join("docs").join(name);
    if env::var(UPDATE).is_ok_and(|value| value == "1") {
        fs::write(&path, text).expect("the page can be written");
        return;
    }
    // Windows may have checked it out with its own line ends.
    let committed = fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    assert!(committed == text, "docs/{name} is stale: {UPDATE}=1 and the same command write it");
}

/// Returns a page with the help of a program and of each of its commands.
///
/// # Panics
/// If the program does not start.
pub fn manual(program: &Path, name: &str, lead: &str) -> String {
    let mut text = format!("# `{name}`\n\n{lead}\n\nMade from `--help` by a test; do not edit.\n");
    add(&mut text, program, name, &[]);
    text
}

/// Adds the help of a command and of the commands below it.
fn add(text: &mut String, program: &Path, title: &str, words: &[String]) {
    let help = help(program, words);
    *text += &format!("\n## {title}\n\n```text\n{}\n```\n", help.trim_end());
    for word in commands(&help) {
        add(text, program, &format!("{title} {word}"), &[words, &[word]].concat());
    }
}

/// Returns the help of a command. Lines end without blanks.
fn help(program: &Path, words: &[String]) -> String {
    let output = Command::new(program).args(words).arg("--help").output().expect("the program starts");
    let text = String::from_utf8_lossy(&output.stdout).replace(".exe", "");
    text.lines().map(|line| line.trim_end().to_owned() + "\n").collect()
}

/// Returns the commands that a help lists.
fn commands(help: &str) -> Vec<String> {
    let listed = help.lines().skip_while(|line| *line != "Commands:").skip(1).take_while(|line| !line.is_empty());
    let names = listed.filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    names.filter_map(|line| line.split_whitespace().next()).filter(|name| *name != "help").map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use super::commands;

    #[test]
    fn the_commands_of_a_help_are_found() {
        let help =
            "About.\n\nCommands:\n  tpg   Evolve\n        more\n  help  Print this\n\nOptions:\n  -h  Print help\n";
        assert_eq!(commands(help), ["tpg"]);
        assert!(commands("Options:\n  -h\n").is_empty());
    }
}
