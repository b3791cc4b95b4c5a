//! The arm's network: packed or not, it decides for the same moves.

use tpg_arm::observation::Observation;
use tpg_arm::sac::fixed::{FixedDecision, FixedPolicy, Network, quantise};
use tpg_arm::sac::packed::{Model, PackedPolicy};
use tpg_arm::sac::{Actions, FEATURES, Mask, features};
use tpg_arm::{Arm, Pose, WIDOWX, frame::Frame};
use tpg_runtime::net::{self, Layer, Meaning, ModelError, OutputKind, Rescale};
use tpg_runtime::policy::Policy as _;
use tpg_testing::numbers::Numbers;

const ARM: Arm<f32> = WIDOWX.to_f32();

fn layer<const I: usize, const O: usize>(numbers: &mut Numbers, shift: u8) -> Layer<I, O> {
    Layer {
        weights: core::array::from_fn(|_| core::array::from_fn(|_| numbers.within(127) as i8)),
        bias: core::array::from_fn(|_| numbers.within(100_000)),
        rescale: [Rescale { factor: 20_000, shift }; O],
    }
}

fn decision() -> FixedDecision {
    FixedDecision::new(Actions::Fine, Mask::JointLimits, false)
}

#[test]
fn a_million_observations_answer_the_same_packed_and_not() {
    let mut numbers = Numbers(7);
    let network = Network::<16, 16> {
        first: layer(&mut numbers, 22),
        second: layer(&mut numbers, 22),
        last: layer(&mut numbers, 24),
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
        let mut joint = |low: i32, high: i32| (low + (numbers.next_u32() % (high - low + 1) as u32) as i32) as i16;
        let pose = Pose([joint(2, 4094), joint(1025, 3071), joint(1025, 3071), joint(1025, 3071)]);
        let target = [0; 3].map(|_: i32| numbers.within(45_000) as f32 / 100.0);
        let seen = Observation::at(&ARM, pose, target);
        let values = quantise(&features(&Frame::new(&ARM, &seen)));
        assert_eq!(model.preferences(&values, &mut scratch), network.preferences(&values));
        assert_eq!(packed.decide(&seen), plain.decide(&seen));
    }
}

#[test]
fn every_decision_survives_as_flags() {
    for actions in [Actions::Coarse, Actions::Fine] {
        for mask in [Mask::None, Mask::JointLimits] {
            for may_rest in [false, true] {
                let decision = FixedDecision::new(actions, mask, may_rest);
                let OutputKind::Preferences { flags } = decision.meaning().answer else { panic!("preferences") };
                assert_eq!(FixedDecision::from_flags(flags), decision);
            }
        }
    }
}

#[test]
fn networks_of_other_problems_are_refused() {
    let mut numbers = Numbers(9);
    let layer: Layer<FEATURES, 4> = layer(&mut numbers, 22);
    let rows = net::LayerRows {
        inputs: FEATURES,
        kind: net::Kind::W8A16,
        weights: net::Weights::I8(layer.weights.as_flattened()),
        bias: &layer.bias,
        rescale: &layer.rescale,
    };
    let arms = decision().meaning();
    for (meaning, good) in [
        (arms, true),
        (Meaning { contract: arms.contract ^ 1, ..arms }, false),
        (Meaning { answer: OutputKind::Argmax, ..arms }, false),
    ] {
        let mut words = vec![0; net::words(&[(FEATURES, 4, net::Kind::W8A16)], &meaning)];
        assert!(net::pack(&[rows], &meaning, &mut words));
        assert_eq!(Model::parse(&words).err(), (!good).then_some(ModelError::Meaning), "{meaning:?}");
    }
}
