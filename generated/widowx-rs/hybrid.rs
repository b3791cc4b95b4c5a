//! How this folder's graph and its actor share the arm: made from `hybrid.toml` by `tpg-train`; do not edit.

use tpg_arm::cycle::Brent;
use tpg_arm::hybrid::{Guard, Settings};

/// When they change.
pub const SETTINGS: Settings<f32> = Settings {
    hand_back_after: 1000,
    separation: f32::INFINITY,
    guard: Guard::Both,
};

/// What notices that the graph comes to a pose again.
pub type Detector = Brent;
