//! Networks of every kind as Rust: what `tpg-codegen policy` writes compiles, which proves that nothing can overflow, and
//! holds the words that C gets, too.

#[allow(unreachable_pub, reason = "made for users' crates")]
#[path = "fixtures/policy-kinds/w16a16.rs"]
mod w16a16;

use tpg_arm::sac::FEATURES;
use tpg_arm::sac::packed::Model;
use tpg_codegen::policy::{QuantisedPolicy, to_rust, to_words};

#[test]
fn the_rust_of_every_kind_is_fresh_and_holds_the_words() {
    let files = [(
        include_str!("fixtures/policy-kinds/w16a16.q.json"),
        include_str!("fixtures/policy-kinds/w16a16.rs"),
        &w16a16::MODEL[..],
        w16a16::SCRATCH,
    )];
    for (json, rust, words, scratch) in files {
        let policy = QuantisedPolicy::from_json("policy.q.json", json).expect("a good file");
        let made = to_rust(&policy).expect("it packs");
        assert!(made == rust, "{}: `tpg-codegen policy FILE --lang rust` writes\n{made}", policy.kind);
        assert_eq!(to_words(&policy).expect("it packs"), words, "{}", policy.kind);
        let model = Model::parse(words).expect("what was packed");
        assert_eq!(model.scratch(), scratch);
        assert_eq!(w16a16::MEANING, model.decision().meaning());
        let mut memory = vec![0; scratch];
        let mut answers = std::collections::BTreeSet::new();
        for n in 0..5000 {
            let features: [i16; FEATURES] = std::array::from_fn(|i| ((n * 7919 + i * 104_729) % 16_384) as i16 - 8192);
            let answer = model.preferences(&features, &mut memory);
            assert_eq!(answer[..], policy.outputs(&features)[..], "{}, {n}", policy.kind);
            answers.insert(answer);
        }
        assert!(answers.len() > 100, "{}: a network that always says the same proves nothing", policy.kind);
    }
}

#[test]
fn a_network_that_could_overflow_does_not_pack() {
    let text = include_str!("fixtures/policy-kinds/w16a16.q.json");
    let policy = QuantisedPolicy::from_json("policy.q.json", text).expect("a good file");
    let mut wrong = policy.clone();
    wrong.layers[1].weights.fill(i16::MAX);
    let error = QuantisedPolicy::from_json("policy.q.json", &wrong.to_json()).expect_err("an overflow");
    assert!(error.to_string().contains("layers[1].weights"), "{error}");
    assert!(to_words(&wrong).is_err(), "the runtime's own proof");
}

#[test]
fn layers_whose_sizes_overflow_a_product_are_refused() {
    let text = include_str!("fixtures/policy-kinds/w16a16.q.json");
    let mut document: serde_json::Value = serde_json::from_str(text).expect("JSON");
    for (inputs, outputs) in [(u64::MAX, 2), (1 << 32, 1 << 32), (1 << 63, 2), (38, u64::MAX)] {
        let layer = &mut document["layers"][0];
        assert!(layer["inputs"].is_u64() && layer["outputs"].is_u64(), "{layer}");
        (layer["inputs"], layer["outputs"]) = (inputs.into(), outputs.into());
        let error = QuantisedPolicy::from_json("policy.q.json", &document.to_string()).expect_err("no such layer");
        assert!(error.to_string().contains("layers[0]"), "{error}");
    }
}
