//! An environment that runs elsewhere can fail: its error ends the evaluation and arrives as itself.

use std::error::Error;
use std::fmt;
use tpg_engine::random::Stream;
use tpg_engine::{
    Act, ActionSpace, Acts, Destination, Edge, Environment, EpisodeResult, Episodes, EvaluationError, Evaluator,
    LocalThreads, OneByOne, PolicyGraph, SourceSet, Step, View, Work,
};
use tpg_graph::SourceDocument;
use tpg_runtime::ops::Own;

/// The exception of a user's environment.
#[derive(Debug, PartialEq)]
struct Unplugged {
    step: u32,
}

impl fmt::Display for Unplugged {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "unplugged at step {}", self.step)
    }
}

impl Error for Unplugged {}

/// Counts to ten; a task above 100 loses its connection on the way.
struct Counter;

impl Environment<f32> for Counter {
    type Task = u32;
    type Episode = u32;

    fn sources(&self) -> Vec<SourceDocument> {
        vec![SourceDocument::new("count", "", vec![[0.0, 200.0]])]
    }
    fn actions(&self) -> ActionSpace {
        ActionSpace::discrete(["on", "off"])
    }
    fn time_limit(&self) -> u32 {
        10
    }
    fn draw(&self, _: &mut Stream) -> u32 {
        0
    }
    fn start(&self, task: &u32) -> u32 {
        *task
    }
    fn observe(&self, count: &mut u32, _: SourceSet, state: &mut [f32]) {
        state[0] = *count as f32;
    }
    fn step(&self, count: &mut u32, _: Act<'_, f32>) -> Step {
        *count += 1;
        Step::reward(1.0)
    }
    fn lanes(&self) -> Box<dyn Episodes<f32, u32> + '_> {
        Box::new(Remote { inner: OneByOne::new(self), fragile: false, step: 0 })
    }
}

/// The counter on another machine.
struct Remote<'e> {
    inner: OneByOne<'e, f32, Counter>,
    fragile: bool,
    step: u32,
}

impl Episodes<f32, u32> for Remote<'_> {
    fn begin(&mut self, lane: usize, task: &u32) -> Result<(), EvaluationError> {
        self.fragile |= *task > 100;
        self.inner.begin(lane, task)
    }
    fn step(&mut self, acts: Acts<'_, f32>, ended: &mut Vec<(usize, EpisodeResult)>) -> Result<(), EvaluationError> {
        self.step += 1;
        if self.fragile && self.step == 3 {
            return Err(EvaluationError::new(Unplugged { step: self.step }));
        }
        self.inner.step(acts, ended)
    }
    fn keys(&self) -> &[u64] {
        self.inner.keys()
    }
    fn cycle(&self, lane: usize, key: u64, actions: u32) -> Option<EpisodeResult> {
        self.inner.cycle(lane, key, actions)
    }
    fn observe(&mut self, wanted: SourceSet, view: &mut View<'_, f32>) -> Result<(), EvaluationError> {
        self.inner.observe(wanted, view)
    }
    fn close_up(&mut self, lane: usize) {
        self.inner.close_up(lane);
    }
}

#[test]
fn an_error_of_an_episode_arrives_as_itself() {
    let edge = |action| Edge { program: 0, to: Destination::Action(action) };
    let policy = PolicyGraph::new(1, 0, vec![vec![edge(0), edge(1)]], vec![Vec::new()]);
    let evaluator = LocalThreads::<f32, Own, _>::new(&Counter, 2).expect("threads start");
    let work = |tasks: Vec<u32>| Work { tasks, policies: vec![policy.clone(); 4] };

    let error = evaluator.evaluate(&work(vec![1, 2, 101])).expect_err("one episode loses its connection");
    assert!(error.to_string().ends_with("unplugged at step 3"), "{error}");
    let inner = error.into_inner().downcast::<Unplugged>().expect("the error that was raised");
    assert_eq!(*inner, Unplugged { step: 3 });

    let answers = evaluator.evaluate(&work(vec![1, 2])).expect("nothing of the failure is left");
    assert!(answers.iter().flatten().all(|ending| ending.score == 10.0));
}
