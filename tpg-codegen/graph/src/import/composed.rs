//! Formulas of words: instructions of a `.dot` file, a run's own ones, laws.

use crate::Word;
use crate::model::{LineDocument, OperandDocument};
use std::collections::BTreeSet;
use tpg_runtime::ops::Instruction;

/// The meaning of an instruction number in a `.dot` file.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Operator {
    /// Its name in messages.
    pub(crate) name: String,
    /// Its value; `None` if the sidecar does not give one, because no program uses it.
    pub(crate) value: Option<Expression>,
    /// The windows of its operands.
    pub(crate) windows: Windows,
}

/// The operands that a line can have, by name.
pub(crate) const OPERANDS: [&str; 6] = ["a", "b", "c", "d", "e", "f"];

/// The constants of a line, by name: GEGELATI's `%0` and `%1`.
pub(crate) const CONSTANTS: [&str; 4] = ["k0", "k1", "k2", "k3"];

/// The extent of each operand that is a window on an array: `[3]`, or rows and columns `[3, 3]`. Empty for a number.
pub(crate) type Windows = [Vec<u32>; OPERANDS.len()];

/// The value of an instruction, made of its operands.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// The operand at this place, `a` is 0, `b` is 1; and which of its values, 0 but for a window.
    Operand(usize, usize),
    /// The constant of the line at this place: `k0` is 0.
    Constant(usize),
    /// A number.
    Number(f64),
    /// A word and its operands.
    Call(Word, Vec<Expression>),
}

/// What a line gives to its instruction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Given<'l> {
    /// The operands; each has as many values as its window, or one.
    pub(crate) operands: &'l [Vec<OperandDocument>],
    /// The constants of the line.
    pub(crate) constants: &'l [f64],
}

/// What a line reads that is a part of an expression.
#[derive(Clone, Copy, Debug)]
pub enum Reading {
    /// The operand at this place, and which of its values.
    Operand(usize, usize),
    /// The constant of the line at this place.
    Constant(usize),
    /// A number.
    Number(f64),
    /// A register that an earlier line has written.
    Register(u32),
}

/// The accepted form, for messages.
pub(crate) const FORM: &str =
    "a formula of words, +, -, *, /, operands a to f, constants of the line k0 to k3, and numbers: a * div(b, 10)";

impl Expression {
    /// Returns the expression that a word stands for by itself.
    pub(crate) fn word(word: Word) -> Self {
        Self::Call(word, (0..word.arity()).map(|place| Self::Operand(place, 0)).collect())
    }

    /// Parses a formula of numbers `a` to `f` that is at least one call; the error says what was found.
    ///
    /// ```
    /// use tpg_graph::import::Expression;
    ///
    /// let half = Expression::call("(a + b) / 2")?;
    /// assert_eq!((half.arity(), half.scratch()), (2, 1));
    /// assert!(Expression::call("plus(a, b)").is_err());
    /// # Ok::<(), String>(())
    /// ```
    ///
    /// # Errors
    /// If it is no call, or calls what is no word.
    pub fn call(text: &str) -> Result<Self, String> {
        Self::parse(text, &Windows::default())
    }

    /// Parses such a formula of operands of which some are windows; the error says what was found.
    pub(crate) fn parse(text: &str, windows: &Windows) -> Result<Self, String> {
        match Self::formula(text, |name| leaf(name, windows))? {
            call @ Self::Call(..) => Ok(call),
            _ => Err(format!("`{text}`, which computes nothing")),
        }
    }

    /// Parses a formula of calls, `+`, `-`, `*`, `/`, brackets, numbers, and what `leaf` makes of other names; the error says what was
    /// found.
    ///
    /// # Errors
    /// If it is no formula, or calls what is no word.
    pub fn formula(text: &str, leaf: impl Fn(&str) -> Result<Self, String>) -> Result<Self, String> {
        let mut parser = FormulaParser { rest: text, leaf: &leaf };
        match parser.sum()? {
            _ if !parser.rest.trim().is_empty() => Err(format!("`{}` after the formula", parser.rest.trim())),
            found => Ok(found),
        }
    }

    /// Returns the number of operands that a line must have: 2 if `b` occurs and `c` does not.
    pub fn arity(&self) -> usize {
        match self {
            Self::Operand(place, _) => place + 1,
            Self::Number(_) | Self::Constant(_) => 0,
            Self::Call(_, operands) => operands.iter().map(Self::arity).max().unwrap_or(0),
        }
    }

    /// Returns the number of constants that a line must have: 2 if `k1` occurs and no later one.
    pub fn constants(&self) -> usize {
        match self {
            Self::Constant(place) => place + 1,
            Self::Operand(..) | Self::Number(_) => 0,
            Self::Call(_, operands) => operands.iter().map(Self::constants).max().unwrap_or(0),
        }
    }

    /// Adds the words that occur.
    pub fn words(&self, words: &mut BTreeSet<Word>) {
        if let Self::Call(word, operands) = self {
            words.insert(*word);
            operands.iter().for_each(|operand| operand.words(words));
        }
    }

    /// Returns the number of registers that its intermediate values need.
    pub fn scratch(&self) -> u32 {
        let Self::Call(_, operands) = self else { return 0 };
        let is_call = |operand: &&Self| matches!(operand, Self::Call(..));
        (0..)
            .zip(operands.iter().filter(is_call))
            .map(|(held, operand)| held + 1 + operand.scratch())
            .max()
            .unwrap_or(0)
    }

    /// Tells `line` of each line that leaves the value in register `to`, in order: its register, its word and what it reads.
    /// Registers from `free` on are for intermediate values.
    pub fn spell(&self, to: u32, free: u32, line: &mut impl FnMut(u32, Word, &[Reading])) {
        let Self::Call(word, inner) = self else { return };
        let mut held = free;
        let mut reads = Vec::with_capacity(inner.len());
        for operand in inner {
            reads.push(match *operand {
                Self::Operand(place, value) => Reading::Operand(place, value),
                Self::Constant(place) => Reading::Constant(place),
                Self::Number(value) => Reading::Number(value),
                Self::Call(..) => {
                    operand.spell(held, held + 1, line);
                    held += 1;
                    Reading::Register(held - 1)
                }
            });
        }
        line(to, *word, &reads);
    }

    /// Appends the lines of a graph's document that leave the value in register `to`.
    pub(crate) fn lines(&self, given: Given<'_>, to: u32, free: u32, lines: &mut Vec<LineDocument>) {
        let operand = |read: &Reading| match *read {
            Reading::Operand(place, value) => given.operands[place][value].clone(),
            Reading::Constant(place) => OperandDocument::Constant(given.constants[place]),
            Reading::Number(value) => OperandDocument::Constant(value),
            Reading::Register(register) => OperandDocument::Place(format!("r{register}")),
        };
        self.spell(to, free, &mut |to, word, reads| {
            lines.push(LineDocument { to, op: word.name().to_owned(), args: reads.iter().map(operand).collect() });
        });
    }
}

struct FormulaParser<'t, 'l> {
    rest: &'t str,
    leaf: &'l dyn Fn(&str) -> Result<Expression, String>,
}

impl<'t> FormulaParser<'t, '_> {
    fn sum(&mut self) -> Result<Expression, String> {
        self.operators([('+', Instruction::Add), ('-', Instruction::Sub)], |it| {
            it.operators([('*', Instruction::Mul), ('/', Instruction::Div)], Self::factor)
        })
    }

    /// Parses operands with operators of the same rank between them, from the left.
    fn operators(
        &mut self,
        operators: [(char, Instruction); 2],
        operand: impl Fn(&mut Self) -> Result<Expression, String>,
    ) -> Result<Expression, String> {
        let mut left = operand(self)?;
        while let Some((_, instruction)) = operators.into_iter().find(|(mark, _)| self.takes(*mark)) {
            left = Expression::Call(instruction.into(), vec![left, operand(self)?]);
        }
        Ok(left)
    }

    fn factor(&mut self) -> Result<Expression, String> {
        if self.takes('-') {
            return Ok(match self.factor()? {
                Expression::Number(value) => Expression::Number(-value),
                value => Expression::Call(Instruction::Sub.into(), vec![Expression::Number(0.0), value]),
            });
        }
        if self.takes('(') {
            let inner = self.sum()?;
            return if self.takes(')') { Ok(inner) } else { Err("`(` without its closing bracket".to_owned()) };
        }
        let text = self.token();
        if !self.takes('(') {
            return match text.parse::<f64>() {
                Ok(value) if value.is_finite() => Ok(Expression::Number(value)),
                _ => (self.leaf)(text),
            };
        }
        // A register that is written and read needs a line of its own.
        let word =
            Word::from_name(text).filter(|word| !word.reads_destination()).ok_or(format!("{text:?} as a word"))?;
        let mut operands = vec![self.sum()?];
        while self.takes(',') {
            operands.push(self.sum()?);
        }
        if !self.takes(')') {
            return Err(format!("`{text}(` without its closing bracket"));
        }
        if operands.len() == word.arity() {
            Ok(Expression::Call(word, operands))
        } else {
            Err(format!("{} operands of {text}, which takes {}", operands.len(), word.arity()))
        }
    }

    /// Takes a number or a name: everything up to a space, a bracket, a comma or an operator.
    fn token(&mut self) -> &'t str {
        let text = self.rest.trim_start();
        let is_number = text.starts_with(|c: char| c.is_ascii_digit() || c == '.');
        let mut last = ' ';
        let ends = |c: char| {
            let is_sign = is_number && "eE".contains(std::mem::replace(&mut last, c));
            c.is_whitespace() || "(),*/".contains(c) || ("+-".contains(c) && !is_sign)
        };
        let (token, rest) = text.split_at(text.find(ends).unwrap_or(text.len()));
        self.rest = rest;
        token
    }

    fn takes(&mut self, mark: char) -> bool {
        let after = self.rest.trim_start().strip_prefix(mark);
        self.rest = after.unwrap_or(self.rest);
        after.is_some()
    }
}

/// Returns the operand or the constant of that name, where some operands are windows.
fn leaf(text: &str, windows: &Windows) -> Result<Expression, String> {
    let name = text.split('[').next().unwrap_or_default();
    if let Some(place) = OPERANDS.iter().position(|operand| *operand == name) {
        return in_window(place, &text[name.len()..], &windows[place]).map(|value| Expression::Operand(place, value));
    }
    let constant = CONSTANTS.iter().position(|constant| *constant == text).map(Expression::Constant);
    constant.ok_or_else(|| format!("{text:?}, which is neither an operand nor a finite number"))
}

/// Returns the place of a value in an operand's window: `[1][2]` of 3 by 3 is 5.
fn in_window(place: usize, indices: &str, window: &[u32]) -> Result<usize, String> {
    let found = || {
        let name = OPERANDS[place];
        let extent: Vec<String> = window.iter().map(u32::to_string).collect();
        match window {
            [] => format!("{name}{indices} of a number"),
            _ => format!("{name}{indices} of a window of {}", extent.join(" by ")),
        }
    };
    let inner = indices.strip_prefix('[').and_then(|rest| rest.strip_suffix(']'));
    let indices: Vec<u32> = match inner {
        None if indices.is_empty() => Vec::new(),
        None => return Err(found()),
        Some(inner) => inner.split("][").map(|index| index.parse().map_err(|_| found())).collect::<Result<_, _>>()?,
    };
    if indices.len() != window.len() || indices.iter().zip(window).any(|(index, extent)| index >= extent) {
        return Err(found());
    }
    Ok(indices.iter().zip(window).fold(0, |before, (&index, &extent)| before * extent as usize + index as usize))
}

#[cfg(test)]
mod tests {
    use super::{Expression, Given, Windows};
    use crate::model::OperandDocument;

    fn written(text: &str) -> Vec<String> {
        let expression = Expression::parse(text, &Windows::default()).expect("an expression");
        let operands = ["x[0]", "r3"].map(|place| vec![OperandDocument::Place(place.to_owned())]);
        let mut lines = Vec::new();
        expression.lines(Given { operands: &operands, constants: &[0.5, -2.0] }, 1, 8, &mut lines);
        let highest = lines.iter().map(|line| line.to).filter(|&to| to >= 8).map(|to| to - 7).max().unwrap_or(0);
        assert_eq!(expression.scratch(), highest, "{text}");
        let operand = |operand: &OperandDocument| match operand {
            OperandDocument::Place(place) => place.clone(),
            OperandDocument::Constant(value) => value.to_string(),
        };
        let line = |line: &crate::LineDocument| {
            format!("r{} = {}({})", line.to, line.op, line.args.iter().map(operand).collect::<Vec<_>>().join(", "))
        };
        lines.iter().map(line).collect()
    }

    #[test]
    fn calls_become_lines() {
        assert_eq!(written("mul(a, div(b, 10))"), ["r8 = div(r3, 10)", "r1 = mul(x[0], r8)"]);
        assert_eq!(written("copy(3.25)"), ["r1 = copy(3.25)"]);
        let weighted = ["r8 = mul(x[0], 0.5)", "r9 = mul(r3, -2)", "r1 = sub(r8, r9)"];
        assert_eq!(written("sub(mul(a, k0), mul(b, k1))"), weighted);
        let infix = ["r10 = mul(2, r3)", "r9 = sub(x[0], r10)", "r8 = div(r9, 1e-3)", "r1 = add(r8, -4)"];
        assert_eq!(written("(a-2*b) / 1e-3 + -4").last(), infix.last().map(|line| (*line).to_owned()).as_ref());
        assert_eq!(written("a - b - 1")[0], "r8 = sub(x[0], r3)", "from the left");
        assert_eq!(written("-a"), ["r1 = sub(0, x[0])"]);
        let nested = ["r8 = sin(x[0])", "r9 = cos(r3)", "r10 = abs(r9)", "r9 = add(r10, 1)", "r1 = sub(r8, r9)"];
        let found = written(" sub( sin(a), add(abs(cos(b)) ,1) ) ");
        assert_eq!(found.len(), nested.len(), "{found:?}");
        assert_eq!(found.last().map(String::as_str), Some("r1 = sub(r8, r9)"));
    }

    #[test]
    fn what_is_no_call_is_refused() {
        let texts = [
            "",
            "a",
            "7",
            "mul(a)",
            "mul(a, b",
            "plus(a, b)",
            "mul(a, b) c",
            "(a + b",
            "a +",
            "a ** b",
            "1e999 * a",
            "mul(a, g)",
            "mul(a, k4)",
            "mul(a, nan)",
            "multiply_add(a, b)",
        ];
        for text in texts {
            Expression::parse(text, &Windows::default()).expect_err(text);
        }
    }

    #[test]
    fn values_of_windows_have_a_place() {
        let windows: Windows = [vec![3], vec![2, 3], vec![], vec![], vec![], vec![]];
        let parse = |text: &str| Expression::parse(text, &windows);
        let Ok(Expression::Call(_, operands)) = parse("sub(a[2], b[1][0])") else { panic!("a call") };
        assert_eq!(operands, [Expression::Operand(0, 2), Expression::Operand(1, 3)]);
        for text in
            ["abs(a)", "abs(a[3])", "abs(a[0][0])", "abs(b[1])", "abs(b[2][0])", "abs(c[0])", "abs(a[x])", "abs(a[0)"]
        {
            parse(text).expect_err(text);
        }
    }
}
