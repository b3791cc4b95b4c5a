//! A policy as formulas in a structure: for pages and reports that show it.

use crate::emit::integers::{bids_in_units, output_in_units};
use crate::formula::Formulas;
use crate::integers::{Form, forms};
use crate::ir::{Module, NodeId, Successor, reached};
use crate::options::{Language, Options, Profile, Style};
use crate::program::compile;
use crate::shape::Shape;
use serde::Serialize;
use tpg_graph::Graph;

/// A policy as formulas, optimised as its fast C is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct PolicyFormulas {
    /// The teams, the root first; empty where nothing is decided.
    pub teams: Vec<TeamFormulas>,
    /// The leaves that walks end at; empty for a policy that answers with an action.
    pub leaves: Vec<LeafFormulas>,
}

/// A team: the highest bid wins; of equal bids, the last. NaN is lowest.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct TeamFormulas {
    /// Its id in the graph.
    pub id: u32,
    /// Names of what several bids share, and their formulas.
    pub shared: Vec<(String, String)>,
    /// The bids, in the order that decides ties.
    pub bids: Vec<BidFormula>,
}

/// A bid and its destination.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct BidFormula {
    /// The program's id in the graph.
    pub program: u32,
    /// The destination in words: `team 3`, `leaf 1`, or an action's name.
    pub to: String,
    /// The team's place in [`PolicyFormulas::teams`] where the bid is for a team.
    pub team: Option<usize>,
    /// The formula.
    pub formula: String,
}

/// A leaf: what each output is before it is limited to its range.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct LeafFormulas {
    /// Its id in the graph.
    pub id: u32,
    /// Its number among all leaves of the graph.
    pub number: usize,
    /// Names of what several outputs share, and their formulas.
    pub shared: Vec<(String, String)>,
    /// Each output's name and formula.
    pub values: Vec<(String, String)>,
}

impl PolicyFormulas {
    /// The formulas of a graph. A value of a source with one value has the source's name.
    ///
    /// ```
    /// use tpg_codegen::report::PolicyFormulas;
    /// use tpg_codegen::Options;
    /// use tpg_graph::sample::{self, Shape};
    ///
    /// let graph = sample::graph(&Shape::default(), 7);
    /// let formulas = PolicyFormulas::of(&graph, &Options::new("arm".parse()?));
    /// assert!(formulas.teams.iter().all(|team| !team.bids.is_empty()));
    /// # Ok::<(), String>(())
    /// ```
    pub fn of(graph: &Graph, options: &Options) -> Self {
        let options = Options { style: Style::Pure, profile: Some(Profile::Fast), ..options.clone() };
        let program = &compile(graph, &options, Language::C);
        let module = &program.module;
        let forms = if module.graph.has_counts() { forms(module) } else { Vec::new() };
        let teams = match program.shape {
            Shape::Formula => Vec::new(),
            _ => (0..module.teams.len()).map(|team| TeamFormulas::new(module, &forms, team)).collect(),
        };
        let outputs = module.graph.outputs();
        let leaves = reached(&module.leaves).map(|(number, leaf)| {
            let formulas = Formulas::new(module, &leaf.values);
            let in_units: Vec<Option<String>> = match module.graph.has_counts() {
                true => {
                    let values = outputs.iter().zip(&leaf.values);
                    values.map(|(output, &value)| output_in_units(module, &forms, output, value)).collect()
                }
                false => vec![None; outputs.len()],
            };
            let (shared, texts) = texts(module, &formulas, &leaf.values, in_units);
            let names = outputs.iter().map(|output| output.name.clone());
            LeafFormulas { id: leaf.label, number, shared, values: names.zip(texts).collect() }
        });
        Self { teams, leaves: leaves.collect() }
    }
}

impl TeamFormulas {
    fn new(module: &Module<'_>, forms: &[Form], team: usize) -> Self {
        let team = &module.teams[team];
        let bids: Vec<NodeId> = team.edges.iter().map(|edge| module.bidders[edge.bidder].value).collect();
        let formulas = Formulas::new(module, &bids);
        // To one scale, all or none of them.
        let in_units = || bids_in_units(module, forms, &bids).into_iter().collect::<Option<Vec<_>>>();
        let in_units = module.graph.has_counts().then(in_units).flatten();
        let in_units = in_units.map_or_else(|| vec![None; bids.len()], |texts| texts.into_iter().map(Some).collect());
        let (shared, texts) = texts(module, &formulas, &bids, in_units);
        let bid = |(edge, formula): (&crate::ir::Edge, String)| {
            let (to, team) = match edge.to {
                Successor::Team(team) => (format!("team {}", module.teams[team].label), Some(team)),
                Successor::Action(end) if module.graph.leaves().is_empty() => {
                    (module.graph.actions()[usize::from(end.0)].to_string(), None)
                }
                Successor::Action(end) => (module.graph.end_name(end), None),
            };
            BidFormula { program: module.bidders[edge.bidder].label, to, team, formula }
        };
        Self { id: team.label, shared, bids: team.edges.iter().zip(texts).map(bid).collect() }
    }
}

/// Returns the formulas of values, those in units where there are such, and what the others share.
fn texts(
    module: &Module<'_>,
    formulas: &Formulas,
    values: &[NodeId],
    in_units: Vec<Option<String>>,
) -> (Vec<(String, String)>, Vec<String>) {
    let shared = if in_units.iter().all(Option::is_some) { Vec::new() } else { formulas.shared().to_vec() };
    let counts = if module.graph.has_counts() { " (in counts)" } else { "" };
    let text = |(in_units, &value): (Option<String>, &NodeId)| {
        in_units.unwrap_or_else(|| format!("{}{counts}", formulas.formula(value)))
    };
    (shared, in_units.into_iter().zip(values).map(text).collect())
}
