//! A network in integers as one array of words, and C that holds it.

use super::meaning::{self, Output};
use super::network::QuantisedPolicy;
use crate::emit::{File, Prefix};
use askama::Template;
use tpg_graph::error::InputError;
use tpg_runtime::net::{self, LayerRows, Meaning, Model, Rescale, Weights};

#[derive(Template)]
#[template(path = "c/model.c", escape = "none")]
struct ModelSource<'a> {
    banner: &'a [String],
    prefix: &'a str,
    upper: &'a str,
    words: &'a [u32],
}

#[derive(Template)]
#[template(path = "c/model.h", escape = "none")]
struct ModelHeader<'a> {
    banner: &'a [String],
    prefix: &'a str,
    upper: &'a str,
    words: usize,
    scratch: usize,
    policy: &'a QuantisedPolicy,
}

/// The network as [`Model`] reads it.
///
/// # Errors
/// If it has a rescale that is no multiplier of 32 bits.
pub fn to_words(policy: &QuantisedPolicy) -> Result<Vec<u32>, InputError> {
    let refuse = |found: String, accepted: &str| InputError::new("policy.q.json", "$.layers", found, accepted);
    let (scales, values) = (meaning::scales(&policy.inputs), policy.output.values());
    let meaning =
        Meaning { contract: policy.contract(), inputs: &scales, answer: policy.output.answer(), values: &values };
    let rescales: Vec<Vec<Rescale>> = policy.layers.iter().map(|layer| layer.rescales()).collect();
    if let Some(at) = rescales.iter().flatten().find(|rescale| rescale.multiplier().is_none()) {
        return Err(refuse(format!("{at:?}"), "factor / 2^shift below 1/2, and exact in 32 bits"));
    }
    let mut sizes = Vec::new();
    let mut rows = Vec::new();
    for (layer, rescale) in policy.described().iter().zip(&rescales) {
        sizes.push((layer.inputs, layer.outputs, layer.kind));
        let weights = Weights::I16(&layer.layer.weights);
        rows.push(LayerRows { inputs: layer.inputs, kind: layer.kind, weights, bias: &layer.layer.bias, rescale });
    }
    let mut words = vec![0; net::words(&sizes, &meaning)];
    if !net::pack(&rows, &meaning, &mut words) {
        let accepted = format!("1 to {} layers of at most {} values", net::LAYERS, net::WIDTH);
        return Err(refuse(format!("layers of {sizes:?}"), &accepted));
    }
    Ok(words)
}

/// Words of scratch memory that a decision needs.
pub(super) fn scratch(words: &[u32]) -> usize {
    Model::parse(words).map_or(0, |model| model.scratch())
}

/// The banner of a network's C, with a line about its size.
pub(super) fn banner(policy: &QuantisedPolicy, size: String) -> Vec<String> {
    vec![
        format!("Made by tpg-codegen {} from a network in integers; do not edit.", env!("CARGO_PKG_VERSION")),
        format!("Weights' SHA-256: {}", policy.source_sha256),
        size,
    ]
}

/// `PREFIX.h` and `PREFIX.c`.
pub(super) fn files(prefix: &Prefix, header: &impl Template, source: &impl Template) -> Vec<File> {
    let file = |extension: &str, text: askama::Result<String>| File {
        name: format!("{prefix}.{extension}"),
        text: text.expect("a template of plain values") + "\n",
    };
    vec![file("h", header.render()), file("c", source.render())]
}

/// `PREFIX.h` and `PREFIX.c`: the words as a constant array, for `tpg_network_init`, or for `tpg_sac_init` where its outputs
/// are the arm's preferences.
///
/// # Errors
/// As [`to_words`].
pub fn to_c(policy: &QuantisedPolicy, prefix: &Prefix) -> Result<Vec<File>, InputError> {
    let words = &to_words(policy)?;
    let (layers, multiplications, bytes) = (policy.layers.len(), policy.multiplications(), 4 * words.len());
    let mut banner =
        banner(policy, format!("{layers} layers, {multiplications} multiplications a decision, {bytes} bytes."));
    let (inputs, outputs) = (policy.inputs.len(), policy.layers.last().map_or(0, |layer| layer.outputs));
    banner.push(match &policy.output {
        Output::Preferences(preferences) => format!("Actions: {}; mask: {}.", preferences.actions, preferences.mask),
        Output::Values(_) => format!("{inputs} inputs, values of {outputs} outputs."),
        Output::Argmax(_) => format!("{inputs} inputs, the greatest of {outputs} outputs."),
    });
    let (banner, upper, prefix_text) = (&*banner, &*prefix.upper(), prefix.lower());
    let header =
        ModelHeader { banner, prefix: prefix_text, upper, words: words.len(), scratch: scratch(words), policy };
    Ok(files(prefix, &header, &ModelSource { banner, prefix: prefix_text, upper, words }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::policy::{FloatLayer, Input, Preferences, quantise};
    use tpg_runtime::net::Kind;

    const FEATURES: usize = 38;

    fn policy(kind: Kind) -> QuantisedPolicy {
        let mut state = 7u32;
        let mut number = move || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 8) as f32 / (1 << 24) as f32 - 0.5
        };
        let layers: Vec<FloatLayer> = [(FEATURES, 9), (9, 6), (6, 4)]
            .map(|(inputs, outputs)| FloatLayer {
                inputs,
                weights: (0..inputs * outputs).map(|_| number()).collect(),
                bias: (0..outputs).map(|_| number()).collect(),
            })
            .into();
        let quantised = quantise(&layers, &[2.0, 2.0], kind).expect("ordinary numbers");
        let inputs = (0..FEATURES).map(|number| Input::plain(&format!("input {number}"))).collect();
        let preferences = Preferences { actions: "coarse".to_owned(), mask: "none".to_owned(), may_rest: true };
        QuantisedPolicy::new("0".repeat(64), inputs, Output::Preferences(preferences), kind, quantised).expect("sound")
    }

    #[test]
    fn the_words_answer_what_the_policy_does() {
        for kind in Kind::ALL {
            let policy = policy(kind);
            let words = to_words(&policy).expect("it packs");
            let model = Model::parse(&words).expect("what was packed");
            assert_eq!(model.answer(), net::OutputKind::Preferences { flags: 2 });
            let mut scratch = vec![0; model.scratch()];
            for n in 0..2000 {
                let features: [i16; FEATURES] =
                    std::array::from_fn(|i| (((n * 7919 + i * 104_729) % 16_384) as i16) - 8192);
                assert_eq!(model.first(&features, &mut scratch)[..], policy.outputs(&features)[..]);
            }
        }
    }

    #[test]
    fn c_holds_the_words() {
        let policy = policy(Kind::W8A16);
        let [header, source] = &to_c(&policy, &"arm_net".parse().expect("a prefix")).expect("it packs")[..] else {
            panic!("two files")
        };
        let words = to_words(&policy).expect("it packs");
        assert_eq!((header.name.as_str(), source.name.as_str()), ("arm_net.h", "arm_net.c"));
        assert!(header.text.contains(&format!("#define ARM_NET_WORDS {}U", words.len())), "{}", header.text);
        let found = source.text.split(|c: char| !c.is_ascii_alphanumeric());
        let found = found.filter_map(|word| word.strip_prefix("0x")?.strip_suffix('U'));
        let found: Vec<u32> = found.map(|word| u32::from_str_radix(word, 16).expect("a word")).collect();
        assert_eq!(found, words);
    }

    #[test]
    fn what_the_runtime_cannot_pack_is_refused() {
        let mut policy = policy(Kind::W8A16);
        policy.layers[1].shift[0] = 3;
        policy.layers[1].factor[0] = 20_000;
        assert!(to_words(&policy).expect_err("no multiplier").to_string().contains("20000"));
    }
}
