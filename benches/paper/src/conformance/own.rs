//! Files that the artifact does not have: reference values of other programs, which are computed by this project's own
//! code here. They make the folder complete, and confirm nothing.

use crate::actor::{INPUTS, RecordedActor};
use crate::chain::Chain;
use crate::fk::reference;
use crate::torch_random::TorchRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use serde_json::json;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use tpg_arm::observation::Observation;
use tpg_arm::{Collision, JOINTS, Pose, WIDOWX};
use tpg_graph::command::CommandError;
use tpg_problems::arm::targets::Start;

/// The files, for people.
pub(super) const NAMES: [&str; 3] = ["rng_torch_normal4.json", "fk_collision.csv", "forward_checks in sac/*.json"];

const SEED: u64 = 1;
const POSES: usize = 1000;
const CHECKS: usize = 40;

/// Returns draws by seed.
pub(super) fn random_numbers() -> String {
    let draws = |seed: u64| {
        let mut random = TorchRandom::new(seed);
        let draw = |_| [0; JOINTS].map(|_: u8| f64::from(random.normal()));
        (0..8).map(draw).collect::<Vec<_>>()
    };
    let by_seed: BTreeMap<String, _> = [0, 1, 2, 12_345].map(|seed| (seed.to_string(), draws(seed))).into();
    json!(by_seed).to_string()
}

fn pose(random: &mut ChaCha8Rng) -> Pose {
    Pose(WIDOWX.ranges.map(|range| random.random_range(range.min..=range.max)))
}

/// Returns hands and collisions of random poses.
pub(super) fn poses() -> String {
    let (chain, mut random) = (Chain::new(WIDOWX), ChaCha8Rng::seed_from_u64(SEED));
    let mut text = "m0,m1,m2,m3,x,y,z,collision_code\n".to_owned();
    for _ in 0..POSES {
        let found = reference(&chain, pose(&mut random));
        let code = match found.collision {
            None => 0,
            Some(Collision::Table) => 1,
            Some(Collision::HandCorner) => 2,
            Some(Collision::Base) => 3,
        };
        let ([m0, m1, m2, m3], [x, y, z]) = (found.pose.0, found.hand);
        let _ = writeln!(text, "{m0},{m1},{m2},{m3},{x:?},{y:?},{z:?},{code}");
    }
    text
}

/// Returns the description of an actor's weights, with its answers to random states.
pub(super) fn description(weights: &[u8], start: Start) -> Result<String, CommandError> {
    let mut offset = 0;
    let layout: Vec<_> = RecordedActor::layout()
        .map(|(name, shape)| {
            let part = json!({"name": name, "shape": shape, "offset": offset});
            offset += shape.iter().product::<usize>();
            part
        })
        .collect();
    let order = match start {
        Start::Fs => "target/100,diff/100,hand/100,motors",
        Start::Rs => "target/100,hand/100,diff/100,motors",
    };
    let mut description = json!({
        "dtype": "f32 little endian",
        "layout": layout,
        "activation": "fc1->relu->ln1->fc2->relu->ln2->{mu,sigma}; LayerNorm eps 1e-5, sigma=clamp(raw,1e-6,1)",
        "state_order": order,
        "forward_checks": [],
    });
    let place = tempfile::tempdir().map_err(CommandError::other)?;
    let (bytes, text) = (place.path().join("actor.f32"), place.path().join("actor.json"));
    std::fs::write(&bytes, weights).map_err(CommandError::other)?;
    std::fs::write(&text, description.to_string()).map_err(CommandError::other)?;
    let actor = RecordedActor::read(&bytes, &text)?;
    let (chain, mut random) = (Chain::new(WIDOWX), ChaCha8Rng::seed_from_u64(SEED));
    let checks: Vec<_> = (0..CHECKS)
        .map(|_| {
            let pose = pose(&mut random);
            let target = [0; 3].map(|_: u8| f64::from(random.random_range(-300_i32..=300)));
            let state: [f32; INPUTS] = actor.state(&Observation::new(&WIDOWX, pose, chain.hand(pose), target));
            let (mu, sigma) = actor.forward(&state);
            json!({"motors": pose.0, "target": target, "state": state, "mu": mu, "sigma": sigma})
        })
        .collect();
    description["forward_checks"] = json!(checks);
    Ok(description.to_string())
}
