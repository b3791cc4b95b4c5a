//! Replays the paper's recorded policies and poses: everything must be equal, row by row and step by step.

use crate::support;
use crate::support::fk::{self, Exactness, Nearness};
use crate::support::traces::{trace_difference, traces};
use std::path::Path;
use tpg_arm::WIDOWX;
use tpg_codegen::emit::{Code, Language, Options, Prefix};
use tpg_codegen::verify::Workshop;
use tpg_engine::{Plan, PolicyGraph, Single};
use tpg_graph::engine::{Engine, Reference};
use tpg_graph::import::{self, Profile};
use tpg_graph::interpret::Answer;
use tpg_graph::{Graph, in_arithmetic_of};
use tpg_paper::binding::Binding;
use tpg_paper::chain::Chain;
use tpg_paper::episode::Rules;
use tpg_paper::limits::max_actions;
use tpg_paper::{data, replay};
use tpg_problems::arm::targets::Start;
use tpg_runtime::ops::Maths;
use tpg_runtime::scalar::Scalar;

/// Error bounds of the hand stated by `tpg_arm::kinematics`, mm.
const F64_BOUND: f64 = 5e-13;
const F32_BOUND: f64 = 1.1e-4;

/// A recorded policy.
struct Case {
    /// The graph, without `.dot`.
    graph: String,
    /// Prefix of the names of its recorded files.
    recorded: String,
    problem: Start,
    tolerance: f64,
    /// Suffix of the name of its step trace.
    trace: Option<&'static str>,
}

/// Returns the policies of the paper's table 2, as trained and as pruned by the authors.
fn final_policies() -> Vec<Case> {
    let mut cases = Vec::new();
    for (problem, name) in [(Start::Fs, "fs"), (Start::Rs, "rs")] {
        for seed in 0..5 {
            for suffix in ["", ".cleaned"] {
                let recorded = format!("tpg/{name}_final_s{seed}");
                cases.push(Case {
                    graph: format!("{recorded}{suffix}"),
                    recorded,
                    problem,
                    tolerance: 3.0,
                    trace: None,
                });
            }
        }
    }
    cases
}

/// Returns the policies that the authors recorded with every step.
fn traced_policies() -> Vec<Case> {
    let names = [
        ("fs_init7200_150gen_s0", 3.0),
        ("fs_init7200_150gen_s1", 3.0),
        ("fs_init7200_150gen_s2", 3.0),
        ("fs_init180_150gen_s1", 3.0),
        ("fs_360R180S_range0.03_s0", 0.03),
        ("fs_5000R20S_range0.03_s0", 0.03),
    ];
    let case = |(name, tolerance)| {
        let recorded = format!("tpg_traced/{name}");
        let trace = Some(".trace.csv.gz");
        Case { graph: recorded.clone(), recorded, problem: Start::Fs, tolerance, trace }
    };
    names.into_iter().map(case).collect()
}

/// What decides.
#[derive(Clone, Copy)]
enum Decider {
    Interpreter,
    /// The trainer's own engine, one state at a time.
    Trainer,
    /// Generated code, compiled.
    Code(Language),
}

impl Decider {
    fn start<'g>(self, file: &Path, graph: &'g Graph) -> Box<dyn Engine + 'g> {
        match self {
            Self::Interpreter => Box::new(Reference::new(graph)),
            Self::Trainer => in_arithmetic_of!(graph, trainer(graph)),
            // The folder is deleted on return; the program started from it keeps running.
            Self::Code(language) => {
                let options = Options::new(Prefix::of_file(file));
                let code = Code::of_graph("the graph", graph, &options, language).unwrap();
                Box::new(Workshop::new().unwrap().start(&code).unwrap())
            }
        }
    }
}

/// The trainer's evaluator, with the length of a state.
struct Trainer<S, M>(Single<S, M>, usize);

impl<S: Scalar, M: Maths<S>> Engine for Trainer<S, M> {
    fn name(&self) -> &str {
        "trainer"
    }

    fn answer(&mut self, states: &[f64], answers: &mut Vec<Answer>) -> std::io::Result<()> {
        for state in states.chunks_exact(self.1) {
            let state: Vec<S> = state.iter().map(|&value| S::from_f64(value)).collect();
            answers.push(self.0.answer(&state));
        }
        Ok(())
    }
}

fn trainer<'g, S: Scalar, M: Maths<S> + 'static>(graph: &'g Graph) -> Box<dyn Engine + 'g> {
    let plan = Plan::new::<M>(&PolicyGraph::from(graph), graph.sources());
    Box::new(Trainer::<S, M>(Single::new(plan), graph.state_length()))
}

/// Totals over several policies.
#[derive(Debug, Default, PartialEq, Eq)]
struct Totals {
    graphs: usize,
    end_rows: usize,
    trace_rows: usize,
    steps: usize,
}

fn replay_all(folder: &Path, cases: &[Case], engine: Decider) -> Totals {
    let chain = Chain::new(WIDOWX);
    let mut totals = Totals::default();
    let mut differences = Vec::new();
    for case in cases {
        let targets = match case.problem {
            Start::Fs => "targets_fs.csv",
            Start::Rs => "targets_rs.csv",
        };
        let tasks = data::tasks(&folder.join(targets)).unwrap();
        let file = folder.join(format!("{}.dot", case.graph));
        let graph = import::load(&file, Some(Profile::Ecta24), None).unwrap();
        let binding = Binding::new(&graph).unwrap();
        let ends = data::ends(&folder.join(format!("{}.ends.csv", case.recorded))).unwrap();
        let rules = Rules { max_actions: max_actions(case.problem), tolerance: case.tolerance };
        let mut engine = engine.start(&file, &graph);
        let done = replay::run(&chain, rules, &tasks, &binding, engine.as_mut()).unwrap();

        let mut comparisons = vec![replay::compare(&ends, &done, replay::end_difference)];
        totals.graphs += 1;
        totals.end_rows += comparisons[0].exact_rows;
        if let Some(suffix) = case.trace {
            let traces = traces(&folder.join(format!("{}{suffix}", case.recorded)));
            let comparison = replay::compare(&traces, &done, trace_difference);
            totals.trace_rows += comparison.exact_rows;
            totals.steps += traces.values().map(Vec::len).sum::<usize>();
            comparisons.push(comparison);
        }
        let inexact = comparisons.into_iter().filter(|comparison| !comparison.is_exact());
        differences.extend(inexact.map(|comparison| format!("{}: {comparison:?}", case.graph)));
    }
    assert!(differences.is_empty(), "{}", differences.join("\n"));
    totals
}

/// Replays 20 graphs with 60 rows each.
fn replay_final(test: &str, engine: Decider) {
    let Some(folder) = support::folder(test) else { return };
    let totals = replay_all(&folder, &final_policies(), engine);
    assert_eq!(totals, Totals { graphs: 20, end_rows: 1_200, trace_rows: 0, steps: 0 });
}

/// Replays 6 graphs with 60 rows each and all their steps.
fn replay_traced(test: &str, engine: Decider) {
    let Some(folder) = support::folder(test) else { return };
    let totals = replay_all(&folder, &traced_policies(), engine);
    assert_eq!(totals, Totals { graphs: 6, end_rows: 360, trace_rows: 360, steps: 223_121 });
}

#[test]
fn final_policies_through_the_interpreter() {
    replay_final("final_policies_through_the_interpreter", Decider::Interpreter);
}

#[test]
fn traced_policies_through_the_interpreter() {
    replay_traced("traced_policies_through_the_interpreter", Decider::Interpreter);
}

#[test]
fn final_policies_through_the_trainers_engine() {
    replay_final("final_policies_through_the_trainers_engine", Decider::Trainer);
}

#[test]
fn traced_policies_through_the_trainers_engine() {
    replay_traced("traced_policies_through_the_trainers_engine", Decider::Trainer);
}

#[test]
fn final_policies_through_generated_c() {
    replay_final("final_policies_through_generated_c", Decider::Code(Language::C));
}

#[test]
fn traced_policies_through_generated_c() {
    replay_traced("traced_policies_through_generated_c", Decider::Code(Language::C));
}

#[test]
fn final_policies_through_generated_rust() {
    replay_final("final_policies_through_generated_rust", Decider::Code(Language::Rust));
}

#[test]
fn traced_policies_through_generated_rust() {
    replay_traced("traced_policies_through_generated_rust", Decider::Code(Language::Rust));
}

#[test]
fn recorded_poses_come_out_to_the_bit() {
    let Some(file) = support::foreign_file("recorded_poses_come_out_to_the_bit", "fk_collision.csv") else { return };
    let recorded = fk::reference_poses(&file);
    let exactness = fk::exactness(&Chain::new(WIDOWX), &recorded);
    assert_eq!(exactness, Exactness { poses: 1_000, exact_hands: 1_000, exact_collisions: 1_000 });
}

#[test]
fn recorded_poses_are_near_on_the_lattice() {
    let Some(file) = support::foreign_file("recorded_poses_are_near_on_the_lattice", "fk_collision.csv") else {
        return;
    };
    let recorded = fk::reference_poses(&file);
    let chain = Chain::new(WIDOWX);
    let in_f64 = fk::nearness(&chain, &WIDOWX, recorded.iter().copied());
    let in_f32 = fk::nearness(&chain, &WIDOWX.to_f32(), recorded);
    for (name, bound, Nearness { poses, worst, differences }) in
        [("f64", F64_BOUND, in_f64), ("f32", F32_BOUND, in_f32)]
    {
        println!("{name}: worst error {worst:e} mm, {} collision answers differ", differences.len());
        assert_eq!(poses, 1_000);
        assert!(worst <= bound, "{name}: {worst:e} mm");
        assert_eq!(differences, []);
    }
}
