use super::*;
use crate::arm::{Pose, WIDOWX};
use crate::sac::fixed::{FixedPolicy, quantise};
use proptest::prelude::*;
use tpg_kernels::portable;

extern crate std;
use std::vec;
use std::vec::Vec;

const ARM: Arm<f32> = WIDOWX.to_f32();

/// A stream of numbers without a pattern.
struct Numbers(u64);

impl Numbers {
    fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as u32
    }

    fn below(&mut self, bound: i32) -> i32 {
        (self.next() % (2 * bound as u32 + 1)) as i32 - bound
    }
}

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
            small: (0..count).map(|_| numbers.below(127) as i8).collect(),
            wide: (0..count).map(|_| numbers.below(wide) as i16).collect(),
            bias: (0..outputs).map(|_| numbers.below(20_000)).collect(),
            rescale: (0..outputs)
                .map(|_| Rescale {
                    factor: (16_384 + numbers.next() % 16_384) as i16,
                    shift: 17 + (numbers.next() % if matches!(kind, Kind::W8A8) { 10 } else { 8 }) as u8,
                })
                .collect(),
        }
    }

    fn rows(&self) -> LayerRows<'_> {
        let weights = if self.kind == Kind::W16A16 { Weights::I16(&self.wide) } else { Weights::I8(&self.small) };
        LayerRows { inputs: self.inputs, kind: self.kind, weights, bias: &self.bias, rescale: &self.rescale }
    }

    /// The layer by its definition: sums in 64 bits, [`Rescale::apply`].
    fn outputs(&self, inputs: &[i16], low: i16, high: i16) -> Vec<i16> {
        let weight = |row: usize, column: usize| {
            let at = row * self.inputs + column;
            if self.kind == Kind::W16A16 { i64::from(self.wide[at]) } else { i64::from(self.small[at]) }
        };
        (0..self.bias.len())
            .map(|row| {
                let products = (0..self.inputs).map(|column| weight(row, column) * i64::from(inputs[column]));
                let sum = i64::from(self.bias[row]) + products.sum::<i64>();
                let sum = i32::try_from(sum).expect("a sound layer");
                self.rescale[row].apply(sum, low).min(high)
            })
            .collect()
    }
}

fn decision() -> FixedDecision {
    FixedDecision::new(Actions::Fine, Mask::JointLimits, false)
}

fn packed(layers: &[Random]) -> Vec<u32> {
    let sizes: Vec<_> = layers.iter().map(|layer| (layer.inputs, layer.bias.len(), layer.kind)).collect();
    let rows: Vec<_> = layers.iter().map(Random::rows).collect();
    let mut words = vec![0; super::words(&sizes)];
    assert!(pack(&rows, &decision(), &mut words));
    words
}

proptest! {
    #[test]
    fn a_packed_network_is_its_definition(
        sizes in prop::collection::vec(1usize..70, 1..4),
        kinds in prop::array::uniform4(prop::sample::select(&Kind::ALL[..])),
        seed in any::<u64>(),
        extreme in any::<bool>(),
    ) {
        let mut numbers = Numbers(seed);
        let mut layers = Vec::new();
        for (index, &kind) in kinds.iter().take(sizes.len()).enumerate() {
            let outputs = sizes.get(index + 1).copied().unwrap_or(JOINTS);
            layers.push(Random::new(sizes[index], outputs, kind, &mut numbers));
        }
        let words = packed(&layers);
        let model = Model::parse(&words).expect("what was packed");
        let mut scratch = vec![0xdead_beef; model.scratch()];
        for _ in 0..8 {
            let inputs: Vec<i16> = (0..sizes[0])
                .map(|_| if extreme { [i16::MIN, i16::MAX, 0][(numbers.next() % 3) as usize] } else { numbers.next() as i16 })
                .collect();
            let mut values: Vec<i16> = inputs.clone();
            for (index, layer) in layers.iter().enumerate() {
                if index == 0 && layer.kind == Kind::W8A8 {
                    values.iter_mut().for_each(|value| *value = tpg_kernels::clip_to_i8(*value));
                }
                let next = layers.get(index + 1);
                let high = if next.is_some_and(|next| next.kind == Kind::W8A8) { 127 } else { i16::MAX };
                values = layer.outputs(&values, if next.is_some() { 0 } else { LAST }, high);
            }
            let expected: Vec<i32> = values.into_iter().map(i32::from).collect();
            prop_assert_eq!(&model.preferences(&inputs, &mut scratch)[..], &expected[..]);
        }
    }

    #[test]
    fn damage_is_found(at in 0usize..2000, bit in 0u32..32) {
        let mut numbers = Numbers(1);
        let layers = [Random::new(FEATURES, 16, Kind::W8A16, &mut numbers), Random::new(16, 4, Kind::W8A16, &mut numbers)];
        let mut words = packed(&layers);
        let at = at % words.len();
        words[at] ^= 1 << bit;
        // The flags beside the checksum say what the actions are, not what is read.
        prop_assert!(Model::parse(&words).is_err() || at == 1);
        prop_assert!(Model::parse(&words[..words.len() - 1]).is_err());
    }

    #[test]
    fn nothing_panics_whatever_the_words(mut words in prop::collection::vec(any::<u32>(), 0..64), fix in any::<bool>()) {
        if fix && words.len() > HEADER {
            words[0] = MAGIC;
            words[1] = (words[1] & !0x3ff) | VERSION | 0x100;
            words[2] = words.len() as u32;
            words[4] = FEATURE_CONTRACT;
            words[3] = crc::of_words(&words[4..]);
        }
        if let Ok(model) = Model::parse(&words) {
            let _ = model.preferences(&[1; FEATURES], &mut [0; 64]);
        }
    }
}

#[test]
fn a_million_observations_answer_the_same_packed_and_not() {
    let mut numbers = Numbers(7);
    let weight = |numbers: &mut Numbers| numbers.below(127) as i8;
    let rescale = |shift| Rescale { factor: 20_000, shift };
    let network = Network::<16, 16> {
        first: Layer {
            weights: core::array::from_fn(|_| core::array::from_fn(|_| weight(&mut numbers))),
            bias: core::array::from_fn(|_| numbers.below(100_000)),
            rescale: [rescale(22); 16],
        },
        second: Layer {
            weights: core::array::from_fn(|_| core::array::from_fn(|_| weight(&mut numbers))),
            bias: core::array::from_fn(|_| numbers.below(100_000)),
            rescale: [rescale(22); 16],
        },
        last: Layer {
            weights: core::array::from_fn(|_| core::array::from_fn(|_| weight(&mut numbers))),
            bias: core::array::from_fn(|_| numbers.below(100_000)),
            rescale: [rescale(24); 4],
        },
    };
    let words: [u32; Network::<16, 16>::WORDS] = network.pack(&decision());
    let model = Model::parse(&words).expect("what was packed");
    let wide: [u32; Network::<16, 16>::WIDE_WORDS] = network.pack_wide(&decision());
    let wide = Model::parse(&wide).map(|model| model.preferences(&[77; FEATURES], &mut [0; 40]));
    assert_eq!(wide, Ok(network.preferences(&[77; FEATURES])));
    let packed = PackedPolicy::<{ Network::<16, 16>::SCRATCH }>::new(&ARM, model).expect("it fits");
    let plain = FixedPolicy { arm: &ARM, network: &network, decision: decision() };
    let mut scratch = [0; Network::<16, 16>::SCRATCH];
    for _ in 0..1_000_000 {
        let mut joint = |low: i32, high: i32| (low + (numbers.next() % (high - low + 1) as u32) as i32) as i16;
        let pose = Pose([joint(2, 4094), joint(1025, 3071), joint(1025, 3071), joint(1025, 3071)]);
        let target = [numbers.below(45_000), numbers.below(45_000), numbers.below(45_000)].map(|v| v as f32 / 100.0);
        let seen = Observation::at(&ARM, pose, target);
        let values = quantise(&features(&Frame::of(&ARM, &seen)));
        assert_eq!(model.preferences(&values, &mut scratch), network.preferences(&values));
        assert_eq!(packed.decide(&seen), plain.decide(&seen));
    }
}

impl Model<'_> {
    /// [`preferences`](Model::preferences) by the kernels in plain Rust.
    fn portable_preferences(&self, inputs: &[i16]) -> [i32; JOINTS] {
        let hidden = &self.hidden[..self.count];
        let mut from = vec![0; hidden.first().unwrap_or(&self.last).inputs];
        match hidden.first().unwrap_or(&self.last).kind.form() {
            Form::Pairs => tpg_kernels::pair_inputs(inputs, &mut from),
            Form::Split => tpg_kernels::split_inputs(inputs, &mut from),
        }
        for (index, layer) in hidden.iter().enumerate() {
            let form = hidden.get(index + 1).unwrap_or(&self.last).kind.form();
            let blocks = layer.blocks.chunks_exact(layer.kind.block(from.len()));
            from = blocks.flat_map(|block| portable::hidden(layer.kind, form, block, &from)).collect();
        }
        let sums = portable::accumulate(self.last.kind, self.last.blocks, &from);
        portable::rescale(self.last.kind, self.last.blocks, &from, sums)
            .map(|preference| preference.clamp(i32::from(LAST), i32::from(i16::MAX)))
    }
}

#[test]
fn a_million_observations_answer_the_same_in_every_kind_and_form() {
    let mut numbers = Numbers(8);
    for kind in Kind::ALL {
        let sizes = [(FEATURES, 16), (16, 12), (12, JOINTS)];
        let layers = sizes.map(|(inputs, outputs)| Random::new(inputs, outputs, kind, &mut numbers));
        let words = packed(&layers);
        let model = Model::parse(&words).expect("what was packed");
        let mut scratch = vec![0; model.scratch()];
        for number in 0..1_000_000 {
            let mut joint = |low: i32, high: i32| (low + (numbers.next() % (high - low + 1) as u32) as i32) as i16;
            let pose = Pose([joint(2, 4094), joint(1025, 3071), joint(1025, 3071), joint(1025, 3071)]);
            let target = [0; 3].map(|_: i32| numbers.below(45_000) as f32 / 100.0);
            let inputs = quantise(&features(&Frame::at(&ARM, pose, target)));
            let answer = model.preferences(&inputs, &mut scratch);
            assert_eq!(answer, model.portable_preferences(&inputs), "{kind:?}, {number}: {}", tpg_kernels::form());
            let mut values = inputs.to_vec();
            if kind == Kind::W8A8 {
                values.iter_mut().for_each(|value| *value = tpg_kernels::clip_to_i8(*value));
            }
            for (index, layer) in layers.iter().enumerate() {
                let last = index + 1 == layers.len();
                let high = if last { i16::MAX } else { kind.activation() };
                values = layer.outputs(&values, if last { LAST } else { 0 }, high);
            }
            assert!(answer.iter().zip(&values).all(|(a, b)| *a == i32::from(*b)), "{kind:?}, {number}");
        }
    }
}

#[test]
fn what_does_not_fit_is_refused() {
    let mut numbers = Numbers(3);
    let mut layer = Random::new(FEATURES, 4, Kind::W8A16, &mut numbers);
    let mut words = vec![0; super::words(&[(FEATURES, 4, Kind::W8A16)])];
    assert!(pack(&[layer.rows()], &decision(), &mut words));
    let model = Model::parse(&words).expect("what was packed");
    assert_eq!(model.preferences(&[1; FEATURES], &mut [0; 1]), [0; 4], "scratch memory is too short");
    let mut other = words.clone();
    other[4] ^= 1;
    other[3] = crc::of_words(&other[4..]);
    assert_eq!(Model::parse(&other).err(), Some(ModelError::Features));
    assert_eq!(Model::parse(&words[..3]).err(), Some(ModelError::Short));
    assert_eq!(Model::parse(&[]).err(), Some(ModelError::NotAModel));
    layer.bias[2] = i32::MAX;
    assert!(!pack(&[layer.rows()], &decision(), &mut words), "an accumulator overflows");
    layer.bias[2] = 0;
    layer.rescale[1].shift = 12;
    assert!(!pack(&[layer.rows()], &decision(), &mut words), "no multiplier");
}

#[test]
fn a_multiplier_is_its_rescale() {
    let mut numbers = Numbers(9);
    for _ in 0..100_000 {
        let rescale = Rescale { factor: (numbers.next() & 0x7fff) as i16, shift: 1 + (numbers.next() % 47) as u8 };
        let Some(multiplier) = rescale.multiplier() else { continue };
        let accumulator = (numbers.next() as i32) << (numbers.next() % 4);
        let value = (i64::from(accumulator) * i64::from(multiplier) + (1 << 31)) >> 32;
        assert_eq!(i64::from(rescale.apply(accumulator, LAST)), value.clamp(-32767, 32767), "{rescale:?}");
    }
}
