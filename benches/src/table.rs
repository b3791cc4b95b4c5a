//! What was measured, as a table: a row for each subject, a column for each variant.

use crate::variant::Variant;
use std::fmt::Write as _;

/// A number for each subject and variant: less is better.
#[derive(Clone, Debug, Default)]
pub struct Table {
    title: String,
    rows: Vec<(String, Vec<Option<f64>>)>,
}

impl Table {
    /// An empty table.
    pub fn new(title: &str) -> Self {
        Self { title: title.to_owned(), rows: Vec::new() }
    }

    /// Notes a number.
    pub fn note(&mut self, subject: &str, variant: Variant, number: f64) {
        let column = Variant::ALL.iter().position(|&other| other == variant).expect("one of all");
        if !self.rows.iter().any(|(name, _)| name == subject) {
            self.rows.push((subject.to_owned(), vec![None; Variant::ALL.len()]));
        }
        if let Some((_, numbers)) = self.rows.iter_mut().find(|(name, _)| name == subject) {
            numbers[column] = Some(number);
        }
    }

    /// The numbers, and how many times each variant has the yardstick's: the first column's number over its own.
    pub fn render(&self) -> String {
        let mut text = format!("\n{}\n\n|", self.title);
        for name in std::iter::once("policy".to_owned()).chain(Variant::ALL.map(Variant::name)) {
            let _ = write!(text, " {name} |");
        }
        let _ = writeln!(text, "\n|{}", " --- |".repeat(1 + Variant::ALL.len()));
        for (name, numbers) in &self.rows {
            let _ = write!(text, "| {name} |");
            for number in numbers {
                let ratio = numbers[0].zip(*number).map(|(yardstick, number)| yardstick / number);
                let cell = number.zip(ratio).map_or("–".to_owned(), |(n, ratio)| format!("{n:.1} ({ratio:.2})"));
                let _ = write!(text, " {cell} |");
            }
            text.push('\n');
        }
        let _ = write!(text, "| geometric mean of the ratios, worst to best |");
        for column in 0..Variant::ALL.len() {
            let cell = self.ratios(column).map_or("–".to_owned(), |Ratios { mean, least, greatest }| {
                format!("**{mean:.2}** ({least:.2} to {greatest:.2})")
            });
            let _ = write!(text, " {cell} |");
        }
        text.push('\n');
        text
    }

    /// How a variant compares with the yardstick; `None` without a subject that has both.
    fn ratios(&self, column: usize) -> Option<Ratios> {
        let ratios: Vec<f64> =
            self.rows.iter().filter_map(|(_, numbers)| Some(numbers[0]? / numbers[column]?)).collect();
        let mean = (ratios.iter().map(|ratio| ratio.ln()).sum::<f64>() / ratios.len() as f64).exp();
        let least = ratios.iter().copied().reduce(f64::min)?;
        let greatest = ratios.iter().copied().reduce(f64::max)?;
        Some(Ratios { mean, least, greatest })
    }
}

struct Ratios {
    mean: f64,
    least: f64,
    greatest: f64,
}

#[cfg(test)]
mod tests {
    use super::Table;
    use crate::variant::Variant;
    use tpg_codegen::emit::{Language, Profile};

    #[test]
    fn ratios_are_to_the_yardstick_and_their_mean_is_geometric() {
        let fast = Variant::Generated(Language::C, Profile::Fast);
        let mut table = Table::new("nanoseconds");
        for (name, gegelati, number) in [("a", 20.0, 10.0), ("b", 80.0, 10.0)] {
            table.note(name, Variant::Gegelati, gegelati);
            table.note(name, fast, number);
        }
        let text = table.render();
        assert!(text.contains("| a | 20.0 (1.00) | – | 10.0 (2.00) |"), "{text}");
        assert!(text.contains("**4.00** (2.00 to 8.00)"), "{text}");
    }
}
