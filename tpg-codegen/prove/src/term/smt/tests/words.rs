//! Claims about words.

use super::super::super::{Operator, Terms, Width, Word};
use super::{Lemmas, conditions, opaque};

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
        apply(Or, u, terms.number(0x7fc0_0000)),
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

pub(super) fn words_of_32_bits() -> Lemmas {
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

pub(super) fn words_of_64_bits() -> Lemmas {
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
