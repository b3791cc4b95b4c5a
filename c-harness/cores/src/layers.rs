//! Networks 38-64-64-4 of every kind with weights without a pattern, to count on every core, and to compare with the host.

use tpg_runtime::net::{self, Kind, LayerRows, Meaning, Model, OutputKind, Rescale, Weights, pack};

/// Values of each layer, the inputs first.
const SIZES: [usize; 4] = [38, 64, 64, 4];
/// Inputs that each network is asked with.
pub const INPUTS: u32 = 200;
/// Words of scratch memory: as many as the widest layer's inputs.
const SCRATCH: usize = 64;

const MEANING: Meaning<'static> =
    Meaning { contract: 0, inputs: &[], answer: OutputKind::Preferences { flags: 0 }, values: &[] };

static W8A16: [u32; words(Kind::W8A16)] = model(Kind::W8A16);
static W16A16: [u32; words(Kind::W16A16)] = model(Kind::W16A16);

/// The answer of a network, and the instructions that it took.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Asked {
    /// A hash of every answer.
    pub hash: u64,
    /// Inputs that it was asked with.
    pub inputs: u32,
    /// Instructions of all of them.
    pub instructions: u32,
    /// Instructions of the costliest one.
    pub worst: u32,
}

const fn words(kind: Kind) -> usize {
    let [a, b, c, d] = SIZES;
    net::words(&[(a, b, kind), (b, c, kind), (c, d, kind)], &MEANING)
}

/// Numbers without a pattern.
struct LayerNumbers(u32);

impl LayerNumbers {
    const fn next(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        self.0
    }

    /// From −`bound`/2 to `bound`/2.
    const fn below(&mut self, bound: i32) -> i32 {
        (self.next() >> 8) as i32 % (bound + 1) - bound / 2
    }
}

/// A network with weights without a pattern.
const fn model<const WORDS: usize>(kind: Kind) -> [u32; WORDS] {
    let mut words = [0; WORDS];
    let mut numbers = LayerNumbers(1);
    let bound = match kind {
        Kind::W8A16 => 250,
        Kind::W16A16 => 400,
    };
    let mut weights = [[0i16; 64 * 64]; 3];
    let mut biases = [[0i32; 64]; 3];
    let rescale = [Rescale { factor: 20_000, shift: 22 }; 64];
    let mut layer = 0;
    while layer < 3 {
        let mut at = 0;
        while at < SIZES[layer] * SIZES[layer + 1] {
            weights[layer][at] = numbers.below(bound) as i16;
            at += 1;
        }
        at = 0;
        while at < SIZES[layer + 1] {
            biases[layer][at] = numbers.below(10_000);
            at += 1;
        }
        layer += 1;
    }
    let mut rows = [LayerRows { inputs: 0, kind, weights: Weights::I16(&[]), bias: &[], rescale: &[] }; 3];
    layer = 0;
    while layer < 3 {
        let (inputs, outputs) = (SIZES[layer], SIZES[layer + 1]);
        rows[layer] = LayerRows {
            inputs,
            kind,
            weights: Weights::I16(weights[layer].split_at(inputs * outputs).0),
            bias: biases[layer].split_at(outputs).0,
            rescale: rescale.split_at(outputs).0,
        };
        layer += 1;
    }
    assert!(pack(&rows, &MEANING, &mut words));
    words
}

/// Asks the network of a kind: `from` starts a count of instructions, `count` says how many since. `None` where it is no model.
pub fn ask(kind: Kind, from: impl Fn(), count: impl Fn() -> u32) -> Option<Asked> {
    let words: &[u32] = match kind {
        Kind::W8A16 => &W8A16,
        Kind::W16A16 => &W16A16,
    };
    let model = Model::parse(words).ok()?;
    let mut scratch = [0; SCRATCH];
    from();
    let nothing = count();
    let mut numbers = LayerNumbers(11);
    let mut asked = Asked { hash: 0xcbf2_9ce4_8422_2325, inputs: INPUTS, ..Asked::default() };
    for _ in 0..INPUTS {
        let inputs: [i16; SIZES[0]] = core::array::from_fn(|_| (numbers.next() >> 16) as i16);
        from();
        let answers = model.first(&inputs, &mut scratch);
        let instructions = count() - nothing;
        asked.instructions += instructions;
        asked.worst = asked.worst.max(instructions);
        for byte in answers.into_iter().flat_map(i32::to_le_bytes) {
            asked.hash = (asked.hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
    Some(asked)
}

/// [`ask`] for C, the kind by its code; `false` where there is no such kind.
#[allow(unsafe_code, reason = "C finds it by this name")]
#[unsafe(no_mangle)]
pub extern "C" fn rust_layers(
    code: u32,
    from: extern "C" fn(),
    count: extern "C" fn() -> u32,
    asked: &mut Asked,
) -> bool {
    match Kind::from_code(code).and_then(|kind| ask(kind, || from(), || count())) {
        Some(answer) => {
            *asked = answer;
            true
        }
        None => false,
    }
}
