//! A network in integers as C that needs nothing else: C99 with its own arithmetic, bit for bit [`QuantisedPolicy`]'s.

use super::meaning::Output;
use super::model::{banner, files};
use super::network::{Layer, QuantisedPolicy};
use crate::emit::{File, Prefix};
use crate::verify::{BuildError, Workshop, c_command, compile};
use askama::Template;
use std::io::{self, Seek as _, Write as _};
use std::process::{Command, Stdio};
use tpg_graph::error::InputError;
use tpg_runtime::net::{FRACTION_ONE, Squash, Value};

/// Values of the table of tanh, 1/32 apart.
const TABLE: i32 = 194;

#[derive(Template)]
#[template(path = "c/network.h", escape = "none")]
struct NetworkHeader<'a> {
    banner: &'a [String],
    prefix: &'a str,
    upper: &'a str,
    policy: &'a QuantisedPolicy,
}

#[derive(Template)]
#[template(path = "c/network.c", escape = "none")]
struct NetworkSource<'a> {
    banner: &'a [String],
    prefix: &'a str,
    policy: &'a QuantisedPolicy,
    layers: Vec<Layer<'a>>,
    /// Bits of a weight.
    bits: usize,
    outputs: usize,
    /// The arrays that a layer reads and writes, by turns.
    arrays: [&'a str; 2],
    values: Vec<Value>,
    table: Vec<i32>,
}

#[derive(Template)]
#[template(path = "c/network_harness.c", escape = "none")]
struct Harness<'a> {
    prefix: &'a str,
    is_choice: bool,
}

/// `PREFIX.h` and `PREFIX.c`: C99 that is C++11 too, reentrant, without a heap. `PREFIX_infer` answers with an action's
/// number, or with the values of the outputs.
///
/// # Errors
/// For a network of the arm's preferences, which `tpg_sac_init` of the C library turns into moves.
pub fn to_plain_c(policy: &QuantisedPolicy, prefix: &Prefix) -> Result<Vec<File>, InputError> {
    if let Output::Preferences(_) = policy.output {
        return Err(InputError::new("policy.q.json", "$.output", "preferences", "values or an argmax"));
    }
    let size =
        format!("{} multiplications a decision, {} bytes of constants.", policy.multiplications(), policy.bytes());
    let banner = &banner(policy, size);
    let layers = policy.described();
    let values = policy.output.values();
    let is_squashed = values.iter().any(|value| value.squash == Squash::Tanh);
    let header = NetworkHeader { banner, prefix: prefix.lower(), upper: &prefix.upper(), policy };
    let source = NetworkSource {
        banner,
        prefix: prefix.lower(),
        policy,
        bits: policy.kind().bits(),
        outputs: layers.last().map_or(0, |layer| layer.outputs),
        layers,
        arrays: ["a", "b"],
        values,
        table: if is_squashed { table() } else { Vec::new() },
    };
    Ok(files(prefix, &header, &source))
}

impl NetworkSource<'_> {
    fn widest(&self) -> usize {
        self.layers.iter().flat_map(|layer| [layer.inputs, layer.outputs]).max().unwrap_or(1)
    }

    fn has_clamp(&self) -> bool {
        self.values.iter().any(|value| value.squash == Squash::Clamp)
    }
}

/// The runtime's table of tanh, read from its function.
fn table() -> Vec<i32> {
    let unit = Value { min: -1.0, max: 1.0, squash: Squash::Tanh, exponent: 11 };
    (0..TABLE).map(|k| unit.fraction(64 * k).min(FRACTION_ONE)).collect()
}

/// Compiles the [plain C](to_plain_c) of a network and counts the states to which it does not answer as the network does,
/// bit for bit.
///
/// # Errors
/// If there is no compiler, or it refuses.
pub fn differences(policy: &QuantisedPolicy, states: &[Vec<f32>]) -> Result<usize, BuildError> {
    let prefix: Prefix = "network".parse().map_err(io::Error::other)?;
    let files = to_plain_c(policy, &prefix).map_err(io::Error::other)?;
    let workshop = Workshop::new()?;
    let folder = workshop.write("network", &files)?;
    let is_choice = policy.is_choice();
    let harness = Harness { prefix: prefix.lower(), is_choice };
    std::fs::write(folder.join("harness.c"), harness.render().map_err(io::Error::other)?)?;
    let mut command = c_command(&folder)?;
    command.args(["-Wall", "-Wextra", "-Werror", "-o", "harness", "harness.c", "network.c"]);
    compile("C", command)?;
    // A file, not a pipe: the program must not wait for a reader while its writer waits for it.
    let mut input = tempfile::tempfile()?;
    let bytes: Vec<u8> = states.iter().flatten().flat_map(|value| value.to_ne_bytes()).collect();
    input.write_all(&bytes)?;
    input.rewind()?;
    let answers = Command::new(folder.join("harness")).stdin(Stdio::from(input)).output()?.stdout;
    let expected = |state: &Vec<f32>| match is_choice {
        true => (policy.choose(state) as u16).to_ne_bytes().to_vec(),
        false => policy.values(state).iter().flat_map(|value| value.to_ne_bytes()).collect(),
    };
    let length = if is_choice { 2 } else { 4 * policy.output.values().len() };
    let mut found = answers.chunks(length.max(1));
    Ok(states.iter().filter(|state| found.next() != Some(&expected(state)[..])).count())
}

#[cfg(test)]
mod tests {
    use super::{differences, to_plain_c};
    use crate::policy::{FloatLayer, FloatNetwork, FloatOutput, FloatValue, Input, Output, Preferences};
    use tpg_runtime::net::{Kind, Squash};

    struct Numbers(u32);

    impl Numbers {
        /// A number from −1 to 1.
        fn next(&mut self) -> f32 {
            self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (self.0 >> 8) as f32 / (1 << 23) as f32 - 1.0
        }

        fn layer(&mut self, inputs: usize, outputs: usize) -> FloatLayer {
            let weights = (0..inputs * outputs).map(|_| self.next()).collect();
            FloatLayer { inputs, weights, bias: (0..outputs).map(|_| self.next()).collect() }
        }
    }

    fn network(seed: u32, output: FloatOutput, outputs: usize) -> FloatNetwork {
        let mut numbers = Numbers(seed);
        let scaled = Input { name: "scaled".into(), offset: 0.3, scale: 0.7 };
        FloatNetwork {
            inputs: vec![Input::plain("x"), scaled, Input::plain("z")],
            layers: vec![numbers.layer(3, 9), numbers.layer(9, 5), numbers.layer(5, outputs)],
            output,
        }
    }

    #[test]
    fn plain_c_answers_bit_for_bit_as_the_network() {
        let value = |name: &str, squash| FloatValue { name: name.into(), min: -2.0, max: 0.7, squash };
        let mut states: Vec<Vec<f32>> = Vec::new();
        let mut numbers = Numbers(99);
        for n in 0..20_000 {
            let size = [0.5, 2.0, 9.0, 1e9][n % 4];
            states.push((0..3).map(|_| numbers.next() * size).collect());
        }
        for special in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -0.0, 1e-40, f32::MAX] {
            states.extend([vec![special; 3], vec![0.1, special, 0.2]]);
        }
        for kind in Kind::ALL {
            let outputs = [
                FloatOutput::Values(vec![value("a", Squash::Tanh), value("b", Squash::Clamp)]),
                FloatOutput::Argmax(vec!["left".into(), "right".into()]),
            ];
            for (seed, output) in (1..).zip(outputs) {
                let network = network(seed, output, 2);
                let policy = network.quantise(&states[..4], kind, "0".repeat(64)).expect("ordinary numbers");
                assert_eq!(differences(&policy, &states).expect("it compiles"), 0, "{}", kind.name());
            }
        }
    }

    #[test]
    fn preferences_are_left_to_the_library() {
        let mut policy = network(1, FloatOutput::Argmax(vec!["a".into(), "b".into()]), 2)
            .quantise(&[vec![0.1, 0.2, 0.3]], Kind::W8A16, "0".repeat(64))
            .expect("ordinary numbers");
        let preferences = Preferences { actions: "fine".into(), mask: "none".into(), may_rest: true };
        policy.output = Output::Preferences(preferences);
        let error = to_plain_c(&policy, &"net".parse().expect("a prefix")).expect_err("no values");
        assert!(error.to_string().contains("an argmax"), "{error}");
    }
}
