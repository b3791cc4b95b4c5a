//! Networks: their files, and packed words.

use crate::Bytes;
use tpg_codegen::policy::{self, QuantisedPolicy};
use tpg_engine::Output;
use tpg_graph::error::Finding;
use tpg_problems::{PolicyKind, Problem};
use tpg_runtime::net::Model;
use tpg_train::Network;
use tpg_train::parts::Tensors;
use tpg_train::parts::{foreign, weights};

/// Values at which integers are most likely to go wrong.
const EDGES: [i16; 8] = [i16::MIN, i16::MAX, 0, 1, -1, 4096, -4096, 12_345];

/// A `policy.q.json`: packed, it answers as its definition does.
///
/// # Panics
/// If the two differ, or what is written is not read again.
pub fn policy(data: &[u8]) {
    let text = String::from_utf8_lossy(data);
    let policy = match QuantisedPolicy::from_json("fuzzed.q.json", &text) {
        Ok(policy) => policy,
        Err(error) => return drop(error.to_string()),
    };
    let again = QuantisedPolicy::from_json("written.q.json", &policy.to_json()).expect("what is written is read");
    let inputs = policy.layers.first().map_or(0, |layer| layer.inputs);
    if let Ok(words) = policy::to_words(&policy) {
        let model = Model::parse(&words).expect("what is packed is a model");
        assert_eq!((model.inputs(), model.scratch() < 1 << 20), (inputs, true));
        let mut scratch = vec![u32::MAX; model.scratch()];
        for seed in 0..4 {
            let from = |place: usize| EDGES[(place * (2 * seed + 1) + seed) % EDGES.len()];
            let integers: Vec<i16> = (0..inputs).map(from).collect();
            let expected = policy.outputs(&integers);
            assert_eq!(again.outputs(&integers), expected);
            let mut outputs = vec![0; model.outputs()];
            assert!(model.outputs_of(&integers, &mut scratch, &mut outputs));
            assert_eq!(outputs, expected, "packed words differ from the definition");
        }
    }
    let _ = (policy::to_rust(&policy).is_ok(), policy.bytes(), policy.multiplications());
    let _ = policy::to_c(&policy, &"fuzzed".parse().expect("a prefix")).is_ok();
}

/// Packed words: the first byte chooses whether the length and the checksum are mended first.
///
/// # Panics
/// If an accepted model answers outside of its range.
pub fn words(data: &[u8]) {
    let Some((&mend, data)) = data.split_first() else { return };
    let mut words: Vec<u32> = data.chunks_exact(4).map(|four| u32::from_le_bytes(Bytes(four).array())).collect();
    if mend != 0 && words.len() > 5 {
        words[2] = words.len() as u32;
        words[3] = checksum(&words);
    }
    let Ok(model) = Model::parse(&words) else { return };
    let mut scratch = vec![u32::MAX; model.scratch()];
    let inputs: Vec<i16> = (0..model.inputs()).map(|place| EDGES[place % EDGES.len()]).collect();
    let mut outputs = vec![0; model.outputs()];
    assert!(model.outputs_of(&inputs, &mut scratch, &mut outputs), "there is enough memory");
    model.first(&inputs, &mut scratch);
    // Too little memory, other lengths, what is no number.
    assert!(!model.outputs_of(&inputs, &mut scratch[1..], &mut outputs), "there is too little memory");
    model.outputs_of(&inputs[..inputs.len() / 2], &mut scratch, &mut outputs);
    let state: Vec<f32> = (0..model.inputs()).map(|place| [f32::NAN, f32::INFINITY, -1e38, 0.5][place % 4]).collect();
    let mut values = vec![0.0; model.outputs()];
    if model.values(&state, &mut scratch, &mut values) {
        assert!(values.iter().all(|value| value.is_finite()), "{values:?}");
    }
    model.choose(&state, &mut scratch);
    assert!(model.scale(model.inputs()).is_none());
}

/// The CRC-32 over all words but the first and the checksum.
fn checksum(words: &[u32]) -> u32 {
    let checked = words[1..3].iter().chain(&words[4..]).flat_map(|word| word.to_le_bytes());
    !checked
        .fold(u32::MAX, |crc, byte| (0..8).fold(crc ^ u32::from(byte), |crc, _| (crc >> 1) ^ (0xedb8_8320 * (crc & 1))))
}

/// A safetensors file: as a container, as a policy, as another trainer's actor.
///
/// # Panics
/// If what is written is not read again.
pub fn safetensors(data: &[u8]) {
    let Ok(tensors) = Tensors::from_bytes(data) else { return };
    let bytes = tensors.to_bytes();
    assert_eq!(Tensors::from_bytes(&bytes).expect("what is written is read").to_bytes(), bytes);
    let read = |tensors: Tensors| {
        let (network, contract) = weights::from_tensors(tensors)?;
        let again = weights::from_tensors(weights::to_tensors(&network, &contract)).expect("what is written is read");
        assert_eq!(again.0.parameters().len(), network.parameters().len());
        let problem = Problem::from_table("fuzzed", &contract.problem, PolicyKind::Network);
        let environment = problem.map(|problem| problem.network_environment(0)).ok();
        let network = Network::Float(Box::new((network, contract)));
        let fits = environment.map(|it| network.fit("fuzzed", &it.sources(), &it.actions()).is_ok());
        Ok::<_, Finding>(fits.unwrap_or_default())
    };
    let _ = read(tensors.clone());
    let output = Output { name: "a".into(), unit: "".into(), min: -1.0, max: 1.0 };
    let _ = foreign::from_tensors(tensors, 3, &[output]).is_ok();
}
