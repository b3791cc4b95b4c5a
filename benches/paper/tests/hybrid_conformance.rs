//! The paper's hybrids: the deterministic part must be equal, row by row; the rest must agree with its recorded
//! statistics.

use crate::support;
use crate::support::hybrid::{Determined, HybridDone, HybridEnd, Sampled, determined, episode, hybrid_ends};
use crate::support::policies::GraphPolicy;
use rayon::prelude::*;
use std::collections::BTreeMap;
use std::path::Path;
use tpg_arm::hybrid::{Guard, Hybrid, Settings};
use tpg_arm::observation::Observation;
use tpg_arm::{Move, WIDOWX};
use tpg_graph::import::{self, Profile};
use tpg_paper::actor::RecordedActor;
use tpg_paper::chain::Chain;
use tpg_paper::data::{self, ByRow, Task};
use tpg_paper::episode::Rules;
use tpg_paper::limits::max_actions;
use tpg_problems::arm::targets::Start;
use tpg_runtime::ops::System;
use tpg_runtime::policy::Policy;

const TPG_SEEDS: u32 = 5;
const SAC_SEEDS: u32 = 3;

struct Recorded {
    tasks: ByRow<Task>,
    ends: Vec<HybridEnd>,
    graphs: Vec<tpg_graph::Graph>,
    actors: Vec<RecordedActor>,
    rules: Rules,
}

impl Recorded {
    fn read(folder: &Path, name: &str, problem: Start) -> Self {
        let tasks = data::tasks(&folder.join(format!("targets_{name}.csv"))).expect("recorded targets");
        let ends = hybrid_ends(&folder.join(format!("hybrid_{name}.ends.csv.gz")));
        let graph = |seed| {
            let file = folder.join(format!("tpg/{name}_final_s{seed}.dot"));
            import::load(&file, Some(Profile::Ecta24), None).expect("a recorded graph")
        };
        let actor = |seed| {
            let file = |suffix: &str| folder.join(format!("sac/{name}_s{seed}.{suffix}"));
            RecordedActor::read(&file("actor.f32"), &file("json")).expect("a recorded actor")
        };
        Self {
            tasks,
            ends,
            graphs: (0..TPG_SEEDS).map(graph).collect(),
            actors: (0..SAC_SEEDS).map(actor).collect(),
            rules: Rules { max_actions: max_actions(problem), tolerance: 3.0 },
        }
    }

    fn tpg(&self, seed: u32) -> GraphPolicy<f64, System> {
        GraphPolicy::new(&self.graphs[seed as usize], &WIDOWX).expect("a graph of the arm")
    }
}

fn settings(separation: f64, hand_back_after: u32) -> Settings<f64> {
    Settings { hand_back_after, separation, guard: Guard::None }
}

/// A policy that is never used: the deterministic part ends before.
struct Nobody;

impl Policy for Nobody {
    type State = Observation<f64>;
    type Action = Move;
    fn decide(&self, _seen: &Observation<f64>) -> Move {
        unreachable!("the network is not asked before the first hand-over")
    }
}

#[test]
fn what_is_determined_comes_out_the_same() {
    let Some(folder) = support::folder("what_is_determined_comes_out_the_same") else { return };
    let chain = Chain::new(WIDOWX);
    // Rows of the graph alone, rows of one turn of the network, and all rows.
    for (name, problem, counts) in [("fs", Start::Fs, (2_691, 1_400, 5_400)), ("rs", Start::Rs, (1_980, 1_066, 6_300))]
    {
        let recorded = Recorded::read(&folder, name, problem);
        // Before the first hand-over neither the actor nor the length of its turns matters.
        let mut known: BTreeMap<(u32, u64, u32), Determined> = BTreeMap::new();
        let tpgs: Vec<_> = (0..TPG_SEEDS).map(|seed| recorded.tpg(seed)).collect();
        let (mut alone, mut one_turn) = (0, 0);
        for end in &recorded.ends {
            let what = format!("{name}: {end:?}");
            let hybrid = Hybrid {
                arm: &WIDOWX,
                tpg: &tpgs[end.tpg_seed as usize],
                sac: Nobody,
                settings: settings(end.separation_mm, end.hand_back_after),
            };
            let ours = *known
                .entry((end.tpg_seed, end.separation_mm.to_bits(), end.row))
                .or_insert_with(|| determined(&chain, recorded.rules, &recorded.tasks[&end.row], &hybrid));
            let tpg_actions = end.end.tpg_actions.expect("a column of this file");
            match end.end.state.actions - tpg_actions {
                0 => {
                    assert_eq!(ours, Determined::Whole(end.end.state), "{what}");
                    alone += 1;
                }
                turn if turn < end.hand_back_after => {
                    assert_eq!(ours, Determined::FirstHandOver(tpg_actions), "{what}");
                    one_turn += 1;
                }
                _ => {
                    let Determined::FirstHandOver(at) = ours else { panic!("no hand-over: {what}, {ours:?}") };
                    assert!(at <= tpg_actions, "{what}: first hand-over after {at}");
                }
            }
        }
        assert_eq!((alone, one_turn, recorded.ends.len()), counts, "{name}: all that was recorded");
    }
}

/// Means over several rows.
#[derive(Debug, Default)]
struct Means {
    distance: f64,
    success: f64,
    collision: f64,
    tpg_ratio: f64,
}

fn means(done: impl ExactSizeIterator<Item = HybridDone>) -> Means {
    let rows = done.len() as f64;
    let mut means = Means::default();
    for HybridDone { end, tpg_actions } in done {
        means.distance += end.distance_um as f64 / 1000.0 / rows;
        means.success += 100.0 * f64::from(u8::from(end.success)) / rows;
        means.collision += 100.0 * f64::from(u8::from(end.collision)) / rows;
        means.tpg_ratio += f64::from(tpg_actions) / f64::from(end.actions) / rows;
    }
    means
}

#[test]
fn the_rest_agrees_within_its_statistics() {
    let Some(folder) = support::folder("the_rest_agrees_within_its_statistics") else { return };
    let chain = Chain::new(WIDOWX);
    // The paper's chosen cell and one with short turns; with the allowed deviations in mm and points, and the number of
    // repetitions.
    let cases = [
        ("fs", Start::Fs, [(20.0, 100), (10.0, 10)], (1.5, 2.0), 3),
        ("rs", Start::Rs, [(10.0, 100), (10.0, 10)], (3.0, 3.0), 1),
    ];
    for (name, problem, cells, (millimetres, points), times) in cases {
        let recorded = Recorded::read(&folder, name, problem);
        for (separation, hand_back_after) in cells {
            let rows: Vec<&HybridEnd> = (recorded.ends.iter())
                .filter(|end| end.separation_mm == separation && end.hand_back_after == hand_back_after)
                .collect();
            assert_eq!(rows.len(), 15 * 60);
            let theirs = means(rows.iter().map(|end| HybridDone {
                end: end.end.state,
                tpg_actions: end.end.tpg_actions.expect("a column of this file"),
            }));
            // Each repetition uses different random numbers.
            let repeated: Vec<&HybridEnd> = rows.iter().cycle().take(times * rows.len()).copied().collect();
            let ours: Vec<HybridDone> = (repeated.par_iter().enumerate())
                .map_init(
                    || (0..TPG_SEEDS).map(|seed| recorded.tpg(seed)).collect::<Vec<_>>(),
                    |tpgs, (number, end)| {
                        let hybrid = Hybrid {
                            arm: &WIDOWX,
                            tpg: &tpgs[end.tpg_seed as usize],
                            sac: Sampled::new(&recorded.actors[end.sac_seed as usize], number as u64),
                            settings: settings(separation, hand_back_after),
                        };
                        episode(&chain, recorded.rules, &recorded.tasks[&end.row], &hybrid)
                    },
                )
                .collect();
            let ours = means(ours.into_iter());
            let what = format!("{name} ({separation}, {hand_back_after}): ours {ours:?}, recorded {theirs:?}");
            assert!((ours.distance - theirs.distance).abs() <= millimetres, "{what}");
            assert!((ours.success - theirs.success).abs() <= points, "{what}");
            assert!((ours.collision - theirs.collision).abs() <= points, "{what}");
            assert!((ours.tpg_ratio - theirs.tpg_ratio).abs() <= 0.03, "{what}");
            println!("{what}");
        }
    }
}
