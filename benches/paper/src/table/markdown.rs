//! Renders `docs/results.md`.

use super::compiled::Times;
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

/// The page: its prose is `templates/results.md`, its tables are made here.
#[derive(Template)]
#[template(path = "results.md", escape = "none")]
struct MarkdownPage<'a> {
    problems: &'a [MarkdownSection],
    ideas: String,
}

/// The table of one problem, and the times of compiled code: ns, µs of an episode, and how many times faster the hybrid is.
struct MarkdownSection {
    title: &'static str,
    episodes: usize,
    table: String,
    graph: String,
    constant_time: String,
    reference: String,
    over_reference: String,
    /// By how much the paper says that its hybrid is faster.
    reported: &'static str,
    over_network: String,
    over_planner: String,
    hybrid_episode: String,
    network_episode: String,
}

impl MarkdownSection {
    fn new(problem: &ProblemResults) -> Self {
        let Times { tpg, tpg_constant_time, sac, hybrid, reference } = problem.times;
        let over = |time: Time| {
            let factor = time.mean / hybrid.mean;
            if factor >= 10.0 { format!("{factor:.0}") } else { format!("{factor:.1}") }
        };
        let row = |name: &str| problem.rows.iter().find(|row| row.name == name);
        let episode =
            |name: &str, time: Time| thousands(row(name).map_or(0.0, |row| row.actions.mean) * time.mean / 1e3);
        let (title, reported) = match problem.start {
            Start::Fs => ("fixed start", "11"),
            Start::Rs => ("random start", "2.8"),
        };
        Self {
            title,
            episodes: problem.episodes,
            table: table(&problem.rows, problem.episodes),
            graph: thousands(tpg.mean),
            constant_time: thousands(tpg_constant_time.mean),
            reference: thousands(reference.mean),
            over_reference: over(reference),
            reported,
            over_network: over(sac),
            over_planner: problem.rows.first().and_then(|row| row.time).map_or("–".to_owned(), over),
            hybrid_episode: episode("**hybrid, shipped**", hybrid),
            network_episode: episode("SAC, shipped", sac),
        }
    }
}

/// Renders the file, with the results of `ideas` on validation episodes.
///
/// # Panics
/// Never: the template only puts text together.
pub fn page(problems: &[ProblemResults], ideas: &[Row]) -> String {
    let sections: Vec<MarkdownSection> = problems.iter().map(MarkdownSection::new).collect();
    let page = MarkdownPage { problems: &sections, ideas: effects(ideas) };
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

fn effects(rows: &[Row]) -> String {
    let cells = |row: &Row| {
        let [success, collision, distance, actions] = outcome(row);
        [row.name.clone(), success, collision, distance, actions, by_graph(row)]
    };
    grid(&["policy", "success %", "collision %", "distance mm", "actions", "by graph %"], rows.iter().map(cells))
}
