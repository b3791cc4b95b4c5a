//! Parsing of program lines and constants from labels and comments.

use super::declared::{OperandText, ProgramLine};
use super::fault::Fault;
use super::lexer::quote;
use crate::import::composed::OPERANDS;
use std::str::FromStr;

/// Terminator of every program line: the exporter's spelling of Graphviz's `\n`.
const END: &str = "&#92;n";

/// Syntax of a line, for messages.
const LINE: &str = "instruction|register&source|location#source|location&#92;n";

/// Parses the label of a node that holds program lines.
pub(super) fn lines(label: &str) -> Result<Vec<ProgramLine>, Fault> {
    let mut lines = Vec::new();
    let mut rest = label;
    while !rest.is_empty() {
        let place = lines.len() + 1;
        let (text, after) = rest
            .split_once(END)
            .ok_or_else(|| Fault::new(format!("program line {place} {} without its end {END}", quote(rest)), LINE))?;
        let line = line(text).ok_or_else(|| Fault::new(format!("program line {place} {}", quote(text)), LINE))?;
        lines.push(line);
        rest = after;
    }
    Ok(lines)
}

fn line(text: &str) -> Option<ProgramLine> {
    let (head, tail) = text.split_once('&')?;
    let (instruction, to) = head.split_once('|')?;
    let mut line = ProgramLine {
        instruction: number(instruction)?,
        to: number(to)?,
        written: 0,
        operands: [OperandText::default(); OPERANDS.len()],
    };
    for operand in tail.split('#') {
        let (source, location) = operand.split_once('|')?;
        let operand = OperandText { source: number(source)?, location: number(location)? };
        if let Some(place) = line.operands.get_mut(line.written) {
            *place = operand;
        }
        line.written += 1;
    }
    Some(line)
}

/// Parses digits only: `FromStr` would accept a sign.
pub(super) fn number<N: FromStr>(text: &str) -> Option<N> {
    text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse().ok()).flatten()
}

/// Parses a program's constants: the integers of GEGELATI 1, `3|-5|`, or the real numbers of GEGELATI 2, `0.63|-0.4|`.
pub(super) fn constants(comment: &str) -> Result<Vec<f64>, Fault> {
    let accepted = "finite numbers, each followed by |";
    let finite = |text: &str| text.parse::<f64>().ok().filter(|value| value.is_finite());
    if comment.is_empty() {
        return Ok(Vec::new());
    }
    let list = comment
        .strip_suffix('|')
        .ok_or_else(|| Fault::new(format!("constants {} without a | at the end", quote(comment)), accepted))?;
    list.split('|')
        .map(|text| finite(text.trim()).ok_or_else(|| Fault::new(format!("the constant {}", quote(text)), accepted)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_program_of_two_lines() {
        let found = lines("7|5&1|1#4|70&#92;n1|3&0|0#4|5#9|9&#92;n").expect("two lines");
        let operand = |source, location| OperandText { source, location };
        let none = operand(0, 0);
        let expected = [
            ProgramLine {
                instruction: 7,
                to: 5,
                written: 2,
                operands: [operand(1, 1), operand(4, 70), none, none, none, none],
            },
            ProgramLine {
                instruction: 1,
                to: 3,
                written: 3,
                operands: [none, operand(4, 5), operand(9, 9), none, none, none],
            },
        ];
        assert_eq!(found, expected);
        assert_eq!(lines("").expect("no line"), []);
    }

    #[test]
    fn what_is_no_line() {
        for bad in [
            "7",
            "7|5",
            "7|5&",
            "7|5&1",
            "7|5&1|",
            "7|5&1|1#",
            "|5&1|1",
            "7|-5&1|1",
            "+7|5&1|1",
            "7|5&1|x",
            "7|5&1|1|2",
        ] {
            let fault = lines(&format!("{bad}&#92;n")).expect_err(bad);
            assert_eq!(fault.found, format!("program line 1 `{bad}`"));
        }
        assert!(lines("1|0&0|0&#92;n7|5&1|1").expect_err("no end").found.starts_with("program line 2"));
    }

    #[test]
    fn constants_of_both_versions() {
        assert_eq!(constants("0|-5|2147483647|").expect("integers"), [0.0, -5.0, 2147483647.0]);
        assert_eq!(constants("0.63|-0.40|1e-3|").expect("reals"), [0.63, -0.4, 1e-3]);
        assert!(constants("").expect("none").is_empty());
        for bad in ["1", "1|2", "1||", "a note", "1e999|", "nan|", "inf|", "x|"] {
            constants(bad).expect_err(bad);
        }
    }
}
