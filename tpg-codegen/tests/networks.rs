//! Networks of any shape: integers near the floating point they were made of, the same packed and not, and as a file.

use tpg_codegen::emit::Prefix;
use tpg_codegen::policy::{
    FloatLayer, FloatNetwork, FloatOutput, FloatValue, Input, QuantiseError, QuantisedPolicy, to_c, to_rust, to_words,
};
use tpg_runtime::net::{Kind, Model, Squash};

/// A stream of numbers without a pattern.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as u32
    }

    fn below(&mut self, bound: usize) -> usize {
        self.next() as usize % bound
    }

    /// From −1 to 1.
    fn unit(&mut self) -> f32 {
        (self.next() >> 7) as f32 / (1 << 23) as f32 - 1.0
    }
}

/// A network of random shape, weights as training begins with (±√(3/inputs)), and states that it may meet.
fn random(seed: u64) -> (FloatNetwork, Vec<Vec<f32>>) {
    let mut numbers = Numbers(seed);
    let hidden = seed as usize % 5;
    let sizes: Vec<usize> =
        (0..hidden + 2).map(|layer| if layer > hidden { 1 } else { 4 } + numbers.below(37)).collect();
    let layers = sizes
        .windows(2)
        .map(|pair| {
            let spread = (3.0 / pair[0] as f32).sqrt();
            FloatLayer {
                inputs: pair[0],
                weights: (0..pair[0] * pair[1]).map(|_| spread * numbers.unit()).collect(),
                bias: (0..pair[1]).map(|_| 0.2 * numbers.unit()).collect(),
            }
        })
        .collect();
    let input = |number: usize, numbers: &mut Numbers| Input {
        name: format!("input {number}"),
        offset: 10.0 * numbers.unit(),
        scale: 0.1 + numbers.unit().abs(),
    };
    let inputs: Vec<Input> = (0..sizes[0]).map(|number| input(number, &mut numbers)).collect();
    let outputs = sizes[hidden + 1];
    let value = |number: usize, numbers: &mut Numbers| {
        let min = 5.0 * numbers.unit();
        let squash = if number.is_multiple_of(2) { Squash::Tanh } else { Squash::Clamp };
        FloatValue { name: format!("output {number}"), min, max: min + 0.5 + 4.0 * numbers.unit().abs(), squash }
    };
    let output = if seed.is_multiple_of(3) {
        FloatOutput::Argmax((0..outputs).map(|number| format!("action {number}")).collect())
    } else {
        FloatOutput::Values((0..outputs).map(|number| value(number, &mut numbers)).collect())
    };
    let states = (0..200)
        .map(|_| inputs.iter().map(|input| input.offset + 1.5 * numbers.unit() / input.scale).collect())
        .collect();
    (FloatNetwork { inputs, layers, output }, states)
}

/// Greatest accepted distance from floating point, in parts of the range: rounded weights add up over the layers.
const fn bound(kind: Kind) -> f64 {
    match kind {
        Kind::W8A16 => 0.03,
        Kind::W16A16 => 0.001,
    }
}

#[test]
fn integers_answer_nearly_what_the_numbers_did_for_any_shape() {
    let seeds = tpg_testing::amount(60, 300);
    let (mut worst, mut networks) = ([0.0f64; 2], 0);
    for seed in 0..seeds {
        let (network, states) = random(seed);
        for (kind, worst) in Kind::ALL.into_iter().zip(&mut worst) {
            let policy = match network.quantise(&states, kind, String::new()) {
                Ok(policy) => policy,
                Err(QuantiseError::Silent { .. }) => continue,
                Err(error) => panic!("network {seed}: {error}"),
            };
            networks += 1;
            for state in &states {
                let wanted = network.answer(state);
                match &network.output {
                    FloatOutput::Values(values) => {
                        for ((value, wanted), found) in values.iter().zip(&wanted).zip(policy.values(state)) {
                            let parts = (f64::from(found) - wanted).abs() / f64::from(value.max - value.min);
                            assert!(parts < bound(kind), "network {seed}, {kind:?}, {value:?}: {found}, not {wanted}");
                            *worst = worst.max(parts);
                        }
                    }
                    FloatOutput::Argmax(_) => {
                        let spread = wanted.iter().copied().fold(1.0, |most, output| f64::max(most, output.abs()));
                        let best = wanted.iter().copied().fold(f64::MIN, f64::max);
                        let lost = (best - wanted[policy.choose(state)]) / spread;
                        assert!(lost < 2.0 * bound(kind), "network {seed}, {kind:?}: an action worse by {lost}");
                    }
                }
            }
        }
    }
    assert!(networks > 16 * seeds / 9, "{networks} networks");
    println!("worst, in parts of a range: {worst:?}");
}

#[test]
fn files_and_words_answer_as_the_policy() {
    for seed in 0..tpg_testing::amount(20, 60) {
        let (network, states) = random(seed);
        for kind in Kind::ALL {
            let Ok(policy) = network.quantise(&states, kind, "0".repeat(64)) else { continue };
            let again = QuantisedPolicy::from_json("policy.q.json", &policy.to_json());
            assert_eq!(again.as_ref(), Ok(&policy), "network {seed}");
            let words = to_words(&policy).expect("it packs");
            let model = Model::parse(&words).expect("what was packed");
            let mut scratch = vec![0; model.scratch()];
            let mut values = vec![0.0; model.outputs()];
            let wild = [vec![f32::NAN; model.inputs()], vec![f32::MAX; model.inputs()], vec![-1e9; model.inputs()]];
            for state in states.iter().chain(&wild) {
                match &network.output {
                    FloatOutput::Values(_) => {
                        assert!(model.values(state, &mut scratch, &mut values));
                        assert_eq!(values, policy.values(state), "network {seed}");
                    }
                    FloatOutput::Argmax(_) => {
                        let chosen = model.choose(state, &mut scratch).map(usize::from);
                        assert_eq!(chosen, Some(policy.choose(state)), "network {seed}");
                    }
                }
            }
        }
    }
}

#[test]
fn what_is_written_says_what_goes_in_and_comes_out() {
    let speed = Input { name: "speed".into(), offset: 0.5, scale: 0.125 };
    let torque = FloatValue { name: "torque".into(), min: -2.0, max: 2.0, squash: Squash::Tanh };
    let network = FloatNetwork {
        inputs: vec![Input::plain("cos"), Input::plain("sin"), speed],
        layers: vec![FloatLayer { inputs: 3, weights: vec![0.0, -3.0, -0.5], bias: vec![0.0] }],
        output: FloatOutput::Values(vec![torque]),
    };
    let policy = network.quantise(&[vec![1.0; 3]], Kind::W8A16, "0".repeat(64)).expect("it fits");
    let prefix: Prefix = "pendulum".parse().expect("a prefix");
    let [header, ..] = &to_c(&policy, &prefix).expect("it packs")[..] else { panic!("a header") };
    for line in ["tpg_network_init", "2 speed: the network sees (value - 0.5) * 0.125", "0 torque: -2 to 2"] {
        assert!(header.text.contains(line), "{line}:\n{}", header.text);
    }
    assert!(header.text.contains("#define PENDULUM_INPUTS 3U\n#define PENDULUM_OUTPUTS 1U\n"), "{}", header.text);
    let rust = to_rust(&policy).expect("it packs");
    for line in ["//! - 2: speed", "Scaling { offset: 0.5, scale: 0.125 }", "squash: Squash::Tanh, exponent: 11"] {
        assert!(rust.contains(line), "{line}:\n{rust}");
    }
    assert!(!rust.contains("tpg_arm"), "{rust}");
}

#[test]
fn networks_that_do_not_fit_are_refused() {
    let (network, states) = random(1);
    let with = |change: &dyn Fn(&mut FloatNetwork)| {
        let mut network = network.clone();
        change(&mut network);
        network.quantise(&states, Kind::W8A16, String::new()).expect_err("it does not fit")
    };
    assert_eq!(with(&|n| n.layers[1].inputs += 1), QuantiseError::Shape { layer: 1 });
    assert_eq!(with(&|n| n.output = FloatOutput::Argmax(vec![])), QuantiseError::Shape { layer: 2 });
    assert_eq!(with(&|n| n.layers[0].bias[0] = f32::NAN), QuantiseError::NotFinite { layer: 0, row: 0 });
    let FloatOutput::Values(values) = &network.output else { panic!("values") };
    let mut infinite = values.clone();
    infinite[0].max = f32::INFINITY;
    let error = with(&|n| n.output = FloatOutput::Values(infinite.clone()));
    assert!(error.to_string().contains("$.output.values[0]"), "{error}");
    let text = network.quantise(&states, Kind::W8A16, String::new()).expect("it fits").to_json();
    for (from, to, place) in [
        ("\"squash\":\"tanh\"", "\"squash\":\"sine\"", "sine"),
        ("\"version\":2", "\"version\":3", "$.format"),
        ("\"exponent\":11", "\"exponent\":12", "$.output.values"),
        ("\"output\":", "\"actions\":\"fine\",\"output\":", "unknown field `actions`"),
    ] {
        let bad = text.replacen(from, to, 1);
        assert_ne!(bad, text, "{from}");
        let error = QuantisedPolicy::from_json("q.json", &bad).expect_err(place);
        assert!(error.to_string().contains(place), "{error}");
    }
}
