//! Renders `docs/results.md`.

use super::compiled::Times;
use super::paper::PRINTED;
use super::rows::Row;
use super::timing::Time;
use askama::Template;
use tpg_engine::Sample;
use tpg_engine::confidence;
use tpg_problems::arm::targets::Start;

/// All results of one problem.
#[derive(Debug)]
pub struct ProblemResults {
    /// Start of the episodes.
    pub start: Start,
    /// Number of test episodes.
    pub episodes: usize,
    /// The table.
    pub rows: Vec<Row>,
    /// Times of compiled code.
    pub times: Times,
}

impl ProblemResults {
    fn name(&self) -> &'static str {
        match self.start {
            Start::Fs => "fixed start",
            Start::Rs => "random start",
        }
    }
}

/// The page: its prose is `templates/results.md`, its tables are made here.
#[derive(Template)]
#[template(path = "results.md", escape = "none")]
struct MarkdownPage<'a> {
    problems: &'a [MarkdownSection],
    costs: String,
    ideas: String,
    printed: String,
}

/// The tables of one problem.
struct MarkdownSection {
    title: &'static str,
    episodes: usize,
    table: String,
}

/// Renders the file, with the results of `ideas` on validation episodes.
///
/// # Panics
/// Never: the template only puts text together.
pub fn page(problems: &[ProblemResults], ideas: &[Row]) -> String {
    let section = |problem: &ProblemResults| MarkdownSection {
        title: problem.name(),
        episodes: problem.episodes,
        table: table(&problem.rows, problem.episodes),
    };
    let sections: Vec<MarkdownSection> = problems.iter().map(section).collect();
    let page = MarkdownPage { problems: &sections, costs: costs(problems), ideas: effects(ideas), printed: printed() };
    page.render().expect("text is put together").trim_end().to_owned() + "\n"
}

/// Renders a table: the first column is text, the others are numbers.
pub fn grid<R: AsRef<[String]>>(names: &[impl AsRef<str>], rows: impl IntoIterator<Item = R>) -> String {
    let line = |cells: &[String]| format!("| {} |", cells.join(" | "));
    let head: Vec<String> = names.iter().map(|name| name.as_ref().to_owned()).collect();
    let rule: Vec<String> = (0..names.len()).map(|place| if place == 0 { "---" } else { "--:" }.to_owned()).collect();
    let rows = rows.into_iter().map(|row| line(row.as_ref()));
    [line(&head), line(&rule)].into_iter().chain(rows).collect::<Vec<_>>().join("\n")
}

fn number(spread: Sample, factor: f64, digits: usize, many: bool) -> String {
    let mean = factor * spread.mean;
    if many {
        format!("{mean:.digits$} ± {:.digits$}", factor * spread.deviation())
    } else {
        format!("{mean:.digits$}")
    }
}

fn thousands(value: f64) -> String {
    let digits = format!("{value:.0}");
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place) % 3 == 0 {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

fn table(rows: &[Row], episodes: usize) -> String {
    let names = [
        "policy",
        "success %",
        "collision %",
        "distance mm",
        "actions",
        "ns per action",
        "worst ns",
        "bytes, fast · small",
    ];
    let cells = |row: &Row| {
        let many = row.policies > 1;
        let name = if many { format!("{} ({})", row.name, row.policies) } else { row.name.clone() };
        let time = |part: fn(&Time) -> f64| row.time.as_ref().map_or("–".to_owned(), |time| thousands(part(time)));
        let bytes = row.bytes.map_or("–".to_owned(), |[fast, small]| {
            let fast_text = thousands(fast as f64);
            if fast == small { fast_text } else { format!("{fast_text} · {}", thousands(small as f64)) }
        });
        let [mut success, collision, distance, actions] = outcome(row);
        if !many {
            let [low, high] = confidence(row.success.mean, episodes).map(|end| 100.0 * end);
            success += &format!(" ({low:.1} to {high:.1})");
        }
        [name, success, collision, distance, actions, time(|time| time.mean), time(|time| time.worst), bytes]
    };
    grid(&names, rows.iter().map(cells))
}

/// Formats success and collisions in %, distance in mm, and actions.
fn outcome(row: &Row) -> [String; 4] {
    let many = row.policies > 1;
    [
        number(row.success, 100.0, 1, many),
        number(row.collision, 100.0, 1, many),
        number(row.distance, 1.0, 2, many),
        number(row.actions, 1.0, 0, many),
    ]
}

fn by_graph(row: &Row) -> String {
    row.by_graph.map_or("–".to_owned(), |ratio| number(ratio, 100.0, 0, row.policies > 1))
}

/// Tabulates the times of compiled code.
fn costs(problems: &[ProblemResults]) -> String {
    let times = |time: f64, by: f64| {
        let factor = time / by;
        if factor >= 10.0 { format!("{factor:.0} times") } else { format!("{factor:.1} times") }
    };
    let column = |problem: &ProblemResults| {
        let shipped = problem.times;
        let row = |name: &str| problem.rows.iter().find(|row| row.name == name);
        let episode =
            |name: &str, time: Time| thousands(row(name).map_or(0.0, |row| row.actions.mean) * time.mean / 1e3);
        let planner = problem.rows.first().and_then(|row| row.time);
        let of_the_paper = if problem.start == Start::Fs { "11" } else { "2.8" };
        [
            format!("{}; {}", thousands(shipped.tpg.mean), thousands(shipped.tpg_constant_time.mean)),
            thousands(shipped.reference.mean),
            format!("**{}** ({of_the_paper})", times(shipped.reference.mean, shipped.hybrid.mean)),
            times(shipped.sac.mean, shipped.hybrid.mean),
            planner.map_or("–".to_owned(), |planner| times(planner.mean, shipped.hybrid.mean)),
            format!("{}; {}", episode("**hybrid, shipped**", shipped.hybrid), episode("SAC, shipped", shipped.sac)),
        ]
    };
    const NAMES: [&str; 6] = [
        "graph alone; in constant time, ns",
        "the paper's network, 13-256-256-4 in `f32`, ns",
        "hybrid faster than the paper's network (the paper reports, corrected)",
        "hybrid faster than the small network alone",
        "hybrid faster than the planner",
        "a whole episode: hybrid; small network alone, µs",
    ];
    let columns: Vec<[String; 6]> = problems.iter().map(column).collect();
    let cell = |place: usize, row: usize| columns.get(place).map_or(String::new(), |column| column[row].clone());
    let rows = (0..NAMES.len()).map(|row| [NAMES[row].to_owned(), cell(0, row), cell(1, row)]);
    let title = |place: usize| problems.get(place).map_or("", ProblemResults::name);
    grid(&["times", title(0), title(1)], rows)
}

fn effects(rows: &[Row]) -> String {
    let cells = |row: &Row| {
        let [success, collision, distance, actions] = outcome(row);
        [row.name.clone(), success, collision, distance, actions, by_graph(row)]
    };
    grid(&["policy", "success %", "collision %", "distance mm", "actions", "by graph %"], rows.iter().map(cells))
}

/// Tabulates what the paper's own files say.
fn printed() -> String {
    let cells = |(name, fixed, random): &(&str, [&str; 3], [&str; 3])| {
        [name].into_iter().chain(fixed).chain(random).map(|cell| (*cell).to_owned()).collect::<Vec<String>>()
    };
    let names =
        ["policy", "fixed: distance mm", "success %", "collision %", "random: distance mm", "success %", "collision %"];
    grid(&names, PRINTED.iter().map(cells))
}
