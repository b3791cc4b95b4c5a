//! The table: description and result of each run, and the mean of each group of several.

use super::runs::{Group, Run};
use super::test::Tested;
use crate::hybrid::rollout::Policies;
use std::slice::from_ref;
use tpg_engine::{Sample, quantile};
use tpg_graph::error::counted;
use tpg_picture::{Section, Table};

/// A number of a run, where it has one.
type Number<'a> = &'a dyn Fn(&Run) -> Option<f64>;

pub(super) fn section(groups: &[Group]) -> Section {
    let measure = groups.iter().flat_map(|group| &group.runs).find_map(|run| run.result.as_ref()?.measure);
    let measure = measure.map_or_else(|| "measure".to_owned(), |measure| format!("{} {}", measure.name, measure.unit));
    let [mean_measure, median_measure] = ["mean", "median"].map(|which| format!("{which} {measure}"));
    let measured = |run: &Run| run.result.as_ref().filter(|tested| tested.measure.is_some()).map(Tested::measures);
    let summary = |run: &Run| run.result.as_ref().map(Tested::summary);
    let columns: [(&str, Number<'_>); 7] = [
        ("score", &|run| Some(summary(run)?.score)),
        ("success %", &|run| Some(100.0 * summary(run)?.success?)),
        (&mean_measure, &|run| Some(Sample::new(&measured(run)?).mean)),
        (&median_measure, &|run| quantile(&measured(run)?, 0.5)),
        ("actions", &|run| Some(summary(run)?.actions)),
        ("selection", &Run::validated),
        ("CPU s", &|run| run.cpu),
    ];
    let mut rows = Vec::new();
    for group in groups {
        let row = |words: [String; 3], runs: &[Run]| {
            let cell = |(_, number): &(&str, Number<'_>)| spread(&runs.iter().filter_map(*number).collect::<Vec<_>>());
            words.into_iter().chain(columns.iter().map(cell)).collect::<Vec<_>>()
        };
        let count = group.runs.len();
        if count > 1 {
            rows.push(row([group.name.clone(), counted(count, "seed"), String::new()], &group.runs));
        }
        for run in &group.runs {
            let seed = run.seed.map_or_else(String::new, |seed| seed.to_string());
            rows.push(row([run.name.clone(), seed, policy(run)], from_ref(run)));
        }
    }
    let header = ["run", "seed", "policy"].into_iter().chain(columns.iter().map(|(name, _)| *name));
    let table = told(Table { header: header.map(str::to_owned).collect(), rows });
    let text = "± is the standard deviation over the seeds of a group.".to_owned();
    Section { title: "Results".to_owned(), text, tables: vec![table], ..Section::default() }
}

/// Leaves out columns in which no row says anything.
fn told(Table { header, rows }: Table) -> Table {
    let says = |column: usize| rows.iter().any(|row: &Vec<String>| !row[column].is_empty());
    let kept: Vec<usize> = (0..header.len()).filter(|&column| says(column)).collect();
    let cells = |row: &[String]| kept.iter().map(|&column| row[column].clone()).collect::<Vec<_>>();
    Table { header: cells(&header), rows: rows.iter().map(|row| cells(row)).collect() }
}

/// Describes the policy of a run.
fn policy(run: &Run) -> String {
    let what = match &run.policies {
        Policies::Graph(named) => {
            let graph = &named.1;
            let edges: usize = graph.teams().iter().map(|team| team.edges.len()).sum();
            [(graph.teams().len(), "team"), (edges, "edge"), (graph.programs().len(), "program")]
                .map(|(count, what)| counted(count, what))
                .join(", ")
        }
        Policies::Network((_, network)) => {
            let [inputs, hidden @ ..] = &network.widths()[..] else { unreachable!("a network has inputs") };
            format!("{inputs} inputs, {}", hidden.iter().map(usize::to_string).collect::<Vec<_>>().join("-"))
        }
        Policies::Both(hybrid) => hybrid.setting.sentence(),
    };
    format!("{}: {what}", run.kind())
}

/// Formats mean ± standard deviation (of the sample, n − 1); for a single value, the value itself.
fn spread(values: &[f64]) -> String {
    let sample = Sample::new(values);
    match sample.count {
        0 => String::new(),
        1 => format!("{:.1}", sample.mean),
        _ => format!("{:.1} ± {:.1}", sample.mean, sample.sample_deviation()),
    }
}
