//! PyTorch, if available.

use std::path::PathBuf;
use std::process::{Command, Stdio};

/// Returns the Python interpreter that has PyTorch: the one named by `TPG_PYTHON` (default `python3`), or, if
/// `TPG_INSTALL_PYTORCH` is set, one in a virtual environment in the target folder, which pip creates from PyPI in the
/// first run. Otherwise reports that the comparison is skipped.
pub(crate) fn python() -> Option<String> {
    let has_torch = |python: &str| {
        let import = Command::new(python).args(["-c", "import torch"]).stderr(Stdio::null()).status();
        import.is_ok_and(|status| status.success())
    };
    let named = std::env::var("TPG_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    if has_torch(&named) {
        return Some(named);
    }
    if std::env::var_os("TPG_INSTALL_PYTORCH").is_some() {
        let folder: PathBuf = [env!("CARGO_TARGET_TMPDIR"), "pytorch"].iter().collect();
        let own = folder.join("bin/python").display().to_string();
        let done = |mut command: Command| command.status().is_ok_and(|status| status.success());
        if has_torch(&own) {
            return Some(own);
        }
        let mut venv = Command::new(&named);
        venv.args(["-m", "venv"]).arg(&folder);
        let mut install = Command::new(&own);
        install.args(["-m", "pip", "install", "--quiet", "torch", "numpy"]);
        if done(venv) && done(install) && has_torch(&own) {
            return Some(own);
        }
    }
    println!(
        "SKIPPED: PyTorch. {named} has none; name another Python in TPG_PYTHON, or set TPG_INSTALL_PYTORCH=1 to install \
         it from PyPI under the target folder."
    );
    None
}

/// Runs a script of this folder and returns the numbers that it prints, separated by whitespace.
///
/// # Panics
/// If the script fails.
pub(crate) fn numbers(python: &str, script: &str, arguments: &[String]) -> Vec<f64> {
    let path: PathBuf = [env!("CARGO_MANIFEST_DIR"), script].iter().collect();
    let output = Command::new(python).arg(path).args(arguments).stderr(Stdio::null()).output().expect("it ran before");
    assert!(output.status.success(), "{script} failed");
    let text = String::from_utf8_lossy(&output.stdout);
    text.split_whitespace().map(|number| number.parse().expect("a number")).collect()
}

/// Returns the median of an odd number of measurements.
pub(crate) fn median(mut measured: Vec<f64>) -> f64 {
    measured.sort_by(f64::total_cmp);
    measured[measured.len() / 2]
}
