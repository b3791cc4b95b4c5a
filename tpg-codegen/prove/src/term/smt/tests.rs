//! Every rule of the terms, by a solver: operators applied to terms of many shapes, each result equal to what SMT-LIB says of the
//! operator. What is built here fires every rule.

use super::super::evaluate::Evaluator;
use super::super::{Arithmetic, Bool, Float, Operator, Terms, Width, Word};
use super::Script;
use crate::order::together;
use sha2::{Digest, Sha256};
use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// Claims that a solver is to prove.
#[derive(Default)]
struct Lemmas {
    terms: Terms,
    scripts: Vec<String>,
    /// What no rule has changed
    plain: usize,
}

impl Lemmas {
    /// A claim, of which the names of terms are filled in.
    fn claim(&mut self, claim: impl FnOnce(&mut Script<'_>) -> String) {
        let mut script = Script::new(&self.terms);
        let claim = claim(&mut script);
        script.assert(&format!("(not {claim})"));
        self.scripts.push(script.finish());
    }

    /// The claim that a node means what is written.
    fn means(&mut self, node: u32, meaning: impl FnOnce(&mut Script<'_>) -> String) {
        let mut script = Script::new(&self.terms);
        let meaning = meaning(&mut script);
        if script.meaning(&self.terms.node_at(node)) == meaning {
            self.plain += 1;
            return;
        }
        let name = script.name(node);
        script.assert(&format!("(not (= {name} {meaning}))"));
        self.scripts.push(script.finish());
    }

    fn truth(&mut self, term: Bool, meaning: impl FnOnce(&mut Script<'_>) -> String) {
        if term.0 & 1 == 0 {
            self.means(term.0 >> 1, meaning);
        } else {
            self.means(term.0 >> 1, |script| format!("(not {})", meaning(script)));
        }
    }
}

const CONSTANTS: [u32; 14] = [
    0,
    0x8000_0000, // zeros
    0x3f80_0000,
    0xbf80_0000, // 1 and -1
    0x4000_0000,
    0x40a0_0000, // 2 and 5
    0x0080_0000,
    0x7e80_0000,
    0x7f00_0000, // normal powers of two: the lowest, its reciprocal, and one that has none
    1,
    0x7f7f_ffff, // the least and the greatest above 0
    0x7f80_0000,
    0xff80_0000,
    0x7fc0_0000, // infinities and NaN
];

/// Conditions that nothing relates, and some of floats.
fn conditions(terms: &Terms) -> Vec<Bool> {
    let [x, y] = [0, 1].map(|index| terms.source(index));
    let [c, d] = [4, 6].map(|index| terms.at_most(terms.source(index), terms.source(index + 1)));
    vec![c, !c, d, terms.less(x, y), terms.is_nan(x), terms.and(c, d), !terms.and(c, !d)]
}

fn floats(terms: &Terms) -> Vec<Float> {
    let [x, y, z] = [0, 1, 2].map(|index| terms.source(index));
    let [c, _, d, less, ..] = conditions(terms)[..] else { unreachable!() };
    let mut all = vec![x, y];
    all.extend(CONSTANTS.map(|bits| terms.constant_bits(bits)));
    let [zero, minus_zero, one, two, nan] =
        [0, 0x8000_0000, 0x3f80_0000, 0x4000_0000, 0x7fc0_0000].map(|bits| terms.constant_bits(bits));
    all.extend([
        terms.negate(x),
        terms.magnitude(x),
        terms.add(x, y),
        terms.subtract(x, y),
        terms.negate(terms.add(x, y)),
        terms.multiply(x, y),
        terms.negate(terms.multiply(x, y)),
        terms.multiply(x, two),
        terms.divide(x, y),
        terms.divide(two, x),
        terms.remainder(x, y),
        terms.add(x, zero),
        terms.negate(terms.add(x, zero)),
        terms.multiply(terms.add(x, zero), y),
        terms.divide(terms.add(x, zero), y),
        terms.remainder(terms.add(x, zero), y),
        terms.choose_float(c, x, y),
        terms.choose_float(c, minus_zero, one),
        terms.choose_float(c, x, nan),
        terms.choose_float(d, y, two),
        terms.choose_float(c, terms.choose_float(d, x, y), z),
        terms.choose_float(less, x, y),
        terms.of_bits(opaque(terms, 8)),
        terms.of_integer(true, opaque(terms, 8)),
        terms.of_integer(false, opaque(terms, 8)),
        terms.unknown(),
    ]);
    all
}

/// A word of 32 bits of which nothing is known.
fn opaque(terms: &Terms, index: u32) -> Word {
    let [a, b] = [index, index + 1].map(|index| terms.bits(terms.source(index)));
    terms.apply(Operator::ShiftLeft, Width::W32, a, b)
}

/// `fmod` by the remainder of IEEE 754, which is nearest to 0. For constants only: it is hard to solve.
fn fmod(a: &str, b: &str) -> String {
    let rem = format!("(fp.rem (fp.abs {a}) (fp.abs {b}))");
    let positive = format!(
        "(ite (fp.isNegative {rem}) (ite (fp.isZero {rem}) (_ +zero 8 24) (fp.add RNE {rem} (fp.abs {b}))) {rem})"
    );
    format!("(ite (fp.isNegative {a}) (fp.neg {positive}) {positive})")
}

fn arithmetic() -> Lemmas {
    let mut lemmas = Lemmas::default();
    let all = floats(&lemmas.terms);
    for &a in &all {
        let (negated, magnitude, zero_free) =
            (lemmas.terms.negate(a), lemmas.terms.magnitude(a), lemmas.terms.zero_free(a));
        lemmas.means(negated.0, |s| format!("(fp.neg {})", s.number(a)));
        lemmas.means(magnitude.0, |s| format!("(fp.abs {})", s.number(a)));
        if zero_free != a {
            lemmas.claim(|s| {
                let (a, b) = (s.number(a), s.number(zero_free));
                format!("(or (= {a} {b}) (and (fp.isZero {a}) (fp.isZero {b})))")
            });
        }
        let bits = lemmas.terms.bits(a);
        lemmas.claim(|s| {
            let (a, bits) = (s.number(a), s.word(bits));
            format!(
                "(and (= {a} ((_ to_fp 8 24) ((_ extract 31 0) {bits}))) (= ((_ extract 63 32) {bits}) #x00000000))"
            )
        });
        for &b in &all {
            for (operation, function) in [
                (Arithmetic::Add, "fp.add RNE"),
                (Arithmetic::Multiply, "fp.mul RNE"),
                (Arithmetic::Divide, "fp.div RNE"),
                (Arithmetic::Remainder, "fmod"),
            ] {
                let result = lemmas.terms.arithmetic(operation, a, b);
                let folds = [a, b].iter().all(|&term| lemmas.terms.bits_of(term).is_some());
                let may_fold = [a, b].iter().all(|&term| {
                    let leaves = lemmas.terms.leaves(term.0);
                    leaves.iter().any(|&leaf| lemmas.terms.bits_of(Float(leaf)).is_some())
                });
                if operation == Arithmetic::Remainder && may_fold && !folds {
                    // the solver does not know what constants fold to
                    continue;
                }
                lemmas.means(result.0, |s| {
                    let (a, b) = (s.number(a), s.number(b));
                    if function == "fmod" && folds { fmod(&a, &b) } else { format!("({function} {a} {b})") }
                });
            }
            let result = lemmas.terms.subtract(a, b);
            lemmas.means(result.0, |s| format!("(fp.sub RNE {} {})", s.number(a), s.number(b)));
        }
    }
    lemmas
}

fn comparisons() -> Lemmas {
    let mut lemmas = Lemmas::default();
    let (all, conditions) = (floats(&lemmas.terms), conditions(&lemmas.terms));
    let comparisons: [(fn(&Terms, Float, Float) -> Bool, &str); 4] = [
        (Terms::at_most, "(or (fp.isNaN {a}) (fp.leq {a} {b}))"),
        (Terms::less, "(fp.lt {a} {b})"),
        (Terms::less_or_equal, "(fp.leq {a} {b})"),
        (Terms::equal, "(fp.eq {a} {b})"),
    ];
    let choices: [(fn(&Terms, Float, Float) -> Float, &str); 2] =
        [(Terms::minimum, "(ite (fp.lt {a} {b}) {a} {b})"), (Terms::maximum, "(ite (fp.gt {a} {b}) {a} {b})")];
    for (at, &a) in all.iter().enumerate() {
        let nan = lemmas.terms.is_nan(a);
        lemmas.truth(nan, |s| format!("(fp.isNaN {})", s.number(a)));
        // what is made of the first comparison is no rule of its own
        let made_of_it = at % 5 == 0;
        for &b in &all {
            let filled =
                |meaning: &str, s: &mut Script<'_>| meaning.replace("{a}", &s.number(a)).replace("{b}", &s.number(b));
            for (make, meaning) in &comparisons[..if made_of_it { 4 } else { 1 }] {
                let result = make(&lemmas.terms, a, b);
                lemmas.truth(result, |s| filled(meaning, s));
            }
            for (make, meaning) in &choices[..if made_of_it { 2 } else { 0 }] {
                let result = make(&lemmas.terms, a, b);
                lemmas.means(result.0, |s| filled(meaning, s));
            }
            for &condition in &conditions {
                let result = lemmas.terms.choose_float(condition, a, b);
                lemmas.means(result.0, |s| format!("(ite {} {} {})", s.truth(condition), s.number(a), s.number(b)));
            }
        }
        let cases = lemmas.terms.float_cases(a);
        lemmas.claim(|s| {
            let cases = cases.iter().map(|&(condition, case)| {
                format!(" (and {} (= {} {}))", s.truth(condition), s.number(a), s.number(case))
            });
            let cases = cases.collect::<String>();
            format!("(or false{cases})")
        });
        let limits = [-1.0, 1.0, 0.0].map(|limit| lemmas.terms.constant(limit));
        let limited = lemmas.terms.clamp(a, limits);
        lemmas.means(limited.0, |s| {
            let [a, low, high, nan] = [a, limits[0], limits[1], limits[2]].map(|number| s.number(number));
            format!("(ite (fp.isNaN {a}) {nan} (ite (fp.lt {a} {low}) {low} (ite (fp.gt {a} {high}) {high} {a})))")
        });
    }
    lemmas
}

/// Words of 32 bits.
fn words(terms: &Terms) -> Vec<Word> {
    let [x, y] = [0, 1].map(|index| terms.source(index));
    let [c, _, d, less, ..] = conditions(terms)[..] else { unreachable!() };
    let [p, q, u, v] = [terms.bits(x), terms.bits(y), opaque(terms, 8), opaque(terms, 10)];
    let [zero, one, ones, half, rest, infinity, top, five] =
        [0, 1, 0xffff_ffff, 0x8000_0000, 0x7fff_ffff, 0x7f80_0000, 31, 5].map(|number| terms.number(number));
    let apply = |operator, a, b| terms.apply(operator, Width::W32, a, b);
    use Operator::{Add, And, Multiply, Or, ShiftLeft, ShiftRight, Subtract, Xor};
    vec![
        zero,
        one,
        ones,
        half,
        rest,
        infinity,
        top,
        five,
        p,
        q,
        u,
        v,
        terms.word_of(c),
        terms.choose_word(c, ones, zero),
        terms.choose_word(d, ones, zero),
        terms.choose_word(less, five, one),
        terms.choose_word(c, u, v),
        terms.choose_word(d, u, zero),
        terms.choose_word(c, apply(Xor, u, v), five),
        terms.choose_word(c, terms.choose_word(d, u, v), p),
        apply(Add, u, five),
        apply(Add, u, half),
        apply(Xor, u, five),
        apply(Xor, u, half),
        apply(Xor, p, half),
        apply(Xor, p, q),
        apply(Xor, u, v),
        apply(Xor, u, ones),
        apply(And, u, rest),
        apply(And, p, rest),
        apply(And, u, five),
        apply(And, u, v),
        apply(Or, u, five),
        apply(Or, u, v),
        apply(Subtract, five, u),
        apply(Subtract, infinity, apply(And, p, rest)),
        apply(Subtract, p, one),
        apply(Subtract, u, v),
        apply(ShiftRight, u, five),
        apply(ShiftRight, u, v),
        apply(ShiftLeft, u, five),
        apply(Multiply, u, v),
        terms.bits(terms.subtract(x, y)),
        terms.bits(terms.negate(x)),
        terms.bits(terms.magnitude(x)),
        terms.bits(terms.add(x, terms.constant(0.0))),
        terms.element(&[3, 1 << 31, 8].into(), terms.choose_word(c, one, terms.choose_word(d, zero, terms.number(2)))),
        terms.element(&[7, 9, 0xffff_ffff, 5].into(), apply(ShiftRight, u, terms.number(30))),
    ]
}

const OPERATORS: [(Operator, &str); 9] = [
    (Operator::Add, "bvadd"),
    (Operator::Subtract, "bvsub"),
    (Operator::Multiply, "bvmul"),
    (Operator::And, "bvand"),
    (Operator::Or, "bvor"),
    (Operator::Xor, "bvxor"),
    (Operator::ShiftLeft, "bvshl"),
    (Operator::ShiftRight, "bvlshr"),
    (Operator::ShiftArithmetic, "bvashr"),
];

/// Sets of numbers of 32 bits: borders of the order of floats and others.
const SETS: [&[(u64, u64)]; 12] = [
    &[(0x8000_0000, 0xffff_ffff)],
    &[(0, 0)],
    &[(1, 0x7f80_0000)],
    &[(0, 0x7f80_0000)],
    &[(0x8000_0000, 0x8000_0000)],
    &[(0x8000_0001, 0xff80_0000)],
    &[(0x7f80_0001, 0x7fff_ffff), (0xff80_0001, 0xffff_ffff)],
    &[(0xff80_0001, 0xffff_ffff)],
    &[(0x7fc0_0000, 0x7fc0_0000)],
    &[(3, 9), (0x4000_0000, 0x9000_0000)],
    &[(0x3f80_0000, 0x7f7f_ffff), (0x8000_0000, 0x8000_0000)],
    &[(5, 5), (0xffff_fffa, 0xffff_ffff)],
];

/// An operation of words of 32 bits, whose upper bits are 0.
fn narrow(function: &str, a: &str, b: &str) -> String {
    format!("(concat #x00000000 ({function} ((_ extract 31 0) {a}) ((_ extract 31 0) {b})))")
}

fn inside(word: &str, set: &[(u64, u64)]) -> String {
    let all =
        set.iter().map(|(low, high)| format!(" (and (bvule (_ bv{low} 64) {word}) (bvule {word} (_ bv{high} 64)))"));
    format!("(or false{})", all.collect::<String>())
}

fn words_of_32_bits() -> Lemmas {
    let mut lemmas = Lemmas::default();
    let all = words(&lemmas.terms);
    let conditions = conditions(&lemmas.terms);
    let mut results = all.clone();
    for &a in &all {
        let float = lemmas.terms.of_bits(a);
        lemmas.means(float.0, |s| format!("((_ to_fp 8 24) ((_ extract 31 0) {}))", s.word(a)));
        for (signed, function) in [(true, "to_fp"), (false, "to_fp_unsigned")] {
            let float = lemmas.terms.of_integer(signed, a);
            lemmas.means(float.0, |s| format!("((_ {function} 8 24) RNE ((_ extract 31 0) {}))", s.word(a)));
        }
        for &b in &all {
            for (operator, function) in OPERATORS {
                let result = lemmas.terms.apply(operator, Width::W32, a, b);
                lemmas.means(result.0, |s| narrow(function, &s.word(a), &s.word(b)));
                results.push(result);
            }
            for (signed, function) in [(false, "bvult"), (true, "bvslt")] {
                let result = lemmas.terms.below(signed, Width::W32, a, b);
                lemmas.truth(result, |s| {
                    format!("({function} ((_ extract 31 0) {}) ((_ extract 31 0) {}))", s.word(a), s.word(b))
                });
            }
            let result = lemmas.terms.same(Width::W32, a, b);
            lemmas.truth(result, |s| format!("(= {} {})", s.word(a), s.word(b)));
            for &condition in &conditions[..4] {
                let result = lemmas.terms.choose_word(condition, a, b);
                lemmas.means(result.0, |s| format!("(ite {} {} {})", s.truth(condition), s.word(a), s.word(b)));
            }
        }
    }
    results.sort_unstable();
    results.dedup();
    for word in results {
        let few = all.contains(&word);
        for set in &SETS[..if few { SETS.len() } else { 1 }] {
            let result = lemmas.terms.within(word, Width::W32, set);
            lemmas.truth(result, |s| inside(&s.word(word), set));
        }
    }
    lemmas
}

fn words_of_64_bits() -> Lemmas {
    let mut lemmas = Lemmas::default();
    let all = {
        let terms = &lemmas.terms;
        let [c, _, d, less, ..] = conditions(terms)[..] else { unreachable!() };
        let apply = |operator, a, b| terms.apply(operator, Width::W64, a, b);
        let [u, v] = [opaque(terms, 8), opaque(terms, 10)];
        let number = |number| terms.number(number);
        use Operator::{Add, And, Multiply, Or, ShiftLeft, ShiftRight, Subtract, Xor};
        let w = apply(Or, apply(ShiftLeft, u, number(32)), v);
        let half = number(1 << 63);
        vec![
            number(0),
            number(1),
            number(u64::MAX),
            number(0xffff_ffff),
            half,
            number(63),
            number(5),
            u,
            w,
            terms.apply(Add, Width::W32, u, number(5)),
            terms.apply(Xor, Width::W32, u, number(0xffff_ffff)),
            apply(Add, w, number(5)),
            apply(Xor, w, number(u64::MAX)),
            apply(Xor, w, half),
            apply(And, w, number(u64::MAX >> 1)),
            apply(And, w, number(0xffff_ffff)),
            apply(ShiftRight, w, number(5)),
            apply(Subtract, w, u),
            apply(Multiply, u, v),
            terms.choose_word(c, w, v),
            terms.choose_word(c, number(u64::MAX), number(0)),
            terms.choose_word(d, w, number(0)),
            terms.choose_word(less, number(5), number(1)),
        ]
    };
    let sets: [&[(u64, u64)]; 4] =
        [&[(1 << 63, u64::MAX)], &[(0, 0)], &[(3, 9), (1 << 40, 1 << 63)], &[(0, 0xffff_ffff), (1 << 33, u64::MAX)]];
    for &a in &all {
        for &b in &all {
            for (operator, function) in OPERATORS {
                let result = lemmas.terms.apply(operator, Width::W64, a, b);
                lemmas.means(result.0, |s| format!("({function} {} {})", s.word(a), s.word(b)));
                for set in &sets[..2] {
                    let within = lemmas.terms.within(result, Width::W64, set);
                    lemmas.truth(within, |s| inside(&s.word(result), set));
                }
            }
            for (signed, function) in [(false, "bvult"), (true, "bvslt")] {
                let result = lemmas.terms.below(signed, Width::W64, a, b);
                lemmas.truth(result, |s| format!("({function} {} {})", s.word(a), s.word(b)));
            }
            let result = lemmas.terms.same(Width::W64, a, b);
            lemmas.truth(result, |s| format!("(= {} {})", s.word(a), s.word(b)));
        }
        for set in sets {
            let within = lemmas.terms.within(a, Width::W64, set);
            lemmas.truth(within, |s| inside(&s.word(a), set));
        }
    }
    lemmas
}

fn truth_values() -> Lemmas {
    let mut lemmas = Lemmas::default();
    let all = {
        let terms = &lemmas.terms;
        let mut all = conditions(terms);
        let [c, d, less] = [all[0], all[2], all[3]];
        all.extend([Terms::TRUE, Terms::FALSE, terms.or(c, d), terms.choose(c, d, less), terms.choose(d, less, !less)]);
        all.extend([terms.all([c, d, less]), !terms.all([!c, d, less])]);
        all
    };
    for &a in &all {
        for &b in &all {
            let (both, either) = (lemmas.terms.and(a, b), lemmas.terms.or(a, b));
            lemmas.truth(both, |s| format!("(and {} {})", s.truth(a), s.truth(b)));
            lemmas.truth(either, |s| format!("(or {} {})", s.truth(a), s.truth(b)));
            for &c in &all {
                let chosen = lemmas.terms.choose(a, b, c);
                lemmas.truth(chosen, |s| format!("(ite {} {} {})", s.truth(a), s.truth(b), s.truth(c)));
                let left = lemmas.terms.restricted(a, &[b, c]);
                lemmas.claim(|s| {
                    let (a, b, c) = (s.truth(a), s.truth(b), s.truth(c));
                    format!("(=> (and {b} {c}) (= {} {a}))", s.truth(left))
                });
            }
        }
    }
    lemmas
}

/// Whole numbers by exhaustion: every rule for every value of three counts.
#[test]
fn whole_numbers() {
    use std::cmp::Ordering::{Equal, Less};
    let terms = Terms::new();
    let ranges = [[-20, 20], [0, 5], [3, 4]];
    let [k, l, m] = [0, 1, 2].map(|index: u32| terms.counted(index, ranges[index as usize]));
    let (c, negative) = (terms.at_most(terms.source(3), terms.constant(0.0)), terms.less(k, terms.whole(0)));
    let twice = terms.multiply(k, terms.whole(2));
    let mut all = vec![k, l, m];
    all.extend([-3, -1, 0, 1, 2, 4, 7].map(|value| terms.whole(value)));
    all.extend([
        terms.add(k, l),
        terms.subtract(k, l),
        terms.subtract(k, terms.whole(3)),
        terms.add(twice, terms.whole(1)),
        terms.subtract(terms.whole(6), terms.multiply(k, terms.whole(3))),
        terms.multiply(k, l),
        terms.divide(k, l),
        terms.divide(k, m),
        terms.divide(m, k),
        terms.remainder(k, m),
        terms.shifted(k, 4),
        terms.shifted(terms.negate(k), 4),
        terms.rounded_down(k, m),
        terms.magnitude(k),
        terms.choose_float(terms.less(k, l), k, l),
        terms.choose_float(c, k, m),
        terms.choose_float(negative, terms.negate(k), k),
    ]);
    let facts = [terms.less(k, l), negative, c, terms.at_most(l, terms.whole(2)), terms.at_most(twice, m)];
    let held = facts.iter().flat_map(|&fact| [fact, !fact]);
    let held: Vec<[Bool; 2]> = held.clone().flat_map(|a| held.clone().map(move |b| [a, b])).collect();
    type Meaning = fn(i64, i64) -> Option<i64>;
    type Made<T> = fn(&Terms, Float, Float) -> T;
    let numbers: [(Made<Float>, Meaning); 9] = [
        (|terms, a, b| terms.add(a, b), |a, b| Some(a + b)),
        (|terms, a, b| terms.subtract(a, b), |a, b| Some(a - b)),
        (|terms, a, b| terms.multiply(a, b), |a, b| Some(a * b)),
        (|terms, a, b| terms.divide(a, b), |a, b| Some(a.checked_div(b).unwrap_or(0))),
        (|terms, a, b| terms.remainder(a, b), |a, b| Some(a.checked_rem(b).unwrap_or(a))),
        (
            |terms, a, b| terms.rounded_down(a, b),
            |a, b| (b != 0).then(|| if b > 0 { a.div_euclid(b) } else { (-a).div_euclid(-b) }),
        ),
        (|terms, a, _| terms.negate(a), |a, _| Some(-a)),
        (|terms, a, _| terms.magnitude(a), |a, _| Some(a.abs())),
        (|terms, a, _| terms.shifted(a, 8), |a, _| Some(a.div_euclid(8))),
    ];
    let truths: [(Made<Bool>, &[std::cmp::Ordering]); 3] = [
        (|terms, a, b| terms.at_most(a, b), &[Less, Equal]),
        (|terms, a, b| terms.less(a, b), &[Less]),
        (|terms, a, b| terms.equal(b, a), &[Equal]),
    ];
    let pairs: Vec<_> = all.iter().flat_map(|&a| all.iter().map(move |&b| (a, b))).collect();
    let results = numbers.map(|(made, _)| pairs.iter().map(|&(a, b)| made(&terms, a, b)).collect::<Vec<_>>());
    let relations = truths.map(|(made, _)| pairs.iter().map(|&(a, b)| made(&terms, a, b)).collect::<Vec<_>>());
    let distinct: std::collections::BTreeSet<_> = results.iter().flatten().copied().collect();
    let intervals: Vec<_> = (distinct.iter())
        .map(|&number| held.iter().map(|facts| terms.interval_under(number, facts)).collect::<Vec<_>>())
        .collect();
    terms.complete(String::new).expect("nothing is left out");
    let mut evaluator = Evaluator::default();
    let values = |at: usize| ranges[at][0] as i32..=ranges[at][1] as i32;
    for (k, l, m, c) in values(0)
        .flat_map(|k| values(1).flat_map(move |l| values(2).flat_map(move |m| [-1.0_f32, 1.0].map(|c| (k, l, m, c)))))
    {
        evaluator.set(&[k as u32, l as u32, m as u32, c.to_bits()]);
        let mut value = |number: Float| evaluator.value(&terms, number.0) as i64;
        for (results, (_, meaning)) in results.iter().zip(numbers) {
            for (&(a, b), &result) in pairs.iter().zip(results) {
                let (a, b, found) = (value(a), value(b), value(result));
                assert_eq!(found, meaning(a, b).unwrap_or(found), "{result:?} of {a} and {b}");
            }
        }
        let known: Vec<_> = distinct.iter().map(|&number| i128::from(value(number))).collect();
        let holds: Vec<_> = held.iter().map(|facts| facts.iter().all(|&fact| evaluator.truth(&terms, fact))).collect();
        for (relations, (_, orderings)) in relations.iter().zip(truths) {
            for (&(a, b), &relation) in pairs.iter().zip(relations) {
                let (a, b) = (evaluator.value(&terms, a.0) as i64, evaluator.value(&terms, b.0) as i64);
                assert_eq!(evaluator.truth(&terms, relation), orderings.contains(&a.cmp(&b)), "{a} and {b}");
            }
        }
        for (&number, intervals) in known.iter().zip(&intervals) {
            for (interval, _) in intervals.iter().zip(&holds).filter(|(_, holds)| **holds) {
                let [low, high] = interval.expect("the facts hold");
                assert!(low <= number && number <= high, "{number} in {low} to {high}");
            }
        }
    }
}

/// What the order of floats excludes: two comparisons that share a number, where a third one holds.
fn orders() -> Lemmas {
    let mut lemmas = Lemmas::default();
    let all = {
        let terms = &lemmas.terms;
        let [x, y, z] = [0, 1, 2].map(|index| terms.source(index));
        let [zero, one, two] = [0.0, 1.0, 2.0].map(|value| terms.constant(value));
        let mut all: Vec<_> = [0, 1, 0x3f80_0000, 0xbf80_0000, 0x7f7f_ffff, 0x7f80_0000, 0xff80_0000, 0x7fc0_0000]
            .map(|bits| terms.constant_bits(bits))
            .into();
        all.extend([x, y, z, terms.negate(x), terms.negate(y), terms.magnitude(x), terms.add(x, zero)]);
        all.extend([terms.subtract(x, y), terms.subtract(y, x), terms.add(x, y), terms.add(x, one)]);
        all.extend([terms.multiply(x, two), terms.multiply(x, y), terms.divide(x, y), terms.divide(x, zero)]);
        all
    };
    for &a in &all {
        for &b in &all {
            for &c in &all {
                let [first, second, third] = [(a, b), (b, c), (c, a)].map(|(a, b)| lemmas.terms.at_most(a, b));
                for assumed in [Terms::TRUE, third] {
                    let sides = [[first, !first], [second, !second]];
                    let found = together(&lemmas.terms, assumed, [&sides[0], &sides[1]], 1 << 12).expect("few cases");
                    for (p, q) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                        let [left, right] = [sides[0][p], sides[1][q]];
                        if !found.pairs.contains(&(p, q)) && ![assumed, left, right].contains(&Terms::FALSE) {
                            lemmas.claim(|s| {
                                format!("(not (and {} {} {}))", s.truth(assumed), s.truth(left), s.truth(right))
                            });
                        }
                    }
                }
            }
        }
    }
    lemmas
}

/// Every claim is one that the solver has proven: `cargo xtask lemmas` asks it anew.
#[test]
fn every_rule_is_proven() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/lemmas");
    let place = folder.join("proven.txt");
    let subjects: [(&str, fn() -> Lemmas); 6] = [
        ("truth values", truth_values),
        ("words of 32 bits", words_of_32_bits),
        ("words of 64 bits", words_of_64_bits),
        ("arithmetic", arithmetic),
        ("comparisons", comparisons),
        ("orders", orders),
    ];
    let mut text = String::new();
    for (subject, lemmas) in subjects {
        let scripts = lemmas().scripts;
        let sum: String = Sha256::digest(scripts.concat()).iter().map(|byte| format!("{byte:02x}")).collect();
        text += &format!("{subject}: {} claims, SHA-256 {sum}\n", scripts.len());
        let Some(python) = std::env::var_os("TPG_SOLVER") else { continue };
        let folder_of_scripts = tempfile::tempdir().expect("a folder");
        let file = folder_of_scripts.path().join("claims.smt2");
        std::fs::write(&file, scripts.join(";\n")).expect("it can be written");
        let began = Instant::now();
        let solver = Command::new(python).arg(folder.join("solve.py")).arg(file).output().expect("the solver starts");
        let answers = String::from_utf8_lossy(&solver.stdout);
        assert_eq!(answers.lines().count(), scripts.len(), "{}", String::from_utf8_lossy(&solver.stderr));
        for (script, answer) in scripts.iter().zip(answers.lines()) {
            assert_eq!(answer, "unsat", "{subject}\n{script}");
        }
        println!("{subject}: {} claims proven in {:.0?}", scripts.len(), began.elapsed());
    }
    if std::env::var_os("TPG_SOLVER").is_some() {
        std::fs::write(&place, &text).expect("it can be written");
    }
    let proven = std::fs::read_to_string(place).expect("what is proven");
    assert_eq!(text, proven, "rules or claims have changed: run `cargo xtask lemmas`");
}
