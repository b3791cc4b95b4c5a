//! `--explain`: the bids of each team, and the values of each leaf, as readable formulas.

mod policy;
mod table;

pub use policy::{BidFormula, LeafFormulas, PolicyFormulas, TeamFormulas};
pub use table::{Bids, Destination, Value};

use crate::options::Options;
use askama::Template;
use std::fmt::Debug;
use tpg_graph::{Graph, Output, Range};

#[derive(Template)]
#[template(path = "explain.txt", escape = "none")]
struct Explained<'a> {
    graph: &'a Graph,
    formulas: PolicyFormulas,
}

impl Explained<'_> {
    /// Tests for a word whose name does not say what it means.
    fn negates(&self, formulas: &impl Debug) -> bool {
        format!("{formulas:?}").contains("negate_if_less(")
    }

    /// An answer in the output's unit.
    fn value(&self, output: &Output, answer: &f64) -> f64 {
        output.counts.map_or(*answer, |counts| counts.value(*answer))
    }

    fn limits(&self, output: &Output) -> Range {
        let [min, max] = [output.range.min, output.range.max].map(|end| self.value(output, &end));
        Range { min, max }
    }
}

/// Returns the formulas of a graph as fast C: what each team's bids are, and what each leaf computes.
pub fn explain(graph: &Graph, options: &Options) -> String {
    let explained = Explained { graph, formulas: PolicyFormulas::of(graph, options) };
    explained.render().expect("the template renders").trim_start().to_owned() + "\n"
}
