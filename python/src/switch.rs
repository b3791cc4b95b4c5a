//! The rules by which a graph and a network take turns.

use crate::error;
use pyo3::prelude::*;
use tpg_runtime::cycle::Brent;
use tpg_runtime::switch::{AskSwitch, Chosen, Driver, NEVER, Patience, Settings, Turn};

/// The turns of one episode.
#[pyclass(module = "tpg_train._tpg")]
pub(crate) struct Switch {
    rules: AskSwitch<f32, Brent<u64>>,
    patience: Patience<f32>,
    actions: u64,
}

#[pymethods]
impl Switch {
    /// Begins an episode at a distance to the goal; infinite where it is not known yet. The network takes over when the
    /// distance exceeds its least by more than `separation`, or after `patience` actions of the graph without progress, and
    /// hands back after `hand_back_after` actions; `None` is never.
    #[new]
    #[pyo3(signature = (distance, separation = f32::INFINITY, patience = None, hand_back_after = None))]
    fn new(distance: f32, separation: f32, patience: Option<u32>, hand_back_after: Option<u32>) -> PyResult<Self> {
        let bad = |value: Option<u32>| value == Some(0);
        if !matches!(separation, 0.0..) || bad(patience) || bad(hand_back_after) {
            let shown = |value: Option<u32>| value.map_or_else(|| "None".to_owned(), |value| value.to_string());
            let (patience, back) = (shown(patience), shown(hand_back_after));
            let found = format!("separation {separation}, patience {patience}, hand_back_after {back}");
            return Err(error::input(format!("{found}; accepted: a distance from 0, and actions from 1 or None")));
        }
        let settings = Settings { hand_back_after: hand_back_after.unwrap_or(NEVER), separation };
        // Every moment is another one: cycles are not detected.
        let rules = tpg_runtime::switch::Switch::new(settings, Brent::new(), 0_u64, distance);
        Ok(Self {
            rules: AskSwitch::new(rules),
            patience: Patience::new(patience.unwrap_or(NEVER), distance),
            actions: 0,
        })
    }

    /// True if the network has its turn.
    #[getter]
    fn network_drives(&self) -> bool {
        self.rules.driver() == Driver::Sac
    }

    /// Notes an action, the network's because the graph `asked` for it or because it has its turn, and the distance behind it.
    fn acted(&mut self, asked: bool, distance: f32) {
        self.actions += 1;
        let drives = self.network_drives();
        let driver = if asked || drives { Driver::Sac } else { Driver::Tpg };
        let turn = Turn { chosen: Chosen { driver, wanted: () }, asked: asked && !drives };
        let stalls = self.patience.ends(turn.driver(), distance);
        self.rules.acted(&turn, stalls, self.actions, distance);
    }
}
