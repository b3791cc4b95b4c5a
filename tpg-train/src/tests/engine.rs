//! The engine gives the same results as the interpreter, step by step, for all settings of lanes, sharing and threads.

use crate::configuration::Configuration as _;
use crate::evolution::config::EvolutionConfig;
use crate::evolution::generation::{Evolution, Goal};
use crate::evolution::run::{Naming, graph_of};
use crate::evolution::stage::{Moment, Stage as _};
use crate::evolution::state::{Best, State};
use tpg_arm::binding::moved;
use tpg_arm::cycle::Visited;
use tpg_arm::episode::{Episode, Outcome, Summary};
use tpg_arm::kinematics::Lattice;
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_arm::{Arm, Collision, Invalid, Move, WIDOWX};
use tpg_engine::{Environment, EpisodeResult, Evaluator, Lanes, LocalThreads, Piece, Plan, PolicyGraph, Work};
use tpg_graph::Word;
use tpg_graph::interpret::Interpreter;
use tpg_graph::{Graph, ScalarType};
use tpg_problems::Number;
use tpg_problems::arm::arms::ARMS;
use tpg_problems::arm::targets::{Set, Start, tasks};
use tpg_problems::arm::{self, ArmEnvironment, ArmProblem, ArmTask};
use tpg_problems::{Problem, ProblemSettings};
use tpg_runtime::ops::{Maths, Own};
use tpg_runtime::policy::{ActionId, Policy as _};

/// A configuration that covers everything: every source, every instruction, literals.
fn config(scalar: ScalarType) -> EvolutionConfig {
    let mut config = EvolutionConfig::preset("best-rs").expect("a preset");
    config.language.scalar = scalar;
    config.language.instructions = Word::ALL.map(|word| word.name().to_owned()).to_vec();
    config.tpg.nb_roots = 120;
    config.tpg.init_nb_roots = 20;
    config.tpg.max_init_outgoing_edges = 3;
    config.tpg.p_edge_destination_change = 0.5;
    config
}

/// Returns the arm's configuration with every source.
fn problem() -> arm::ArmConfig {
    let sources = Source::ALL.map(|source| source.name().to_owned()).to_vec();
    arm::ArmConfig { sources, may_stop: true, ..arm::ArmConfig::default() }
}

/// Returns a policy as a run finds it.
fn found(policy: PolicyGraph) -> Best {
    Best { generation: 0, result: tpg_engine::Summary::new(&[]), policy, ranges: None }
}

struct World<S> {
    config: EvolutionConfig,
    environment: ArmEnvironment<S>,
    policies: Vec<PolicyGraph>,
}

/// Returns half the range of every value.
fn literal_units<S: Number>(environment: &ArmEnvironment<S>) -> Vec<f64> {
    let ranges = environment.sources().into_iter().flat_map(|source| source.ranges);
    ranges.map(|[min, max]| 0.5 * (max - min)).collect()
}

impl<S: Number> World<S>
where
    Own: Maths<S>,
{
    /// Creates roots that are several mutations away from random ones, with several levels of teams.
    fn new(scalar: ScalarType, arm: &Arm<f64>, mut problem: arm::ArmConfig) -> Self {
        let config = config(scalar);
        // Random policies that read this source rarely return to a pose, and the test needs cycles.
        problem.sources.retain(|name| name != "stance");
        let environment = ArmEnvironment::<S>::new(arm, problem.problem(Start::Rs));
        let evaluator = LocalThreads::<S, Own, _>::new(&environment, 1).expect("a thread");
        let evolution = Evolution::new(&config, &environment, &evaluator, literal_units(&environment), Goal::default());
        let mut state = State::new(1);
        let mut policies: Vec<PolicyGraph> = Vec::new();
        for generation in 0..7 {
            let moment = Moment { seed: 1, generation };
            let context = evolution.context(&state);
            policies = state.population.ask(&context, moment).into_iter().map(|root| root.policy).collect();
            let genome = &mut state.population.genome;
            let doomed: Vec<_> = genome.roots().into_iter().step_by(2).collect();
            genome.remove_roots(&doomed);
        }
        assert!(policies.iter().map(|policy| policy.teams.len()).max() > Some(4), "deep graphs are wanted");
        Self { config, environment, policies }
    }

    fn graph(&self, policy: &PolicyGraph) -> Graph {
        graph_of(&self.config, 1, &found(policy.clone()), &self.environment, &Naming::default()).expect("a valid graph")
    }
}

/// An arm that differs from the WidowX in everything: longer and shorter links, tighter and wider ranges, another base.
fn another_arm() -> Arm<f64> {
    let text = ARMS[0]
        .text
        .replace("base = 125.0", "base = 90.0")
        .replace("upper_arm = 142.0", "upper_arm = 201.5")
        .replace("elbow_offset = 49.0", "elbow_offset = 0.0")
        .replace("forearm = 142.0", "forearm = 117.25")
        .replace("hand = 155.0", "hand = 80.0\nshoulder_radial = 25.0")
        .replace("hand_length = 160.0", "hand_length = 99.0")
        .replace("[[2, 4094], [1025, 3071]", "[[700, 3500], [800, 3300]")
        .replace("[15.0, 15.0, 95.0, 151.0]", "[30.0, 30.0, 95.0, 120.0]")
        .replace("[15.0, 68.0, 95.0, 95.0]", "[30.0, 68.0, 95.0, 95.0]");
    let text = "[problem]\nname = \"fs\"\n".to_owned() + &text;
    let problem = Problem::from_toml("another arm", &text).expect("an arm that can be");
    let ProblemSettings::Arm(config) = problem.settings else { panic!("an arm") };
    config.arm()
}

fn arm_tasks(arm: &Arm<f64>, count: usize) -> Vec<ArmTask> {
    tasks(arm, 5, Set::Training, Start::Rs, count).into_iter().map(ArmTask::from).collect()
}

/// Runs the runtime's own episode with the interpreter and the exact set of visited poses.
fn by_interpreter<S: Number, M: Maths<S>>(
    graph: &Graph,
    arm: &Arm<S>,
    problem: &ArmProblem,
    task: &ArmTask,
) -> (Vec<ActionId>, Summary<S>) {
    let interpreter = Interpreter::<S, M>::new(graph);
    let (start, play) = (problem.reach(&task.into()), problem.play(&task.into()));
    let mut episode = Episode::with_play(arm, start, Visited::<4096>::new(), play);
    let mut actions = Vec::new();
    let mut state = vec![S::ZERO; graph.state_length()];
    loop {
        Source::fill(&problem.sources, arm, episode.observation(), &TargetMemo::new(), &mut state);
        let action = interpreter.decide(&state);
        actions.push(action);
        let effect = graph.actions()[usize::from(action.0)].effect.as_ref();
        let moves = effect.and_then(|effect| moved(&effect.name, &effect.values)).unwrap_or(Move::STOP);
        if let Some(outcome) = episode.advance(moves) {
            let Observation { pose, .. } = *episode.observation();
            let distance = episode.distance();
            return (actions, Summary { outcome, actions: episode.actions(), pose, distance });
        }
    }
}

fn same<S: Lattice>(ending: &EpisodeResult, summary: &Summary<S>, outcomes: &[&str]) -> bool {
    let name = match summary.outcome {
        Outcome::Reached => "reached",
        Outcome::Cycle => "cycle",
        Outcome::Stop => "stop",
        Outcome::Timeout => "timeout",
        Outcome::Invalid(Invalid::JointLimit(_)) => "joint_limit",
        Outcome::Invalid(Invalid::Collision(Collision::Base)) => "base",
        Outcome::Invalid(_) => "table",
    };
    outcomes[usize::from(ending.outcome)] == name
        && ending.actions == summary.actions
        && ending.measure.to_bits() == summary.distance.to_f64().to_bits()
}

fn engine_is_the_interpreter<S: Number>(scalar: ScalarType, arm: &Arm<f64>, problem: arm::ArmConfig) -> [usize; 7]
where
    Own: Maths<S>,
{
    let world = World::<S>::new(scalar, arm, problem);
    let tasks = arm_tasks(arm, 12);
    let mut ways = [0usize; 7];
    let mut steps = 0;
    for policy in &world.policies {
        let graph = world.graph(policy);
        // The plan comes from the genome's own policy, with introns and shared programs; the graph was written and read
        // again.
        let graph = Graph::from_json("again", &graph.to_json()).expect("what was written can be read");
        let plan = Plan::<S>::new::<Own>(policy, &world.environment.sources());
        let mut lanes = Lanes::<S, Own, _>::new(&world.environment, 5);
        let mut watched = vec![Vec::new(); tasks.len()];
        let endings = lanes.run_watched(&plan, &tasks, |task, act| watched[task].push(ActionId(act.choice() as u16)));
        let endings = endings.expect("no episode of the arm fails");
        for ((task, ending), watched) in tasks.iter().zip(&endings).zip(&watched) {
            let (actions, summary) =
                by_interpreter::<S, Own>(&graph, world.environment.arm(), world.environment.problem(), task);
            // The engine detects a cycle later and then goes back to its first repeat.
            assert_eq!(watched[..actions.len()], actions, "the same actions");
            assert!(same(ending, &summary, world.environment.outcomes()), "{ending:?} against {summary:?}");
            ways[usize::from(ending.outcome)] += 1;
            steps += actions.len();
        }
    }
    assert!(steps > 20_000, "only {steps} steps compared");
    ways
}

#[test]
fn every_step_is_the_interpreters_in_f32() {
    let ways = engine_is_the_interpreter::<f32>(ScalarType::F32, &WIDOWX, problem());
    assert!(ways[1] > 5 && ways[2] > 10 && ways[3] > 10, "cycles, stops and limits must occur: {ways:?}");
}

#[test]
fn every_step_is_the_interpreters_in_f64() {
    let ways = engine_is_the_interpreter::<f64>(ScalarType::F64, &WIDOWX, problem());
    assert!(ways[1] > 5 && ways[2] > 10 && ways[3] > 10, "cycles, stops and limits must occur: {ways:?}");
}

/// So wide a tolerance is reached by chance, and so much play decides when.
#[test]
fn with_play_too_every_step_is_the_interpreters() {
    let loose = arm::ArmConfig { tolerance: 250.0, backlash: 150, ..problem() };
    let [reached, cycles, ..] = engine_is_the_interpreter::<f32>(ScalarType::F32, &WIDOWX, loose.clone());
    assert!(reached > 5 && cycles > 5, "{reached} targets reached, {cycles} cycles");
    engine_is_the_interpreter::<f64>(ScalarType::F64, &another_arm(), loose);
}

#[test]
fn every_step_is_the_interpreters_on_another_arm() {
    let ways = engine_is_the_interpreter::<f32>(ScalarType::F32, &another_arm(), problem());
    assert!(ways[1] > 5 && ways[2] > 10 && ways[3] > 10, "cycles, stops and limits must occur: {ways:?}");
}

#[test]
fn no_number_of_lanes_or_threads_changes_an_answer() {
    let world = World::<f32>::new(ScalarType::F32, &WIDOWX, problem());
    let policies = world.policies.iter().take(tpg_testing::amount(25, usize::MAX)).cloned().collect();
    let work = Work { tasks: arm_tasks(&WIDOWX, tpg_testing::amount(8, 30)), policies };
    let answers = |threads: usize| {
        let evaluator = LocalThreads::<f32, Own, _>::new(&world.environment, threads).expect("threads start");
        evaluator.evaluate(&work).expect("local threads always answer")
    };
    let reference = answers(1);
    assert!(reference.iter().flatten().any(|ending| ending.actions > 100));
    for lanes in [1, 2, 7, 64, 500] {
        let mut lanes = Lanes::<f32, Own, _>::new(&world.environment, lanes);
        let mut run = |policy| lanes.run(&Plan::new::<Own>(policy, &world.environment.sources()), &work.tasks);
        let alone: Result<Vec<_>, _> = work.policies.iter().map(&mut run).collect();
        assert_eq!(alone.expect("nothing fails"), reference);
    }
    for threads in [2, 5] {
        assert_eq!(answers(threads), reference, "{threads} threads");
    }
    assert_eq!(world.config.language.instructions.len(), Word::ALL.len());

    let evaluator = LocalThreads::<f32, Own, _>::new(&world.environment, 2).expect("threads start");
    for parts in [1, 4, 7, 100] {
        let mut joined = vec![Vec::new(); work.policies.len()];
        let pieces = Piece::cut(work.policies.len(), work.tasks.len(), parts);
        assert_eq!(pieces.len() > work.policies.len(), parts > 1);
        for (piece, endings) in pieces.iter().zip(evaluator.pieces(&work, &pieces).expect("local threads answer")) {
            joined[piece.policy].extend(endings);
        }
        assert_eq!(joined, reference, "{parts} parts");
    }
}

#[test]
fn work_survives_its_way_over_a_wire() {
    let world = World::<f32>::new(ScalarType::F32, &WIDOWX, problem());
    let work = Work { tasks: arm_tasks(&WIDOWX, 3), policies: vec![world.policies[3].clone()] };
    let text = serde_json::to_string(&work).expect("work is plain data");
    assert_eq!(serde_json::from_str::<Work<ArmTask>>(&text).expect("and can be read"), work);
}
