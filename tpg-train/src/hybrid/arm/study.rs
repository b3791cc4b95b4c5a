//! The cells of the arm's study: every pair of a graph and an actor under every setting.

use super::setting::{Detector, Setting};
use super::trial;
use crate::hybrid::span::Span;
use crate::hybrid::study;
use crate::sac::motors::MotorNetwork;
use serde::{Deserialize, Serialize};
use tpg_arm::Arm;
use tpg_arm::hybrid::Guard;
use tpg_graph::Graph;
use tpg_graph::error::InputError;
use tpg_problems::arm::ArmProblem;
use tpg_problems::arm::targets::Task;

/// The paper's values of `nbItGoBackTPG`, plus "never".
pub const HAND_BACKS: [Span; 7] = [Span(1), Span(5), Span(10), Span(50), Span(100), Span(1000), Span::NEVER];

/// The paper's values of `sepDistance`, mm.
pub const SEPARATIONS: [f64; 6] = [1.0, 3.0, 10.0, 20.0, 100.0, f64::INFINITY];

/// Returns every setting with the given guards and detectors.
pub fn settings(guards: &[Guard], detectors: &[Detector]) -> Vec<Setting> {
    let mut all = Vec::new();
    for &guard in guards {
        for &detector in detectors {
            for hand_back_after in HAND_BACKS {
                all.extend(SEPARATIONS.map(|separation_mm| Setting {
                    hand_back_after,
                    separation_mm,
                    guard,
                    detector,
                }));
            }
        }
    }
    all
}

/// One row of `cells.csv`: a pair under a setting. Rates lie in 0..1.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Cell {
    /// Position of the graph on the command line, from 0.
    pub tpg: usize,
    /// Position of the actor on the command line, from 0.
    pub sac: usize,
    /// The guard's name.
    pub guard: String,
    /// Method of detecting cycles.
    pub cycle_detector: Detector,
    /// The paper's `nbItGoBackTPG`.
    pub hand_back_after: Span,
    /// The paper's `sepDistance`, mm.
    pub separation_mm: f64,
    /// Number of episodes.
    pub episodes: usize,
    /// Fraction of the episodes that reached their target.
    pub success: f64,
    /// Fraction of the episodes that ended with an invalid action.
    pub collision: f64,
    /// Mean final distance.
    pub distance_mm: f64,
    /// Mean number of actions.
    pub actions: f64,
    /// Fraction of all actions that the graph chose.
    pub tpg_action_ratio: f64,
    /// The same fraction for each episode, averaged over episodes.
    pub tpg_ratio_of_episodes: f64,
    /// Hand-overs per episode because the guard refused.
    pub hand_overs_guard: f64,
    /// Hand-overs per episode because the hand strayed.
    pub hand_overs_drift: f64,
    /// Hand-overs per episode because the graph stopped.
    pub hand_overs_stop: f64,
    /// Hand-overs per episode because the graph cycled.
    pub hand_overs_cycle: f64,
    /// Number of times per episode that the network handed the arm back.
    pub hand_backs: f64,
}

/// Identity of a cell, in the order of `cells.csv`.
type Key = (usize, usize, String, Detector, Span, u64);

impl Cell {
    /// Returns the setting.
    pub fn setting(&self) -> Setting {
        Setting {
            hand_back_after: self.hand_back_after,
            separation_mm: self.separation_mm,
            guard: Guard::from_name(&self.guard).unwrap_or(Guard::None),
            detector: self.cycle_detector,
        }
    }
}

/// Subject of a study.
#[derive(Debug)]
pub struct Study {
    /// The graphs, with their files.
    pub tpgs: Vec<(String, Graph)>,
    /// The actors, with their files.
    pub sacs: Vec<(String, MotorNetwork)>,
    /// The settings.
    pub settings: Vec<Setting>,
    /// The arm.
    pub arm: Arm<f64>,
    /// The rules of the episodes.
    pub problem: ArmProblem,
    /// Tasks of the episodes.
    pub tasks: Vec<Task>,
}

impl study::Study for Study {
    type Setting = Setting;
    type Cell = Cell;
    type Key = Key;

    fn policies(&self) -> [usize; 2] {
        [self.tpgs.len(), self.sacs.len()]
    }

    fn settings(&self) -> &[Setting] {
        &self.settings
    }

    fn key(&self, tpg: usize, sac: usize, setting: &Setting) -> Key {
        let Setting { hand_back_after, separation_mm, guard, detector } = *setting;
        (tpg, sac, guard.name().to_owned(), detector, hand_back_after, separation_mm.to_bits())
    }

    fn key_of(&self, cell: &Cell) -> Key {
        let Cell { tpg, sac, cycle_detector, hand_back_after, separation_mm, .. } = *cell;
        (tpg, sac, cell.guard.clone(), cycle_detector, hand_back_after, separation_mm.to_bits())
    }

    fn cell(&self, tpg: usize, sac: usize, setting: &Setting) -> Result<Cell, InputError> {
        let (file, graph) = &self.tpgs[tpg];
        let done = trial::run(file, graph, &self.sacs[sac].1, setting, self.problem.clone(), &self.tasks)?;
        let [guard, drift, stop, cycle] = done.hand_overs;
        Ok(Cell {
            tpg,
            sac,
            guard: setting.guard.name().to_owned(),
            cycle_detector: setting.detector,
            hand_back_after: setting.hand_back_after,
            separation_mm: setting.separation_mm,
            episodes: done.trial.episodes,
            success: done.trial.success_rate,
            collision: done.trial.collision_rate,
            distance_mm: done.trial.mean_distance_mm,
            actions: done.trial.mean_actions,
            tpg_action_ratio: done.tpg_action_ratio,
            tpg_ratio_of_episodes: done.tpg_ratio_of_episodes,
            hand_overs_guard: guard,
            hand_overs_drift: drift,
            hand_overs_stop: stop,
            hand_overs_cycle: cycle,
            hand_backs: done.hand_backs,
        })
    }
}
