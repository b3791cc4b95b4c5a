//! Networks with weights without a pattern, in every kind: what a kind costs does not depend on the numbers.

use crate::Failure;
use crate::line::Line;
use crate::record::Hash;
use std::fmt::Write as _;
use tpg_arm::sac::fixed::FixedDecision;
use tpg_arm::sac::packed::Model;
use tpg_arm::sac::{Actions, FEATURES, Mask};
use tpg_codegen::emit::File;
use tpg_kernels::Kind;
use tpg_runtime::net::{self, LayerRows, Rescale, Weights};

/// The shipped size, and the paper's with its 13 inputs.
const SIZES: [[usize; 4]; 3] = [[FEATURES, 64, 64, 4], [13, 256, 256, 4], [FEATURES, 256, 256, 4]];

fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::W8A16 => "i8, i16 activations",
        Kind::W16A16 => "i16",
        Kind::W8A8 => "i8",
    }
}

/// Every model, by name.
fn all() -> Result<Vec<(String, Vec<u32>)>, Failure> {
    let mut models = Vec::new();
    for size in SIZES {
        for kind in Kind::ALL {
            let [a, b, c, d] = size;
            models.push((format!("layers {a}-{b}-{c}-{d} {}", kind_name(kind)), model(&size, kind)?));
        }
    }
    Ok(models)
}

/// `models.rs`: the models by name.
pub(crate) fn file() -> Result<File, Failure> {
    let mut text = String::from("static MODELS: &[(&str, &[u32])] = &[\n");
    for (name, words) in all()? {
        let _ = write!(text, "    ({name:?}, &[");
        for word in words {
            let _ = write!(text, "{word},");
        }
        text.push_str("]),\n");
    }
    text.push_str("];\n");
    Ok(File { name: "models.rs".to_owned(), text })
}

/// Compares the preferences that a firmware computed with this machine's, by their hash; how many there were.
pub(crate) fn compare(lines: &[Line]) -> Result<u64, Failure> {
    let mut count = 0;
    for (name, words) in all()? {
        let is_it =
            |line: &&Line| line.words.split_first().is_some_and(|(f, rest)| f == "bits" && rest.join(" ") == name);
        let line = lines.iter().find(is_it).ok_or_else(|| Failure::new(format!("{name}: no bits")))?;
        let model = Model::parse(&words).map_err(|error| Failure::new(format!("{name}: {error:?}")))?;
        let mut scratch = vec![0; model.scratch()];
        let mut state = 11u32;
        let mut hash = Hash::new();
        for _ in 0..line.number("inputs") {
            let inputs: [i16; FEATURES] = std::array::from_fn(|_| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                (state >> 16) as i16
            });
            for preference in model.preferences(&inputs, &mut scratch) {
                hash.add(u64::from(preference as u32));
            }
            count += 1;
        }
        let hash = format!("{:016x}", hash.0);
        if line.values.get("hash") != Some(&hash) {
            return Err(Failure::new(format!("{name}: other preferences than on this machine ({hash}): {line:?}")));
        }
    }
    Ok(count)
}

fn model(size: &[usize; 4], kind: Kind) -> Result<Vec<u32>, Failure> {
    let mut state = 1u32;
    let mut number = |bound: i32| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as i32 % (bound + 1) - bound / 2
    };
    let mut layers = Vec::new();
    for pair in size.windows(2) {
        let [inputs, outputs] = [pair[0], pair[1]];
        let count = inputs * outputs;
        let small: Vec<i8> = (0..count).map(|_| number(250) as i8).collect();
        let wide: Vec<i16> = (0..count).map(|_| number(400) as i16).collect();
        let bias: Vec<i32> = (0..outputs).map(|_| number(10_000)).collect();
        let rescale = vec![Rescale { factor: 20_000, shift: if kind == Kind::W8A8 { 23 } else { 22 } }; outputs];
        layers.push((inputs, small, wide, bias, rescale));
    }
    let rows: Vec<LayerRows<'_>> = layers
        .iter()
        .map(|(inputs, small, wide, bias, rescale)| {
            let weights = if kind == Kind::W16A16 { Weights::I16(wide) } else { Weights::I8(small) };
            LayerRows { inputs: *inputs, kind, weights, bias, rescale }
        })
        .collect();
    let sizes: Vec<_> = size.windows(2).map(|pair| (pair[0], pair[1], kind)).collect();
    let meaning = FixedDecision::new(Actions::Fine, Mask::None, false).meaning();
    let mut words = vec![0; net::words(&sizes, &meaning)];
    if net::pack(&rows, &meaning, &mut words) { Ok(words) } else { Err(Failure::new("no model")) }
}
