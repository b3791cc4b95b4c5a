//! The Python package: built as a wheel, installed into a virtual environment, tested there.

use crate::check::{Run, step};
use crate::venv::{environment, interpreter};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs, io};
use tpg_testing::library::{target_folder, top};

/// The greatest size of a wheel, bytes.
const LARGEST_WHEEL: u64 = 4_000_000;

/// The options of `cargo xtask python`.
#[derive(Clone, Copy, Debug, Default, clap::Args)]
pub(crate) struct PythonArgs {
    /// Build the wheel for users, optimised and stripped, and check its size
    #[arg(long)]
    release: bool,
    /// Install PyTorch and Stable-Baselines3 first, for the tests that need them: gigabytes, once
    #[arg(long)]
    sb3: bool,
}

/// Builds and tests the package.
pub(crate) fn check(run: &mut Run, arguments: PythonArgs) {
    let Some(python) = interpreter() else {
        run.missing("Python package", "Python 3.10 or newer with venv; Debian: python3-venv");
        return;
    };
    let place = target_folder().join("python");
    let steps = || -> io::Result<PathBuf> {
        let venv = environment(&python, &place.join("venv"), &folder().join("requirements.txt"))?;
        let wheel = wheel(&venv, &place, arguments.release)?;
        install(&venv, &wheel)?;
        Ok(venv)
    };
    let venv = match steps() {
        Ok(venv) => venv,
        Err(error) => return run.failed("Python package", &error),
    };
    run.tests("pytest", tests(&venv, &place, &["tests"]));
    let settings = folder().join("pyproject.toml");
    let module = |words: &[&str]| {
        let mut command = command(&venv, &place);
        command.arg("-m").args(words);
        command
    };
    for words in [["ruff", "check", "--no-cache"], ["ruff", "format", "--check"]] {
        let mut style = module(&words);
        style.arg(folder());
        run.check(&words[..2].join(" "), style);
    }
    let mut types = module(&["mypy", "--strict", "--config-file"]);
    types.arg(&settings).arg("--package").arg("tpg_train");
    run.check("mypy of the package", types);
    let mut types = module(&["mypy", "--strict", "--config-file"]);
    types.arg(&settings).arg(folder().join("examples"));
    run.check("mypy of the examples", types);
    let mut stubs = module(&["mypy.stubtest", "tpg_train._tpg", "--mypy-config-file"]);
    stubs.arg(&settings);
    run.check("stubtest", stubs);
    sb3(run, &python, &place, arguments.sb3);
}

/// Tests what needs PyTorch, where it is installed.
fn sb3(run: &mut Run, python: &str, place: &Path, wanted: bool) {
    let home = env::var_os("HOME").map_or_else(|| place.to_owned(), PathBuf::from);
    let own = home.join(".cache/tpg-train/sb3");
    if !wanted && !own.join("bin/python").exists() {
        // The tests have said what they skip.
        return;
    }
    let ready = || -> io::Result<PathBuf> {
        let venv =
            if wanted { environment(python, &own, &folder().join("requirements-sb3.txt"))? } else { own.clone() };
        install(&venv, &newest(&place.join("wheels"))?)?;
        Ok(venv)
    };
    match ready() {
        Ok(venv) => {
            let example = "tests/test_examples.py::test_a_notebook_runs[sb3_to_microcontroller]";
            run.tests("pytest with PyTorch", tests(&venv, place, &["tests/test_sb3.py", example]));
        }
        Err(error) => run.failed("pytest with PyTorch", &error),
    }
}

fn folder() -> PathBuf {
    top().join("python")
}

/// Builds the wheel and returns its path.
fn wheel(venv: &Path, place: &Path, release: bool) -> io::Result<PathBuf> {
    let wheels = place.join("wheels");
    // An old wheel must not be taken for the new one.
    let _ = fs::remove_dir_all(&wheels);
    let python = venv.join("bin/python");
    let mut build = Command::new(&python);
    build.args(["-m", "maturin", "build", "--quiet", "--manifest-path"]).arg(folder().join("Cargo.toml"));
    build.arg("--out").arg(&wheels).arg("--interpreter").arg(&python).env("PYO3_PYTHON", &python);
    build.args(["--profile", if release { "wheel" } else { "dev" }]);
    step(build)?;
    let wheel = newest(&wheels)?;
    let size = fs::metadata(&wheel)?.len();
    println!("{}: {size} bytes", wheel.display());
    if release && size > LARGEST_WHEEL {
        return Err(io::Error::other(format!("a wheel of {size} bytes; accepted: up to {LARGEST_WHEEL}")));
    }
    Ok(wheel)
}

fn newest(wheels: &Path) -> io::Result<PathBuf> {
    let mut files = fs::read_dir(wheels)?.filter_map(|entry| entry.ok().map(|entry| entry.path()));
    let is_wheel = |path: &PathBuf| path.extension().is_some_and(|extension| extension == "whl");
    files.find(is_wheel).ok_or_else(|| io::Error::other(format!("{}: no wheel", wheels.display())))
}

fn install(venv: &Path, wheel: &Path) -> io::Result<()> {
    let mut pip = Command::new(venv.join("bin/python"));
    pip.args(["-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--force-reinstall", "--no-deps"]);
    pip.arg(wheel);
    step(pip)
}

/// Runs pytest. In a folder without the sources: what is tested is the installed wheel.
fn tests(venv: &Path, place: &Path, paths: &[&str]) -> Command {
    let mut pytest = command(venv, place);
    pytest.args(["-m", "pytest", "-q", "-p", "no:cacheprovider", "--rootdir"]).arg(folder());
    pytest.arg("-c").arg(folder().join("pyproject.toml"));
    pytest.args(paths.iter().map(|path| folder().join(path)));
    pytest
}

fn command(venv: &Path, place: &Path) -> Command {
    let mut python = Command::new(venv.join("bin/python"));
    python.current_dir(place).env("PYTHONDONTWRITEBYTECODE", "1");
    python
}
