//! Claims about floats and their order.

use super::super::super::{Arithmetic, Float, Terms};
use super::super::Script;
use super::{Bool, Lemmas, conditions, opaque};
use crate::order::together;

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

/// `fmod` by the remainder of IEEE 754, which is nearest to 0. For constants only: it is hard to solve.
fn fmod(a: &str, b: &str) -> String {
    let rem = format!("(fp.rem (fp.abs {a}) (fp.abs {b}))");
    let positive = format!(
        "(ite (fp.isNegative {rem}) (ite (fp.isZero {rem}) (_ +zero 8 24) (fp.add RNE {rem} (fp.abs {b}))) {rem})"
    );
    format!("(ite (fp.isNegative {a}) (fp.neg {positive}) {positive})")
}

pub(super) fn arithmetic() -> Lemmas {
    let mut lemmas = Lemmas::default();
    let all = floats(&lemmas.terms);
    for &a in &all {
        let (negated, magnitude, zero_free) =
            (lemmas.terms.negate(a), lemmas.terms.magnitude(a), lemmas.terms.zero_free(a));
        lemmas.means(negated.0, |s| format!("(fp.neg {})", s.number(a)));
        lemmas.means(magnitude.0, |s| format!("(fp.abs {})", s.number(a)));
        let root = lemmas.terms.root(a);
        lemmas.means(root.0, |s| format!("(fp.sqrt RNE {})", s.number(a)));
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

/// Makes a term of two floats.
type Made<T> = fn(&Terms, Float, Float) -> T;

pub(super) fn comparisons() -> Lemmas {
    let mut lemmas = Lemmas::default();
    let (all, conditions) = (floats(&lemmas.terms), conditions(&lemmas.terms));
    let comparisons: [(Made<Bool>, &str); 4] = [
        (Terms::at_most, "(or (fp.isNaN {a}) (fp.leq {a} {b}))"),
        (Terms::less, "(fp.lt {a} {b})"),
        (Terms::less_or_equal, "(fp.leq {a} {b})"),
        (Terms::equal, "(fp.eq {a} {b})"),
    ];
    let choices: [(Made<Float>, &str); 2] =
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

/// Pairs of comparisons that the order of floats excludes where a third one holds.
pub(super) fn orders() -> Lemmas {
    let mut lemmas = Lemmas::default();
    let mut asked = Vec::new();
    {
        let terms = &lemmas.terms;
        let [x, y, z] = [0, 1, 2].map(|index| terms.source(index));
        let [zero, one, two] = [0.0, 1.0, 2.0].map(|value| terms.constant(value));
        let nan = terms.constant(f32::NAN);
        let mut all: Vec<_> = [0, 1, 0x3f80_0000, 0xbf80_0000, 0x7f7f_ffff, 0x7f80_0000, 0xff80_0000, 0x7fc0_0000]
            .map(|bits| terms.constant_bits(bits))
            .into();
        let constants = all.clone();
        let sums = [terms.subtract(x, y), terms.subtract(y, x), terms.add(x, y), terms.add(x, one)];
        all.extend([x, y, z, terms.negate(x), terms.negate(y), terms.magnitude(x), terms.add(x, zero)]);
        all.extend([terms.multiply(x, two), terms.multiply(x, y), terms.divide(x, y), terms.divide(x, zero)]);
        all.extend(sums);
        // three numbers
        let pairs = all.iter().flat_map(|&a| all.iter().map(move |&b| (a, b)));
        asked.extend(pairs.flat_map(|(a, b)| all.iter().map(move |&c| [(a, b), (b, c), (c, a)])));
        // two numbers, and a sum beside a constant
        for pair in [(x, y), (y, x), (x, terms.negate(y)), (terms.negate(y), x), (x, x)] {
            for (sum, constant) in sums.iter().flat_map(|&sum| constants.iter().map(move |&constant| (sum, constant))) {
                asked.extend([[pair, (sum, constant), (pair.0, nan)], [pair, (constant, sum), (y, nan)]]);
            }
        }
    }
    for comparisons in asked {
        let [first, second, third] = comparisons.map(|(a, b)| lemmas.terms.at_most(a, b));
        let sides = [[first, !first], [second, !second]];
        for assumed in [Terms::TRUE, third, !third] {
            let found = together(&lemmas.terms, assumed, [&sides[0], &sides[1]], 1 << 12).expect("few cases");
            for (p, q) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let all = [assumed, sides[0][p], sides[1][q]];
                if !found.pairs.contains(&(p, q)) && !all.contains(&Terms::FALSE) {
                    lemmas.claim(|s| format!("(not (and {}))", all.map(|condition| s.truth(condition)).join(" ")));
                }
            }
        }
    }
    lemmas
}
