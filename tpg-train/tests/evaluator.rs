//! A custom evaluator of roots behind the same trait, which exchanges policies and answers as text, in any order. The run
//! is the same.

use std::cell::{Cell, RefCell};
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;
use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{
    Destination, Edge, Environment, EpisodeResult, EvaluationError, Evaluator, Line, LocalThreads, Moments, Operand,
    Plan, Play, Played, PolicyGraph, Rollout, Single, Work,
};
use tpg_problems::arm::targets::Start;
use tpg_problems::arm::{self, ArmEnvironment, ArmTask};
use tpg_runtime::ops::{Instruction, Own};
use tpg_train::{Config as EvolutionConfig, Configuration as _, RunEnd, RunError, RunOptions, train as run};

/// A remote worker: it receives a policy with the tasks and sends an answer. It has no other information.
struct Worker<'e> {
    environment: &'e ArmEnvironment<f32>,
}

impl Worker<'_> {
    fn ask(&self, message: &str) -> Result<String, EvaluationError> {
        let work: Work<ArmTask> = serde_json::from_str(message).map_err(EvaluationError::new)?;
        let engine = LocalThreads::<f32, Own, _>::new(self.environment, 1)?;
        let answers = engine.evaluate(&work)?;
        serde_json::to_string(&answers).map_err(EvaluationError::new)
    }
}

/// Sends policies one by one, the last first.
struct Wire<'e> {
    worker: Worker<'e>,
    sent: Cell<u32>,
}

impl Evaluator<ArmTask> for Wire<'_> {
    fn evaluate(&self, work: &Work<ArmTask>) -> Result<Vec<Vec<EpisodeResult>>, EvaluationError> {
        let mut answers = Vec::new();
        for policy in work.policies.iter().rev() {
            let one = Work::<ArmTask> { tasks: work.tasks.clone(), policies: vec![policy.clone()] };
            let message = serde_json::to_string(&one).map_err(EvaluationError::new)?;
            let reply: Vec<Vec<EpisodeResult>> =
                serde_json::from_str(&self.worker.ask(&message)?).map_err(EvaluationError::new)?;
            let Ok([answer]) = <[_; 1]>::try_from(reply) else {
                return Err(EvaluationError::new("another number of answers than one to a policy"));
            };
            self.sent.set(self.sent.get() + 1);
            answers.push(answer);
        }
        answers.reverse();
        Ok(answers)
    }

    /// Runs each episode, and once more for its states.
    fn play(&self, plays: &[Play<ArmTask>]) -> Result<Vec<Played>, EvaluationError> {
        let environment = self.worker.environment;
        let one = |Play { policy, task, after }: &Play<ArmTask>| {
            let ending = self.evaluate(&Work { tasks: vec![*task], policies: vec![policy.clone()] })?[0][0];
            let single = Single::<f32, Own>::new(Plan::new::<Own>(policy, &environment.sources()));
            let mut states: Vec<Vec<f64>> = Vec::new();
            Rollout::new(environment, task).run(|state| {
                states.push(state.iter().map(|&value| value.into()).collect());
                single.answer(state).into()
            });
            let mut seen = Moments::new(states[0].len());
            states.iter().take(ending.actions as usize).for_each(|state| seen.push(state));
            Ok(Played { ending, seen, states: after.iter().map(|&after| states[after as usize].clone()).collect() })
        };
        plays.iter().map(one).collect()
    }
}

fn config() -> EvolutionConfig {
    let mut config = EvolutionConfig::preset("best-rs").expect("a preset");
    (config.tpg.nb_roots, config.tpg.init_nb_roots, config.learning.ratio_deleted_roots) = (32, 40, 0.7);
    (config.learning.nb_iterations_per_policy_evaluation, config.learning.nb_generations) = (12, 5);
    (config.selection.lexicase_survivors, config.selection.racing_episodes) = (2, 4);
    config.selection.validation_episodes = 20;
    config
}

fn train<V: Evaluator<ArmTask>>(folder: &Path, environment: &ArmEnvironment<f32>, evaluator: &V) -> Vec<Vec<u8>> {
    let options = RunOptions { folder: folder.to_owned(), ..RunOptions::default() };
    let end = run(&config(), 7, environment, evaluator, &options, |_| ControlFlow::Continue(()));
    assert!(matches!(end, Ok(RunEnd::Finished(_))), "{end:?}");
    let read = |name| fs::read(folder.join(name)).expect("a run leaves it");
    ["graph.json", "generations.jsonl", "checkpoint"].map(read).to_vec()
}

#[test]
fn a_run_is_the_same_wherever_its_roots_are_evaluated() {
    let environment = arm::ArmConfig::default().environment::<f32>(Start::Rs);
    let folder = tempfile::tempdir().expect("a temporary folder");
    let local = LocalThreads::<f32, Own, _>::new(&environment, 2).expect("threads start");
    let wire = Wire { worker: Worker { environment: &environment }, sent: Cell::default() };
    let expected = train(&folder.path().join("local"), &environment, &local);
    assert!(train(&folder.path().join("wire"), &environment, &wire) == expected, "other bytes over a wire");
    assert!(wire.sent.get() > 100 && Environment::<f32>::time_limit(&environment) > 0);
}

/// Loses its connection at the third call.
struct Broken<V> {
    inner: V,
    asked: RefCell<u32>,
}

impl<V: Evaluator<ArmTask>> Evaluator<ArmTask> for Broken<V> {
    fn evaluate(&self, work: &Work<ArmTask>) -> Result<Vec<Vec<EpisodeResult>>, EvaluationError> {
        *self.asked.borrow_mut() += 1;
        if *self.asked.borrow() == 3 { Err(EvaluationError::new("connection lost")) } else { self.inner.evaluate(work) }
    }

    fn play(&self, plays: &[Play<ArmTask>]) -> Result<Vec<Played>, EvaluationError> {
        self.inner.play(plays)
    }
}

#[test]
fn a_lost_machine_is_an_error_and_the_run_can_be_resumed() {
    let config = config();
    let environment = arm::ArmConfig::default().environment::<f32>(Start::Rs);
    let folder = tempfile::tempdir().expect("a temporary folder");
    let local = || LocalThreads::<f32, Own, _>::new(&environment, 1).expect("threads start");
    let expected = train(&folder.path().join("whole"), &environment, &local());
    let broken = Broken { inner: local(), asked: RefCell::new(0) };
    let options = RunOptions {
        folder: folder.path().join("broken"),
        resume: true,
        checkpoint_every: std::time::Duration::ZERO,
        ..RunOptions::default()
    };
    let go = || run(&config, 7, &environment, &broken, &options, |_| ControlFlow::Continue(()));
    let error = go().expect_err("a machine was lost").to_string();
    assert!(error.contains("connection lost"), "{error}");
    assert!(matches!(go(), Ok(RunEnd::Finished(_))));
    let read = |name| fs::read(options.folder.join(name)).expect("a run leaves it");
    assert!(["graph.json", "generations.jsonl", "checkpoint"].map(read).to_vec() == expected);
}

/// Evaluates on threads until it is lost.
struct Losing<'e> {
    threads: LocalThreads<'e, f32, Own, ArmEnvironment<f32>>,
    calls_left: Cell<u32>,
}

impl Evaluator<ArmTask> for Losing<'_> {
    fn evaluate(&self, work: &Work<ArmTask>) -> Result<Vec<Vec<EpisodeResult>>, EvaluationError> {
        let Some(left) = self.calls_left.get().checked_sub(1) else { return Err(EvaluationError::new("lost")) };
        self.calls_left.set(left);
        self.threads.evaluate(work)
    }

    fn play(&self, plays: &[Play<ArmTask>]) -> Result<Vec<Played>, EvaluationError> {
        self.threads.play(plays)
    }
}

#[test]
fn a_run_that_loses_its_evaluator_is_saved_and_ends_as_an_undisturbed_one() {
    let environment = arm::ArmConfig::default().environment::<f32>(Start::Rs);
    let threads = || LocalThreads::<f32, Own, _>::new(&environment, 2).expect("threads start");
    let folder = tempfile::tempdir().expect("a temporary folder");
    let whole = train(&folder.path().join("whole"), &environment, &threads());
    for &calls in tpg_testing::amount(&[0, 5][..], &[0, 1, 5, 8][..]) {
        let options =
            RunOptions { folder: folder.path().join(calls.to_string()), resume: true, ..RunOptions::default() };
        let losing = Losing { threads: threads(), calls_left: Cell::new(calls) };
        let lost = run(&config(), 7, &environment, &losing, &options, |_| ControlFlow::Continue(()));
        assert!(matches!(lost, Err(RunError::Evaluation(_))), "{lost:?}");
        let end = run(&config(), 7, &environment, &threads(), &options, |_| ControlFlow::Continue(()));
        assert!(matches!(end, Ok(RunEnd::Finished(_))), "{end:?}");
        let read = |name| fs::read(options.folder.join(name)).expect("a run leaves it");
        assert_eq!(["graph.json", "generations.jsonl", "checkpoint"].map(read).to_vec(), whole);
    }
}

#[test]
fn an_episode_with_what_was_seen_is_the_same_as_one_that_is_run_again() {
    let environment = arm::ArmConfig::default().environment::<f32>(Start::Rs);
    let threads = LocalThreads::<f32, Own, _>::new(&environment, 2).expect("threads start");
    // Policies that read little: what they do not read is seen, too.
    let policy = |action| {
        let line =
            Line { instruction: Instruction::Mul.into(), to: 0, operands: [Operand::Input(0), Operand::Input(2)] };
        let edges = [action, 8 - action].map(|action| (action, Destination::Action(action)));
        let team = edges.into_iter().enumerate().map(|(program, (_, to))| Edge { program: program as u32, to });
        PolicyGraph::new(2, 0, vec![team.collect()], vec![vec![line], vec![]])
    };
    let task = |number| environment.draw(&mut Stream::new(1, number, Purpose::Test, 0));
    let plays: Vec<_> =
        (0..9).map(|number| Play { policy: policy(number as u16), task: task(number), after: vec![0, 0] }).collect();
    let again = Wire { worker: Worker { environment: &environment }, sent: Cell::default() };
    let expected = again.play(&plays).expect("no machine is lost");
    let played = threads.play(&plays).expect("no machine is lost");
    assert_eq!(played, expected);
    let actions: u64 = played.iter().map(|played| u64::from(played.ending.actions)).sum();
    for Played { ending, seen, states } in &played {
        assert_eq!((seen.count(), seen.length(), states.len()), (u64::from(ending.actions), 5, 2));
    }
    assert!(actions > 1000, "{actions}");
}
