//! The compiled part of the Python package `tpg_train`: evolution, graphs and code generation for `model.py` to drive.
//!
//! | module | subject |
//! | --- | --- |
//! | [`graph`] | a graph: decisions, formulas, code, proof, report, picture |
//! | [`evolution`] | runs, which call Python for the results of episodes |
//! | [`policy`] | what a worker is sent |
//! | [`driver`] | whole episodes of a Gymnasium environment |
//! | [`space`] | an environment's observations and actions |
//! | [`eye`] | images as observations |
//! | [`samples`] | labelled samples as an environment |
//! | [`gym`] | an environment that a trainer steps itself |
//! | [`actor`] | soft actor-critics |
//! | [`switch`] | turns of a graph and a network |
//! | [`native`] | the built-in problems as environments |
//! | [`network`] | networks in integers |
//! | [`error`] | Python exceptions |

mod actor;
mod driver;
mod error;
mod evolution;
mod eye;
mod graph;
mod gym;
mod native;
mod network;
mod policy;
mod samples;
mod space;
mod switch;

use pyo3::prelude::*;
use tpg_engine::random::{Purpose, Stream};

/// The seeds of test episodes: no training and no selection reads them.
#[pyfunction]
fn test_seeds(seed: u64, count: u64) -> Vec<u64> {
    (0..count).map(|index| space::seed_of(&mut Stream::new(seed, 0, Purpose::Evaluation, index))).collect()
}

#[pymodule]
fn _tpg(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add("InputError", module.py().get_type::<error::InputError>())?;
    module.add("TrainingError", module.py().get_type::<error::TrainingError>())?;
    module.add_class::<graph::Graph>()?;
    module.add_class::<policy::Policy>()?;
    module.add_class::<driver::Driver>()?;
    module.add_class::<space::Space>()?;
    module.add_class::<eye::Eye>()?;
    module.add_class::<samples::Samples>()?;
    module.add_class::<native::NativeEnv>()?;
    module.add_class::<network::Network>()?;
    module.add_class::<switch::Switch>()?;
    module.add_function(wrap_pyfunction!(actor::train_network, module)?)?;
    module.add_function(wrap_pyfunction!(driver::flat, module)?)?;
    module.add_function(wrap_pyfunction!(driver::success_of, module)?)?;
    module.add_function(wrap_pyfunction!(test_seeds, module)?)?;
    module.add_function(wrap_pyfunction!(evolution::configuration, module)?)?;
    module.add_function(wrap_pyfunction!(evolution::evolve, module)?)?;
    module.add_function(wrap_pyfunction!(native::evaluate_native, module)?)?;
    module.add_function(wrap_pyfunction!(native::quantise_native, module)?)?;
    module.add_function(wrap_pyfunction!(native::problems, module)?)
}
