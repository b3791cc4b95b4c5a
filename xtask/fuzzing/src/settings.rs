//! Files of settings and tasks: TOML and CSV.

use std::cell::OnceCell;
use std::fs;
use std::path::Path;
use tempfile::TempDir;
use tpg_arm::WIDOWX;
use tpg_problems::arm::targets;
use tpg_problems::continuous::ContinuousProblem;
use tpg_train::evolution::config::EvolutionConfig;
use tpg_train::hybrid::arm::setting::HybridFile;
use tpg_train::hybrid::setting::read_file;
use tpg_train::sac;

/// Gives a function a file with some content.
pub(crate) fn with_file<T>(content: &[u8], name: &str, read: impl FnOnce(&Path) -> T) -> T {
    thread_local! { static FOLDER: OnceCell<TempDir> = const { OnceCell::new() } }
    FOLDER.with(|folder| {
        let folder = folder.get_or_init(|| TempDir::new().expect("a temporary folder"));
        let path = folder.path().join(name);
        fs::write(&path, content).expect("the folder can be written");
        read(&path)
    })
}

/// Tasks of the arm as CSV.
///
/// # Panics
/// If what is written is not read again.
pub fn targets(data: &[u8]) {
    let read = |content: &[u8]| with_file(content, "targets.csv", |path| targets::read_csv(&WIDOWX, path));
    match read(data) {
        Ok(tasks) => {
            let again = read(targets::to_csv(&tasks).as_bytes()).expect("what is written is read");
            assert!(again == tasks, "what is read is what was written");
        }
        Err(error) => drop(error.to_string()),
    }
}

/// A `hybrid.toml`, of the arm and of any other problem.
///
/// # Panics
/// If what is written is not read again.
pub fn hybrid(data: &[u8]) {
    match with_file(data, "hybrid.toml", HybridFile::read) {
        Ok(file) => {
            assert!(file.to_rust().is_ok(), "what is read is a setting");
            drop(file.setting().map(|setting| setting.sentence()));
            let text = toml::to_string(&file).expect("plain data");
            with_file(text.as_bytes(), "hybrid.toml", HybridFile::read).expect("what is written is read");
        }
        Err(error) => drop(error.to_string()),
    }
    match with_file(data, "hybrid.toml", read_file) {
        Ok(file) => {
            drop((file.to_rust(), file.setting().sentence()));
            let text = toml::to_string(&file).expect("plain data");
            with_file(text.as_bytes(), "hybrid.toml", read_file).expect("what is written is read");
        }
        Err(error) => drop(error.to_string()),
    }
}

/// The configuration of an evolution.
///
/// # Panics
/// If what is written is not read again, or differs.
pub fn tpg_config(data: &[u8]) {
    match EvolutionConfig::from_toml("fuzzed.toml", &String::from_utf8_lossy(data)) {
        Ok(config) => {
            let text = config.to_toml();
            let again =
                EvolutionConfig::from_toml("written.toml", &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
            assert_eq!(again.to_toml(), text);
            drop(config.instructions());
        }
        Err(error) => drop(error.to_string()),
    }
}

/// The configuration of soft actor-critic.
///
/// # Panics
/// If what is written is not read again, or differs.
pub fn sac_config(data: &[u8]) {
    match sac::config::SacConfig::from_toml("fuzzed.toml", &String::from_utf8_lossy(data)) {
        Ok(config) => {
            let text = config.to_toml();
            let again = sac::config::SacConfig::from_toml("written.toml", &text);
            let again = again.unwrap_or_else(|error| panic!("{error}\n{text}"));
            assert_eq!(again.to_toml(), text);
            let _ = ContinuousProblem::from_table("fuzzed.toml", &config.problem).is_ok();
        }
        Err(error) => drop(error.to_string()),
    }
}
