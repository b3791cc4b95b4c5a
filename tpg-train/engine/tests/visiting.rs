//! The recorded states of an episode are those that the policy itself went through, whether it chooses or computes.

use tpg_engine::random::Stream;
use tpg_engine::{
    Act, ActionSpace, Destination, Edge, Environment, Evaluator, Limits, Line, LocalThreads, Operand, Output, Play,
    PolicyGraph, SourceSet, Step,
};
use tpg_graph::{SourceDocument, Word};
use tpg_runtime::ops::{Instruction, Own};

/// A place that moves by the value, or by 1 for the second action; the third step ends an episode.
struct Walk {
    computes: bool,
}

impl Environment<f32> for Walk {
    type Task = f32;
    type Episode = f32;

    fn sources(&self) -> Vec<SourceDocument> {
        let ranges = vec![[f64::NEG_INFINITY, f64::INFINITY]];
        vec![SourceDocument::new("place", "", ranges)]
    }
    fn actions(&self) -> ActionSpace {
        let output = Output { name: "step".into(), unit: String::new(), min: -8.0, max: 8.0 };
        if self.computes { ActionSpace::Box(vec![output]) } else { ActionSpace::discrete(["stay", "go"]) }
    }
    fn time_limit(&self) -> u32 {
        3
    }
    fn draw(&self, _: &mut Stream) -> f32 {
        1.0
    }
    fn start(&self, task: &f32) -> f32 {
        *task
    }
    fn observe(&self, place: &mut f32, _: SourceSet, state: &mut [f32]) {
        state[0] = *place;
    }
    fn step(&self, place: &mut f32, act: Act<'_, f32>) -> Step {
        *place += match act {
            Act::Values(values) => values[0],
            act => act.choice() as f32,
        };
        Step::reward(0.0)
    }
}

fn visited(computes: bool, policy: PolicyGraph, after: &[u32]) -> Vec<f64> {
    let walk = Walk { computes };
    let evaluator = LocalThreads::<f32, Own, _>::new(&walk, 1).expect("a thread");
    let plays = [Play { policy, task: 1.0, after: after.to_vec() }];
    let played = evaluator.play(&plays).expect("nothing fails");
    played[0].states.iter().map(|state| state[0]).collect()
}

#[test]
fn a_policy_that_computes_walks_by_its_own_values() {
    // The step is the place itself, at most 8: 1, 2, 4, 8.
    let place = Operand::Input(0);
    let line = Line { to: 0, instruction: Word::from(Instruction::Max), operands: [place; 2] };
    let team = vec![Edge { program: 0, to: Destination::Action(0) }];
    let limits = Limits { min: -8.0, max: 8.0, nan: 0.0 };
    let policy = PolicyGraph::new(1, 0, vec![team], vec![vec![line]]).with_outputs(vec![limits], vec![vec![0]]);
    assert_eq!(visited(true, policy, &[0, 1, 1, 2]), [1.0, 2.0, 2.0, 4.0]);
}

#[test]
fn a_policy_that_chooses_walks_by_its_own_actions() {
    let team = vec![Edge { program: 0, to: Destination::Action(1) }];
    let policy = PolicyGraph::new(1, 0, vec![team], vec![vec![]]);
    assert_eq!(visited(false, policy, &[0, 0, 2]), [1.0, 1.0, 3.0]);
}
