//! Roots side by side end as each of them alone.

use std::sync::Arc;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{
    Act, ActionSpace, DEFAULT_LANES, Destination, Edge, End, Environment, EpisodeResult, Evaluator, Lanes, Limits,
    Line, LocalThreads, Operand, Output, Plan, PolicyGraph, SourceSet, Step, Work,
};
use tpg_graph::SourceDocument;
use tpg_runtime::ops::{Instruction, Maths, Own};
use tpg_runtime::scalar::Scalar;

/// A point that actions or values push about, for as long as the task says.
struct Drift {
    computes: bool,
}

/// The point, the task, and the number of pushes.
type Episode = ([f64; 2], u32, u32);

impl<S: Scalar> Environment<S> for Drift {
    type Task = u32;
    type Episode = Episode;

    fn sources(&self) -> Vec<SourceDocument> {
        let ranges = vec![[f64::NEG_INFINITY, f64::INFINITY]; 3];
        vec![SourceDocument::new("point and task", "1", ranges)]
    }
    fn actions(&self) -> ActionSpace {
        let output = |name: &str| Output { name: name.into(), unit: String::new(), min: -1.0, max: 1.0 };
        match self.computes {
            true => ActionSpace::Box(vec![output("across"), output("up")]),
            false => ActionSpace::discrete(["left", "right", "up"]),
        }
    }
    fn time_limit(&self) -> u32 {
        30
    }
    fn draw(&self, stream: &mut Stream) -> u32 {
        stream.below(40) as u32
    }
    fn start(&self, &task: &u32) -> Episode {
        ([f64::from(task) / 7.0, -1.0], task, 0)
    }
    fn observe(&self, &mut ([x, y], task, _): &mut Episode, _: SourceSet, state: &mut [S]) {
        state.copy_from_slice(&[x, y, f64::from(task)].map(S::from_f64));
    }
    fn step(&self, (point, task, pushes): &mut Episode, act: Act<'_, S>) -> Step {
        match act {
            Act::Values(values) => point.iter_mut().zip(values).for_each(|(at, value)| *at += value.to_f64()),
            act => point[act.choice() / 2] += [-0.5, 0.5, 0.25][act.choice()],
        }
        *pushes += 1;
        let step = Step::reward(point[0] - 3.0 * point[1]);
        if *pushes > *task { step.ending(End::new(0)) } else { step }
    }
}

/// Returns roots that have programs and teams in common, some of them twice.
fn roots(computes: bool, stream: &mut Stream) -> Vec<PolicyGraph> {
    let instructions = [
        Instruction::Add,
        Instruction::Mul,
        Instruction::Sub,
        Instruction::Sin,
        Instruction::Cos,
        Instruction::Ln,
        Instruction::Exp,
        Instruction::NegateIfLess,
    ];
    let operand = |stream: &mut Stream| match stream.below(3) {
        0 => Operand::Register(stream.below(3) as u16),
        1 => Operand::Input(stream.below(3) as u16),
        _ => Operand::Constant(stream.between(-8, 8) as f64 / 4.0),
    };
    let mut line = |_| Line {
        to: stream.below(3) as u16,
        instruction: (*stream.pick(&instructions)).into(),
        operands: [operand(stream), operand(stream)],
    };
    let programs: Vec<Arc<[Line]>> = (0..12).map(|length| (0..length).map(&mut line).collect()).collect();
    let leaves: Vec<Vec<u32>> = (0..3).map(|_| vec![stream.below(12) as u32, stream.below(12) as u32]).collect();
    let mut team = |teams: usize| {
        let mut edge = |_| Edge {
            program: stream.below(12) as u32,
            to: match stream.below(teams + 3) {
                action @ 0..3 => Destination::Action(action as u16),
                team => Destination::Team(team as u32 - 3),
            },
        };
        (0..1 + teams % 4).map(&mut edge).collect::<Vec<_>>()
    };
    let mut common = Vec::new();
    (0..6).for_each(|teams| common.push(team(teams)));
    let mut root = |place: usize| {
        let mut teams = common.clone();
        teams.push(if place % 9 == 8 { common[5].clone() } else { team(3 + place % 4) });
        let policy = PolicyGraph::with_programs(3, 6, teams, programs.clone());
        if !computes {
            return policy;
        }
        let limits = Limits { min: -1.0, max: 1.0, nan: 0.5 };
        policy.with_outputs(vec![limits, limits], leaves.clone())
    };
    (0..30).map(&mut root).collect()
}

/// Returns endings with the bits of their scores: 0 and −0 are not the same.
fn bits(endings: &[EpisodeResult]) -> Vec<(EpisodeResult, u64)> {
    endings.iter().map(|ending| (*ending, ending.score.to_bits())).collect()
}

fn roots_side_by_side_end_as_alone<S: Scalar>(computes: bool)
where
    Own: Maths<S>,
{
    let environment = Drift { computes };
    let sources = Environment::<S>::sources(&environment);
    let mut stream = Stream::new(1, 0, Purpose::Test, u64::from(computes));
    let roots = roots(computes, &mut stream);
    let tasks: Vec<Vec<u32>> = (0..roots.len())
        .map(|place| (0..place % 8).map(|_| Environment::<S>::draw(&environment, &mut stream)).collect())
        .collect();
    let alone: Vec<Vec<(EpisodeResult, u64)>> = (roots.iter().zip(&tasks))
        .map(|(root, tasks)| {
            let plan = Plan::<S>::new::<Own>(root, &sources);
            bits(&Lanes::<S, Own, _>::new(&environment, 1).run(&plan, tasks).expect("nothing fails"))
        })
        .collect();
    let scores: std::collections::BTreeSet<u64> = alone.iter().flatten().map(|(_, score)| *score).collect();
    assert!(scores.len() > 60, "only {} different scores", scores.len());
    let policies: Vec<&PolicyGraph> = roots.iter().collect();
    let lists: Vec<&[u32]> = tasks.iter().map(|tasks| &tasks[..]).collect();
    let plan = Plan::<S>::of_roots::<Own>(&policies, &sources);
    for count in [1, 3, 8, 40, 112, 512] {
        let mut lanes = Lanes::<S, Own, _>::new(&environment, count);
        for again in 0..2 {
            let endings = lanes.run_roots(&plan, &lists).expect("nothing fails");
            let endings: Vec<_> = endings.iter().map(|endings| bits(endings)).collect();
            assert_eq!(endings, alone, "{count} lanes, run {again}");
        }
    }
}

#[test]
fn roots_that_choose_side_by_side_end_as_alone() {
    roots_side_by_side_end_as_alone::<f32>(false);
    roots_side_by_side_end_as_alone::<f64>(false);
}

#[test]
fn roots_that_compute_side_by_side_end_as_alone() {
    roots_side_by_side_end_as_alone::<f32>(true);
    roots_side_by_side_end_as_alone::<f64>(true);
}

/// Roots of one call may have other outputs and other numbers of registers.
#[test]
fn roots_that_cannot_stand_side_by_side_are_evaluated_too() {
    let environment = Drift { computes: true };
    let mut stream = Stream::new(2, 0, Purpose::Test, 0);
    let mut roots = roots(true, &mut stream);
    for (place, root) in roots.iter_mut().enumerate() {
        root.outputs[1].max = [1.0, 0.5][place / 2 % 2];
        root.registers = [3, 4][place / 5 % 2];
    }
    let work = Work { tasks: vec![9, 25, 3], policies: roots.to_vec() };
    let sources = Environment::<f32>::sources(&environment);
    for threads in [1, 3] {
        let evaluator = LocalThreads::<f32, Own, _>::new(&environment, threads).expect("threads");
        let answers = evaluator.evaluate(&work).expect("nothing fails");
        for (answer, root) in answers.iter().zip(&roots) {
            let plan = Plan::new::<Own>(root, &sources);
            let alone =
                Lanes::<f32, Own, _>::new(&environment, DEFAULT_LANES).run(&plan, &work.tasks).expect("nothing fails");
            assert_eq!(bits(answer), bits(&alone), "{threads} threads");
        }
    }
}
