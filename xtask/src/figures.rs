//! Tables of the README and of the book, written from measured results: `docs/figures.toml`, and the PROVENANCE.md of each
//! shipped policy; and from the instructions that `c-harness/costs.toml` holds.
//!
//! A table is what a document holds between `<!-- table NAME -->` and `<!-- end -->`.

use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::path::Path;
use std::{fs, io};
use tpg_testing::library::top;

/// Documents with tables.
const DOCUMENTS: [&str; 3] = ["README.md", "docs/experiments.md", "docs/performance.md"];

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct FigureResults {
    tasks: Vec<FigureTask>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct FigureTask {
    /// The name in Gymnasium.
    id: String,
    /// The folder of the shipped policy under `generated/`.
    folder: String,
    /// What the shipped policy is.
    kind: String,
    /// Decimals of returns.
    decimals: usize,
    /// The return of the best published network.
    network: f64,
    /// Published returns with their sources.
    published: String,
    by_default: Option<Default>,
    linear: LinearFit,
    trees: Trees,
}

/// Trainings with default settings.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Default {
    /// The mean return of each seed.
    seeds: Vec<f64>,
    /// The commit of the trainer, and its date.
    trained_at: String,
    date: String,
    /// Steps asked for, if training ran on Gymnasium.
    steps: Option<String>,
    /// CPU seconds for a seed.
    cpu_s: Option<String>,
}

/// Weighted sums: return and bytes.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct LinearFit {
    random_search: (f64, u32),
    covariance: (f64, u32),
}

/// Decision trees that imitate the shipped policy: return and bytes.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Trees {
    leaves_16: (f64, u32),
    leaves_128: (f64, u32),
}

/// Figures of a shipped policy, as its PROVENANCE.md prints them.
struct ShippedFigures {
    mean: f64,
    interval: f64,
    minimum: String,
    bytes: String,
    instructions: String,
}

impl ShippedFigures {
    fn read(folder: &str) -> io::Result<Self> {
        let path = top().join("generated").join(folder).join("PROVENANCE.md");
        let text = fs::read_to_string(&path)?;
        let between = |text: &str, start: &str, end: &str| -> io::Result<String> {
            let found = text.split_once(start).and_then(|(_, rest)| rest.split_once(end));
            let found = found.ok_or_else(|| invalid(&path, &format!("no text between {start:?} and {end:?}")))?;
            Ok(found.0.trim().to_owned())
        };
        let result = between(&text, ": **", "**")?;
        let code = between(&text, "| C, profile `fast` |", "\n")?;
        let parts = result.split_once(" ± ").and_then(|(mean, rest)| Some((mean, rest.split_once(", minimum ")?)));
        let (mean, (interval, minimum)) =
            parts.ok_or_else(|| invalid(&path, &format!("{result:?} is no \"mean ± interval, minimum minimum\"")))?;
        let parsed = |text: &str| {
            let plain = text.replace('−', "-").replace(',', "");
            plain.parse().map_err(|_| invalid(&path, &format!("{text:?} is no number")))
        };
        Ok(Self {
            mean: parsed(mean)?,
            interval: parsed(interval)?,
            minimum: minimum.to_owned(),
            bytes: between(&code, "", " bytes")?,
            instructions: between(&code, "at most ", " instructions")?,
        })
    }
}

/// Instructions counted under QEMU: `c-harness/costs.toml`.
#[derive(Debug, Deserialize)]
struct Costs {
    cost: BTreeMap<String, Cost>,
}

#[derive(Debug, Deserialize)]
struct Cost {
    actions: u32,
    instructions: u32,
    worst: u32,
}

impl Costs {
    /// Returns the costs of the arm's policies in C: mean and maximum, from a fixed and from a random start.
    fn rows(&self) -> Vec<String> {
        let row = |(part, what): (&str, &str)| {
            let both = ["fs", "rs"].map(|start| &self.cost[&format!("{start} {part}")]);
            let [mean, worst] = [
                both.map(|cost| number(f64::from(cost.instructions) / f64::from(cost.actions), 0)),
                both.map(|cost| number(cost.worst.into(), 0)),
            ];
            format!("| {what} | {} | {} |", mean.join(" / "), worst.join(" / "))
        };
        [("graph", "graph"), ("network", "network"), ("hybrid", "hybrid, with its checks")].map(row).into()
    }
}

/// Reads a TOML file of the repository.
fn read<T: DeserializeOwned>(file: &str) -> io::Result<T> {
    let path = top().join(file);
    toml::from_str(&fs::read_to_string(&path)?).map_err(|error| invalid(&path, &error.to_string()))
}

fn invalid(path: &Path, what: &str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidData, format!("{}: {what}", path.display()))
}

/// Formats a number with a minus sign and separated thousands.
fn number(value: f64, decimals: usize) -> String {
    let text = format!("{:.decimals$}", value.abs());
    let (whole, fraction) = text.split_once('.').map_or((text.as_str(), ""), |(whole, fraction)| (whole, fraction));
    let mut grouped = String::new();
    for (at, digit) in whole.chars().enumerate() {
        if at > 0 && (whole.len() - at) % 3 == 0 {
            grouped.push(',');
        }
        grouped.push(digit);
    }
    let sign = if value < 0.0 && text.chars().any(|digit| ('1'..='9').contains(&digit)) { "−" } else { "" };
    if fraction.is_empty() { format!("{sign}{grouped}") } else { format!("{sign}{grouped}.{fraction}") }
}

/// Formats a return, a whole number without decimals.
fn round(value: f64, decimals: usize) -> String {
    number(value, if value == value.round() { 0 } else { decimals })
}

/// Formats a return of a rival, with no decimals from a thousand on.
fn brief(value: f64, decimals: usize) -> String {
    if value.abs() >= 1000.0 { number(value, 0) } else { round(value, decimals) }
}

fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// Returns half of the 95 % interval of a mean by Student's t.
fn interval(values: &[f64]) -> f64 {
    /// Quantiles 0.975 for 1, 2, … degrees of freedom.
    const STUDENT: [f64; 9] = [12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262];
    let center = mean(values);
    let freedom = values.len() - 1;
    let variance = values.iter().map(|value| (value - center).powi(2)).sum::<f64>() / freedom as f64;
    STUDENT[freedom - 1] * (variance / values.len() as f64).sqrt()
}

/// Formats the mean of seeds.
fn default_mean(task: &FigureTask, default: &Default) -> String {
    let whole = default.seeds.iter().any(|seed| seed.abs() >= 1000.0);
    number(mean(&default.seeds), if whole { 0 } else { task.decimals })
}

impl FigureResults {
    fn read() -> io::Result<Self> {
        let file = "docs/figures.toml";
        let results: Self = read(file)?;
        let mut seeds = results.tasks.iter().filter_map(|task| Some(task.by_default.as_ref()?.seeds.len()));
        match seeds.find(|count| !(2..=10).contains(count)) {
            Some(count) => Err(invalid(&top().join(file), &format!("{count} seeds; accepted: 2 to 10"))),
            None => Ok(results),
        }
    }

    /// Returns a table by its name, `None` if there is no such table.
    fn table(&self, name: &str) -> io::Result<Option<String>> {
        let (head, rows) = match name {
            "results" => (
                "| task | ours, by default | linear | best network | shipped policy | flash, bytes | instructions | form |\n\
                 | --- | --: | --: | --: | --: | --: | --: | --- |",
                self.of_each(overview)?,
            ),
            "default" | "default-python" => (
                "| task | steps | seeds | mean | CPU s per seed | trainer |\n| --- | --- | --- | --: | --- | --- |",
                self.trainings(name == "default-python"),
            ),
            "costs" => ("| C | mean | worst |\n| --- | --- | --- |", read::<Costs>("c-harness/costs.toml")?.rows()),
            "shipped" => (
                "| task | return | minimum | flash | instructions | published |\n| --- | --- | --: | --: | --: | --- |",
                self.of_each(shipped)?,
            ),
            "rivals" => (
                "| task | shipped | random search | covariance adaptation | 16 leaves | 128 leaves |\n\
                 | --- | --- | --- | --- | --- | --- |",
                self.of_each(rivals)?,
            ),
            _ => return Ok(None),
        };
        Ok(Some(format!("{head}\n{}", rows.join("\n"))))
    }

    /// Returns a row for each task and its shipped policy.
    fn of_each(&self, row: fn(&FigureTask, ShippedFigures) -> String) -> io::Result<Vec<String>> {
        self.tasks.iter().map(|task| Ok(row(task, ShippedFigures::read(&task.folder)?))).collect()
    }

    /// Returns trainings on Gymnasium, which are limited by steps, or those on this project's own simulators.
    fn trainings(&self, is_limited: bool) -> Vec<String> {
        let trained = self.tasks.iter().filter_map(|task| Some((task, task.by_default.as_ref()?)));
        let row = |(task, default): (&FigureTask, &Default)| {
            let precise = if mean(&default.seeds).abs() >= 1000.0 { 0 } else { task.decimals };
            format!(
                "| {} | {} | {} | {} ± {} | {} | {}, {} |",
                if is_limited { task.id.clone() } else { format!("`{}`", task.folder) },
                default.steps.as_deref().unwrap_or("–"),
                seeds(task, default),
                default_mean(task, default),
                number(interval(&default.seeds), precise),
                default.cpu_s.as_deref().unwrap_or("–"),
                default.trained_at,
                default.date
            )
        };
        trained.filter(|(_, default)| default.steps.is_some() == is_limited).map(row).collect()
    }
}

fn overview(task: &FigureTask, shipped: ShippedFigures) -> String {
    let ours = task.by_default.as_ref().map_or_else(|| "–".into(), |default| default_mean(task, default));
    let linear = brief(task.linear.random_search.0.max(task.linear.covariance.0), 1);
    let network = brief(task.network, 1);
    format!(
        "| {} | {ours} | {linear} | {network} | {} | {} | {} | {} |",
        task.id,
        round(shipped.mean, task.decimals),
        shipped.bytes,
        shipped.instructions,
        task.kind
    )
}

fn shipped(task: &FigureTask, shipped: ShippedFigures) -> String {
    let ShippedFigures { mean, interval, minimum, bytes, instructions } = shipped;
    let [mean, interval] = [mean, interval].map(|value| number(value, task.decimals));
    format!("| {} | {mean} ± {interval} | {minimum} | {bytes} | {instructions} | {} |", task.id, task.published)
}

fn rivals(task: &FigureTask, shipped: ShippedFigures) -> String {
    let (linear, trees) = (&task.linear, &task.trees);
    let rivals = [linear.random_search, linear.covariance, trees.leaves_16, trees.leaves_128]
        .map(|(value, bytes)| format!("{} ({})", brief(value, task.decimals), number(f64::from(bytes), 0)));
    let mean = round(shipped.mean, task.decimals);
    format!("| {} | {mean} ({}) | {} |", task.id, shipped.bytes, rivals.join(" | "))
}

fn seeds(task: &FigureTask, default: &Default) -> String {
    let whole = default.steps.is_some() && default.seeds.iter().all(|seed| *seed == seed.round());
    let decimals = if whole { 0 } else { task.decimals };
    default.seeds.iter().map(|seed| number(*seed, decimals)).collect::<Vec<_>>().join(", ")
}

/// Returns a document with its tables written anew.
fn rewritten(results: &FigureResults, path: &Path) -> io::Result<(String, String)> {
    let text = fs::read_to_string(path)?;
    let mut lines = text.lines();
    let mut written = String::new();
    while let Some(line) = lines.next() {
        written.push_str(line);
        written.push('\n');
        let Some(name) = line.strip_prefix("<!-- table ").and_then(|rest| rest.strip_suffix(" -->")) else { continue };
        let table = results.table(name)?.ok_or_else(|| invalid(path, &format!("no table is called {name:?}")))?;
        if !lines.any(|line| line == "<!-- end -->") {
            return Err(invalid(path, &format!("table {name:?} has no <!-- end -->")));
        }
        written.push_str(&format!("\n{table}\n\n<!-- end -->\n"));
    }
    Ok((text, written))
}

/// Writes the tables and prints the documents that changed.
///
/// # Errors
/// If a file cannot be read or written, or results are incomplete.
pub(crate) fn write() -> io::Result<()> {
    let results = FigureResults::read()?;
    for document in DOCUMENTS {
        let path = top().join(document);
        let (before, now) = rewritten(&results, &path)?;
        if before != now {
            fs::write(&path, now)?;
            println!("{}", path.display());
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_of_the_documents_are_those_of_the_results() {
        let results = FigureResults::read().expect("results");
        let tables: usize = DOCUMENTS
            .iter()
            .map(|document| {
                let (before, now) = rewritten(&results, &top().join(document)).expect("a document");
                assert_eq!(before, now, "{document} differs from its results: cargo xtask figures");
                before.matches("<!-- table ").count()
            })
            .sum();
        assert_eq!(tables, 6);
    }

    #[test]
    fn numbers_have_a_minus_sign_and_separated_thousands() {
        assert_eq!(number(-1_032.0, 0), "−1,032");
        assert_eq!(number(9_359.84, 1), "9,359.8");
        assert_eq!(number(-0.001, 2), "0.00");
        assert_eq!(brief(500.0, 2), "500");
    }

    #[test]
    fn an_interval_is_that_of_students_t() {
        // 2.776 * sqrt(2.5 / 5)
        assert!((interval(&[1.0, 2.0, 3.0, 4.0, 5.0]) - 1.963).abs() < 1e-3);
    }
}
