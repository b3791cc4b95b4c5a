//! Errors as Python exceptions, with the messages of the command lines.

use pyo3::create_exception;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use std::fmt::Display;

create_exception!(tpg_train, InputError, PyValueError, "A file, a setting or an environment that is not accepted.");
create_exception!(tpg_train, TrainingError, PyRuntimeError, "A run that cannot go on. What it had learned is saved.");

/// Wraps what is wrong with an input.
pub(crate) fn input(error: impl Display) -> PyErr {
    InputError::new_err(error.to_string())
}

/// Wraps what ended a run.
pub(crate) fn training(error: impl Display) -> PyErr {
    TrainingError::new_err(error.to_string())
}
