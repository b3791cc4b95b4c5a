//! Soft actor-critics on Gymnasium environments.

use crate::error;
use crate::evolution::with_settings;
use crate::gym::Gym;
use crate::network::{Network, kind_of};
use crate::space::Space;
use pyo3::prelude::*;
use sha2::{Digest, Sha256};
use tpg_train::sac::config::SacConfig;
use tpg_train::sac::contract::{Contract, Provenance};
use tpg_train::sac::integers::quantise;
use tpg_train::sac::presets;
use tpg_train::sac::training::Training;
use tpg_train::sac::weights::to_tensors;

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
    let preset = presets::find("long").expect("it comes with the trainer").table();
    let settings = with_settings("long", preset, settings)?;
    let config = settings.read(SacConfig::from_toml).map_err(error::input)?;
    let (gym, kind) = (Gym::new(space.clone(), make), kind_of(kind)?);
    py.detach(|| {
        let mut training = Training::new(&gym, config, seed).map_err(error::input)?;
        let validation =
            tpg_engine::tasks(&gym, tpg_engine::TaskSet::Validation, 0, training.config().validation.episodes);
        let every = training.config().validation.every;
        let stopped = || match gym.failed() {
            Some(failed) => Err(failed),
            None => Ok(()),
        };
        let mut ticks = 0_u64;
        while !training.finished() {
            let before = training.decisions() / every;
            training.tick();
            if training.decisions() / every > before || training.finished() {
                training.validate(&validation);
            }
            stopped()?;
            ticks += 1;
            if ticks.is_multiple_of(LOOK) {
                Python::attach(|py| py.check_signals())?;
            }
        }
        let best =
            training.best().ok_or_else(|| error::input("a run without a validation; accepted: more decisions"))?;
        let provenance = Provenance {
            tool: concat!("tpg-train ", env!("CARGO_PKG_VERSION")).to_owned(),
            config: "long".to_owned(),
            seed,
            decisions: best.decisions,
            validation: Some(best.result),
            ..Provenance::default()
        };
        let actor = training.config().actor.clone();
        let contract = Contract::new(toml::Table::new(), training.interface(), actor, provenance);
        let bytes = to_tensors(&best.actor, &contract).to_bytes();
        let sha256 = Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect();
        let policy = quantise("<network>", (&best.actor, &contract), &gym, sha256, kind, seed).map_err(error::input)?;
        stopped()?;
        Ok((Network::of(policy), best.result.score))
    })
}
