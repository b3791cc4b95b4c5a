//! Virtual environments of Python under the target folder, with pinned packages.

use crate::check::step;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};
use tpg_testing::answers;

/// Finds a Python of 3.10 or newer that can make virtual environments.
pub(crate) fn interpreter() -> Option<String> {
    let named = env::var("TPG_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let test = "import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 10))";
    answers(&named, &["-c", test]).then_some(named)
}

/// Makes a virtual environment with the pinned requirements, unless it is there.
pub(crate) fn environment(python: &str, venv: &Path, requirements: &Path) -> io::Result<PathBuf> {
    let stamp = venv.join("requirements.txt");
    let wanted = fs::read_to_string(requirements)?;
    if fs::read_to_string(&stamp).is_ok_and(|have| have == wanted) {
        return Ok(venv.to_owned());
    }
    let mut make = Command::new(python);
    make.args(["-m", "venv", "--clear"]).arg(venv);
    step(make)?;
    let mut pip = Command::new(venv.join("bin/python"));
    pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "-r"]).arg(requirements);
    step(pip)?;
    fs::write(stamp, wanted)?;
    Ok(venv.to_owned())
}
