//! An environment of hidden type does what the environment does.

use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{
    AnyTask, Destination, Edge, Environment, EpisodeResult, Evaluator, Line, LocalThreads, Operand, PolicyGraph,
    SourceSet, Work, erase,
};
use tpg_problems::{CartPole, Problem, ProblemName};
use tpg_runtime::ops::{Instruction, Own};

/// `left` bids 0 and `right` the sum of angle and angular velocity.
fn falling() -> PolicyGraph {
    let sum = Line { to: 0, instruction: Instruction::Add.into(), operands: [Operand::Input(2), Operand::Input(3)] };
    let edge = |program: u32, action| Edge { program, to: Destination::Action(action) };
    PolicyGraph::new(1, 0, vec![vec![edge(0, 0), edge(1, 1)]], vec![vec![], vec![sum]])
}

fn endings<E: Environment<f32>>(environment: &E) -> Vec<EpisodeResult> {
    let draw = |index| environment.draw(&mut Stream::new(7, 0, Purpose::Task, index));
    let work = Work { tasks: (0..50).map(draw).collect(), policies: vec![falling()] };
    let evaluator = LocalThreads::<f32, Own, _>::new(environment, 1).expect("a thread");
    evaluator.evaluate(&work).expect("local threads answer").remove(0)
}

#[test]
fn episodes_end_as_those_of_the_environment() {
    let hidden = erase::<f32, _>(CartPole);
    let expected = endings(&CartPole);
    assert!(expected.iter().any(|ending| ending.actions > 100), "some last");
    assert_eq!(endings(&&*hidden), expected);
}

#[test]
fn a_task_looks_in_a_file_as_the_problems_own() {
    let hidden = erase::<f32, _>(CartPole);
    let stream = || Stream::new(7, 0, Purpose::Task, 3);
    let (own, any) = (Environment::<f32>::draw(&CartPole, &mut stream()), hidden.draw(&mut stream()));
    let text = serde_json::to_string(&own).expect("plain data");
    assert_eq!(serde_json::to_string(&any).expect("plain data"), text);
    let read: AnyTask = serde_json::from_str(&text).expect("JSON");
    assert_eq!(read, any);
    assert!(hidden.accepts(&read));
    let mut states = [[0.0_f32; 4]; 2];
    for (task, state) in [any, read].iter().zip(&mut states) {
        hidden.observe(&mut hidden.start(task), SourceSet::ALL, state);
    }
    assert_eq!(states[0].map(f32::to_bits), states[1].map(f32::to_bits));
}

#[test]
fn a_task_of_another_problem_is_not_accepted() {
    for name in ProblemName::ALL {
        let environment = Problem::new(name).environment::<f32>();
        for text in ["null", "\"left\"", "[]", "{}"] {
            let task: AnyTask = serde_json::from_str(text).expect("JSON");
            assert!(!environment.accepts(&task), "{}: {text}", name.name());
        }
        let drawn = environment.draw(&mut Stream::new(1, 0, Purpose::Task, 0));
        assert!(environment.accepts(&drawn), "{}", name.name());
    }
}
