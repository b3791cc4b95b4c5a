//! Tokens of C, after the directives of the preprocessor that generated code uses.
//!
//! The text is read as a compiler reads it that defines no macro of its own: neither GCC's nor fast maths'.

use super::compile;
use super::condition::{Condition, PRAGMAS, UNFUSED};
use crate::input::{Missing, Result};
use Token::*;
use std::collections::{HashMap, HashSet};

/// A token.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Token {
    Name(String),
    /// A number as it is written
    Number(String),

    Sign(&'static str),
    End,
}

/// A token with the line that it is on.
#[derive(Clone)]
pub(super) struct Placed {
    pub(super) token: Token,
    pub(super) line: u32,
}

/// Signs, the longest first.
const SIGNS: [&str; 2] = [
    "<<= >>= -> ++ -- << >> <= >= == != && || += -= *= /= %= &= |= ^=",
    "{ } ( ) [ ] ; , : ? = + - * / % & | ^ ~ ! < > .",
];

/// Macros of the standard headers that generated code uses.
const STANDARD: [(&str, &str); 7] = [
    ("INT32_MAX", "2147483647"),
    ("INT32_MIN", "(-2147483647 - 1)"),
    ("FLT_MAX", "3.40282347e+38F"),
    ("FLT_MIN", "1.17549435e-38F"),
    ("FLT_EPSILON", "1.1920929e-7F"),
    ("INFINITY", "(1.0F / 0.0F)"),
    ("NAN", "(0.0F / 0.0F)"),
];

/// Reads included files by their names.
pub(super) type Include<'a> = &'a dyn Fn(&str) -> Option<String>;

/// The names of a macro's arguments, if it has any, and its text.
type Macro = (Option<Vec<Token>>, Vec<Placed>);

struct Preprocessor<'a> {
    include: Include<'a>,
    macros: HashMap<String, Macro>,
    tokens: Vec<Placed>,
    depth: u32,
    /// The pragmas so far, each with the number of tokens before it
    pragmas: HashMap<String, usize>,
}

/// The tokens of a file and of what it includes.
pub(super) fn tokens(file: &str, text: &str, include: Include<'_>, has_floats: bool) -> Result<Vec<Placed>> {
    let (macros, pragmas) = (HashMap::new(), HashMap::new());
    let mut preprocessor = Preprocessor { include, macros, tokens: Vec::new(), depth: 0, pragmas };
    for (name, value) in STANDARD {
        let value = line_tokens(file, value, 0)?;
        preprocessor.macros.insert(name.to_owned(), (None, value));
    }
    preprocessor.file(file, text)?;
    let is_body = |pair: &[Placed]| pair[0].token == Sign(")") && pair[1].token == Sign("{");
    let code = preprocessor.tokens.windows(2).position(is_body).unwrap_or(usize::MAX);
    let forbidden = |pragma: &&str| preprocessor.pragmas.get(*pragma).is_some_and(|&before| before <= code);
    if has_floats && !UNFUSED.iter().all(forbidden) {
        return Err(Missing::new(file, "the pragmas of generated code against fused operations, before all functions"));
    }
    let line = preprocessor.tokens.last().map_or(1, |last| last.line);
    preprocessor.tokens.push(Placed { token: End, line });
    Ok(preprocessor.tokens)
}

/// The text with comments as spaces; line breaks stay.
fn plain(text: &str) -> String {
    let mut parts = text.split("/*");
    let mut plain = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (comment, behind) = part.split_once("*/").unwrap_or((part, ""));
        plain.push(' ');
        plain.extend(comment.chars().filter(|&letter| letter == '\n'));
        plain += behind;
    }
    plain
}

fn line_tokens(file: &str, text: &str, line: u32) -> Result<Vec<Placed>> {
    let mut tokens = Vec::new();
    let mut rest = text.trim_start();
    while let Some(first) = rest.chars().next() {
        let taken = |ty: &dyn Fn(char) -> bool| rest.find(|letter| !ty(letter)).unwrap_or(rest.len());
        let (token, length) = if first.is_ascii_alphabetic() || first == '_' {
            let length = taken(&|letter| letter.is_ascii_alphanumeric() || letter == '_');
            (Name(rest[..length].to_owned()), length)
        } else if first.is_ascii_digit() || first == '.' && rest[1..].starts_with(|next: char| next.is_ascii_digit()) {
            // a sign belongs to a number behind the letter of an exponent
            let mut before = ' ';
            let goes_on = |&letter: &char| {
                let sign = "+-".contains(letter) && "eEpP".contains(before);
                before = letter;
                letter.is_ascii_alphanumeric() || letter == '.' || sign
            };
            let length = rest.chars().take_while(goes_on).count();
            (Number(rest[..length].to_owned()), length)
        } else if let Some(sign) = SIGNS.iter().flat_map(|signs| signs.split(' ')).find(|sign| rest.starts_with(sign)) {
            (Sign(sign), sign.len())
        } else {
            return Err(Missing::new(format!("{file}:{line}"), format!("the letter {first:?}")));
        };
        tokens.push(Placed { token, line });
        rest = rest[length..].trim_start();
    }
    Ok(tokens)
}

impl Preprocessor<'_> {
    fn file(&mut self, file: &str, text: &str) -> Result<()> {
        self.depth += 1;
        if self.depth > 16 {
            return Err(Missing::new(file, "files that include each other"));
        }
        let mut conditions: Vec<Condition> = Vec::new();
        let plain = plain(text);
        let mut lines = (1..).zip(plain.lines()).peekable();
        while let Some((number, text)) = lines.next() {
            let place = || format!("{file}:{number}");
            let active = conditions.iter().all(|condition| condition.active);
            let mut line = text.split_whitespace().collect::<Vec<_>>().join(" ");
            if line.starts_with("# ") {
                line.remove(1);
            }
            let ends = ["#elif", "#else", "#endif"].iter().any(|word| line.starts_with(word));
            // what is in a branch belongs to the innermost condition that the text reaches
            let reached = conditions.iter().position(|condition| !condition.active).unwrap_or(conditions.len());
            let open = if ends { conditions.len().saturating_sub(1) } else { conditions.len() };
            for condition in conditions[..open.min(reached + 1)].iter_mut().filter(|_| !line.is_empty()) {
                condition.branches.last_mut().into_iter().for_each(|branch| branch.push(line.clone()));
            }
            let is_possible = conditions.iter().all(|condition| condition.active || condition.foreign.is_some());
            if is_possible && PRAGMAS.contains(&line.as_str()) {
                self.pragmas.entry(line.clone()).or_insert(self.tokens.len());
            }
            let Some(directive) = text.trim_start().strip_prefix('#') else {
                if active {
                    let expanded = self.expanded(line_tokens(file, text, number)?, &mut HashSet::new());
                    self.tokens.extend(expanded);
                }
                continue;
            };
            let directive = directive.trim_start();
            let end = directive.find(|letter: char| !letter.is_ascii_alphabetic()).unwrap_or(directive.len());
            let (word, rest) = (&directive[..end], directive[end..].trim());
            match word {
                "if" | "ifdef" | "ifndef" => {
                    let holds = active
                        && match word {
                            "if" => self.condition(&place(), rest)? != 0,
                            _ => self.macros.contains_key(rest) == (word == "ifdef"),
                        };
                    let defines = lines.peek().is_some_and(|next| next.1.trim() == format!("#define {rest}"));
                    let is_known = word == "ifndef" && (defines || rest.ends_with("_NO_SELFTEST"));
                    conditions.push(Condition {
                        active: holds,
                        taken: holds,
                        foreign: (active && !is_known && self.is_foreign(rest)).then(place),
                        has_else: false,
                        branches: vec![Vec::new()],
                    });
                }
                "elif" | "else" => {
                    let Some(mut condition) = conditions.pop() else {
                        return Err(Missing::new(place(), "the #if of an #else"));
                    };
                    let outer = conditions.iter().all(|condition| condition.active);
                    condition.active =
                        outer && !condition.taken && (word == "else" || self.condition(&place(), rest)? != 0);
                    condition.taken |= condition.active;
                    if outer && self.is_foreign(rest) {
                        condition.foreign.get_or_insert_with(place);
                    }
                    condition.has_else |= word == "else";
                    condition.branches.push(Vec::new());
                    conditions.push(condition);
                }
                "endif" => {
                    let condition = conditions.pop();
                    condition.ok_or_else(|| Missing::new(place(), "the #if of an #endif"))?.check()?;
                }
                _ if !active => {}
                "include" => {
                    if let Some(name) = rest.strip_prefix('"').and_then(|name| name.strip_suffix('"')) {
                        let text = (self.include)(name);
                        let text = text.ok_or_else(|| Missing::new(place(), format!("the file {name}")))?;
                        self.file(name, &text)?;
                    }
                }
                "define" => {
                    let end = rest.find(|letter: char| !(letter.is_ascii_alphanumeric() || letter == '_'));
                    let (name, value) = rest.split_at(end.unwrap_or(rest.len()));
                    let (names, value) = match value.strip_prefix('(').and_then(|value| value.split_once(')')) {
                        Some((names, value)) => (Some(line_tokens(file, names, number)?), value),
                        None => (None, value),
                    };
                    let is_name = |token: &Token| matches!(token, Name(_));
                    let names = names.map(|names| names.into_iter().map(|name| name.token).filter(is_name).collect());
                    self.macros.insert(name.to_owned(), (names, line_tokens(file, value, number)?));
                }
                "pragma" if PRAGMAS.contains(&line.as_str()) => {}
                _ => return Err(Missing::new(place(), format!("#{word} {rest}"))),
            }
        }
        self.depth -= 1;
        Ok(())
    }

    /// Tests whether a condition names a macro that the text does not define.
    fn is_foreign(&self, condition: &str) -> bool {
        let names = condition.split(|letter: char| !(letter.is_ascii_alphanumeric() || letter == '_'));
        let is_name = |name: &&str| name.starts_with(|first: char| !first.is_ascii_digit()) && *name != "defined";
        names.filter(is_name).any(|name| !self.macros.contains_key(name))
    }

    /// Tokens with all macros replaced but for those that this is the text of.
    fn expanded(&self, tokens: Vec<Placed>, inside: &mut HashSet<String>) -> Vec<Placed> {
        let (mut expanded, mut tokens) = (Vec::new(), tokens.into_iter().peekable());
        while let Some(token) = tokens.next() {
            let name = if let Name(name) = &token.token { name.clone() } else { String::new() };
            let found = self.macros.get(&name).filter(|_| !inside.contains(&name));
            let opens = |next: &Placed| next.token == Sign("(");
            let (names, text) = match found {
                Some((None, text)) => (&[][..], text),
                Some((Some(names), text)) if tokens.next_if(opens).is_some() => (&names[..], text),
                _ => {
                    expanded.push(token);
                    continue;
                }
            };
            let (mut arguments, mut depth) = (vec![Vec::new()], 0);
            while !names.is_empty()
                && let Some(next) = tokens.next()
            {
                depth += match next.token {
                    Sign("(" | "[") => 1,
                    Sign(")" | "]") => -1,
                    _ => 0,
                };
                match next.token {
                    _ if depth < 0 => break,
                    Sign(",") if depth == 0 => arguments.push(Vec::new()),
                    _ => arguments.last_mut().into_iter().for_each(|last| last.push(next.clone())),
                }
            }
            let arguments: Vec<_> = arguments.into_iter().map(|argument| self.expanded(argument, inside)).collect();
            let mut replaced = Vec::new();
            for inner in text {
                match names.iter().position(|name| *name == inner.token).and_then(|at| arguments.get(at)) {
                    Some(argument) => replaced.extend(argument.iter().cloned()),
                    None => replaced.push(Placed { line: token.line, ..inner.clone() }),
                }
            }
            inside.insert(name.clone());
            expanded.extend(self.expanded(replaced, inside));
            inside.remove(&name);
        }
        expanded
    }

    /// The value of a condition of `#if`: numbers, `defined`, `!`, `&&`, `||`, comparisons. Names that are not defined are 0.
    fn condition(&self, place: &str, text: &str) -> Result<i64> {
        let missing = || Missing::new(place, format!("#if {text}"));
        let mut tokens = Vec::new();
        let mut rest = line_tokens(place, text, 0)?.into_iter();
        let mut next = || rest.next().map(|placed| placed.token);
        while let Some(token) = next() {
            tokens.push(match token {
                Name(name) if name == "defined" => {
                    let (Some(Sign("(")), Some(Name(name)), Some(Sign(")"))) = (next(), next(), next()) else {
                        return Err(missing());
                    };
                    Number(u8::from(self.macros.contains_key(&name)).to_string())
                }
                Name(name) if self.macros.contains_key(&name) => return Err(missing()),
                Name(_) => Number("0".to_owned()),
                token => token,
            });
        }
        let tokens = tokens.into_iter().chain([End]).map(|token| Placed { token, line: 0 });
        compile::constant(place, tokens.collect()).map_err(|_| missing())
    }
}
