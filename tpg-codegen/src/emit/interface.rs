//! The sources of a state and the outputs of an answer as generated code documents them.

use super::block::unused;
use super::c::field::field;
use super::file::comment;
use super::integers::{with_unit, worth, worth_from};
use super::names;
use super::syntax::Syntax;
use std::collections::BTreeSet;
use tpg_graph::{ActionDocument, Graph, Output, SourceDocument};

/// A source.
pub(super) struct SourceView {
    pub(super) name: String,
    /// The field of C's struct.
    pub(super) field: String,
    /// The places of its values in a flat state: from the first to the one behind the last.
    pub(super) first: usize,
    pub(super) end: usize,
    pub(super) length: usize,
    /// The type of a value.
    pub(super) kind: String,
    /// The unit and the range; of counts, the worth of one.
    pub(super) meaning: String,
}

impl SourceView {
    /// The member of C's struct: a value, or an array of more than one.
    pub(super) fn member(&self) -> String {
        if self.length == 1 { self.field.clone() } else { format!("{}[{}]", self.field, self.length) }
    }
}

/// Every source, its unit made safe for a comment, with the type of its values.
pub(super) fn sources(
    graph: &Graph,
    safe: impl Fn(&str) -> String,
    kind: impl Fn(&SourceDocument) -> String,
) -> Vec<SourceView> {
    let mut end = 0;
    (graph.sources().iter())
        .map(|source| {
            let length = source.ranges.len();
            end += length;
            SourceView {
                name: source.name.clone(),
                field: field(graph, &source.name),
                first: end - length,
                end,
                length,
                kind: kind(source),
                meaning: meaning_of(source, &safe(&source.unit)),
            }
        })
        .collect()
}

/// The constant of each action, and its name where the constant does not say it.
pub(super) fn actions(graph: &Graph, upper: &str) -> Vec<(String, String)> {
    let said = |(action, name): (&ActionDocument, String)| {
        let shown = comment(&action.to_string());
        (format!("{upper}_{}", name.to_ascii_uppercase()), if shown == name { String::new() } else { shown })
    };
    graph.actions().iter().zip(names::actions(graph)).map(said).collect()
}

/// The name in capitals of the policy that each asking action asks, and the action's number.
pub(super) fn asks(graph: &Graph) -> Vec<(String, usize)> {
    let actions = graph.actions().iter().enumerate();
    actions.filter_map(|(number, action)| Some((action.ask.as_ref()?.to_ascii_uppercase(), number))).collect()
}

/// An output.
pub(super) struct OutputView {
    pub(super) name: String,
    /// The field of C's struct.
    pub(super) field: String,
    /// The type of its value.
    pub(super) kind: String,
    /// The unit and the range; of counts, the worth of one.
    pub(super) meaning: String,
    pub(super) nan: f64,
    /// The literal of that value, which is a memory's first.
    pub(super) initial: String,
    /// Its place among the outputs.
    pub(super) place: usize,
    /// The literals of its lowest value, its highest, and the value in place of NaN.
    pub(super) limits: [String; 3],
    /// The variable that holds its value before it is limited.
    pub(super) variable: String,
}

/// Every output, its unit made safe for a comment, with the type of its value.
pub(super) fn outputs(
    syntax: &impl Syntax,
    safe: impl Fn(&str) -> String,
    kind: impl Fn(&Output) -> String,
) -> Vec<OutputView> {
    let mut taken = BTreeSet::new();
    (syntax.graph().outputs().iter().enumerate())
        .map(|(place, output @ Output { name, unit, range, nan, counts })| OutputView {
            name: name.clone(),
            field: field(syntax.graph(), name),
            kind: kind(output),
            meaning: match counts {
                Some(counts) => {
                    let [low, high] = [range.min, range.max]
                        .map(|end| format!("{end} ({})", with_unit(&counts.value(end).to_string(), &safe(unit))));
                    format!("{}: {low} to {high}", worth(counts.scale, &safe(unit)))
                }
                None => meaning(&safe(unit), &written(&[range.min, range.max])),
            },
            nan: *nan,
            initial: syntax.literal(*nan),
            place,
            limits: [range.min, range.max, *nan].map(|limit| syntax.literal(limit)),
            variable: unused(syntax.local(name), &mut taken),
        })
        .collect()
}

/// A unit, if there is one, and a range.
fn meaning(unit: &str, range: &str) -> String {
    if unit.is_empty() { range.to_owned() } else { format!("{unit}, {range}") }
}

/// The unit of a source, and its range; of counts, what one is worth.
fn meaning_of(source: &SourceDocument, unit: &str) -> String {
    match &source.counts[..] {
        [] => meaning(unit, &range(&source.ranges)),
        counts => {
            let worth = common(counts.iter().map(|counts| worth_from(counts, unit)).collect());
            format!("{worth}: {}", range(&source.ranges))
        }
    }
}

/// The common range of the values, or if ranges differ, each value's own in order.
fn range(ranges: &[[f64; 2]]) -> String {
    common(ranges.iter().map(written).collect())
}

/// The text that all values have, or each value's own in order.
fn common(mut texts: Vec<String>) -> String {
    if texts.iter().all(|text| *text == texts[0]) {
        texts.truncate(1);
    }
    texts.join("; ")
}

/// A range in as few digits as tell its ends from other numbers: of the type `f32`, if they are such.
pub(crate) fn written(&[low, high]: &[f64; 2]) -> String {
    let number = |end: f64| {
        let narrow = end as f32;
        if f64::from(narrow) == end { (narrow + 0.0).to_string() } else { end.to_string() }
    };
    format!("{} to {}", number(low), number(high))
}

#[cfg(test)]
mod tests {
    use super::range;

    #[test]
    fn each_value_has_its_own_range_where_they_differ() {
        let between = |min, max| [min, max];
        assert_eq!(range(&[between(-1.0, 1.0)]), "-1 to 1");
        assert_eq!(range(&[between(-1.0, 1.0), between(-1.0, 1.0)]), "-1 to 1");
        assert_eq!(range(&[between(-1.0, 1.0), between(-0.0, 2.5)]), "-1 to 1; 0 to 2.5");
    }

    #[test]
    fn a_range_has_the_digits_that_it_needs() {
        let text = |min, max| super::meaning("", &range(&[[min, max]]));
        assert_eq!(text(f64::from(-4.8_f32), f64::from(4.8_f32)), "-4.8 to 4.8");
        assert_eq!(text(-4.8, 4.8), "-4.8 to 4.8");
        assert_eq!(text(0.1, 1e6), "0.1 to 1000000");
    }
}
