//! Settings for sharing the arm between this folder's graph and its actor: those of `hybrid.toml`.

use tpg_arm::cycle::Brent;
use tpg_arm::hybrid::{Guard, Settings};

/// The distance and the number of actions at which the policies take turns.
pub const SETTINGS: Settings<f32> = Settings {
    hand_back_after: 1000,
    separation: f32::INFINITY,
    guard: Guard::Both,
};

/// The detector of cycles: it notices that the graph returns to an earlier pose.
pub type Detector = Brent;
