//! The tables: description and result of each run, and the mean of each group.

use super::runs::{Group, Run};
use super::test::Tested;
use crate::hybrid::rollout::Policies;
use tpg_engine::Sample;
use tpg_graph::error::counted;
use tpg_picture::{Section, Table};

pub(super) fn section(groups: &[Group], tested: &[Vec<Option<Tested>>]) -> Section {
    let measure = tested.iter().flatten().flatten().find_map(|tested| tested.measure);
    let measure = measure.map_or_else(|| "measure".to_owned(), |measure| format!("{} {}", measure.name, measure.unit));
    let (mean_measure, median_measure) = (format!("mean {measure}"), format!("median {measure}"));
    let mut means = Vec::new();
    let mut rows = Vec::new();
    for (group, tested) in groups.iter().zip(tested) {
        let all: Vec<&Tested> = tested.iter().flatten().collect();
        let over = |value: &dyn Fn(&Tested) -> Option<f64>| {
            spread(&all.iter().filter_map(|tested| value(tested)).collect::<Vec<_>>())
        };
        let cpu: Option<Vec<f64>> = group.runs.iter().map(|run| run.cpu).collect();
        means.push(vec![
            group.name.clone(),
            group.runs[0].kind().to_owned(),
            group.runs.len().to_string(),
            over(&|tested| Some(tested.summary().score)),
            over(&|tested| tested.summary().success.map(|success| 100.0 * success)),
            over(&|tested| tested.measure.map(|_| tested.summary().measure)),
            all.iter().map(|tested| tested.summary().score).reduce(f64::max).map_or_else(String::new, one_decimal),
            cpu.map_or_else(String::new, |cpu| spread(&cpu)),
        ]);
        rows.extend(group.runs.iter().zip(tested).map(|(run, tested)| row(run, tested.as_ref())));
    }
    let table =
        |header: &[&str], rows| told(Table { header: header.iter().map(|&cell| cell.to_owned()).collect(), rows });
    Section {
        title: "Results".to_owned(),
        text: String::new(),
        tables: vec![
            table(
                &["group", "kind", "seeds", "score", "success %", &mean_measure, "best seed's score", "CPU s"],
                means,
            ),
            table(
                &[
                    "run",
                    "seed",
                    "policy",
                    "score",
                    "success %",
                    &mean_measure,
                    &median_measure,
                    "actions",
                    "selection",
                    "CPU s",
                ],
                rows,
            ),
        ],
        ..Section::default()
    }
}

/// Leaves out columns in which no row says anything.
fn told(Table { header, rows }: Table) -> Table {
    let says = |column: usize| rows.iter().any(|row: &Vec<String>| !row[column].is_empty());
    let kept: Vec<usize> = (0..header.len()).filter(|&column| says(column)).collect();
    let cells = |row: &[String]| kept.iter().map(|&column| row[column].clone()).collect::<Vec<_>>();
    Table { header: cells(&header), rows: rows.iter().map(|row| cells(row)).collect() }
}

fn row(run: &Run, tested: Option<&Tested>) -> Vec<String> {
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
    let text = |value: Option<f64>| value.map_or_else(String::new, one_decimal);
    let summary = tested.map(Tested::summary);
    let measured = tested.filter(|tested| tested.measure.is_some());
    let median = measured.and_then(|tested| tpg_picture::FiveNumbers::new(&tested.measures())).map(|five| five.median);
    vec![
        run.name.clone(),
        run.seed.map_or_else(String::new, |seed| seed.to_string()),
        what,
        text(summary.map(|summary| summary.score)),
        text(summary.and_then(|summary| summary.success).map(|success| 100.0 * success)),
        text(measured.map(|tested| tested.summary().measure)),
        text(median),
        text(summary.map(|summary| summary.actions)),
        text(run.validated()),
        text(run.cpu),
    ]
}

fn one_decimal(value: f64) -> String {
    format!("{value:.1}")
}

/// Formats mean ± standard deviation (of the sample, n − 1); for a single value, the value itself.
fn spread(values: &[f64]) -> String {
    let sample = Sample::new(values);
    match sample.count {
        0 => String::new(),
        1 => one_decimal(sample.mean),
        _ => format!("{:.1} ± {:.1}", sample.mean, sample.sample_deviation()),
    }
}
