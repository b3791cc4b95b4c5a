//! The arm's network as it lies in flash: it decides as its definition does, and others are refused.

use tpg_arm::observation::Observation;
use tpg_arm::sac::fixed::quantise;
use tpg_arm::sac::packed::{Model, PackedPolicy};
use tpg_arm::sac::{Actions, Decision, FEATURES, Mask, features};
use tpg_arm::{Arm, JOINTS, Pose, WIDOWX, frame::Frame};
use tpg_runtime::net::{
    self, HIDDEN, Kind, LAST, LayerRows, Meaning, ModelError, OutputKind, Rescale, Weights, accumulate,
};
use tpg_runtime::policy::Policy as _;
use tpg_testing::numbers::Numbers;

const ARM: Arm<f32> = WIDOWX.to_f32();

/// A layer of numbers without a pattern.
struct Layer {
    inputs: usize,
    weights: Vec<i8>,
    bias: Vec<i32>,
    rescale: Vec<Rescale>,
}

impl Layer {
    fn new(inputs: usize, outputs: usize, shift: u8, numbers: &mut Numbers) -> Self {
        Self {
            inputs,
            weights: (0..inputs * outputs).map(|_| numbers.within(127) as i8).collect(),
            bias: (0..outputs).map(|_| numbers.within(100_000)).collect(),
            rescale: vec![Rescale { factor: 20_000, shift }; outputs],
        }
    }

    fn rows(&self) -> LayerRows<'_> {
        let Self { inputs, weights, bias, rescale } = self;
        LayerRows { inputs: *inputs, kind: Kind::W8A16, weights: Weights::I8(weights), bias, rescale }
    }

    fn outputs(&self, inputs: &[i16], low: i16) -> Vec<i16> {
        let rows = self.weights.chunks_exact(self.inputs).zip(&self.bias).zip(&self.rescale);
        rows.map(|((weights, &bias), rescale)| rescale.apply(accumulate(bias, weights, inputs), low)).collect()
    }
}

fn packed(layers: &[Layer], meaning: &Meaning<'_>) -> Vec<u32> {
    let sizes: Vec<_> = layers.iter().map(|layer| (layer.inputs, layer.bias.len(), Kind::W8A16)).collect();
    let rows: Vec<_> = layers.iter().map(Layer::rows).collect();
    let mut words = vec![0; net::words(&sizes, meaning)];
    assert!(net::pack(&rows, meaning, &mut words));
    words
}

fn decision() -> Decision<i32> {
    Decision::<i32>::new(Actions::Fine, Mask::JointLimits, false)
}

#[test]
fn a_packed_network_decides_as_its_definition() {
    const SCRATCH: usize = 40;
    let mut numbers = Numbers(7);
    let layers = [(FEATURES, 16, 22), (16, 16, 22), (16, JOINTS, 24)]
        .map(|(inputs, outputs, shift)| Layer::new(inputs, outputs, shift, &mut numbers));
    let words = packed(&layers, &decision().meaning());
    let model = Model::parse(&words).expect("what was packed");
    let policy = PackedPolicy::<SCRATCH>::new(&ARM, model).expect("it fits");
    for _ in 0..tpg_testing::amount(100_000, 1_000_000) {
        let mut joint = |low: i32, high: i32| (low + (numbers.next_u32() % (high - low + 1) as u32) as i32) as i16;
        let pose = Pose([joint(2, 4094), joint(1025, 3071), joint(1025, 3071), joint(1025, 3071)]);
        let target = [0; 3].map(|_: i32| numbers.within(45_000) as f32 / 100.0);
        let seen = Observation::at(&ARM, pose, target);
        let values = quantise(&features(&Frame::new(&ARM, &seen)));
        let first = layers[1].outputs(&layers[0].outputs(&values, HIDDEN), HIDDEN);
        let outputs = layers[2].outputs(&first, LAST);
        let preferences: [i32; JOINTS] = std::array::from_fn(|joint| outputs[joint].into());
        assert_eq!(model.preferences(&values, &mut [0; SCRATCH]), preferences);
        assert_eq!(policy.decide(&seen), decision().decide(preferences, pose, &ARM.ranges));
    }
}

#[test]
fn every_decision_survives_as_flags() {
    for actions in [Actions::Coarse, Actions::Fine] {
        for mask in [Mask::None, Mask::JointLimits] {
            for may_rest in [false, true] {
                let decision = Decision::<i32>::new(actions, mask, may_rest);
                let OutputKind::Preferences { flags } = decision.meaning().answer else { panic!("preferences") };
                assert_eq!(Decision::from_flags(flags), decision);
            }
        }
    }
}

#[test]
fn networks_of_other_problems_are_refused() {
    let layers = [Layer::new(FEATURES, JOINTS, 22, &mut Numbers(9))];
    let arms = decision().meaning();
    for (meaning, good) in [
        (arms, true),
        (Meaning { contract: arms.contract ^ 1, ..arms }, false),
        (Meaning { answer: OutputKind::Argmax, ..arms }, false),
    ] {
        let words = packed(&layers, &meaning);
        assert_eq!(Model::parse(&words).err(), (!good).then_some(ModelError::Meaning), "{meaning:?}");
    }
}
