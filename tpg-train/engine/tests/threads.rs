//! Threads share the environment, the tasks and the counter of steps; any number of them answers the same.

use tpg_engine::random::Stream;
use tpg_engine::{
    Act, ActionSpace, Destination, Edge, Environment, Evaluator, Line, LocalThreads, Operand, Piece, PolicyGraph,
    SourceSet, Step, Work,
};
use tpg_graph::{SourceDocument, Word};
use tpg_runtime::ops::{Instruction, Own};

/// A ball that rolls and slows down; each push is rewarded by where it happens.
struct Ball;

impl Environment<f32> for Ball {
    type Task = f32;
    type Episode = [f32; 2];

    fn sources(&self) -> Vec<SourceDocument> {
        let ranges = vec![[f64::NEG_INFINITY, f64::INFINITY]; 2];
        vec![SourceDocument::new("ball", "", ranges)]
    }
    fn actions(&self) -> ActionSpace {
        ActionSpace::discrete(["roll", "push"])
    }
    fn time_limit(&self) -> u32 {
        50
    }
    fn draw(&self, _: &mut Stream) -> f32 {
        1.0
    }
    fn start(&self, task: &f32) -> [f32; 2] {
        [*task, 0.0]
    }
    fn observe(&self, ball: &mut [f32; 2], _: SourceSet, state: &mut [f32]) {
        state.copy_from_slice(ball);
    }
    fn step(&self, [place, speed]: &mut [f32; 2], act: Act<'_, f32>) -> Step {
        *speed = *speed * 0.9 - *place * 0.1 + act.choice() as f32;
        *place += *speed;
        Step::reward(f64::from(*place))
    }
}

/// A policy that compares `input + input` with another sum of inputs.
fn policy(index: usize) -> PolicyGraph {
    let sum = |a, b| {
        let operands = [Operand::Input(a), Operand::Input(b)];
        vec![Line { to: 0, instruction: Word::from(Instruction::Add), operands }]
    };
    let edge = |program| Edge { program, to: Destination::Action(program as u16) };
    let inputs = (index as u16 % 2, index as u16 / 2 % 2);
    PolicyGraph::new(2, 0, vec![vec![edge(0), edge(1)]], vec![sum(inputs.0, inputs.1), sum(inputs.1, 1)])
}

#[test]
fn any_number_of_threads_answers_the_same() {
    let policies = (0..60).map(policy).collect();
    let work = Work { tasks: (0..40).map(|index| index as f32 * 0.25 - 5.0).collect(), policies };
    let on = |threads| LocalThreads::<f32, Own, _>::new(&Ball, threads).expect("threads");
    let one = on(1);
    let alone = one.evaluate(&work).expect("nothing fails");
    assert!(alone[0] != alone[1], "policies differ");
    let pieces = Piece::cut(60, 40, 3);
    let parts = one.pieces(&work, &pieces).expect("nothing fails");
    for threads in [2, 4, 7] {
        let several = on(threads);
        assert_eq!(several.evaluate(&work).expect("nothing fails"), alone, "{threads} threads");
        assert_eq!(several.pieces(&work, &pieces).expect("nothing fails"), parts, "{threads} threads");
    }
}
