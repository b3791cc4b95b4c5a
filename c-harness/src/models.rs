//! Networks with weights without a pattern, in every kind: what a kind costs does not depend on the numbers.

use crate::Failure;
use crate::line;
use crate::programs::Ran;
use crate::record::Hash;
use tpg_arm::sac::fixed::FixedDecision;
use tpg_arm::sac::packed::Model;
use tpg_arm::sac::{Actions, FEATURES, Mask};
use tpg_codegen::emit::File;
use tpg_cores::layers;
use tpg_kernels::Kind;
use tpg_runtime::net;

/// The shipped size, and the paper's with its 13 inputs.
const SIZES: [[usize; 4]; 3] = [[FEATURES, 64, 64, 4], [13, 256, 256, 4], [FEATURES, 256, 256, 4]];

fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::W8A16 => "i8, i16 activations",
        Kind::W16A16 => "i16",
        Kind::W8A8 => "i8",
    }
}

/// Inputs that each is asked with for its bits, as in the firmware.
const INPUTS: u64 = 200;

/// Every model, by name.
fn all() -> Result<Vec<(String, Vec<u32>)>, Failure> {
    let meaning = FixedDecision::new(Actions::Fine, Mask::None, false).meaning();
    let mut models = Vec::new();
    for size in SIZES {
        let [a, b, c, d] = size;
        for kind in Kind::ALL {
            let mut words = vec![0; net::words(&[(a, b, kind), (b, c, kind), (c, d, kind)], &meaning)];
            if !layers::write::<{ 256 * 256 }, 256>(size, kind, &meaning, &mut words) {
                return Err(Failure::new("no model"));
            }
            models.push((format!("layers {a}-{b}-{c}-{d} {}", kind_name(kind)), words));
        }
    }
    Ok(models)
}

/// `models.rs`: the models by name.
pub(crate) fn file() -> Result<File, Failure> {
    let models = all()?.iter().map(|(name, words)| format!("    ({name:?}, &{words:?}),\n")).collect::<String>();
    let text = format!("const INPUTS: u32 = {INPUTS};\nstatic MODELS: &[(&str, &[u32])] = &[\n{models}];\n");
    Ok(File { name: "models.rs".to_owned(), text })
}

/// Compares the preferences that the firmware in Rust computed with this machine's.
pub(crate) fn check(ran: &Ran<'_>) -> Result<(), Failure> {
    if ran.language == "C" {
        return Ok(());
    }
    for (name, words) in all()? {
        let model = Model::parse(&words).map_err(|error| Failure(format!("{name}: {error:?}")))?;
        let mut scratch = vec![0; model.scratch()];
        let mut state = 11u32;
        let mut hash = Hash::new();
        for _ in 0..INPUTS {
            let inputs: [i16; FEATURES] = std::array::from_fn(|_| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                (state >> 16) as i16
            });
            for preference in model.preferences(&inputs, &mut scratch) {
                hash.add(u64::from(preference as u32));
            }
        }
        line::check(ran.language, ran.lines, &format!("bits {name}"), INPUTS, &hash)?;
    }
    println!("Rust: preferences of networks of every kind: the same bits as on the host");
    Ok(())
}
