//! The paper's own figures, and its own policies run by this project if their recordings are available.

use super::ProblemInputs;
use crate::actor::RecordedActor;
use crate::chain::Chain;
use crate::data::{self, ByRow, Task};
use crate::episode::{EndState, Rules};
use crate::hybrid::{HybridDone, Sampled, episode};
use crate::limits::{max_actions, max_actor_actions};
use crate::sac;
use rayon::prelude::*;
use std::path::Path;
use tpg_arm::hybrid::{Guard, Hybrid, NEVER, Settings};
use tpg_arm::observation::Observation;
use tpg_arm::{Move, WIDOWX};
use tpg_graph::Graph;
use tpg_graph::error::InputError;
use tpg_graph::import::{self, Profile};
use tpg_problems::arm::targets::Start;
use tpg_runtime::ops::System;
use tpg_runtime::policy::Policy;
use tpg_train::hybrid::arm::graph::GraphPolicy;
use tpg_train::hybrid::arm::narrowed::Narrowed;
use tpg_train::hybrid::arm::setting::{Hybrid as Shipped, Setting};
use tpg_train::hybrid::span::Span;
use tpg_train::hybrid::spread::Spread;

/// A row of the paper's table 2: distance in mm, success in % and collision in %, as printed; and the mean and standard
/// deviation over seeds computed from its artifact's own files.
#[derive(Clone, Copy, Debug)]
pub struct Printed {
    /// The policy.
    pub name: &'static str,
    /// As printed.
    pub printed: [f64; 3],
    /// Recomputed from the artifact.
    pub recomputed: [&'static str; 3],
}

/// Returns the paper's rows.
pub const fn printed(start: Start) -> &'static [Printed] {
    match start {
        Start::Fs => &[
            Printed {
                name: "SAC, collisions allowed",
                printed: [7.3, 90.7, 11.2],
                recomputed: ["25.2", "82.0", "11.2"],
            },
            Printed {
                name: "SAC",
                printed: [25.2, 82.0, 11.2],
                recomputed: ["25.2 ± 8.0", "82.0 ± 3.2", "11.2 ± 1.9"],
            },
            Printed {
                name: "TPG",
                printed: [28.5, 56.8, 15.5],
                recomputed: ["28.5 ± 8.9", "56.8 ± 10.2", "15.5 ± 9.8"],
            },
            Printed {
                name: "hybrid",
                printed: [11.3, 86.9, 12.2],
                recomputed: ["11.3 ± 5.9", "86.9 ± 8.4", "12.2 ± 8.3"],
            },
        ],
        Start::Rs => &[
            Printed {
                name: "SAC, collisions allowed",
                printed: [44.1, 57.8, 36.8],
                recomputed: ["33.5 ± 5.0", "43.4 ± 3.9", "4.4"],
            },
            Printed {
                name: "SAC",
                printed: [93.5, 37.4, 36.8],
                recomputed: ["93.5 ± 4.4", "37.4 ± 4.5", "36.8 ± 3.5"],
            },
            Printed {
                name: "TPG",
                printed: [133.7, 22.2, 37.2],
                recomputed: ["134.0 ± 16.6", "22.2 ± 8.4", "37.2 ± 13.6"],
            },
            Printed {
                name: "hybrid",
                printed: [81.2, 49.3, 36.3],
                recomputed: ["81.2 ± 22.2", "49.3 ± 11.3", "36.3 ± 11.2"],
            },
        ],
    }
}

/// A row of the paper's policies, run by this project. Rates lie in 0..1.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// The policies.
    pub name: String,
    /// Number of policies or pairs averaged.
    pub policies: usize,
    /// Final distance, mm.
    pub distance: Spread,
    /// Fraction of the episodes that reached their target.
    pub success: Spread,
    /// Fraction of the episodes whose last action was invalid.
    pub collision: Spread,
    /// Number of actions in an episode.
    pub actions: Spread,
}

impl Measured {
    fn of(name: &str, policies: &[Vec<EndState>]) -> Self {
        let spread = |value: &dyn Fn(&EndState) -> f64| {
            let mean = |ends: &Vec<EndState>| ends.iter().map(value).sum::<f64>() / ends.len().max(1) as f64;
            Spread::of(&policies.iter().map(mean).collect::<Vec<_>>())
        };
        Self {
            name: name.to_owned(),
            policies: policies.len(),
            distance: spread(&|end| end.distance_um as f64 / 1000.0),
            success: spread(&|end| f64::from(u8::from(end.success))),
            collision: spread(&|end| f64::from(u8::from(end.collision))),
            actions: spread(&|end| f64::from(end.actions)),
        }
    }
}

const TPG_SEEDS: u32 = 5;
const SAC_SEEDS: u32 = 3;

struct Recordings {
    chain: Chain,
    tasks: ByRow<Task>,
    graphs: Vec<Graph>,
    actors: Vec<RecordedActor>,
    rules: Rules,
}

/// Runs the paper's policies in the paper's environment; `None` if no folder is given.
///
/// # Errors
/// If a file in the folder is invalid.
pub fn measured(
    start: Start,
    folder: Option<&Path>,
    inputs: &ProblemInputs,
) -> Result<Option<Vec<Measured>>, InputError> {
    let Some(folder) = folder else { return Ok(None) };
    let (name, problem, setting) = match start {
        Start::Fs => ("fs", Start::Fs, Setting::PAPER_FS),
        Start::Rs => ("rs", Start::Rs, Setting::PAPER_RS),
    };
    let graph = |seed| import::load(&folder.join(format!("tpg/{name}_final_s{seed}.dot")), Some(Profile::Ecta24), None);
    let actor = |seed| {
        let file = |suffix: &str| folder.join(format!("sac/{name}_s{seed}.{suffix}"));
        RecordedActor::read(&file("actor.f32"), &file("json"))
    };
    let recordings = Recordings {
        chain: Chain::new(WIDOWX),
        tasks: data::tasks(&folder.join(format!("targets_{name}.csv")))?,
        graphs: (0..TPG_SEEDS).map(graph).collect::<Result<_, _>>()?,
        actors: (0..SAC_SEEDS).map(actor).collect::<Result<_, _>>()?,
        rules: Rules { max_actions: max_actions(problem), tolerance: 3.0 },
    };
    let of_actors = |end_at_collision| {
        let rules = sac::Rules { max_actions: max_actor_actions(problem), tolerance: 3.0, end_at_collision };
        let ends = |actor: &RecordedActor| {
            let done = sac::run(&recordings.chain, rules, &recordings.tasks, actor);
            done.into_values().map(|done| done.end).collect()
        };
        recordings.actors.par_iter().map(ends).collect::<Vec<Vec<EndState>>>()
    };
    let shipped = Shipped::read(&inputs.shipped)?;
    let ours = |settings: Settings<f64>| {
        recordings.with_everyone(settings, SAC_SEEDS.min(1), |_, _, hybrid_of| {
            let policy = shipped.actor.policy();
            hybrid_of(&Narrowed::<f64, _>::new(&policy))
        })
    };
    let paper = setting.settings();
    let guarded = Settings { guard: Guard::Collisions, ..paper };
    let no_hand_back = Settings { hand_back_after: Span::NEVER.0, ..guarded };
    debug_assert_eq!(no_hand_back.hand_back_after, NEVER);
    let sampled = |settings| {
        recordings.with_everyone(settings, SAC_SEEDS, |sac, seed, hybrid_of| {
            hybrid_of(&Sampled::new(&recordings.actors[sac], seed))
        })
    };
    Ok(Some(vec![
        Measured::of("SAC, collisions allowed", &of_actors(false)),
        Measured::of("SAC", &of_actors(true)),
        Measured::of("TPG", &recordings.graphs_alone()?),
        Measured::of("hybrid", &sampled(paper)?),
        Measured::of("hybrid with our guard for joint limits and collisions", &sampled(guarded)?),
        Measured::of("its TPGs, our actor", &ours(paper)?),
        Measured::of("its TPGs, our actor, our guard", &ours(guarded)?),
        Measured::of("its TPGs, our actor, our guard, no hand-back", &ours(no_hand_back)?),
    ]))
}

/// Receives an actor and runs an episode with it.
type HybridOf<'a> = &'a dyn Fn(&dyn Policy<State = Observation<f64>, Action = Move>) -> HybridDone;

impl Recordings {
    /// Runs the graphs alone, by the recorded rules: a hybrid could not end a cycle as the artifact did.
    fn graphs_alone(&self) -> Result<Vec<Vec<EndState>>, InputError> {
        let ends = |graph: &Graph| {
            let policy = GraphPolicy::<f64, System>::new("recorded", graph, &WIDOWX)?;
            let run = |task: &Task| {
                let mut episode = crate::episode::Episode::new(&self.chain, self.rules, task.start, task.target);
                while !episode.advance(policy.decide(episode.observation())) {}
                episode.end_state()
            };
            Ok(self.tasks.values().map(run).collect())
        };
        self.graphs.par_iter().map(ends).collect()
    }

    /// Runs every graph with the given number of actors: `act` creates the actor of an episode and passes it on.
    fn with_everyone(
        &self,
        settings: Settings<f64>,
        actors: u32,
        act: impl Fn(usize, u64, HybridOf<'_>) -> HybridDone + Sync,
    ) -> Result<Vec<Vec<EndState>>, InputError> {
        let pairs: Vec<(usize, usize)> =
            (0..self.graphs.len()).flat_map(|tpg| (0..actors as usize).map(move |sac| (tpg, sac))).collect();
        let ends = |(pair, &(tpg, sac)): (usize, &(usize, usize))| {
            let policy = GraphPolicy::<f64, System>::new("recorded", &self.graphs[tpg], &WIDOWX)?;
            let run = |(row, task): (&u32, &Task)| {
                let seed = pair as u64 * 1000 + u64::from(*row);
                let done = act(sac, seed, &|actor| {
                    let hybrid = Hybrid { arm: &WIDOWX, tpg: &policy, sac: actor, settings };
                    episode(&self.chain, self.rules, task, &hybrid)
                });
                done.end
            };
            Ok(self.tasks.iter().map(run).collect())
        };
        pairs.par_iter().enumerate().map(ends).collect()
    }
}
