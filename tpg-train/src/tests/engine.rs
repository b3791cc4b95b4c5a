//! The engine gives the same results as the interpreter, step by step, for all settings of lanes, sharing and threads.

use crate::configuration::Configuration as _;
use crate::evolution::config::EvolutionConfig;
use crate::evolution::generation::{Evolution, Goal};
use crate::evolution::run::graph_of;
use crate::evolution::stage::{Moment, Stage as _};
use crate::evolution::state::{Best, State};
use tpg_arm::binding::moved;
use tpg_arm::cycle::Visited;
use tpg_arm::episode::{Episode, Outcome, Summary};
use tpg_arm::kinematics::Lattice;
use tpg_arm::observation::shield::{ALLOWED, SHIELDED};
use tpg_arm::observation::{Observation, Source, TargetMemo};
use tpg_arm::{Arm, Collision, Invalid, Move, WIDOWX};
use tpg_codegen::emit::Language;
use tpg_codegen::{Options, compile};
use tpg_engine::{
    Destination, Edge, EngineOptions, Environment, EpisodeResult, Evaluator, Lanes, Line, LocalThreads, Operand, Piece,
    Plan, PolicyGraph, Work,
};
use tpg_graph::Word;
use tpg_graph::interpret::Interpreter;
use tpg_graph::{Graph, ScalarType};
use tpg_problems::arm::arms::ARMS;
use tpg_problems::arm::targets::{Set, Start, tasks};
use tpg_problems::arm::{self, ArmEnvironment, ArmProblem, ArmScalar, ArmTask, Shield};
use tpg_problems::{Problem, ProblemSettings};
use tpg_runtime::ops::{Instruction, Maths, Own};
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
fn problem(shield: Shield) -> arm::Config {
    let names = Source::ALL.map(|source| source.name().to_owned());
    let sources = names.into_iter().filter(|name| !name.starts_with("shield_")).collect();
    arm::Config { sources, shield, may_stop: true, ..arm::Config::default() }
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
fn literal_units<S: ArmScalar>(environment: &ArmEnvironment<S>) -> Vec<f64> {
    let ranges = environment.sources().into_iter().flat_map(|source| source.ranges);
    ranges.map(|[min, max]| 0.5 * (max - min)).collect()
}

impl<S: ArmScalar> World<S>
where
    Own: Maths<S>,
{
    /// Creates roots that are several mutations away from random ones, with several levels of teams.
    fn new(scalar: ScalarType, arm: &Arm<f64>, mut problem: arm::Config) -> Self {
        let config = config(scalar);
        let shield = problem.shield;
        if shield == Shield::None {
            // Random policies that read this source rarely return to a pose, and the test needs cycles.
            problem.sources.retain(|name| name != "stance");
        }
        let environment = ArmEnvironment::<S>::new(arm, problem.problem(Start::Rs));
        let evaluator = LocalThreads::<S, Own, _>::new(&environment, EngineOptions::default(), 1).expect("a thread");
        let evolution = Evolution::new(&config, &environment, &evaluator, literal_units(&environment), Goal::default());
        let mut state = State::new(1, 1);
        let mut policies: Vec<PolicyGraph> = Vec::new();
        for generation in 0..7 {
            let moment = Moment { seed: 1, generation, deme: 0 };
            let context = evolution.context(&state);
            policies = state.population.ask(&context, moment).into_iter().map(|root| root.policy).collect();
            let genome = &mut state.population.demes[0].genome;
            let doomed: Vec<_> = genome.roots().into_iter().step_by(2).collect();
            genome.remove_roots(&doomed);
        }
        assert!(policies.iter().map(|policy| policy.teams.len()).max() > Some(4), "deep graphs are wanted");
        Self { config, environment, policies }
    }

    fn graph(&self, policy: &PolicyGraph) -> Graph {
        graph_of(&self.config, 1, &found(policy.clone()), &self.environment).expect("a valid graph")
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

/// Runs the runtime's own episode with the interpreter and the exact set of visited poses; also returns the bid of the
/// last action.
fn by_interpreter<S: ArmScalar, M: Maths<S>>(
    graph: &Graph,
    arm: &Arm<S>,
    problem: &ArmProblem,
    task: &ArmTask,
) -> (Vec<ActionId>, Summary<S>, S) {
    let interpreter = Interpreter::<S, M>::new(graph);
    let (start, play) = (problem.reach(&task.into()), problem.play(&task.into()));
    let mut episode = Episode::with_play(arm, start, Visited::<4096>::new(), play);
    let mut actions = Vec::new();
    let mut state = vec![S::ZERO; graph.state_length()];
    loop {
        Source::fill(&problem.sources, arm, episode.observation(), &TargetMemo::new(), &mut state);
        let (walk, action) = interpreter.walk(&state);
        actions.push(action);
        let effect = graph.actions()[usize::from(action.0)].effect.as_ref();
        let moves = effect.and_then(|effect| moved(&effect.name, &effect.values)).unwrap_or(Move::STOP);
        if let Some(outcome) = episode.advance(moves) {
            let Observation { pose, .. } = *episode.observation();
            let distance = episode.distance();
            let bid = walk.last().expect("a walk has a decision").bid;
            return (actions, Summary { outcome, actions: episode.actions(), pose, distance }, bid);
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

/// True if a shield prevents the given outcome.
fn prevents(shield: Shield, outcome: Outcome) -> bool {
    match outcome {
        Outcome::Invalid(Invalid::JointLimit(_)) => shield != Shield::None,
        Outcome::Invalid(Invalid::Collision(_)) => shield == Shield::LimitsAndCollision,
        _ => false,
    }
}

/// Also checks every shield: an action that it masks is taken only if no edge of the team bid more.
fn engine_is_the_interpreter<S: ArmScalar>(scalar: ScalarType, arm: &Arm<f64>, shield: Shield) -> [usize; 7]
where
    Own: Maths<S>,
{
    engine_is_the_interpreter_in::<S>(scalar, arm, problem(shield))
}

fn engine_is_the_interpreter_in<S: ArmScalar>(scalar: ScalarType, arm: &Arm<f64>, problem: arm::Config) -> [usize; 7]
where
    Own: Maths<S>,
{
    let shield = problem.shield;
    let world = World::<S>::new(scalar, arm, problem);
    let tasks = arm_tasks(arm, 12);
    let mut ways = [0usize; 7];
    let mut steps = 0;
    for policy in &world.policies {
        let graph = world.graph(policy);
        // The plan comes from the genome's own policy, with introns and shared programs; the graph was written and read
        // again.
        let graph = Graph::from_json("again", &graph.to_json()).expect("what was written can be read");
        let plan = Plan::<S>::new::<Own>(policy, &world.environment.sources(), EngineOptions::default());
        let mut lanes =
            Lanes::<S, Own, _>::new(&world.environment, EngineOptions { lanes: 5, ..EngineOptions::default() });
        let mut watched = vec![Vec::new(); tasks.len()];
        let endings = lanes.run_watched(&plan, &tasks, |task, action| watched[task].push(action));
        let endings = endings.expect("no episode of the arm fails");
        for ((task, ending), watched) in tasks.iter().zip(&endings).zip(&watched) {
            let (actions, summary, bid) =
                by_interpreter::<S, Own>(&graph, world.environment.arm(), world.environment.problem(), task);
            if prevents(shield, summary.outcome) {
                // The bid was the highest, so no allowed action was better.
                assert!(bid.to_f64() <= -ALLOWED, "{:?} with a bid of {bid:?} under {shield:?}", summary.outcome);
            }
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
    let ways = engine_is_the_interpreter::<f32>(ScalarType::F32, &WIDOWX, Shield::None);
    assert!(ways[1] > 5 && ways[2] > 10 && ways[3] > 10, "cycles, stops and limits must occur: {ways:?}");
}

#[test]
fn every_step_is_the_interpreters_in_f64() {
    let ways = engine_is_the_interpreter::<f64>(ScalarType::F64, &WIDOWX, Shield::None);
    assert!(ways[1] > 5 && ways[2] > 10 && ways[3] > 10, "cycles, stops and limits must occur: {ways:?}");
}

/// So wide a tolerance is reached by chance, and so much play decides when.
#[test]
fn with_play_too_every_step_is_the_interpreters() {
    let loose = arm::Config { tolerance: 250.0, backlash: 150, ..problem(Shield::None) };
    let [reached, cycles, ..] = engine_is_the_interpreter_in::<f32>(ScalarType::F32, &WIDOWX, loose.clone());
    assert!(reached > 5 && cycles > 5, "{reached} targets reached, {cycles} cycles");
    engine_is_the_interpreter_in::<f64>(ScalarType::F64, &another_arm(), loose);
}

/// Many random policies have teams in which every bid is NaN; a shield does not affect these, and they may collide.
#[test]
fn under_a_shield_too_every_step_is_the_interpreters() {
    let [.., limits, table, base, _] = engine_is_the_interpreter::<f32>(ScalarType::F32, &WIDOWX, Shield::None);
    let [.., limits_of_limits, _, _, _] = engine_is_the_interpreter::<f32>(ScalarType::F32, &WIDOWX, Shield::Limits);
    assert!(limits_of_limits < limits, "{limits_of_limits} of {limits} limits are hit under a shield");
    let [.., limits_of_both, table_of_both, base_of_both, _] =
        engine_is_the_interpreter::<f32>(ScalarType::F32, &WIDOWX, Shield::LimitsAndCollision);
    let (hits, hits_of_both) = (limits + table + base, limits_of_both + table_of_both + base_of_both);
    assert!(hits_of_both < hits, "{hits_of_both} of {hits} invalid actions are done under a shield");
    engine_is_the_interpreter::<f64>(ScalarType::F64, &WIDOWX, Shield::LimitsAndCollision);
}

/// Duplicates are found by value, and values differ under a shield: merging must not change the choice where an edge is
/// masked, and the edges that the compiler keeps must decide like the graph.
#[test]
fn under_a_shield_equal_programs_for_different_actions_stay_two_bids() {
    let line = |input| Line {
        to: 0,
        instruction: Instruction::Add.into(),
        operands: [Operand::Input(input), Operand::Register(1)],
    };
    let edge = |program, action| Edge { program, to: Destination::Action(action) };
    let policy = PolicyGraph::new(8, 0, vec![vec![edge(0, 0), edge(0, 1), edge(0, 0)]], vec![vec![line(0)]]);
    let config = config(ScalarType::F32);
    let environment = problem(Shield::Limits).environment::<f32>(Start::Rs);
    let vocabulary = config.vocabulary(&environment, literal_units(&environment));
    let shielded = policy.shielded(|action| vocabulary.bound(action));
    assert_eq!(shielded.programs.len(), 2, "one for each action");
    let graph = graph_of(&config, 1, &found(shielded), &environment).expect("a valid graph");
    let removed = compile(&graph, &Options::new("policy".parse().expect("a prefix")), Language::C).removed();
    assert_eq!(removed.duplicate_bids, 1, "the first of three");
    let interpreter = Interpreter::<f32, Own>::new(&graph);
    let mut state = vec![0.0f32; graph.state_length()];
    let first = state.len() - SHIELDED;
    let big = ALLOWED as f32;
    for value in [0.0, -0.0, 3.5, f32::NAN, f32::INFINITY, f32::NEG_INFINITY, big, -big] {
        for (up, down, chosen) in [(big, big, 0), (-big, big, 1), (big, -big, 0), (-big, -big, 0)] {
            (state[0], state[first], state[first + 1]) = (value, up, down);
            // A NaN bid, or one not above the refusal's bound, is not capped: all three are then equal, and the last
            // wins.
            let chosen = if value.is_nan() || value <= -big { 0 } else { chosen };
            assert_eq!(interpreter.decide(&state), ActionId(chosen), "{value} under {up} and {down}");
        }
    }
}

#[test]
fn every_step_is_the_interpreters_on_another_arm() {
    let ways = engine_is_the_interpreter::<f32>(ScalarType::F32, &another_arm(), Shield::None);
    assert!(ways[1] > 5 && ways[2] > 10 && ways[3] > 10, "cycles, stops and limits must occur: {ways:?}");
}

#[test]
fn no_option_and_no_number_of_threads_changes_an_answer() {
    let world = World::<f32>::new(ScalarType::F32, &WIDOWX, problem(Shield::None));
    let policies = world.policies.iter().take(tpg_testing::amount(25, usize::MAX)).cloned().collect();
    let work = Work { tasks: arm_tasks(&WIDOWX, tpg_testing::amount(8, 30)), policies };
    let answers = |options: EngineOptions, threads: usize| {
        let evaluator = LocalThreads::<f32, Own, _>::new(&world.environment, options, threads).expect("threads start");
        evaluator.evaluate(&work).expect("local threads always answer")
    };
    let reference = answers(EngineOptions::default(), 1);
    assert!(reference.iter().flatten().any(|ending| ending.actions > 100));
    for lanes in [1, 2, 7, 64, 500] {
        assert_eq!(answers(EngineOptions { lanes, ..EngineOptions::default() }, 1), reference, "{lanes} lanes");
    }
    assert_eq!(
        answers(EngineOptions { lazy: false, ..EngineOptions::default() }, 1),
        reference,
        "with every bid computed"
    );
    for threads in [2, 5] {
        assert_eq!(answers(EngineOptions::default(), threads), reference, "{threads} threads");
    }
    assert_eq!(world.config.language.instructions.len(), Word::ALL.len());

    let evaluator =
        LocalThreads::<f32, Own, _>::new(&world.environment, EngineOptions::default(), 2).expect("threads start");
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
    let world = World::<f32>::new(ScalarType::F32, &WIDOWX, problem(Shield::None));
    let work = Work { tasks: arm_tasks(&WIDOWX, 3), policies: vec![world.policies[3].clone()] };
    let text = serde_json::to_string(&work).expect("work is plain data");
    assert_eq!(serde_json::from_str::<Work<ArmTask>>(&text).expect("and can be read"), work);
}
