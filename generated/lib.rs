//! This project's own trained policies, compiled by `tpg-codegen`.
//!
//! Each folder holds a policy's `graph.json`, the C and Rust made of it, and `PROVENANCE.md`: how it was trained and how
//! well it does; `hybrid.toml` and `hybrid.rs` say how it shares the arm with the network. `widowx-sac` is a soft actor-critic's network instead: its weights, the same in integers, and the Rust
//! constants of those. `dodge` chooses among behaviours of an arm among moving balls. `asterix`, `breakout` and `space-invaders`
//! see images of MinAtar's games, `eye` those of a camera. The other folders are problems of Gymnasium. Tests fail when regenerating gives other bytes.
//!
//! ```
//! use tpg_generated::widowx_fs::WidowxFs;
//! use tpg_arm::WIDOWX;
//! use tpg_arm::binding;
//! use tpg_arm::cycle::Brent;
//! use tpg_arm::episode::{Episode, Outcome, ReachTask};
//! use tpg_arm::observation::ArmPolicy;
//!
//! let arm = WIDOWX.to_f32();
//! let policy = ArmPolicy::new(WidowxFs, &arm, &const { binding::sources(WidowxFs::SOURCES) }, &const { binding::moves(WidowxFs::MOVES) });
//! let problem = ReachTask { start: arm.home, target: [-23.17, -377.16, 322.52], tolerance: 3.0, max_actions: 1707 };
//! let summary = Episode::new(&arm, problem, Brent::new()).run(&policy, |_pose| ());
//! assert_eq!(summary.outcome, Outcome::Reached);
//! ```

#![no_std]

#[path = "acrobot/acrobot.rs"]
pub mod acrobot;
#[path = "asterix/asterix.rs"]
pub mod asterix;
#[path = "bipedal-walker/bipedal_walker.rs"]
pub mod bipedal_walker;
#[path = "breakout/breakout.rs"]
pub mod breakout;
#[path = "cartpole/cartpole.rs"]
pub mod cartpole;
#[path = "dodge/dodge.rs"]
pub mod dodge;
#[path = "eye/eye.rs"]
pub mod eye;
#[path = "half-cheetah/half_cheetah.rs"]
pub mod half_cheetah;
#[path = "hopper/hopper.rs"]
pub mod hopper;
#[path = "inverted-double-pendulum/inverted_double_pendulum.rs"]
pub mod inverted_double_pendulum;
#[path = "lunar-lander/lunar_lander.rs"]
pub mod lunar_lander;
#[path = "lunar-lander-continuous/lunar_lander_continuous.rs"]
pub mod lunar_lander_continuous;
#[path = "mountain-car/mountain_car.rs"]
pub mod mountain_car;
#[path = "mountain-car-continuous/mountain_car_continuous.rs"]
pub mod mountain_car_continuous;
#[path = "pendulum/pendulum.rs"]
pub mod pendulum;
#[path = "space-invaders/space_invaders.rs"]
pub mod space_invaders;
#[path = "swimmer/swimmer.rs"]
pub mod swimmer;
#[path = "widowx-fs/widowx_fs.rs"]
pub mod widowx_fs;
#[path = "widowx-fs/widowx_fs_fast.rs"]
pub mod widowx_fs_fast;
#[path = "widowx-fs/hybrid.rs"]
pub mod widowx_fs_hybrid;
#[path = "widowx-rs/widowx_rs.rs"]
pub mod widowx_rs;
#[path = "widowx-rs/widowx_rs_fast.rs"]
pub mod widowx_rs_fast;
#[path = "widowx-rs/hybrid.rs"]
pub mod widowx_rs_hybrid;
#[path = "widowx-sac/policy.rs"]
pub mod widowx_sac;
