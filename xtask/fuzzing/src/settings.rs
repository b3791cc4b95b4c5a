//! Files of settings, tasks and arms: TOML, CSV and URDF.

use crate::accepted;
use tpg_arm::WIDOWX;
use tpg_problems::arm::import::{Radii, import};
use tpg_problems::arm::targets;
use tpg_problems::dodge::file as scenes_file;
use tpg_problems::{PolicyKind, Problem};
use tpg_train::parts::parse_file;
use tpg_train::{Config as EvolutionConfig, Configuration, SacConfig};

/// Tasks of the arm as CSV.
///
/// # Panics
/// If what is written is not read again.
pub fn targets(data: &[u8]) {
    let parse = |text: &str| targets::parse_csv(&WIDOWX, "targets.csv", text);
    if let Some(tasks) = accepted(parse(&String::from_utf8_lossy(data))) {
        let again = parse(&targets::to_csv(&tasks)).expect("what is written is read");
        assert!(again == tasks, "what is read is what was written");
    }
}

/// Scenes of `dodge` as CSV.
///
/// # Panics
/// If what is written is not read again.
pub fn scenes(data: &[u8]) {
    if let Some(scenes) = accepted(scenes_file::parse_csv("scenes.csv", &String::from_utf8_lossy(data))) {
        let written = scenes_file::to_csv(&scenes);
        let again = scenes_file::parse_csv("written.csv", &written).expect("what is written is read");
        assert_eq!(scenes_file::to_csv(&again), written, "what is read is what was written");
    }
}

/// A URDF, imported with its link `tip` as the tip.
///
/// # Panics
/// If the section that is made of it is no TOML.
pub fn urdf(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let radii = Radii { link: 20.0, base: 60.0 };
    if let Some(text) = accepted(import("fuzzed.urdf", &text, "tip", &[("roll".to_owned(), 0.0)], &[], radii)) {
        drop(text.parse::<toml::Table>().expect("the section is TOML"));
    }
}

/// A `hybrid.toml`, of the arm and of any other problem.
///
/// # Panics
/// If what is written is not read again.
pub fn hybrid(data: &[u8]) {
    let (name, text) = ("hybrid.toml", String::from_utf8_lossy(data));
    if let Some(file) = accepted(parse_file(name, &text)) {
        drop(file.setting().sentence());
        let text = toml::to_string(&file).expect("plain data");
        parse_file(name, &text).expect("what is written is read");
    }
}

/// The configuration of an evolution.
///
/// # Panics
/// If what is written is not read again, or differs.
pub fn tpg_config(data: &[u8]) {
    if let Some(config) = config::<EvolutionConfig>(data) {
        drop(config.instructions());
    }
}

/// The configuration of soft actor-critic.
///
/// # Panics
/// If what is written is not read again, or differs.
pub fn sac_config(data: &[u8]) {
    if let Some(config) = config::<SacConfig>(data) {
        let _ = Problem::from_table("fuzzed.toml", &config.problem, PolicyKind::Network).is_ok();
    }
}

fn config<C: Configuration>(data: &[u8]) -> Option<C> {
    let config = accepted(C::from_toml("fuzzed.toml", &String::from_utf8_lossy(data)))?;
    let text = toml::to_string(&config).expect("plain data");
    let again = C::from_toml("written.toml", &text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    assert_eq!(toml::to_string(&again).expect("plain data"), text);
    Some(config)
}
