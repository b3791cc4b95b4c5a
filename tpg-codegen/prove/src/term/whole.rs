//! Whole numbers: exact, each with an interval that holds all its values. A sum is a polynomial over what is no sum, so that sums
//! are one node however they are ordered, bracketed and multiplied out.

use super::{Arithmetic, Bool, Float, Node, Terms, Width, Word, decided, rank};
use Node::*;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The greatest magnitude: up to here binary64 holds every whole number, and a quotient rounded to it has the same whole part.
pub(super) const MOST: i128 = 1 << 53;
/// The most products of a sum.
const LONGEST: usize = 1 << 12;
/// Choices in choices, down to which an interval is looked for.
const CHOICES: u32 = 8;
/// A greater sum is not bounded.
const UNBOUNDED: i128 = 1 << 110;

/// The lowest and the highest value.
pub(crate) type Interval = [i128; 2];

/// Products of nodes, each sorted, with their factors.
pub(super) type Products = Vec<(Vec<u32>, i128)>;

/// Counts by their indices, each with its factor: where their sum with a number is 0, or a multiple of a step, an answer may change.
pub(crate) struct Border {
    pub(crate) factors: Vec<(u32, i128)>,
    pub(crate) plus: i128,
    pub(crate) step: i128,
}

/// A number as a multiple of another, which has no constant part, and a constant.
struct Multiple {
    of: Float,
    by: i128,
    plus: i128,
}

fn meet([a, b]: Interval, [c, d]: Interval) -> Interval {
    [a.max(c), b.min(d)]
}

fn corners([a, b]: Interval, [c, d]: Interval, operation: fn(i128, i128) -> i128) -> Interval {
    let all = [operation(a, c), operation(a, d), operation(b, c), operation(b, d)];
    all.into_iter().fold([i128::MAX, i128::MIN], |[low, high], value| [low.min(value), high.max(value)])
}

impl Terms {
    /// A whole number.
    pub fn whole(&self, value: i128) -> Float {
        let products = if value == 0 { Vec::new() } else { vec![(Vec::new(), value)] };
        self.exactly(Sum(products.into()), [value; 2])
    }

    /// A value of the state that is a whole number, with the lowest and the highest there is.
    pub(crate) fn counted(&self, index: u32, range: Interval) -> Float {
        match self.state.as_ref().and_then(|state| state.get(index as usize)) {
            Some(&bits) => self.whole((bits as i32).into()),
            None => self.exactly(Count(index), range),
        }
    }

    /// The interval of a whole number; nothing for binary32.
    pub(crate) fn interval(&self, term: Float) -> Option<Interval> {
        self.intervals.borrow().get(&term).copied()
    }

    /// Tests for a whole number.
    pub(crate) fn is_whole(&self, term: Float) -> bool {
        self.intervals.borrow().contains_key(&term)
    }

    /// The constant that a whole number is.
    pub(crate) fn whole_of(&self, term: Float) -> Option<i128> {
        self.interval(term).filter(|[low, high]| low == high).map(|[value, _]| value)
    }

    /// The place of a constant in the order of its kind.
    pub(crate) fn rank_of(&self, term: Float) -> Option<i128> {
        self.bits_of(term).map_or_else(|| self.whole_of(term), |bits| Some(rank(bits).into()))
    }

    /// The whole number that a word stands for, if it is a constant or a choice of constants.
    pub(crate) fn whole_of_word(&self, word: Word, signed: Option<Width>) -> Option<Float> {
        match self.of_word(word) {
            Number(number) => Some(self.whole(signed.map_or(number.into(), |width| width.signed(number).into()))),
            WordIf(condition, a, b) => {
                let (a, b) = (self.whole_of_word(a, signed)?, self.whole_of_word(b, signed)?);
                Some(self.choose_float(condition, a, b))
            }
            _ => None,
        }
    }

    /// The word of a whole number that is a constant or a choice of constants; of 32 bits if they hold it.
    pub(crate) fn word_of_whole(&self, term: Float) -> Option<Word> {
        match (self.whole_of(term), self.of_float(term)) {
            (Some(value), _) => {
                Some(self.number(i32::try_from(value).map_or(value as u64, |value| u64::from(value as u32))))
            }
            (None, FloatIf(condition, a, b)) => {
                Some(self.choose_word(condition, self.word_of_whole(a)?, self.word_of_whole(b)?))
            }
            _ => None,
        }
    }

    /// Makes a whole number of a node, whose values an interval holds.
    fn exactly(&self, node: Node, interval: Interval) -> Float {
        let [low, high] = interval;
        if low == high && !matches!(node, Sum(ref products) if products.iter().all(|(product, _)| product.is_empty())) {
            return self.whole(low);
        }
        if low < -MOST || high > MOST {
            self.left_out.set(Some("whole numbers of at most 2^53"));
            return self.whole(0);
        }
        let float = Float(self.node(node, 1));
        self.narrow(float, interval)
    }

    /// Records that an interval holds all values of a whole number, too.
    pub(super) fn narrow(&self, float: Float, interval: Interval) -> Float {
        let mut intervals = self.intervals.borrow_mut();
        let known = intervals.entry(float).or_insert(interval);
        *known = meet(*known, interval);
        float
    }

    fn products(&self, term: Float) -> Rc<Products> {
        match self.of_float(term) {
            Sum(products) => products,
            _ => vec![(vec![term.0], 1)].into(),
        }
    }

    /// The products of a sum `a * x + b * y`, merged.
    fn merged(&self, parts: [(Float, i128); 2]) -> Products {
        let parts = parts.into_iter().flat_map(|(term, by)| {
            let products = self.products(term);
            products.iter().map(|(product, factor)| (product.clone(), factor * by)).collect::<Vec<_>>()
        });
        Self::collected(parts)
    }

    fn collected(parts: impl IntoIterator<Item = (Vec<u32>, i128)>) -> Products {
        let mut sum = BTreeMap::<Vec<u32>, i128>::new();
        for (product, by) in parts {
            *sum.entry(product).or_default() += by;
        }
        sum.into_iter().filter(|&(_, by)| by != 0).collect()
    }

    /// An interval of a sum of products.
    fn span(&self, products: &Products) -> Interval {
        let factor = |&atom: &u32| self.interval(Float(atom)).unwrap_or([-MOST, MOST]);
        let times = |a, b| corners(a, b, i128::saturating_mul);
        let mut sum = [0, 0];
        for (product, by) in products {
            let [low, high] = product.iter().map(factor).fold([*by, *by], times);
            if low < -UNBOUNDED || high > UNBOUNDED {
                return [-UNBOUNDED, UNBOUNDED];
            }
            sum = [sum[0] + low, sum[1] + high];
        }
        sum
    }

    /// A sum of products, which an interval is known to hold.
    fn summed(&self, products: Products, known: Interval) -> Float {
        if products.len() > LONGEST || products.iter().any(|(_, by)| by.abs() > MOST) {
            self.left_out.set(Some("whole numbers of at most 2^53"));
            return self.whole(0);
        }
        if let [(product, 1)] = &products[..]
            && let [only] = product[..]
        {
            return self.narrow(Float(only), known);
        }
        let interval = meet(self.span(&products), known);
        self.exactly(Sum(products.into()), interval)
    }

    /// An operation of two whole numbers, exactly. A quotient is cut off; one by 0 is 0.
    pub(super) fn exact(&self, operation: Arithmetic, a: Float, b: Float) -> Float {
        let [p, q] = [a, b].map(|term| self.interval(term).unwrap_or([-MOST, MOST]));
        match operation {
            Arithmetic::Add => self.summed(self.merged([(a, 1), (b, 1)]), corners(p, q, |x, y| x + y)),
            Arithmetic::Multiply => {
                let (first, second) = (self.products(a), self.products(b));
                if first.len() * second.len() > LONGEST {
                    self.left_out.set(Some("whole numbers of at most 2^53"));
                    return self.whole(0);
                }
                let both = first.iter().flat_map(|(x, by)| {
                    second.iter().map(move |(y, factor)| {
                        let mut product = [&x[..], y].concat();
                        product.sort_unstable();
                        (product, by * factor)
                    })
                });
                let mut known = corners(p, q, |x, y| x * y);
                for (quotient, divisor) in [(a, b), (b, a)] {
                    if let Quotient(x, y) = self.of_float(quotient)
                        && y == divisor
                        && let Some([low, high]) = self.interval(x)
                    {
                        // what was divided is not nearer to 0
                        known = meet(known, [low.min(0), high.max(0)]);
                    }
                }
                self.summed(Self::collected(both), known)
            }
            Arithmetic::Divide => match (self.whole_of(a), self.whole_of(b)) {
                (Some(x), Some(y)) => self.whole(x.checked_div(y).unwrap_or(0)),
                (_, Some(by @ 1..)) if by & (by - 1) == 0 && p[0] >= 0 => self.shifted(a, by),
                (_, Some(1)) => a,
                (_, Some(-1)) => self.negate(a),
                _ => {
                    let most = p[0].abs().max(p[1].abs());
                    let near = [(1, i128::MAX), (i128::MIN, -1)].map(|(low, high)| meet(q, [low, high]));
                    let ends = near.iter().filter(|[low, high]| low <= high);
                    let all = ends.map(|&[low, high]| corners(p, [low, high], |x, y| x / y));
                    let interval = all.fold([0, 0], |[low, high], [from, to]| [low.min(from), high.max(to)]);
                    self.exactly(Quotient(a, b), meet(interval, [-most, most]))
                }
            },
            Arithmetic::Remainder => {
                let product = self.exact(Arithmetic::Multiply, self.exact(Arithmetic::Divide, a, b), b);
                // nearer to 0 than the divisor, not beyond the dividend, and with its sign
                let most = if q[0] <= 0 && q[1] >= 0 { MOST } else { q[0].abs().max(q[1].abs()) - 1 };
                self.summed(self.merged([(a, 1), (product, -1)]), [p[0].clamp(-most, 0), p[1].clamp(0, most)])
            }
        }
    }

    /// A whole number divided by a power of two, rounded down.
    pub(crate) fn shifted(&self, a: Float, by: i128) -> Float {
        if by == 1 {
            return a;
        }
        let mirrored = |a| self.exact(Arithmetic::Add, self.negate(a), self.whole(-1));
        if self.multiple(a).by < 0 {
            self.uses("floor(x / n) = -1 - floor((-1 - x) / n)");
            return mirrored(self.shifted(mirrored(a), by));
        }
        let interval = self.interval(a).unwrap_or([-MOST, MOST]).map(|end| end.div_euclid(by));
        self.exactly(Shifted(a, by), interval)
    }

    /// A quotient rounded down, of a divisor other than 0.
    pub(crate) fn rounded_down(&self, a: Float, b: Float) -> Float {
        if let Some(by @ 1..) = self.whole_of(b)
            && by & (by - 1) == 0
        {
            return self.shifted(a, by);
        }
        self.uses("floor(a / b) is a / b, less 1 where that is inexact and the signs differ");
        let (quotient, zero) = (self.divide(a, b), self.whole(0));
        let exact = self.equal(self.multiply(quotient, b), a);
        let [first, second] = [a, b].map(|term| self.less(term, zero));
        let differ = self.choose(first, !second, second);
        self.choose_float(self.and(!exact, differ), self.subtract(quotient, self.whole(1)), quotient)
    }

    /// A number as a multiple; the first product of what it is a multiple of has a positive factor, and no number divides all.
    fn multiple(&self, term: Float) -> Multiple {
        let products = self.products(term);
        let plus = products.first().filter(|(product, _)| product.is_empty()).map_or(0, |&(_, plus)| plus);
        let rest = || products.iter().filter(|(product, _)| !product.is_empty());
        let divisor = rest().fold(0, |divisor, &(_, by)| greatest_divisor(divisor, by));
        let by = if rest().next().is_some_and(|&(_, by)| by < 0) { -divisor } else { divisor };
        if by == 0 || by == 1 && plus == 0 {
            return Multiple { of: term, by: 1, plus: 0 };
        }
        let known = solved(self.interval(term).unwrap_or([-MOST, MOST]), by, plus);
        let of = rest().map(|(product, factor)| (product.clone(), factor / by)).collect();
        Multiple { of: self.summed(of, known), by, plus }
    }

    /// The borders of comparisons and of quotients, where they are of sums of counts.
    pub(crate) fn borders(&self) -> Vec<Border> {
        let nodes = (0..self.count()).map(|number| self.node_at(number as u32));
        let sums = nodes.filter_map(|node| match node {
            AtMost(a, b) if self.is_whole(a) => Some((self.merged([(a, 1), (b, -1)]), 0)),
            Shifted(a, by) => Some((self.merged([(a, 1), (self.whole(0), 1)]), by)),
            _ => None,
        });
        let border = |(products, step): (Products, i128)| {
            let (mut factors, mut plus) = (Vec::new(), 0);
            for (product, by) in products {
                match product[..] {
                    [] => plus = by,
                    [only] => match self.node_at(only) {
                        Count(index) => factors.push((index, by)),
                        _ => return None,
                    },
                    _ => return None,
                }
            }
            (!factors.is_empty()).then_some(Border { factors, plus, step })
        };
        sums.filter_map(border).collect()
    }

    /// Tests that two numbers are the same whole number where conditions hold.
    pub(crate) fn same_under(&self, a: Float, b: Float, conditions: [Bool; 2]) -> bool {
        if !self.is_whole(a) || !self.is_whole(b) {
            return false;
        }
        let facts = conditions.map(|condition| self.parts(condition)).concat();
        self.interval_under(self.subtract(a, b), &facts).is_none_or(|interval| interval == [0, 0])
    }

    /// Tests whether a whole number is at most as high as another: by their intervals, or as the least number of atoms.
    pub(super) fn wholes_at_most(&self, a: Float, b: Float) -> Option<Bool> {
        let ([p, q], [r, s]) = (self.interval(a)?, self.interval(b)?);
        let [low, high] = self.span(&self.merged([(b, 1), (a, -1)]));
        if low >= 0 || q <= r {
            return Some(Self::TRUE);
        }
        if high < 0 || s < p {
            return Some(Self::FALSE);
        }
        if let Some(constant) = self.whole_of(a) {
            return Some(!self.at_most(b, self.whole(constant - 1)));
        }
        let constant = self.whole_of(b)?;
        let Multiple { of, by, plus } = self.multiple(a);
        let bound = (constant - plus).div_euclid(by.abs());
        match by {
            _ if of == a => None,
            1.. => Some(self.at_most(of, self.whole(bound))),
            // -n * x <= c exactly where x > (-c - 1) / n
            _ => Some(!self.at_most(of, self.whole((plus - constant - 1).div_euclid(-by)))),
        }
    }

    /// What is left of a condition where facts hold.
    pub(super) fn restricted(&self, condition: Bool, facts: &[Bool]) -> Bool {
        match (decided(facts, condition), self.of_bool(condition)) {
            (Some(known), _) => Self::known(known),
            (None, (And(members), negated)) => {
                // not all of some, and so not all of more
                let excluded = |&fact: &Bool| match self.of_bool(fact) {
                    (And(some), true) => some.iter().all(|one| members.contains(one)),
                    _ => false,
                };
                if facts.iter().any(excluded) {
                    return Self::known(negated);
                }
                let all = self.all(members.iter().map(|&member| self.restricted(member, facts)).collect::<Vec<_>>());
                if negated { !all } else { all }
            }
            _ => condition,
        }
    }

    /// The interval of a whole number where conditions hold; none if they cannot.
    pub(crate) fn interval_under(&self, term: Float, facts: &[Bool]) -> Option<Interval> {
        self.interval_below(CHOICES, term, facts)
    }

    fn interval_below(&self, choices: u32, term: Float, facts: &[Bool]) -> Option<Interval> {
        if let FloatIf(condition, x, y) = self.of_float(term)
            && let Some(choices) = choices.checked_sub(1)
        {
            let [x, y] = [(x, condition), (y, !condition)].map(|(side, held)| {
                let mut all = self.parts(held);
                let known = all.clone();
                all.extend(facts.iter().flat_map(|&fact| self.parts(self.restricted(fact, &known))));
                if all.contains(&Self::FALSE) { None } else { self.interval_below(choices, side, &all) }
            });
            return match (x, y) {
                (Some([a, b]), Some([c, d])) => Some([a.min(c), b.max(d)]),
                (x, y) => x.or(y),
            };
        }
        let Multiple { of, by, plus } = self.multiple(term);
        let mut known = self.interval(of)?;
        match self.of_float(of) {
            Shifted(inner, by) => {
                known = meet(known, self.interval_below(choices, inner, facts)?.map(|end| end.div_euclid(by)));
            }
            FloatIf(..) if of != term => known = meet(known, self.interval_below(choices, of, facts)?),
            _ => {}
        }
        for &fact in facts {
            let (AtMost(a, b), negated) = self.of_bool(fact) else { continue };
            // the lower one, and how much it is lower at least
            let (low, high, gap) = if negated { (b, a, 1) } else { (a, b, 0) };
            let (Some([least, _]), Some([_, greatest])) = (self.interval(low), self.interval(high)) else { continue };
            let bounds = [(low, [-MOST * 4, greatest - gap]), (high, [least + gap, MOST * 4])];
            for (bounded, bound) in bounds {
                let Multiple { of: other, by, plus } = self.multiple(bounded);
                if other == of {
                    known = meet(known, solved(bound, by, plus));
                }
            }
        }
        let ends = known.map(|end| end * by + plus);
        let ends = if by > 0 { ends } else { [ends[1], ends[0]] };
        let ends = meet(ends, self.interval(term)?);
        (known[0] <= known[1] && ends[0] <= ends[1]).then_some(ends)
    }
}

/// The interval of `x` where `by * x + plus` is in an interval.
fn solved(interval: Interval, by: i128, plus: i128) -> Interval {
    let [low, high] = interval.map(|end| (end - plus) * by.signum());
    let [low, high] = [low.min(high), low.max(high)];
    [-(-low).div_euclid(by.abs()), high.div_euclid(by.abs())]
}

fn greatest_divisor(mut a: i128, mut b: i128) -> i128 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a.abs()
}
