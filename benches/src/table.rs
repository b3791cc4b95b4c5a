//! Tables of measurements: a row for each subject and a column for each variant, followed by a summary for each kind of
//! subject.

use crate::subject::SubjectKind;
use crate::variant::Variant;
use tpg_paper::table::markdown::grid;

/// A number for each subject and variant; lower is better.
#[derive(Clone, Debug, Default)]
pub struct BenchTable {
    title: String,
    rows: Vec<BenchRow>,
}

#[derive(Clone, Debug)]
struct BenchRow {
    name: String,
    kind: SubjectKind,
    numbers: [Option<f64>; Variant::ALL.len()],
}

impl BenchTable {
    /// Creates an empty table.
    pub fn new(title: &str) -> Self {
        Self { title: title.to_owned(), rows: Vec::new() }
    }

    /// Records a number of a subject, by its name.
    pub fn note(&mut self, name: &str, kind: SubjectKind, variant: Variant, number: f64) {
        let place = self.rows.iter().position(|row| row.name == name).unwrap_or_else(|| {
            self.rows.push(BenchRow { name: name.to_owned(), kind, numbers: [None; Variant::ALL.len()] });
            self.rows.len() - 1
        });
        self.rows[place].numbers[column(variant)] = Some(number);
    }

    /// Renders the numbers, each with the baseline's number (first column) divided by it.
    pub fn render(&self) -> String {
        let row = |BenchRow { name, numbers, .. }: &BenchRow| {
            let cell = |number: &Option<f64>| {
                let ratio = numbers[0].zip(*number).map(|(yardstick, number)| yardstick / number);
                number.zip(ratio).map_or("–".to_owned(), |(n, ratio)| format!("{n:.1} ({ratio:.2})"))
            };
            [name.clone()].into_iter().chain(numbers.iter().map(cell)).collect::<Vec<String>>()
        };
        let names: Vec<String> = ["policy".to_owned()].into_iter().chain(Variant::ALL.map(Variant::name)).collect();
        format!("\n{}\n\n{}\n", self.title, grid(&names, self.rows.iter().map(row)))
    }

    /// Summarises the ratio of the baseline's numbers to a variant's, by kind of policy: geometric mean, minimum and
    /// maximum.
    pub fn summary(&self, yardstick: Variant) -> String {
        let others = || Variant::ALL.into_iter().filter(|&variant| variant != yardstick);
        let groups: [(&str, &[SubjectKind]); 4] = [
            ("of the paper, as trained", &[SubjectKind::Trained]),
            ("of the paper, pruned", &[SubjectKind::Pruned]),
            ("of the paper", &[SubjectKind::Trained, SubjectKind::Pruned]),
            ("this project's", &[SubjectKind::Own]),
        ];
        let row = |(name, kinds): (&str, &[SubjectKind])| {
            let rows: Vec<&BenchRow> = self.rows.iter().filter(|row| kinds.contains(&row.kind)).collect();
            let cell = |variant| ratios(&rows, yardstick, variant).unwrap_or_else(|| "–".to_owned());
            let cells = [format!("{} {name}", rows.len())].into_iter().chain(others().map(cell));
            (!rows.is_empty()).then(|| cells.collect::<Vec<String>>())
        };
        let names: Vec<String> = ["policies".to_owned()].into_iter().chain(others().map(Variant::name)).collect();
        let table = grid(&names, groups.into_iter().filter_map(row));
        format!("\n{}: {} over\n\n{table}\n", self.title, yardstick.name())
    }
}

fn column(variant: Variant) -> usize {
    Variant::ALL.iter().position(|&other| other == variant).expect("one of all")
}

/// Computes the ratios of one variant's numbers to another's: mean, least and most; `None` if no row has both numbers.
fn ratios(rows: &[&BenchRow], yardstick: Variant, variant: Variant) -> Option<String> {
    let (top, bottom) = (column(yardstick), column(variant));
    let ratios: Vec<f64> = rows.iter().filter_map(|row| Some(row.numbers[top]? / row.numbers[bottom]?)).collect();
    let mean = (ratios.iter().map(|ratio| ratio.ln()).sum::<f64>() / ratios.len() as f64).exp();
    let least = ratios.iter().copied().reduce(f64::min)?;
    let most = ratios.iter().copied().reduce(f64::max)?;
    Some(format!("**{mean:.2}** ({least:.2} to {most:.2})"))
}

#[cfg(test)]
mod tests {
    use super::BenchTable;
    use crate::subject::SubjectKind;
    use crate::variant::Variant;
    use tpg_codegen::emit::{Language, Profile};

    #[test]
    fn ratios_are_to_the_yardstick_and_their_mean_is_geometric() {
        let fast = Variant::Generated(Language::C, Profile::Fast);
        let mut table = BenchTable::new("nanoseconds");
        for (name, gegelati, number) in [("a", 20.0, 10.0), ("b", 80.0, 10.0)] {
            table.note(name, SubjectKind::Own, Variant::Gegelati, gegelati);
            table.note(name, SubjectKind::Own, fast, number);
        }
        let text = table.render();
        assert!(text.contains("| a | 20.0 (1.00) | – | 10.0 (2.00) |"), "{text}");
        let text = table.summary(Variant::Gegelati);
        assert!(text.contains("| 2 this project's | – | **4.00** (2.00 to 8.00) |"), "{text}");
        assert!(table.summary(fast).contains("**0.25** (0.12 to 0.50)"));
    }
}
