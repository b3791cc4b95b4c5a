//! Rules of whole numbers.

use super::super::super::evaluate::Evaluator;
use super::super::super::{Bool, Float, Terms};

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
