//! The table: description and result of each run, and the mean of each group of several.

use super::runs::{Group, Run};
use super::test::Tested;
use crate::hybrid::rollout::Policies;
use std::ops::Range;
use tpg_engine::Sample;
use tpg_graph::error::counted;
use tpg_picture::{FiveNumbers, Section, Table};

/// A number of a run, where it has one.
type Number<'a> = &'a dyn Fn(&Run, Option<&Tested>) -> Option<f64>;

pub(super) fn section(groups: &[Group], tested: &[Vec<Option<Tested>>]) -> Section {
    let measure = tested.iter().flatten().flatten().find_map(|tested| tested.measure);
    let measure = measure.map_or_else(|| "measure".to_owned(), |measure| format!("{} {}", measure.name, measure.unit));
    let [mean_measure, median_measure] = ["mean", "median"].map(|which| format!("{which} {measure}"));
    let measured = |tested: Option<&Tested>| tested.filter(|tested| tested.measure.is_some()).map(Tested::measures);
    let columns: [(&str, Number<'_>); 7] = [
        ("score", &|_, tested| Some(tested?.summary().score)),
        ("success %", &|_, tested| Some(100.0 * tested?.summary().success?)),
        (&mean_measure, &|_, tested| Some(Sample::new(&measured(tested)?).mean)),
        (&median_measure, &|_, tested| Some(FiveNumbers::new(&measured(tested)?)?.median)),
        ("actions", &|_, tested| Some(tested?.summary().actions)),
        ("selection", &|run, _| run.validated()),
        ("CPU s", &|run, _| run.cpu),
    ];
    let mut rows = Vec::new();
    for (group, tested) in groups.iter().zip(tested) {
        let row = |words: [String; 3], places: Range<usize>| {
            let cell = |(_, number): &(&str, Number<'_>)| {
                let numbers = places.clone().filter_map(|place| number(&group.runs[place], tested[place].as_ref()));
                spread(&numbers.collect::<Vec<_>>())
            };
            words.into_iter().chain(columns.iter().map(cell)).collect::<Vec<_>>()
        };
        let count = group.runs.len();
        if count > 1 {
            rows.push(row([group.name.clone(), counted(count, "seed"), String::new()], 0..count));
        }
        for (place, run) in group.runs.iter().enumerate() {
            let seed = run.seed.map_or_else(String::new, |seed| seed.to_string());
            rows.push(row([run.name.clone(), seed, policy(run)], place..place + 1));
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
