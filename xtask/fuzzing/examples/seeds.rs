//! Writes the seeds of every target to `fuzz/corpus`: small real files of each kind.
//!
//! `cargo run -p tpg-fuzzing --example seeds`

use std::fs;
use tpg_codegen::policy::{self, QuantisedPolicy};
use tpg_fuzzing::checkpoints;
use tpg_graph::Graph;
use tpg_graph::sample::{self, Shape};
use tpg_testing::library::top;
use tpg_train::{Config as EvolutionConfig, Configuration as _, SacConfig};

fn main() -> std::io::Result<()> {
    let put = |target: &str, name: &str, content: &[u8]| {
        let folder = top().join("fuzz/corpus").join(target);
        fs::create_dir_all(&folder)?;
        fs::write(folder.join(name), content)
    };
    let read = |path: &str| fs::read(top().join(path));

    for name in ["all_instructions", "formula", "swing_up"] {
        put("graph_json", name, &read(&format!("tpg-codegen/tests/fixtures/{name}.json"))?)?;
    }
    let small = |shape: Shape| Shape { teams: shape.teams.min(4), edges: 1..=3, lines: 0..=3, ..shape };
    for seed in 1..=3 {
        let graph: Graph = sample::graph(&small(Shape::random(seed)), seed);
        put("graph_json", &format!("random_{seed}"), graph.to_json().as_bytes())?;
    }
    for name in ["pole", "swing"] {
        let part = |kind: &str| read(&format!("tpg-codegen/tests/fixtures/{name}.{kind}"));
        put("dot", name, &[part("toml")?, b"\n%%\n".to_vec(), part("dot")?].concat())?;
    }
    put("trace", "states", b"in0[0],in0[1],in1[0],other\n1,2,3,x\n-0.5,nan,inf,\n")?;
    for seed in 0_u8..3 {
        put("compiled", &format!("shape_{seed}"), &[[seed + 1; 16], [3 * seed + 2; 16]].concat())?;
    }

    let kind = "w16a16";
    let text = read(&format!("tpg-codegen/tests/fixtures/policy-kinds/{kind}.q.json"))?;
    put("policy", kind, &text)?;
    let policy = QuantisedPolicy::from_json(kind, &String::from_utf8_lossy(&text)).expect("a policy");
    let words = policy::to_words(&policy).expect("a small network");
    let bytes: Vec<u8> = [1].into_iter().chain(words.iter().flat_map(|word| word.to_le_bytes())).collect();
    put("packed_words", kind, &bytes)?;
    put("safetensors", "arm", &read("generated/seeds/sac-paper-fs-16-units-1.safetensors")?)?;
    for trainer in ["cleanrl", "sb3"] {
        put("safetensors", trainer, &read(&format!("tpg-train/tests/fixtures/foreign-actors/{trainer}.safetensors"))?)?;
    }

    let targets = String::from_utf8_lossy(&read("generated/test-targets/rs.csv")?).into_owned();
    put("targets", "rs", (targets.lines().take(5).collect::<Vec<_>>().join("\n") + "\n").as_bytes())?;
    put("targets", "recorded", b"row,m0,m1,m2,m3,tx,ty,tz\n0,2048,2048,2048,2048,-290,-140,350\n")?;
    put("hybrid", "arm", &read("generated/widowx-fs/hybrid.toml")?)?;
    let pendulum = "problem = \"pendulum\"\ngraph = \"graph.json\"\nactor = \"policy.q.json\"\n\
                    hand_back_after = 20\nseparation = 2.5\npatience = \"never\"\ncycle_detector = \"none\"\n";
    put("hybrid", "pendulum", pendulum.as_bytes())?;
    for name in ["thorough", "quick", "best-fs"] {
        let text = EvolutionConfig::table(name).expect("a preset").to_string();
        put("tpg_config", name, text.as_bytes())?;
    }
    for name in ["general", "best-fs"] {
        let config = SacConfig::preset(name).expect("a preset");
        put("sac_config", name, config.to_toml().as_bytes())?;
    }
    let sealed = checkpoints::sealed();
    put("checkpoint_file", "pendulum", &sealed[sealed.len().saturating_sub(3000)..])?;
    put("checkpoint_file", "beginning", &sealed[..sealed.len().min(3000)])?;
    put("checkpoint_file", "whole", &sealed)
}
