//! The module in Node: a thousand targets one after another, and every pose as in native code.

mod support;

use std::fs;
use std::path::Path;
use std::process::Command;
use support::page;
use tpg_testing::library::top;
use tpg_web::arm::{ArmState, Scene};
use tpg_web::eye::Camera;

/// FNV-1a of 64 bits over poses and images.
struct Hash(u64);

impl Hash {
    fn add(&mut self, bytes: impl IntoIterator<Item = u8>) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

fn targets() -> Vec<[f64; 3]> {
    let mut reader = csv::Reader::from_path(top().join("generated/test-targets/rs.csv")).expect("the test episodes");
    let target = |row: Result<csv::StringRecord, _>| {
        let row = row.expect("a row");
        [4, 5, 6].map(|column| row[column].parse().expect("a number"))
    };
    reader.records().map(target).collect()
}

/// The line that `bits.mjs` prints, from native code.
fn native(targets: &[[f64; 3]]) -> String {
    let mut scene = Scene::new().expect("a network");
    let (mut hash, mut actions, mut reached) = (Hash(0xcbf2_9ce4_8422_2325), 0, 0);
    for &target in targets {
        scene.aim(target);
        while !scene.view(0).state.is_end() {
            scene.act(0, 1);
            hash.add(scene.poses()[0].0.iter().flat_map(|ticks| ticks.to_le_bytes()));
            actions += 1;
        }
        reached += u32::from(scene.view(0).state == ArmState::Reached);
    }
    let mut camera = Camera::new(1);
    for _ in 0..200 {
        camera.act();
        hash.add(camera.view().pixels);
    }
    assert_eq!(camera.view().ended, 0, "the ball is in the image");
    format!("{reached} of {} reached, {actions} actions, all {:016x}", targets.len(), hash.0)
}

#[test]
fn a_thousand_targets_give_the_poses_of_native_code() {
    let targets = targets();
    assert_eq!(targets.len(), 1000);
    let expected = native(&targets);
    println!("native: {expected}");
    let Some(folder) = page("the module's bits under Node", &["node"]) else { return };
    assert_eq!(node("bits.mjs", &folder, &targets).trim(), expected);
}

#[test]
fn the_way_that_is_lit_ends_at_the_action_that_is_taken() {
    let Some(folder) = page("the decisions under Node", &["node"]) else { return };
    print!("{}", node("decision.mjs", &folder, &targets()[..40]));
}

/// Runs a script with the page, the targets and the arm's graph; returns what it prints.
fn node(script: &str, folder: &Path, targets: &[[f64; 3]]) -> String {
    let file = std::env::temp_dir().join(format!("tpg-targets-{}-{script}.json", std::process::id()));
    fs::write(&file, format!("{targets:?}")).expect("a folder for temporary files");
    let mut node = Command::new("node");
    node.arg(top().join("web/tests").join(script)).arg(folder).arg(&file);
    let output = node.arg(top().join("generated/widowx-rs/graph.json")).output().expect("node starts");
    let _ = fs::remove_file(&file);
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8_lossy(&output.stdout).into_owned()
}
