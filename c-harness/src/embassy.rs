//! The example in Embassy: it stops where the same loop stops here.

use crate::Failure;
use crate::emulate;
use crate::expected::{self, ARM};
use crate::line::Line;
use crate::problems::settings;
use tpg_arm::Pose;
use tpg_arm::cycle::Brent;
use tpg_arm::episode::{ReachTask, Summary};
use tpg_arm::hybrid::{Hybrid, HybridEpisode};
use tpg_problems::arm::targets::Start;
use tpg_testing::library;

const TARGET: &str = "thumbv7m-none-eabi";
const BOARD: &str = "lm3s6965evb";
/// The example's folder, and the end of its name.
const EXAMPLE: &str = "example-embassy";

/// As in the example.
const WHERE: [f32; 3] = [-250.0, 239.0, 267.0];
const TOLERANCE_MM: f32 = 3.0;
const MOST_STEPS: u32 = 1707;

/// Builds the example, runs it, and compares where it stops.
pub(crate) fn check() -> Result<(), Failure> {
    if !library::rust_target(TARGET, "the example in Embassy") {
        return Ok(());
    }
    let expected = expected();
    let made = library::target_folder().join(EXAMPLE);
    // Another workspace, with a target folder of its own.
    let mut cargo = library::cargo(&["build", "--quiet", "--release", "--locked"]);
    cargo.current_dir(library::top().join("c-harness").join(EXAMPLE)).env("CARGO_TARGET_DIR", &made);
    cargo.env_remove("CARGO_ENCODED_RUSTFLAGS");
    library::output(&mut cargo)?;
    let image = made.join(TARGET).join("release").join(format!("tpg-{EXAMPLE}"));
    let lines = emulate::until_done(emulate::qemu("qemu-system-arm", BOARD).arg(image))?;
    if lines.iter().filter(|line| line.words == ["stopped"]).ne([&expected]) {
        return Err(Failure(format!("the example in Embassy is not the host: {lines:?}, not {expected:?}")));
    }
    println!("Embassy on {BOARD}: {} actions, stopped where the host does", expected.number("actions"));
    Ok(())
}

/// The example's loop on this machine.
fn expected() -> Line {
    let hybrid = Hybrid { arm: &ARM, tpg: expected::fs(), sac: expected::network(), settings: settings(Start::Fs) };
    let task = ReachTask { start: ARM.home, target: WHERE, tolerance: TOLERANCE_MM, max_actions: MOST_STEPS };
    let Summary { actions, pose, .. } = HybridEpisode::new(&hybrid, task, Brent::new()).run(|_, _| ()).summary;
    let Pose([base, shoulder, elbow, wrist]) = pose;
    Line::parse(&format!("stopped actions={actions} base={base} shoulder={shoulder} elbow={elbow} wrist={wrist}"))
}
