//! PyTorch, if available.

use std::path::PathBuf;
use std::process::{Command, Stdio};

/// Returns the Python interpreter that has PyTorch, named by `TPG_PYTHON` (default `python3`); otherwise reports that the comparison is
/// skipped.
pub(crate) fn python() -> Option<String> {
    let named = std::env::var("TPG_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let import = Command::new(&named).args(["-c", "import torch"]).stderr(Stdio::null()).status();
    if import.is_ok_and(|status| status.success()) {
        return Some(named);
    }
    println!("SKIPPED: PyTorch. {named} has none; name another Python in TPG_PYTHON.");
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
