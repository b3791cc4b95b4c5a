//! The data of the page: the policies as formulas and tables of bids, their code, and what a decision costs.

use crate::policies::{ARM, EYE, POLICIES, Policy, read, top};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::io;
use tpg_arm::dodge::Behaviour;
use tpg_codegen::report::{Bids, PolicyFormulas, Value};
use tpg_graph::Graph;
use tpg_problems::dodge::draw::Certified;
use tpg_problems::dodge::file::read_csv;

/// The data that the page reads.
#[derive(Serialize)]
struct PageData {
    /// Instructions of an action on a Cortex-M4, by driver.
    costs: BTreeMap<&'static str, PageCost>,
    arm: PageTeams,
    balls: PageBalls,
    eye: PageEye,
    problems: Vec<PageProblem>,
}

/// The bids of a graph's teams, in words and as a table that the page evaluates.
#[derive(Serialize)]
struct PageTeams {
    table: Bids,
    #[serde(flatten)]
    formulas: PolicyFormulas,
}

/// The camera's policy.
#[derive(Serialize)]
struct PageEye {
    /// Bytes and instructions.
    size: String,
    code: String,
    #[serde(flatten)]
    teams: PageTeams,
}

/// Scenes among moving balls.
#[derive(Serialize)]
struct PageBalls {
    /// The first ones of the test scenes.
    scenes: Vec<PageScene>,
    /// Names of the behaviours.
    behaviours: Vec<&'static str>,
    /// Instructions of a step on a Cortex-M4, at most.
    worst: u64,
}

/// A scene: its target for the page, all of it as the module reads it.
#[derive(Serialize)]
struct PageScene {
    target: [f32; 3],
    bytes: Vec<u8>,
}

/// Scenes that the page shows.
const SCENES: usize = 24;

#[derive(Serialize)]
struct PageCost {
    mean: f64,
    worst: u64,
}

#[derive(Serialize)]
struct PageProblem {
    title: &'static str,
    /// The values that the policy sees, with their units.
    sources: Vec<(String, String)>,
    /// The actions, or the outputs with their units.
    answers: Vec<(String, String)>,
    /// Bytes and instructions.
    size: String,
    /// The return on real Gymnasium.
    result: String,
    code: String,
    #[serde(flatten)]
    teams: PageTeams,
}

/// The rows of `costs.toml` that the page shows.
const COSTS: [(&str, &str); 4] =
    [("graph", "rs graph"), ("network", "rs network"), ("hybrid", "rs hybrid"), ("balls", "dodge any behaviour")];

/// The text of the file.
pub(crate) fn text() -> io::Result<String> {
    let problems = POLICIES.iter().map(problem).collect::<io::Result<_>>()?;
    let costs = costs()?;
    let balls = balls(costs["balls"].worst)?;
    let arm = teams(&ARM, &ARM.graph()?)?;
    let eye = PageEye {
        size: EYE.provenance("| C, profile `fast` |")?,
        code: EYE.code()?,
        teams: teams(&EYE, &EYE.graph()?)?,
    };
    let text = serde_json::to_string(&PageData { costs, arm, balls, eye, problems }).map_err(io::Error::other)?;
    Ok(text + "\n")
}

fn balls(worst: u64) -> io::Result<PageBalls> {
    let scenes = read_csv(&top().join("generated/test-targets/dodge.csv")).map_err(io::Error::other)?;
    let scene = |Certified { scene, .. }: &Certified| {
        let bytes = postcard::to_stdvec(scene).expect("plain data");
        PageScene { target: scene.target, bytes }
    };
    let scenes = scenes.iter().take(SCENES).map(scene).collect();
    Ok(PageBalls { scenes, behaviours: Behaviour::ALL.map(Behaviour::name).to_vec(), worst })
}

fn costs() -> io::Result<BTreeMap<&'static str, PageCost>> {
    #[derive(Deserialize)]
    struct PageFile {
        cost: BTreeMap<String, PageRow>,
    }
    #[derive(Deserialize)]
    struct PageRow {
        actions: u64,
        instructions: u64,
        worst: u64,
    }
    let file: PageFile = toml::from_str(&read("c-harness/costs.toml")?).map_err(io::Error::other)?;
    let cost = |(driver, name): (&'static str, &str)| {
        let row = file.cost.get(name).ok_or_else(|| io::Error::other(format!("costs.toml: no row {name}")))?;
        Ok((driver, PageCost { mean: row.instructions as f64 / row.actions as f64, worst: row.worst }))
    };
    COSTS.into_iter().map(cost).collect()
}

fn problem(policy: &Policy) -> io::Result<PageProblem> {
    let graph = policy.graph()?;
    let outputs = graph.outputs().iter().map(|output| (output.name.clone(), output.unit.clone()));
    let answers = graph.actions().iter().map(|action| (action.name.clone(), String::new())).chain(outputs);
    Ok(PageProblem {
        title: policy.title,
        sources: graph.sources().iter().map(|source| (source.name.clone(), source.unit.clone())).collect(),
        answers: answers.collect(),
        size: policy.provenance("| C, profile `fast` |")?,
        result: result(policy)?,
        code: policy.code()?,
        teams: teams(policy, &graph)?,
    })
}

/// The teams of a policy, whose numbers JSON can hold.
fn teams(policy: &Policy, graph: &Graph) -> io::Result<PageTeams> {
    let options = policy.options()?;
    let table = Bids::of(graph, &options);
    let is_odd = |value: &&Value| matches!(value, Value::Constant(number) if !number.is_finite());
    match table.values.iter().find(is_odd) {
        Some(value) => Err(io::Error::other(format!("{value:?} among the values of a bid"))),
        None => Ok(PageTeams { table, formulas: PolicyFormulas::of(graph, &options) }),
    }
}

/// The figures in bold of the test on real Gymnasium.
fn result(policy: &Policy) -> io::Result<String> {
    let line = policy.provenance(&format!("(`benches/control/table.py --only {}`): ", policy.folder))?;
    Ok(line.split("**").nth(1).unwrap_or_default().to_owned())
}
