//! Hash-consed terms over numbers, truth values and machine words. A number is of binary32, or a whole number. Both sides of a proof are built in one [`Terms`]: equal
//! nodes are proven equal.
//!
//! Constructors simplify. Every rule they apply holds for all bit patterns; the rules that are more than definitions are counted
//! by name, see [`Terms::lemmas`]. NaN is one value: its sign and payload are not part of any answer, and a condition that depends
//! on them stays an atom that nothing decides.

mod boolean;
mod compare;
pub mod evaluate;
mod float;
mod rank;
mod set;
pub mod smt;
mod whole;
pub(crate) mod word;

pub(crate) use whole::Border;

pub use rank::{INFINITY, NAN, NEGATIVE_ZERO, is_nan_bits, next_above, next_below, rank};

use crate::input::{Missing, Result};
use Node::*;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;

/// A truth value. Its lowest bit negates the node that the others name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Bool(u32);

/// A number: a binary32 value, or a whole number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Float(u32);

/// A machine word of 32 or 64 bits; narrower integers are words whose upper bits are 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Word(u32);

/// An operation of two floats that is rounded once. A difference is a sum with a negated operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Arithmetic {
    /// `a + b`
    Add,
    /// `a * b`
    Multiply,
    /// `a / b`
    Divide,
    /// `fmod(a, b)`, exact
    Remainder,
}

/// An operation of two words, modulo 2^width.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Operator {
    /// `a + b`
    Add,
    /// `a - b`
    Subtract,
    /// `a * b`
    Multiply,
    /// `a & b`
    And,
    /// `a | b`
    Or,
    /// `a ^ b`
    Xor,
    /// `a << b`, 0 for shifts of the width or more
    ShiftLeft,
    /// `a >> b` of unsigned numbers, 0 for shifts of the width or more
    ShiftRight,
    /// `a >> b` of signed numbers, the sign for shifts of the width or more
    ShiftArithmetic,
}

/// A width of words.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Width {
    /// 32 bits
    W32,
    /// 64 bits
    W64,
}

/// A sorted list of disjoint closed intervals of unsigned numbers.
pub type Set = Rc<[(u64, u64)]>;

/// A node of the table. Only the constructors of [`Terms`] make nodes.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Node {
    /// The truth value *true*
    True,
    /// A conjunction of at least two, sorted
    And(Rc<[Bool]>),
    /// The first ranks at most as high as the second, see [`rank()`]: NaN ranks below minus infinity, both zeros rank equal
    AtMost(Float, Float),
    /// Negative zero; an atom that the order of floats does not see
    IsNegativeZero(Float),
    /// NaN with its sign bit set; an atom that nothing decides
    IsNegativeNan(Float),
    /// A word in a set of numbers
    Within(Word, Set),
    /// The first word is below the second, as unsigned or signed numbers
    Below(bool, Width, Word, Word),
    /// A number by its bits; NaN is always [`NAN`]
    Constant(u32),
    /// A value of the state, by its index
    Source(u32),
    /// A value of the state that is a whole number
    Count(u32),
    /// A sum of products of whole numbers
    Sum(Rc<whole::Products>),
    /// The quotient of two whole numbers, cut off; 0 where the second is
    Quotient(Float, Float),
    /// A whole number divided by a power of two, rounded down
    Shifted(Float, i128),
    /// A value of which nothing is known; equal only to itself
    Unknown(u32),
    /// A rounded operation
    Arithmetic(Arithmetic, Float, Float),
    /// `-a`
    Negative(Float),
    /// `|a|`
    Magnitude(Float),
    /// The square root, rounded
    Root(Float),
    /// A choice between two floats
    FloatIf(Bool, Float, Float),
    /// The value of a function, by the function's name, its argument and the term that defines it
    Own(&'static str, Float, Float),
    /// The float with these 32 bits
    OfBits(Word),
    /// An integer rounded to binary32; of a signed or an unsigned 32-bit number
    OfInteger(bool, Word),
    /// A constant word
    Number(u64),
    /// A choice between two words
    WordIf(Bool, Word, Word),
    /// The bits of a float
    Bits(Float),
    /// An operation of words
    Apply(Operator, Width, Word, Word),
    /// An element of a constant table
    Element(Rc<[u64]>, Word),
}

/// The depth up to which terms are built: the rules walk down them by recursion.
const DEEPEST: u16 = 2_000;

/// The table of terms. It only grows: what a shared reference adds changes no term that is there.
#[derive(Debug)]
pub struct Terms {
    nodes: RefCell<Vec<Node>>,
    /// The depth of each node
    depths: RefCell<Vec<u16>>,
    /// What is missing where a node had to be left out
    left_out: Cell<Option<&'static str>>,
    /// The intervals of whole numbers
    intervals: RefCell<HashMap<Float, whole::Interval>>,
    index: RefCell<HashMap<Node, u32>>,
    lemmas: RefCell<BTreeMap<&'static str, u64>>,
    at_most: RefCell<HashMap<(Float, Float), Bool>>,
    zero_free: RefCell<HashMap<Float, Float>>,
    leaves: RefCell<HashMap<u32, Rc<[u32]>>>,
    unknowns: Cell<u32>,
    /// The bits of the sources, if only one state is looked at
    state: Option<Vec<u32>>,
}

impl Default for Terms {
    fn default() -> Self {
        let terms = Self {
            nodes: RefCell::default(),
            depths: RefCell::default(),
            left_out: Cell::default(),
            intervals: RefCell::default(),
            index: RefCell::default(),
            lemmas: RefCell::default(),
            at_most: RefCell::default(),
            zero_free: RefCell::default(),
            leaves: RefCell::default(),
            unknowns: Cell::default(),
            state: None,
        };
        // the first nodes are the simplest ones of their kinds
        for node in [True, Constant(NAN), Number(0)] {
            terms.node(node, 0);
        }
        terms
    }
}

impl Terms {
    /// The truth value *true*.
    pub const TRUE: Bool = Bool(0);
    /// The truth value *false*.
    pub const FALSE: Bool = Bool(1);

    /// Makes an empty table.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Makes an empty table for one state, given as bits: every source is a constant, and so is all that is computed.
    #[must_use]
    pub fn for_state(state: &[u32]) -> Self {
        Self { state: Some(state.to_vec()), ..Self::default() }
    }

    /// The number of a node; that of a simpler one of its kind, if it is too deep.
    fn node(&self, node: Node, simpler: u32) -> u32 {
        if let Some(&at) = self.index.borrow().get(&node) {
            return at;
        }
        let at = u32::try_from(self.count()).unwrap_or(u32::MAX);
        assert!(at < u32::MAX / 2, "the table of terms is full");
        let depth = self.deepest_part(&node) + 1;
        if depth > DEEPEST {
            self.left_out.set(Some("a proof with expressions of at most 2000 levels"));
            return simpler;
        }
        self.nodes.borrow_mut().push(node.clone());
        self.depths.borrow_mut().push(depth);
        self.index.borrow_mut().insert(node, at);
        at
    }

    /// The value of a node whose parts are constants.
    fn folded(&self, node: &Node) -> Option<u64> {
        evaluate::value_of(self, node, &mut |part| match self.node_at(part) {
            True => Some(1),
            Constant(bits) => Some(bits.into()),
            Number(number) => Some(number),
            Sum(_) => self.whole_of(Float(part)).map(|value| value as u64),
            _ => None,
        })
    }

    /// Gives the value of a function its name: from now on, the term that defines it is known by it.
    pub(crate) fn named(&self, function: &'static str, argument: Float, definition: Float) -> Float {
        let node = self.of_float(definition);
        if matches!(node, Own(..)) || self.deepest_part(&node) == 0 {
            return definition;
        }
        let named = self.node(Own(function, argument, definition), definition.0);
        self.index.borrow_mut().insert(node, named);
        Float(named)
    }

    /// Makes a truth value of a node.
    fn atom(&self, node: Node) -> Bool {
        self.folded(&node).map_or_else(|| Bool(self.node(node, 0) << 1), |value| Self::known(value != 0))
    }

    /// Makes a float of a node.
    fn float(&self, node: Node) -> Float {
        let value = self.folded(&node).map(|bits| Constant(bits as u32));
        Float(self.node(value.unwrap_or(node), 1))
    }

    /// Makes a word of a node.
    fn word(&self, node: Node) -> Word {
        let value = self.folded(&node).map(Number);
        Word(self.node(value.unwrap_or(node), 2))
    }

    /// Returns the depth of the deepest part of a node; 0 where it has none.
    fn deepest_part(&self, node: &Node) -> u16 {
        let (depths, mut deepest) = (self.depths.borrow(), 0);
        visit_parts(node, &mut |part| deepest = deepest.max(depths[part as usize]));
        deepest
    }

    /// Returns an error if a term was too deep or too great to be built: nothing can be claimed with these terms then.
    pub(crate) fn complete(&self, place: impl FnOnce() -> String) -> Result<()> {
        self.left_out.get().map_or(Ok(()), |what| Err(Missing::new(place(), what)))
    }

    /// The condition and the sides of a choice between floats or words.
    fn sides(&self, node: u32) -> Option<(Bool, u32, u32)> {
        match self.node_at(node) {
            FloatIf(condition, a, b) => Some((condition, a.0, b.0)),
            WordIf(condition, a, b) => Some((condition, a.0, b.0)),
            _ => None,
        }
    }

    /// A choice between two nodes of one kind, which `make` makes.
    fn chosen(&self, condition: Bool, a: u32, b: u32, make: fn(Bool, u32, u32) -> Node) -> u32 {
        if condition == Self::TRUE || a == b {
            return a;
        }
        if condition == Self::FALSE {
            return b;
        }
        if condition.0 & 1 == 1 {
            return self.chosen(!condition, b, a, make);
        }
        let (a, b) = (self.given(a, &[condition]), self.given(b, &[!condition]));
        if a == b { a } else { self.node(make(condition, a, b), a) }
    }

    /// A node where facts hold: choices that they decide are made.
    fn given(&self, mut node: u32, facts: &[Bool]) -> u32 {
        while let Some((condition, a, b)) = self.sides(node)
            && let Some(holds) = decided(facts, condition)
        {
            node = if holds { a } else { b };
        }
        node
    }

    /// The nodes that a choice leads to, itself if it is none. Counts no further than is of interest.
    fn leaves(&self, node: u32) -> Rc<[u32]> {
        let Some((_, a, b)) = self.sides(node) else { return Rc::new([node]) };
        if let Some(known) = self.leaves.borrow().get(&node) {
            return known.clone();
        }
        let (a, b) = (self.leaves(a), self.leaves(b));
        let mut all: Vec<_> = a.iter().chain(&*b).copied().collect();
        all.sort_unstable();
        all.dedup();
        // more than any limit
        all.truncate(1 << 12);
        let leaves: Rc<[u32]> = all.into();
        self.leaves.borrow_mut().insert(node, leaves.clone());
        leaves
    }

    /// The nodes that a choice leads to, each with its condition.
    fn cases(&self, from: u32) -> Vec<(Bool, u32)> {
        let mut found: Vec<(u32, Vec<Bool>)> = Vec::new();
        let mut open = vec![(from, Self::TRUE)];
        while let Some((node, held)) = open.pop() {
            match self.sides(node) {
                Some((condition, a, b)) => {
                    open.extend([(b, self.and(held, !condition)), (a, self.and(held, condition))]);
                }
                None if held == Self::FALSE => {}
                None => match found.iter_mut().find(|(other, _)| *other == node) {
                    Some((_, conditions)) => conditions.push(held),
                    None => found.push((node, vec![held])),
                },
            }
        }
        found.into_iter().map(|(node, conditions)| (self.any(conditions), node)).collect()
    }

    /// The values that a float is chosen from, each with its condition.
    pub(crate) fn float_cases(&self, float: Float) -> Vec<(Bool, Float)> {
        self.cases(float.0).into_iter().map(|(condition, node)| (condition, Float(node))).collect()
    }

    /// The words that a word is chosen from, each with its condition.
    pub(crate) fn word_cases(&self, word: Word) -> Vec<(Bool, Word)> {
        self.cases(word.0).into_iter().map(|(condition, node)| (condition, Word(node))).collect()
    }

    /// The two sides of a choice, each with its condition; the word alone if it is none.
    pub(crate) fn one_choice(&self, word: Word) -> Vec<(Bool, Word)> {
        match self.of_word(word) {
            WordIf(condition, a, b) => vec![(condition, a), (!condition, b)],
            _ => vec![(Self::TRUE, word)],
        }
    }

    fn uses(&self, lemma: &'static str) {
        *self.lemmas.borrow_mut().entry(lemma).or_default() += 1;
    }

    /// The rules that were applied, with how often each was.
    #[must_use]
    pub fn lemmas(&self) -> BTreeMap<&'static str, u64> {
        self.lemmas.borrow().clone()
    }

    /// The number of nodes.
    #[must_use]
    pub fn count(&self) -> usize {
        self.nodes.borrow().len()
    }

    /// The node of a truth value, and whether the value is its negation.
    #[must_use]
    pub fn of_bool(&self, term: Bool) -> (Node, bool) {
        (self.node_at(term.0 >> 1), term.0 & 1 == 1)
    }

    /// A node by its number.
    pub(crate) fn node_at(&self, number: u32) -> Node {
        self.nodes.borrow()[number as usize].clone()
    }

    /// The node of a float.
    #[must_use]
    pub fn of_float(&self, term: Float) -> Node {
        self.node_at(term.0)
    }

    /// The node of a word.
    #[must_use]
    pub fn of_word(&self, term: Word) -> Node {
        self.node_at(term.0)
    }
}

/// Visits the parts of a node.
fn visit_parts(node: &Node, visit: &mut dyn FnMut(u32)) {
    match *node {
        True | Constant(_) | Source(_) | Count(_) | Unknown(_) | Number(_) => {}
        Sum(ref products) => products.iter().flat_map(|(product, _)| product).for_each(|&part| visit(part)),
        And(ref parts) => parts.iter().for_each(|part| visit(part.0 >> 1)),
        IsNegativeZero(Float(a))
        | IsNegativeNan(Float(a))
        | Negative(Float(a))
        | Magnitude(Float(a))
        | Root(Float(a))
        | Bits(Float(a))
        | Shifted(Float(a), _)
        | Within(Word(a), _)
        | OfBits(Word(a))
        | OfInteger(_, Word(a))
        | Element(_, Word(a)) => visit(a),
        AtMost(Float(a), Float(b))
        | Node::Arithmetic(_, Float(a), Float(b))
        | Own(_, Float(a), Float(b))
        | Quotient(Float(a), Float(b))
        | Below(_, _, Word(a), Word(b))
        | Apply(_, _, Word(a), Word(b)) => [a, b].into_iter().for_each(visit),
        FloatIf(condition, Float(a), Float(b)) | WordIf(condition, Word(a), Word(b)) => {
            [condition.0 >> 1, a, b].into_iter().for_each(visit);
        }
    }
}

/// The truth of a condition, if facts decide it.
pub(crate) fn decided(facts: &[Bool], condition: Bool) -> Option<bool> {
    if facts.contains(&condition) {
        return Some(true);
    }
    facts.contains(&!condition).then_some(false)
}

#[cfg(test)]
mod tests {
    use super::{Arithmetic, DEEPEST, Operator, Terms, Width};

    #[test]
    fn terms_that_are_too_deep_for_the_rules_are_named() {
        let terms = Terms::new();
        let (mut sum, source) = (terms.source(0), terms.source(1));
        for _ in 1..DEEPEST {
            sum = terms.arithmetic(Arithmetic::Add, sum, source);
        }
        assert!(terms.complete(String::new).is_ok());
        terms.arithmetic(Arithmetic::Add, sum, source);
        let missing = terms.complete(|| "line 3".to_owned()).expect_err("it is too deep");
        assert_eq!(missing.to_string(), "line 3: a proof with expressions of at most 2000 levels");

        // A choice of a choice, and so on, whose bits are read: the rule for bits goes down all of them.
        let terms = Terms::new();
        let (zero, one) = (terms.source(0), terms.source(1));
        let mut chosen = terms.bits(zero);
        for number in 0..100_000 {
            let (condition, float) = (terms.at_most(zero, one), terms.source(number + 2));
            let bits = terms.bits(float);
            let other = terms.apply(Operator::Add, Width::W32, chosen, bits);
            chosen = terms.choose_word(condition, other, bits);
        }
        let _ = terms.of_bits(chosen);
        assert!(terms.complete(String::new).is_err());
    }
}
