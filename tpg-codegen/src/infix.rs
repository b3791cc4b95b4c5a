//! Infix expressions, with no more brackets than the order of operations needs. Nothing is associative: a + (b + c) is not
//! (a + b) + c.

use Level::*;

/// Binding strength of an expression's outermost operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Level {
    Sum,
    Product,
    Atom,
}

/// An expression.
#[derive(Clone, Debug)]
pub(crate) struct Infix {
    pub(crate) text: String,
    pub(crate) level: Level,
    pub(crate) is_number: bool,
}

impl Infix {
    pub(crate) fn atom(text: String) -> Self {
        Self { text, level: Atom, is_number: false }
    }

    /// The text as an operand that must bind at least this tightly.
    fn at(&self, level: Level) -> String {
        if self.level < level { format!("({})", self.text) } else { self.text.clone() }
    }

    /// The text without its sign, if it is a negative number or a product that begins with one.
    fn negated(&self) -> Option<&str> {
        if self.level == Sum { None } else { self.text.strip_prefix('-') }
    }

    /// A sum. To add a negative number, or a product with one, is to subtract the positive one, bit for bit; a number comes
    /// last, a sum first.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        let swap = self.is_number && !other.is_number || other.level == Sum && self.level != Sum;
        let (a, b) = if swap { (other, self) } else { (self, other) };
        let text = match b.negated() {
            Some(positive) => format!("{} - {positive}", a.text),
            None => format!("{} + {}", a.text, b.at(Product)),
        };
        Self { text, level: Sum, is_number: false }
    }

    /// A difference, which to a negative number is a sum.
    pub(crate) fn minus(&self, other: &Self) -> Self {
        let text = match other.negated() {
            Some(positive) => format!("{} + {positive}", self.text),
            None => format!("{} - {}", self.text, other.at(Product)),
        };
        Self { text, level: Sum, is_number: false }
    }

    /// A product: a number comes first, or a product.
    pub(crate) fn times(&self, other: &Self) -> Self {
        let swap = other.is_number && !self.is_number || other.level == Product && self.level != Product;
        let (a, b) = if swap { (other, self) } else { (self, other) };
        Self { text: format!("{} * {}", a.at(Product), b.at(Atom)), level: Product, is_number: false }
    }

    /// A quotient.
    pub(crate) fn over(&self, other: &Self) -> Self {
        Self { text: format!("{} / {}", self.at(Product), other.at(Atom)), level: Product, is_number: false }
    }
}
