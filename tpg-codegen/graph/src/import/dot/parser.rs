//! From text to what it declares, one line at a time.

use super::declared::{
    Declared, DeclaredAction, DeclaredEdge, DeclaredLines, DeclaredProgram, DotNode, NodeKind, Rank, add,
};
use super::fault::{Fault, refuse};
use super::label;
use super::lexer::{self, Token, quote};
use crate::error::InputError;
use Token::*;

/// The statements allowed inside the braces, for messages.
const STATEMENTS: &str = "a team `T0 […]`, a program `P0 […] //`, its lines `I0 [… label=\"…\"]`, a link `P0 -> I0[…]`, an action \
                          `A0 [… label=\"0\"]`, its program `A0 -> P0`, an edge `T0 -> P0 -> T1`, `T0 -> P0 -> A0` or \
                          `T0 -> P0`, the roots \
                          `{ rank= same T0 }`, or the closing }";

/// Reads all statements, skipping those that only affect how the graph is drawn.
pub(super) fn declared(file: &str, text: &str) -> Result<Declared, InputError> {
    let mut declared = Declared::default();
    let mut section = DotSection::Before;
    let mut tokens = Vec::new();
    let mut last = 1;
    for (line, content) in (1..).zip(text.lines()) {
        last = line;
        tokens.clear();
        lexer::tokens(content, &mut tokens)
            .and_then(|()| section.statement(&mut declared, line, content, &tokens))
            .map_err(|fault| fault.on(file, line))?;
    }
    match section {
        DotSection::Before => Err(Fault::new("the file ends before its graph begins", "`digraph{`").on(file, last)),
        DotSection::Inside => Err(Fault::new("the file ends inside its graph", "the closing }").on(file, last)),
        DotSection::After => Ok(declared),
    }
}

/// Section of the file that a line belongs to.
#[derive(Clone, Copy)]
enum DotSection {
    Before,
    Inside,
    After,
}

impl DotSection {
    fn statement(
        &mut self,
        declared: &mut Declared,
        line: usize,
        content: &str,
        tokens: &[Token<'_>],
    ) -> Result<(), Fault> {
        match (*self, tokens) {
            (_, []) => {}
            (Self::Before, [Comment(comment)]) => {
                // `File exported with GEGELATI v1.3.1`.
                let exported = comment.strip_prefix("File exported with ").and_then(|rest| rest.rsplit_once(" v"));
                if let Some((tool, version)) = exported {
                    declared.exporter = Some((tool.to_owned(), version.to_owned()));
                }
            }
            (_, [Comment(_)]) => {}
            (Self::Before, [Word("digraph"), Mark('{')]) => *self = Self::Inside,
            (Self::Before, _) => return refuse(quote(content), "`digraph{`, and comments before it"),
            (Self::Inside, [Mark('}')]) => {
                *self = Self::After;
                declared.close = line;
            }
            (Self::Inside, _) => return inside(declared, line, content, tokens),
            (Self::After, _) => return refuse(quote(content), "nothing after the closing }"),
        }
        Ok(())
    }
}

fn inside(declared: &mut Declared, line: usize, content: &str, tokens: &[Token<'_>]) -> Result<(), Fault> {
    let unknown = || Fault::new(quote(content), STATEMENTS);
    let (tokens, comment) = match tokens {
        [tokens @ .., Comment(comment)] => (tokens, *comment),
        tokens => (tokens, ""),
    };
    if let [Mark('{'), Word("rank"), Mark('='), Word("same"), nodes @ .., Mark('}')] = tokens {
        let roots = nodes.iter().map(|token| node(token)?.ok_or_else(unknown)).collect::<Result<_, _>>()?;
        return match declared.rank.replace(Rank { line, roots }) {
            Some(_) => refuse("the roots a second time", "one line `{ rank= same … }`"),
            None => Ok(()),
        };
    }
    let bracket = tokens.iter().position(|token| *token == Mark('[')).unwrap_or(tokens.len());
    let (head, attributes) = tokens.split_at(bracket);
    let label = label_of(attributes)?;
    if let [Word("graph" | "node" | "edge")] = head {
        return Ok(());
    }
    let path = path(head)?.ok_or_else(unknown)?;
    let kinds: Vec<NodeKind> = path.iter().map(|node| node.kind).collect();
    match (kinds.as_slice(), path.as_slice()) {
        ([NodeKind::Team], &[team]) => add(&mut declared.teams, team, line)?,
        ([NodeKind::Program], &[program]) => {
            if let Some(label) = label.filter(|label| !["0", "1"].contains(label)) {
                let accepted = "no label, \"0\" for a program that bids, \"1\" for one of an action";
                return refuse(format!("{program} with the label {label:?}"), accepted);
            }
            let constants = label::constants(comment)?;
            add(&mut declared.programs, program, DeclaredProgram { line, constants })?;
        }
        ([NodeKind::Lines], &[node]) => {
            let lines = label::lines(label.ok_or_else(|| without_label(node))?)?;
            add(&mut declared.lines, node, DeclaredLines { line, lines, constants: label::constants(comment)? })?;
        }
        ([NodeKind::Action], &[node]) => {
            let label = label.ok_or_else(|| without_label(node))?;
            let labels: Vec<u32> = label.split('-').map(label::number).collect::<Option<_>>().ok_or_else(|| {
                let accepted =
                    "the number of an action, as in label=\"0\", or those of its programs, as in label=\"0-1\"";
                Fault::new(format!("{node} with the label {label:?}"), accepted)
            })?;
            // GEGELATI 2 repeats an action's node before each edge to it.
            if declared.actions.get(&node.number).is_none_or(|known| known.labels != labels) {
                let action = DeclaredAction { line, labels, programs: Vec::new() };
                add(&mut declared.actions, node, action)?;
            }
        }
        ([NodeKind::Action, NodeKind::Program], &[node, program]) => {
            let accepted = || Fault::new(format!("{node}, which no line before declares"), "an action's node");
            declared.actions.get_mut(&node.number).ok_or_else(accepted)?.programs.push(program.number);
            declared.links.push((line, program.number));
        }
        ([NodeKind::Program, NodeKind::Lines], &[program, lines]) => {
            if program.number != lines.number {
                let accepted = format!("{program} -> I{}: a program's lines have its number", program.number);
                return refuse(format!("{program} -> {lines}"), accepted);
            }
            declared.links.push((line, program.number));
        }
        ([NodeKind::Team, NodeKind::Program], &[team, program]) => {
            declared.edges.push(DeclaredEdge { line, team: team.number, program: program.number, to: None });
        }
        ([NodeKind::Team, NodeKind::Program, NodeKind::Team | NodeKind::Action], &[team, program, to]) => {
            declared.edges.push(DeclaredEdge { line, team: team.number, program: program.number, to: Some(to) });
        }
        _ => return Err(unknown()),
    }
    Ok(())
}

fn without_label(node: DotNode) -> Fault {
    Fault::new(format!("{node} without a label"), format!("`{node} [… label=\"…\"]`"))
}

/// Parses nodes joined by arrows; `None` for anything else.
fn path(tokens: &[Token<'_>]) -> Result<Option<Vec<DotNode>>, Fault> {
    let mut nodes = Vec::new();
    for (place, token) in tokens.iter().enumerate() {
        match node(token)? {
            Some(node) if place % 2 == 0 => nodes.push(node),
            None if place % 2 == 1 && *token == Arrow => {}
            _ => return Ok(None),
        }
    }
    Ok((tokens.len() % 2 == 1).then_some(nodes))
}

/// Parses a node name such as `T12`; `None` if the token is not a node name.
fn node(token: &Token<'_>) -> Result<Option<DotNode>, Fault> {
    let Word(word) = *token else { return Ok(None) };
    let Some(kind) = NodeKind::ALL.into_iter().find(|kind| word.starts_with(kind.letter())) else { return Ok(None) };
    let number = &word[1..];
    if number.is_empty() || !number.bytes().all(|byte| byte.is_ascii_digit()) {
        return Ok(None);
    }
    let number = number
        .parse()
        .map_err(|_| Fault::new(format!("the number of {}", quote(word)), format!("0 to {}", u32::MAX)))?;
    Ok(Some(DotNode { kind, number }))
}

/// Returns the label from attributes `[name=value …]`, which may be absent. The other attributes only affect drawing.
fn label_of<'t>(attributes: &[Token<'t>]) -> Result<Option<&'t str>, Fault> {
    let accepted = "attributes `[name=value …]`";
    let mut rest = match attributes {
        [] => return Ok(None),
        [Mark('['), rest @ .., Mark(']')] => rest,
        _ => return refuse("attributes without their closing ]", accepted),
    };
    let mut label = None;
    while !rest.is_empty() {
        let (name, value);
        (name, value, rest) = match rest {
            [Mark(','), after @ ..] => {
                rest = after;
                continue;
            }
            [Word(name), Mark('='), Word(value) | Text(value), after @ ..] => (*name, *value, after),
            _ => return refuse("something else between [ and ]", accepted),
        };
        if name == "label" && label.replace(value).is_some() {
            return refuse("two labels", "one");
        }
    }
    Ok(label)
}
