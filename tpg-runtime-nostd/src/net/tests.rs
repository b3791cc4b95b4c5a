use super::model::columns;
use super::*;
use proptest::prelude::*;
use tpg_testing::numbers::Numbers;

use std::vec;
use std::vec::Vec;

struct Random {
    inputs: usize,
    kind: Kind,
    small: Vec<i8>,
    wide: Vec<i16>,
    bias: Vec<i32>,
    rescale: Vec<Rescale>,
}

impl Random {
    fn new(inputs: usize, outputs: usize, kind: Kind, numbers: &mut Numbers) -> Self {
        let count = inputs * outputs;
        // i16 weights leave room for accumulators: 65,535 a row in all.
        let wide = (65_535 / inputs as i32).min(32_767) - 1;
        Self {
            inputs,
            kind,
            small: (0..count).map(|_| numbers.within(127) as i8).collect(),
            wide: (0..count).map(|_| numbers.within(wide) as i16).collect(),
            bias: (0..outputs).map(|_| numbers.within(20_000)).collect(),
            rescale: (0..outputs)
                .map(|_| Rescale {
                    factor: (16_384 + numbers.next_u32() % 16_384) as i16,
                    shift: 17 + (numbers.next_u32() % 8) as u8,
                })
                .collect(),
        }
    }

    fn rows(&self) -> LayerRows<'_> {
        let weights = if self.kind == Kind::W16A16 { Weights::I16(&self.wide) } else { Weights::I8(&self.small) };
        LayerRows { inputs: self.inputs, kind: self.kind, weights, bias: &self.bias, rescale: &self.rescale }
    }

    /// The layer by its definition: sums in 64 bits, [`Rescale::apply`].
    fn outputs(&self, inputs: &[i16], low: i16) -> Vec<i16> {
        let weight = |row: usize, column: usize| {
            let at = row * self.inputs + column;
            if self.kind == Kind::W16A16 { i64::from(self.wide[at]) } else { i64::from(self.small[at]) }
        };
        (0..self.bias.len())
            .map(|row| {
                let products = (0..self.inputs).map(|column| weight(row, column) * i64::from(inputs[column]));
                let sum = i64::from(self.bias[row]) + products.sum::<i64>();
                let sum = i32::try_from(sum).expect("a sound layer");
                self.rescale[row].apply(sum, low)
            })
            .collect()
    }
}

const PREFERENCES: Meaning<'static> =
    Meaning { contract: 0xfeed, inputs: &[], answer: OutputKind::Preferences { flags: 5 }, values: &[] };

fn packed_as(layers: &[Random], meaning: &Meaning<'_>) -> Vec<u32> {
    let sizes: Vec<_> = layers.iter().map(|layer| (layer.inputs, layer.bias.len(), layer.kind)).collect();
    let rows: Vec<_> = layers.iter().map(Random::rows).collect();
    let mut words = vec![0; super::words(&sizes, meaning)];
    assert!(pack(&rows, meaning, &mut words));
    words
}

fn packed(layers: &[Random]) -> Vec<u32> {
    packed_as(layers, &PREFERENCES)
}

/// The layers of a network, whose sizes are the inputs' and then each layer's outputs.
fn network(sizes: &[usize], kinds: &[Kind], numbers: &mut Numbers) -> Vec<Random> {
    sizes.windows(2).zip(kinds).map(|(pair, &kind)| Random::new(pair[0], pair[1], kind, numbers)).collect()
}

/// The outputs by their definition.
fn by_definition(layers: &[Random], inputs: &[i16]) -> Vec<i32> {
    let mut values = inputs.to_vec();
    for (index, layer) in layers.iter().enumerate() {
        values = layer.outputs(&values, if index + 1 < layers.len() { HIDDEN } else { LAST });
    }
    values.into_iter().map(i32::from).collect()
}

fn kinds() -> impl Strategy<Value = Vec<Kind>> {
    prop::collection::vec(prop::sample::select(&Kind::ALL[..]), LAYERS)
}

proptest! {
    #[test]
    fn a_packed_network_of_any_shape_is_its_definition(
        sizes in prop::collection::vec(1usize..70, 2..=LAYERS + 1),
        kinds in kinds(),
        seed in any::<u64>(),
        extreme in any::<bool>(),
    ) {
        let mut numbers = Numbers(seed);
        let layers = network(&sizes, &kinds, &mut numbers);
        let words = packed(&layers);
        let model = Model::parse(&words).expect("what was packed");
        let outputs = sizes[sizes.len() - 1];
        prop_assert_eq!((model.inputs(), model.outputs(), model.contract()), (sizes[0], outputs, 0xfeed));
        let mut scratch = vec![0xdead_beef; model.scratch()];
        for _ in 0..8 {
            let inputs: Vec<i16> = (0..sizes[0])
                .map(|_| if extreme { [i16::MIN, i16::MAX, 0][(numbers.next_u32() % 3) as usize] } else { numbers.next_u32() as i16 })
                .collect();
            let expected = by_definition(&layers, &inputs);
            let mut found = vec![7; outputs];
            prop_assert!(model.outputs_of(&inputs, &mut scratch, &mut found));
            prop_assert_eq!(&found, &expected);
            prop_assert_eq!(&model.portable_outputs(&inputs), &expected);
            let four = model.first(&inputs, &mut scratch);
            let shown = outputs.min(ROWS);
            prop_assert_eq!(&four[..shown], &expected[..shown]);
        }
    }

    #[test]
    fn states_are_scaled_and_answers_are_values_or_the_greatest(
        sizes in prop::collection::vec(1usize..20, 2..=LAYERS + 1),
        kinds in kinds(),
        seed in any::<u64>(),
        scaled in any::<bool>(),
    ) {
        let mut numbers = Numbers(seed);
        let layers = network(&sizes, &kinds, &mut numbers);
        let mut float = |bound: i32| numbers.within(bound) as f32 / 1000.0;
        let scales: Vec<_> = (0..sizes[0]).map(|_| Scaling { offset: float(3000), scale: float(2000) }).collect();
        let scales = if scaled { scales } else { Vec::new() };
        let outputs = sizes[sizes.len() - 1];
        let values: Vec<_> = (0..outputs)
            .map(|output| {
                let min = float(5000);
                let squash = if output % 2 == 0 { Squash::Tanh } else { Squash::Clamp };
                Value { min, max: min + float(5000).abs(), squash, exponent: (output % 12) as u8 }
            })
            .collect();
        let state: Vec<f32> = (0..sizes[0]).map(|_| float(9000)).collect();
        let inputs: Vec<i16> = match scaled {
            true => state.iter().zip(&scales).map(|(value, s)| integer((value - s.offset) * s.scale)).collect(),
            false => state.iter().map(|&value| integer(value)).collect(),
        };
        let expected = by_definition(&layers, &inputs);

        let words = packed_as(&layers, &Meaning { contract: 1, inputs: &scales, answer: OutputKind::Values, values: &values });
        let model = Model::parse(&words).expect("what was packed");
        let mut scratch = vec![0; model.scratch()];
        let mut found = vec![0.0; outputs];
        prop_assert!(model.values(&state, &mut scratch, &mut found));
        let wanted: Vec<f32> = values.iter().zip(&expected).map(|(value, &output)| value.of(output)).collect();
        prop_assert_eq!(found, wanted);
        prop_assert_eq!(model.choose(&state, &mut scratch), None);
        prop_assert!(!model.values(&state[1..], &mut scratch, &mut vec![0.0; outputs]));

        let words = packed_as(&layers, &Meaning { contract: 1, inputs: &scales, answer: OutputKind::Argmax, values: &[] });
        let model = Model::parse(&words).expect("what was packed");
        let greatest = expected.iter().max().and_then(|most| expected.iter().position(|output| output == most));
        prop_assert_eq!(model.choose(&state, &mut scratch).map(usize::from), greatest);
        prop_assert_eq!(model.choose(&state, &mut []), None);
    }

    #[test]
    fn damage_is_found(at in 0usize..2000, bit in 0u32..32) {
        let mut numbers = Numbers(1);
        let mut words = packed(&network(&[38, 16, 4], &[Kind::W8A16; 2], &mut numbers));
        let at = at % words.len();
        words[at] ^= 1 << bit;
        prop_assert!(Model::parse(&words).is_err());
        prop_assert!(Model::parse(&words[..words.len() - 1]).is_err());
    }

    #[test]
    fn nothing_panics_whatever_the_words(mut words in prop::collection::vec(any::<u32>(), 0..64), fix in any::<bool>()) {
        if fix && words.len() > 6 {
            words[0] = MAGIC;
            words[1] = (words[1] & 0xff03_8300) | u32::from(VERSION) | 0x100;
            words[2] = words.len() as u32;
            words[5] &= 0x0007_0007;
            words[6] &= 3;
            words[3] = crc::of_model(&words);
        }
        if let Ok(model) = Model::parse(&words) {
            let _ = model.outputs_of(&[1; 8], &mut [0; 64], &mut [0; 2]);
            let _ = model.values(&[1.0; 8], &mut [0; 64], &mut [0.0; 8]);
            let _ = model.choose(&[1.0; 8], &mut [0; 64]);
            let _ = model.first(&[1; 8], &mut [0; 64]);
        }
    }
}

#[test]
fn a_million_inputs_answer_the_same_in_every_kind() {
    let mut numbers = Numbers(8);
    for kind in Kind::ALL {
        let layers = network(&[38, 16, 12, 4], &[kind; 3], &mut numbers);
        let words = packed(&layers);
        let model = Model::parse(&words).expect("what was packed");
        let mut scratch = vec![0; model.scratch()];
        for number in 0..1_000_000 {
            let inputs: [i16; 38] = core::array::from_fn(|_| numbers.within(8192) as i16);
            let answer = model.first(&inputs, &mut scratch);
            if number % 10 == 0 {
                assert_eq!(answer[..], model.portable_outputs(&inputs)[..], "{kind:?}, {number}");
            }
            assert_eq!(answer[..], by_definition(&layers, &inputs)[..], "{kind:?}, {number}");
        }
    }
}

#[test]
fn models_of_other_versions_and_meanings_are_refused() {
    let mut numbers = Numbers(3);
    let words = packed(&network(&[3, 2], &[Kind::W8A16], &mut numbers));
    let with = |change: &dyn Fn(&mut Vec<u32>)| {
        let mut words = words.clone();
        change(&mut words);
        words[3] = crc::of_model(&words);
        Model::parse(&words).err()
    };
    assert_eq!(with(&|_| ()), None);
    assert_eq!(with(&|words| words[0] ^= 1), Some(ModelError::NotAModel));
    assert_eq!(with(&|words| words[1] -= 1), Some(ModelError::Version), "an older one");
    assert_eq!(with(&|words| words[1] += 1), Some(ModelError::Version), "a newer one");
    assert_eq!(with(&|words| words[1] |= 3 << 16), Some(ModelError::Meaning), "an unknown answer");
    assert_eq!(with(&|words| words[1] ^= 0x300), Some(ModelError::Layers), "another number of layers");
    assert_eq!(with(&|words| words[5] += 1 << 4), Some(ModelError::Layers), "more inputs than weights");
    assert_eq!(Model::parse(&words[..3]).err(), Some(ModelError::Short));
    assert_eq!(Model::parse(&[]).err(), Some(ModelError::NotAModel));
}

#[test]
fn a_network_that_does_not_fit_is_not_packed() {
    let mut numbers = Numbers(3);
    let mut layer = Random::new(38, 4, Kind::W8A16, &mut numbers);
    let mut words = vec![0; super::words(&[(38, 4, Kind::W8A16)], &PREFERENCES)];
    assert!(pack(&[layer.rows()], &PREFERENCES, &mut words));
    let model = Model::parse(&words).expect("what was packed");
    assert_eq!(model.scratch(), columns(38));
    assert_eq!(model.first(&[1; 38], &mut [0; 1]), [0; 4], "scratch memory is too short");
    assert!(!model.outputs_of(&[1; 38], &mut [0; 1], &mut [0; 4]));
    layer.bias[2] = i32::MAX;
    assert!(!pack(&[layer.rows()], &PREFERENCES, &mut words), "an accumulator overflows");
    layer.bias[2] = 0;
    layer.rescale[1].shift = 12;
    assert!(!pack(&[layer.rows()], &PREFERENCES, &mut words), "no multiplier");
    layer.rescale[1].shift = 22;
    let values = Meaning { answer: OutputKind::Values, ..PREFERENCES };
    assert!(!pack(&[layer.rows()], &values, &mut words), "values without ranges");
    let scale = [Scaling { offset: 0.0, scale: f32::INFINITY }; 38];
    let scaled = Meaning { inputs: &scale, ..PREFERENCES };
    let mut words = vec![0; super::words(&[(38, 4, Kind::W8A16)], &scaled)];
    assert!(!pack(&[layer.rows()], &scaled, &mut words), "a scale that is not finite");
}

/// The product rises or falls with the accumulator, so its ends are at the accumulator's: with the overflow checks of
/// tests this is a proof for every accumulator, factor and shift.
#[test]
fn no_rescale_overflows() {
    for factor in i16::MIN..=i16::MAX {
        for shift in 0..=u8::MAX {
            let rescale = Rescale { factor, shift };
            for accumulator in [i32::MIN, i32::MAX] {
                let rises = (accumulator > 0) == (factor > 0);
                for low in [HIDDEN, LAST] {
                    let value = rescale.apply(accumulator, low);
                    assert!(value >= low && (factor == 0 || shift > 14 || value == if rises { i16::MAX } else { low }));
                }
            }
        }
    }
}

#[test]
fn a_multiplier_is_its_rescale() {
    let mut numbers = Numbers(9);
    for _ in 0..100_000 {
        let rescale =
            Rescale { factor: (numbers.next_u32() & 0x7fff) as i16, shift: 1 + (numbers.next_u32() % 47) as u8 };
        let Some(multiplier) = rescale.multiplier() else { continue };
        let accumulator = (numbers.next_u32() as i32) << (numbers.next_u32() % 4);
        let value = (i64::from(accumulator) * i64::from(multiplier) + (1 << 31)) >> 32;
        assert_eq!(i64::from(rescale.apply(accumulator, LAST)), value.clamp(-32767, 32767), "{rescale:?}");
    }
}
