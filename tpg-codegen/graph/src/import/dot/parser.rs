//! From text to statements, one line at a time.

use super::Fault;
use super::label;
use super::lexer::{self, Token, quote};
use super::statement::{Kind, Located, Node, Statement, Target};
use crate::error::InputError;

/// The statements allowed inside the braces, for messages.
const STATEMENTS: &str = "a team `T0 […]`, a program `P0 […] //`, its lines `I0 [… label=\"…\"]`, a link `P0 -> I0[…]`, an action \
                          `A0 [… label=\"0\"]`, its program `A0 -> P0`, an edge `T0 -> P0 -> T1`, `T0 -> P0 -> A0` or \
                          `T0 -> P0`, the roots \
                          `{ rank= same T0 }`, or the closing }";

/// Parses all statements, skipping those that only affect how the graph is drawn.
pub(super) fn statements(file: &str, text: &str) -> Result<Vec<Located>, InputError> {
    let mut statements = Vec::new();
    let mut section = Section::Before;
    let mut tokens = Vec::new();
    let mut last = 1;
    for (line, content) in (1..).zip(text.lines()) {
        last = line;
        tokens.clear();
        let statement = lexer::tokens(content, &mut tokens)
            .and_then(|()| section.statement(content, &tokens))
            .map_err(|fault| fault.on(file, line))?;
        statements.extend(statement.map(|statement| Located { line, statement }));
    }
    match section {
        Section::Before => Err(Fault::new("the file ends before its graph begins", "`digraph{`").on(file, last)),
        Section::Inside => Err(Fault::new("the file ends inside its graph", "the closing }").on(file, last)),
        Section::After => Ok(statements),
    }
}

/// Section of the file that a line belongs to.
#[derive(Clone, Copy)]
enum Section {
    Before,
    Inside,
    After,
}

impl Section {
    /// Parses one line; `None` if it carries no information about the graph.
    fn statement(&mut self, content: &str, tokens: &[Token<'_>]) -> Result<Option<Statement>, Fault> {
        match (*self, tokens) {
            (_, []) => Ok(None),
            (Self::Before, [Token::Comment(comment)]) => Ok(exporter(comment)),
            (_, [Token::Comment(_)]) => Ok(None),
            (Self::Before, [Token::Word("digraph"), Token::Mark('{')]) => {
                *self = Self::Inside;
                Ok(None)
            }
            (Self::Before, _) => Err(Fault::new(quote(content), "`digraph{`, and comments before it")),
            (Self::Inside, [Token::Mark('}')]) => {
                *self = Self::After;
                Ok(Some(Statement::Close))
            }
            (Self::Inside, _) => inside(content, tokens),
            (Self::After, _) => Err(Fault::new(quote(content), "nothing after the closing }")),
        }
    }
}

/// Parses the exporter's comment: `File exported with GEGELATI v1.3.1`.
fn exporter(comment: &str) -> Option<Statement> {
    let (tool, version) = comment.strip_prefix("File exported with ")?.rsplit_once(" v")?;
    Some(Statement::Exporter { tool: tool.to_owned(), version: version.to_owned() })
}

fn inside(content: &str, tokens: &[Token<'_>]) -> Result<Option<Statement>, Fault> {
    let unknown = || Fault::new(quote(content), STATEMENTS);
    let (tokens, comment) = match tokens {
        [tokens @ .., Token::Comment(comment)] => (tokens, Some(*comment)),
        tokens => (tokens, None),
    };
    if let [
        Token::Mark('{'),
        Token::Word("rank"),
        Token::Mark('='),
        Token::Word("same"),
        nodes @ ..,
        Token::Mark('}'),
    ] = tokens
    {
        let roots = nodes.iter().map(|token| node(token)?.ok_or_else(unknown)).collect::<Result<_, _>>()?;
        return Ok(Some(Statement::Rank { roots }));
    }
    let bracket = tokens.iter().position(|token| *token == Token::Mark('[')).unwrap_or(tokens.len());
    let (head, attributes) = tokens.split_at(bracket);
    let label = label_of(attributes)?;
    if let [Token::Word("graph" | "node" | "edge")] = head {
        return Ok(None);
    }
    let path = path(head)?.ok_or_else(unknown)?;
    let statement = match *path.as_slice() {
        [Node { kind: Kind::Team, number: team }] => Statement::Team { team },
        [Node { kind: Kind::Program, number: program }] => {
            if let Some(label) = label.filter(|label| !["0", "1"].contains(label)) {
                let accepted = "no label, \"0\" for a program that bids, \"1\" for one of an action";
                return Err(Fault::new(format!("P{program} with the label {label:?}"), accepted));
            }
            Statement::Program { program, constants: label::constants(comment.unwrap_or_default())? }
        }
        [node @ Node { kind: Kind::Lines, number: program }] => Statement::Lines {
            program,
            lines: label::lines(label.ok_or_else(|| without_label(node))?)?,
            constants: label::constants(comment.unwrap_or_default())?,
        },
        [node @ Node { kind: Kind::Action, number }] => {
            let label = label.ok_or_else(|| without_label(node))?;
            let labels = label.split('-').map(digits).collect::<Option<_>>().ok_or_else(|| {
                let accepted =
                    "the number of an action, as in label=\"0\", or those of its programs, as in label=\"0-1\"";
                Fault::new(format!("A{number} with the label {label:?}"), accepted)
            })?;
            Statement::Action { node: number, labels }
        }
        [Node { kind: Kind::Action, number: node }, Node { kind: Kind::Program, number: program }] => {
            Statement::ActionProgram { node, program }
        }
        [Node { kind: Kind::Program, number: program }, Node { kind: Kind::Lines, number: lines }] => {
            if program != lines {
                let accepted = format!("P{program} -> I{program}: a program's lines have its number");
                return Err(Fault::new(format!("P{program} -> I{lines}"), accepted));
            }
            Statement::Link { program }
        }
        [Node { kind: Kind::Team, number: team }, Node { kind: Kind::Program, number: program }] => {
            Statement::Edge { team, program, to: Target::OfProgram }
        }
        [Node { kind: Kind::Team, number: team }, Node { kind: Kind::Program, number: program }, to] => {
            let to = match to.kind {
                Kind::Team => Target::Team(to.number),
                Kind::Action => Target::ActionNode(to.number),
                Kind::Program | Kind::Lines => return Err(unknown()),
            };
            Statement::Edge { team, program, to }
        }
        _ => return Err(unknown()),
    };
    Ok(Some(statement))
}

fn without_label(node: Node) -> Fault {
    Fault::new(format!("{node} without a label"), format!("`{node} [… label=\"…\"]`"))
}

/// Parses nodes joined by arrows; `None` for anything else.
fn path(tokens: &[Token<'_>]) -> Result<Option<Vec<Node>>, Fault> {
    let mut nodes = Vec::new();
    for (place, token) in tokens.iter().enumerate() {
        match node(token)? {
            Some(node) if place % 2 == 0 => nodes.push(node),
            None if place % 2 == 1 && *token == Token::Arrow => {}
            _ => return Ok(None),
        }
    }
    Ok((tokens.len() % 2 == 1).then_some(nodes))
}

/// Parses a node name such as `T12`; `None` if the token is not a node name.
fn node(token: &Token<'_>) -> Result<Option<Node>, Fault> {
    let Token::Word(word) = *token else { return Ok(None) };
    let kind = match word.as_bytes().first() {
        Some(b'T') => Kind::Team,
        Some(b'P') => Kind::Program,
        Some(b'I') => Kind::Lines,
        Some(b'A') => Kind::Action,
        _ => return Ok(None),
    };
    let number = &word[1..];
    if number.is_empty() || !number.bytes().all(|byte| byte.is_ascii_digit()) {
        return Ok(None);
    }
    let number = number
        .parse()
        .map_err(|_| Fault::new(format!("the number of {}", quote(word)), format!("0 to {}", u32::MAX)))?;
    Ok(Some(Node { kind, number }))
}

fn digits(text: &str) -> Option<u32> {
    text.bytes().all(|byte| byte.is_ascii_digit()).then(|| text.parse().ok()).flatten()
}

/// Returns the label from attributes `[name=value …]`, which may be absent. The other attributes only affect drawing.
fn label_of<'t>(attributes: &[Token<'t>]) -> Result<Option<&'t str>, Fault> {
    let accepted = "attributes `[name=value …]`";
    let mut rest = match attributes {
        [] => return Ok(None),
        [Token::Mark('['), rest @ .., Token::Mark(']')] => rest,
        _ => return Err(Fault::new("attributes without their closing ]", accepted)),
    };
    let mut label = None;
    while !rest.is_empty() {
        let (name, value);
        (name, value, rest) = match rest {
            [Token::Mark(','), after @ ..] => {
                rest = after;
                continue;
            }
            [Token::Word(name), Token::Mark('='), Token::Word(value) | Token::Text(value), after @ ..] => {
                (*name, *value, after)
            }
            _ => return Err(Fault::new("something else between [ and ]", accepted)),
        };
        if name == "label" && label.replace(value).is_some() {
            return Err(Fault::new("two labels", "one"));
        }
    }
    Ok(label)
}
