//! A policy as formulas in a structure: for pages and reports that show it.

use crate::emit::integers::{bids_in_units, output_in_units};
use crate::formula::Formulas;
use crate::ir::{Module, NodeId, Target, reached};
use crate::options::{Language, Options, Profile, Style};
use crate::program::compile;
use crate::shape::Shape;
use serde::Serialize;
use tpg_graph::{Graph, Output};

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
        let teams = match program.shape {
            Shape::Formula(_) => Vec::new(),
            _ => (0..module.teams.len()).map(|team| TeamFormulas::new(module, team)).collect(),
        };
        let outputs = module.graph.outputs();
        let leaves = reached(&module.leaves).map(|(number, leaf)| {
            let formulas = Formulas::new(module, &leaf.values);
            let value = |(output, &value): (&Output, &NodeId)| {
                let in_units = output_in_units(module, output, value).filter(|_| module.graph.has_counts());
                (output.name.clone(), in_units.unwrap_or_else(|| formulas.formula(value).to_owned()))
            };
            LeafFormulas {
                id: leaf.label,
                number,
                shared: formulas.shared().to_vec(),
                values: outputs.iter().zip(&leaf.values).map(value).collect(),
            }
        });
        Self { teams, leaves: leaves.collect() }
    }
}

impl TeamFormulas {
    fn new(module: &Module<'_>, team: usize) -> Self {
        let team = &module.teams[team];
        let bids: Vec<NodeId> = team.edges.iter().map(|edge| module.bidders[edge.bidder].value).collect();
        let formulas = Formulas::new(module, &bids);
        // To one scale, all or none of them.
        let in_units: Option<Vec<String>> =
            bids_in_units(module, &bids).into_iter().collect::<Option<_>>().filter(|_| module.graph.has_counts());
        let bid = |(place, (edge, &bid)): (usize, (&crate::ir::Edge, &NodeId))| {
            let (to, team) = match edge.to {
                Target::Team(team) => (format!("team {}", module.teams[team].label), Some(team)),
                Target::Action(end) if module.graph.leaves().is_empty() => {
                    (module.graph.actions()[usize::from(end.0)].to_string(), None)
                }
                Target::Action(end) => (module.graph.end_name(end), None),
            };
            BidFormula {
                program: module.bidders[edge.bidder].label,
                to,
                team,
                formula: in_units
                    .as_ref()
                    .map_or_else(|| formulas.formula(bid).to_owned(), |texts| texts[place].clone()),
            }
        };
        Self {
            id: team.label,
            shared: formulas.shared().to_vec(),
            bids: team.edges.iter().zip(&bids).enumerate().map(bid).collect(),
        }
    }
}
