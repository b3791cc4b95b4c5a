//! The study's cells: every pair of a graph and an actor under every setting, in parallel and resumable.

use super::setting::{Detector, HandBack, Setting};
use super::trial;
use crate::actor::file::Actor;
use crate::files::write_atomically;
use indicatif::ProgressBar;
use rayon::prelude::*;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use tpg_arm::hybrid::Guard;
use tpg_graph::Graph;
use tpg_graph::error::{InputError, Place};
use tpg_problems::arm::targets::{Start, Task};

/// The paper's values of `nbItGoBackTPG`, plus "never".
pub const HAND_BACKS: [HandBack; 7] =
    [HandBack(1), HandBack(5), HandBack(10), HandBack(50), HandBack(100), HandBack(1000), HandBack::NEVER];

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
    pub hand_back_after: HandBack,
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
type Key = (usize, usize, String, Detector, HandBack, u64);

impl Cell {
    fn key(&self) -> Key {
        let Self { tpg, sac, cycle_detector, hand_back_after, separation_mm, .. } = *self;
        (tpg, sac, self.guard.clone(), cycle_detector, hand_back_after, separation_mm.to_bits())
    }

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
    pub sacs: Vec<(String, Actor)>,
    /// The settings.
    pub settings: Vec<Setting>,
    /// Start of the episodes.
    pub start: Start,
    /// Tasks of the episodes.
    pub tasks: Vec<Task>,
}

/// Interval between saves of finished cells.
const SAVE_EVERY: Duration = Duration::from_secs(10);

impl Study {
    /// Returns the number of cells.
    pub fn size(&self) -> usize {
        self.tpgs.len() * self.sacs.len() * self.settings.len()
    }

    /// Computes one cell.
    ///
    /// # Errors
    /// If the graph does not fit the arm.
    pub fn cell(&self, tpg: usize, sac: usize, setting: &Setting) -> Result<Cell, InputError> {
        let (file, graph) = &self.tpgs[tpg];
        let done = trial::run(file, graph, &self.sacs[sac].1, setting, self.start, &self.tasks)?;
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

    /// Computes all cells that `path` does not hold yet; the file always contains whole rows of finished cells, in
    /// order. `None` if `stop` was set before all were done.
    ///
    /// # Errors
    /// If the file does not belong to a study, a graph does not fit the arm, or the file cannot be written.
    pub fn run(&self, path: &Path, progress: &ProgressBar, stop: &AtomicBool) -> Result<Option<Vec<Cell>>, InputError> {
        let known = if path.exists() { read(path)? } else { Vec::new() };
        let cells: BTreeMap<Key, Cell> = known.into_iter().map(|cell| (cell.key(), cell)).collect();
        let pairs = (0..self.tpgs.len()).flat_map(|tpg| (0..self.sacs.len()).map(move |sac| (tpg, sac)));
        let key = |tpg, sac, s: &Setting| {
            (tpg, sac, s.guard.name().to_owned(), s.detector, s.hand_back_after, s.separation_mm.to_bits())
        };
        let open: Vec<(usize, usize, &Setting)> = pairs
            .flat_map(|(tpg, sac)| self.settings.iter().map(move |setting| (tpg, sac, setting)))
            .filter(|&(tpg, sac, setting)| !cells.contains_key(&key(tpg, sac, setting)))
            .collect();
        progress.set_length(self.size() as u64);
        progress.set_position((self.size() - open.len()) as u64);
        let shared = Mutex::new((cells, Instant::now()));
        open.par_iter().try_for_each(|&(tpg, sac, setting)| {
            if stop.load(Ordering::Relaxed) {
                return Ok(());
            }
            let cell = self.cell(tpg, sac, setting)?;
            progress.inc(1);
            let mut shared = shared.lock().expect("no thread panicked");
            shared.0.insert(cell.key(), cell);
            if shared.1.elapsed() > SAVE_EVERY {
                write(path, shared.0.values())?;
                shared.1 = Instant::now();
            }
            Ok(())
        })?;
        let (cells, _) = shared.into_inner().expect("no thread panicked");
        write(path, cells.values())?;
        Ok((cells.len() == self.size()).then(|| cells.into_values().collect()))
    }
}

/// Writes rows as CSV.
pub fn to_csv<'a, T: Serialize + 'a>(rows: impl Iterator<Item = &'a T>) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    rows.for_each(|row| writer.serialize(row).expect("plain data in memory"));
    writer.into_inner().expect("memory can be written")
}

fn write<'a>(path: &Path, cells: impl Iterator<Item = &'a Cell>) -> Result<(), InputError> {
    write_atomically(path, &to_csv(cells))
}

/// Reads `cells.csv`.
///
/// # Errors
/// If it cannot be read or has a different format.
pub fn read(path: &Path) -> Result<Vec<Cell>, InputError> {
    let name = path.display().to_string();
    let mut reader = csv::Reader::from_path(path)
        .map_err(|error| InputError::new(&name, Place::Whole, error.to_string(), "a cells.csv of a study"))?;
    let cells: Result<Vec<Cell>, csv::Error> = reader.deserialize().collect();
    cells.map_err(|error| {
        let line = error.position().map_or(1, |position| position.line() as usize);
        InputError::new(&name, Place::Line(line), error.to_string(), "a row of a study")
    })
}
