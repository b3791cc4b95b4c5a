//! Soft actor-critics on Gymnasium environments.

use crate::error;
use crate::evolution::set_all;
use crate::gym::Gym;
use crate::network::{Network, kind_of};
use crate::space::Space;
use pyo3::prelude::*;
use std::ops::ControlFlow;
use tpg_train::{Configuration as _, Layers, SacConfig};

/// Ticks between two looks for Ctrl-C.
const LOOK: u64 = 256;

/// Trains a network on an environment with outputs, and puts it into integers. `make` makes a driver with an environment of
/// its own; `settings` is a JSON object of other values than the preset `long` has. Returns the network and its mean
/// return on the validation episodes, before it was put into integers.
#[pyfunction]
pub(crate) fn train_network(
    py: Python<'_>,
    space: &Space,
    make: Py<PyAny>,
    settings: &str,
    seed: u64,
    kind: &str,
) -> PyResult<(Network, f64)> {
    let mut layers = Layers::of::<SacConfig>(Some("long"), None, |_| Ok("long")).map_err(error::input)?;
    set_all(&mut layers, settings)?;
    let config = layers.read(SacConfig::from_toml).map_err(error::input)?;
    let (gym, kind) = (Gym::new(space.clone(), make), kind_of(kind)?);
    py.detach(|| {
        let (mut ticks, mut stopped) = (0_u64, Ok(()));
        let watch = || {
            ticks += 1;
            if let Some(error) = gym.failed() {
                stopped = Err(error);
            } else if ticks.is_multiple_of(LOOK) {
                stopped = Python::attach(|py| py.check_signals());
            }
            if stopped.is_err() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let trained = tpg_train::train_network(&gym, config, "long", seed, watch);
        stopped?;
        let (network, result) = trained.map_err(error::input)?;
        let policy = network.quantised(&gym, kind, seed).map_err(error::input)?;
        if let Some(error) = gym.failed() {
            return Err(error);
        }
        Ok((Network(policy), result.score))
    })
}
