//! Tables of measurements: a row for each subject and a column for each variant, followed by a summary for each kind of
//! subject.

use crate::subject::{Kind, Subject};
use crate::variant::Variant;
use std::fmt::Write as _;

/// A number for each subject and variant; lower is better.
#[derive(Clone, Debug, Default)]
pub struct Table {
    title: String,
    rows: Vec<BenchRow>,
}

#[derive(Clone, Debug)]
struct BenchRow {
    name: String,
    kind: Kind,
    numbers: [Option<f64>; Variant::ALL.len()],
}

impl Table {
    /// Creates an empty table.
    pub fn new(title: &str) -> Self {
        Self { title: title.to_owned(), rows: Vec::new() }
    }

    /// Records a number.
    pub fn note(&mut self, subject: &Subject, variant: Variant, number: f64) {
        self.note_named(&subject.name, subject.kind, variant, number);
    }

    fn note_named(&mut self, name: &str, kind: Kind, variant: Variant, number: f64) {
        let place = self.rows.iter().position(|row| row.name == name).unwrap_or_else(|| {
            self.rows.push(BenchRow { name: name.to_owned(), kind, numbers: [None; Variant::ALL.len()] });
            self.rows.len() - 1
        });
        self.rows[place].numbers[column(variant)] = Some(number);
    }

    /// Renders the numbers, each with the baseline's number (first column) divided by it.
    pub fn render(&self) -> String {
        let mut text = format!("\n{}\n\n|", self.title);
        for name in std::iter::once("policy".to_owned()).chain(Variant::ALL.map(Variant::name)) {
            let _ = write!(text, " {name} |");
        }
        let _ = writeln!(text, "\n|{}", " --- |".repeat(1 + Variant::ALL.len()));
        for BenchRow { name, numbers, .. } in &self.rows {
            let _ = write!(text, "| {name} |");
            for number in numbers {
                let ratio = numbers[0].zip(*number).map(|(yardstick, number)| yardstick / number);
                let cell = number.zip(ratio).map_or("–".to_owned(), |(n, ratio)| format!("{n:.1} ({ratio:.2})"));
                let _ = write!(text, " {cell} |");
            }
            text.push('\n');
        }
        text
    }

    /// Summarises the ratio of the baseline's numbers to a variant's, by kind of policy: geometric mean, minimum and
    /// maximum.
    pub fn summary(&self, yardstick: Variant) -> String {
        let others = Variant::ALL.iter().filter(|&&variant| variant != yardstick);
        let mut text = format!("\n{}: {} over\n\n| policies |", self.title, yardstick.name());
        for variant in others.clone() {
            let _ = write!(text, " {} |", variant.name());
        }
        let _ = writeln!(text, "\n|{}", " --- |".repeat(Variant::ALL.len()));
        let paper = |kind| kind != Kind::Own;
        let groups: [(&str, &dyn Fn(Kind) -> bool); 4] = [
            ("of the paper, as trained", &|kind| kind == Kind::Trained),
            ("of the paper, pruned", &|kind| kind == Kind::Pruned),
            ("of the paper", &paper),
            ("this project's", &|kind| kind == Kind::Own),
        ];
        for (name, belongs) in groups {
            let rows: Vec<&BenchRow> = self.rows.iter().filter(|row| belongs(row.kind)).collect();
            if rows.is_empty() {
                continue;
            }
            let _ = write!(text, "| {} {name} |", rows.len());
            for &variant in others.clone() {
                let cell = Ratios::new(&rows, yardstick, variant).map_or("–".to_owned(), |ratios| ratios.to_string());
                let _ = write!(text, " {cell} |");
            }
            text.push('\n');
        }
        text
    }
}

fn column(variant: Variant) -> usize {
    Variant::ALL.iter().position(|&other| other == variant).expect("one of all")
}

/// Ratios of one variant's numbers to another's.
struct Ratios {
    mean: f64,
    least: f64,
    most: f64,
}

impl Ratios {
    /// Computes the ratios; `None` if no row has both numbers.
    fn new(rows: &[&BenchRow], yardstick: Variant, variant: Variant) -> Option<Self> {
        let (top, bottom) = (column(yardstick), column(variant));
        let ratios: Vec<f64> = rows.iter().filter_map(|row| Some(row.numbers[top]? / row.numbers[bottom]?)).collect();
        let mean = (ratios.iter().map(|ratio| ratio.ln()).sum::<f64>() / ratios.len() as f64).exp();
        let least = ratios.iter().copied().reduce(f64::min)?;
        let most = ratios.iter().copied().reduce(f64::max)?;
        Some(Self { mean, least, most })
    }
}

impl std::fmt::Display for Ratios {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { mean, least, most } = self;
        write!(f, "**{mean:.2}** ({least:.2} to {most:.2})")
    }
}

#[cfg(test)]
mod tests {
    use super::Table;
    use crate::subject::Kind;
    use crate::variant::Variant;
    use tpg_codegen::emit::{Language, Profile};

    #[test]
    fn ratios_are_to_the_yardstick_and_their_mean_is_geometric() {
        let fast = Variant::Generated(Language::C, Profile::Fast);
        let mut table = Table::new("nanoseconds");
        for (name, gegelati, number) in [("a", 20.0, 10.0), ("b", 80.0, 10.0)] {
            table.note_named(name, Kind::Own, Variant::Gegelati, gegelati);
            table.note_named(name, Kind::Own, fast, number);
        }
        let text = table.render();
        assert!(text.contains("| a | 20.0 (1.00) | – | 10.0 (2.00) |"), "{text}");
        let text = table.summary(Variant::Gegelati);
        assert!(text.contains("| 2 this project's | – | **4.00** (2.00 to 8.00) |"), "{text}");
        assert!(table.summary(fast).contains("**0.25** (0.12 to 0.50)"));
    }
}
