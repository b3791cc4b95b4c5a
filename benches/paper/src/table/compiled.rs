//! The shipped policies as compiled by users: the generated Rust, with this program's own options.

use super::reference::Reference;
use super::timing::{self, Time};
use tpg_arm::binding;
use tpg_arm::cycle::{Brent, CycleDetector, Visited};
use tpg_arm::hybrid::{Guard, Hybrid, Settings};
use tpg_arm::observation::{ArmPolicy, Observation};
use tpg_arm::sac::packed::{Model, PackedPolicy};
use tpg_arm::sac::{Actions, Mask};
use tpg_arm::{Arm, JOINTS, Move, Pose, WIDOWX};
use tpg_engine::random::{Purpose, Stream};
use tpg_generated::widowx_fs::WidowxFs;
use tpg_generated::widowx_fs_fast::WidowxFsFast;
use tpg_generated::widowx_rs::WidowxRs;
use tpg_generated::widowx_rs_fast::WidowxRsFast;
use tpg_generated::{widowx_fs_hybrid, widowx_rs_hybrid, widowx_sac};
use tpg_nn::{Mlp, Shape, Spread};
use tpg_problems::ContinuousProblem;
use tpg_problems::arm::motors::{self, Inputs};
use tpg_problems::arm::targets::{Start, Task};
use tpg_runtime::policy::Policy;
use tpg_train::sac::config::{Actor, Decides};
use tpg_train::sac::contract::{Contract, Provenance};
use tpg_train::sac::interface::Interface;
use tpg_train::sac::motors::MotorNetwork;
use tpg_train::sac::network::Network;

/// The arm that they were trained for, in the precision that they run in.
const ARM: Arm<f32> = WIDOWX.to_f32();

/// Times of a shipped hybrid and its parts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Times {
    /// The graph alone, profile `fast`.
    pub tpg: Time,
    /// The graph alone, profile `constant-time`.
    pub tpg_constant_time: Time,
    /// The network alone, in integers.
    pub sac: Time,
    /// Both, as shipped.
    pub hybrid: Time,
}

/// Other times measured in the same run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Costs {
    /// The shipped hybrid and its parts.
    pub shipped: Times,
    /// The hybrid with each guard, in the order of [`Guard::ALL`].
    pub guards: [Time; 4],
    /// The hybrid with the exact set of visited poses, and with Brent's detector.
    pub detectors: [Time; 2],
    /// The paper's network alone, 13-256-256-4 in `f32`.
    pub reference: Time,
    /// The same shape with the trainer's matrix product, on the widest vectors of the machine.
    pub wide: Time,
}

fn network() -> impl Policy<State = Observation<f32>, Action = Move> + Copy {
    let model = Model::parse(&widowx_sac::MODEL).expect("a committed model");
    PackedPolicy::<{ widowx_sac::SCRATCH }>::new(&ARM, model).expect("its own scratch memory")
}

/// Measures the times on the given tasks.
pub fn times(start: Start, tasks: &[Task]) -> Times {
    use {widowx_fs_hybrid as of_fs, widowx_rs_hybrid as of_rs};
    match start {
        Start::Fs => parts(start, tasks, fs(), of_fs::SETTINGS, &of_fs::Detector::new()),
        Start::Rs => parts(start, tasks, rs(), of_rs::SETTINGS, &of_rs::Detector::new()),
    }
}

/// Number of tasks that are timed.
const TIMED: usize = 100;

/// Measures everything that is compared in one run.
pub fn measure(start: Start, tasks: &[Task]) -> Costs {
    let tasks = &tasks[..TIMED.min(tasks.len())];
    let reference = timing::of_policy_along(&ARM, &Reference::random(1), &network(), start, tasks);
    let shipped = times(start, tasks);
    let (guards, detectors) = match start {
        Start::Fs => variants(start, tasks, fs(), widowx_fs_hybrid::SETTINGS),
        Start::Rs => variants(start, tasks, rs(), widowx_rs_hybrid::SETTINGS),
    };
    Costs { shipped, guards, detectors, reference, wide: wide(start, tasks) }
}

/// Measures the paper's network with the trainer's own matrix product; its weights are random, so it follows the
/// shipped policy's trajectory.
fn wide(start: Start, tasks: &[Task]) -> Time {
    let actor = Actor {
        scaled_inputs: false,
        hidden: vec![256, 256],
        layer_norm: true,
        spread: Spread::Sigma,
        decides: Decides::ByDraw,
    };
    let (inputs, actions, mask) = (Inputs::PaperFs, Actions::Coarse, Mask::None);
    let motors = motors::Config { inputs, actions, mask, may_rest: true, ..motors::Config::default() };
    let problem = ContinuousProblem::Motors(Start::Fs, motors);
    let interface = Interface::new(&&*problem.environment(0), actor.scaled_inputs).expect("motors");
    let shape = Shape {
        inputs: interface.inputs.len(),
        hidden: actor.hidden.clone(),
        outputs: 2 * JOINTS,
        norm: actor.layer_norm,
    };
    let mut random = Stream::new(1, 0, Purpose::Weights, 0);
    let weights = Mlp::random(shape, || random.unit());
    let contract = Contract::new(problem.to_table(), &interface, actor, Provenance::default());
    let wide = MotorNetwork::new(Network::Float(Box::new((weights, contract))), None).expect("a network of the arm");
    timing::of_policy_along(&ARM, &wide.policy(), &network(), start, tasks)
}

fn fs() -> impl Policy<State = Observation<f32>, Action = Move> + Clone {
    let (sources, moves) = const { (&binding::sources(WidowxFsFast::SOURCES), &binding::moves(WidowxFsFast::MOVES)) };
    ArmPolicy::new(WidowxFsFast, &ARM, sources, moves)
}

fn rs() -> impl Policy<State = Observation<f32>, Action = Move> + Clone {
    let (sources, moves) = const { (&binding::sources(WidowxRsFast::SOURCES), &binding::moves(WidowxRsFast::MOVES)) };
    ArmPolicy::new(WidowxRsFast, &ARM, sources, moves)
}

fn parts<T, D>(start: Start, tasks: &[Task], tpg: T, settings: Settings<f32>, detector: &D) -> Times
where
    T: Policy<State = Observation<f32>, Action = Move> + Clone,
    D: CycleDetector<Pose> + Clone,
{
    Times {
        tpg: timing::of_policy(&ARM, &tpg, start, tasks),
        tpg_constant_time: match start {
            Start::Fs => {
                let (sources, moves) =
                    const { (&binding::sources(WidowxFs::SOURCES), &binding::moves(WidowxFs::MOVES)) };
                timing::of_policy(&ARM, &ArmPolicy::new(WidowxFs, &ARM, sources, moves), start, tasks)
            }
            Start::Rs => {
                let (sources, moves) =
                    const { (&binding::sources(WidowxRs::SOURCES), &binding::moves(WidowxRs::MOVES)) };
                timing::of_policy(&ARM, &ArmPolicy::new(WidowxRs, &ARM, sources, moves), start, tasks)
            }
        },
        sac: timing::of_policy(&ARM, &network(), start, tasks),
        hybrid: timing::of_hybrid(&Hybrid { arm: &ARM, tpg, sac: network(), settings }, detector, start, tasks),
    }
}

fn variants<T>(start: Start, tasks: &[Task], tpg: T, settings: Settings<f32>) -> ([Time; 4], [Time; 2])
where
    T: Policy<State = Observation<f32>, Action = Move> + Clone,
{
    let hybrid = |settings| Hybrid { arm: &ARM, tpg: tpg.clone(), sac: network(), settings };
    let guards =
        Guard::ALL.map(|guard| timing::of_hybrid(&hybrid(Settings { guard, ..settings }), &Brent::new(), start, tasks));
    let exact = timing::of_hybrid(&hybrid(settings), &Visited::<4096>::new(), start, tasks);
    let brent = timing::of_hybrid(&hybrid(settings), &Brent::new(), start, tasks);
    (guards, [exact, brent])
}
