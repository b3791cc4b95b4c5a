//! A network in integers, of any shape and for any problem.

use crate::code::{
    self, Refusal, TPG_ARGUMENT, TPG_LENGTH, TPG_MODEL, TPG_MODEL_CHECKSUM, TPG_MODEL_FEATURES, TPG_MODEL_LAYERS,
    TPG_MODEL_VERSION,
};
use crate::memory::{self, Opaque};
use tpg_runtime::net::{Model, ModelError, OutputKind};

/// Words of a tpg_network_t.
pub const TPG_NETWORK_WORDS: usize = 26;

/// A network in integers, checked. Opaque; initialised by tpg_network_init, constant from then on.
#[repr(C)]
pub struct tpg_network_t {
    /// The library's.
    pub opaque: [u64; TPG_NETWORK_WORDS],
}

// SAFETY: any bytes are an array of integers; `initialise` proves that the content fits.
unsafe impl Opaque for tpg_network_t {
    type Content = Model<'static>;
    const TAG: u32 = 0x4e45_5401;
}

pub(crate) fn model_code(error: ModelError) -> Refusal {
    Refusal(match error {
        ModelError::NotAModel => TPG_MODEL,
        ModelError::Version => TPG_MODEL_VERSION,
        ModelError::Short => TPG_LENGTH,
        ModelError::Checksum => TPG_MODEL_CHECKSUM,
        ModelError::Meaning => TPG_MODEL_FEATURES,
        ModelError::Layers => TPG_MODEL_LAYERS,
    })
}

/// Checks a model of `words` 32-bit words and borrows it: it must stay where it is and as it is, in flash say, for as long
/// as `network` is used.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_network_init(network: *mut tpg_network_t, model: *const u32, words: usize) -> i32 {
    // SAFETY: the header's contract; the caller keeps the words for as long as `network` lives.
    code::from_result(unsafe { memory::array::<'static, u32>(model, words) }.and_then(|words| {
        let model = Model::parse(words).map_err(model_code)?;
        // SAFETY: the header's contract.
        unsafe { memory::initialise(network, model) }
    }))
}

/// Gives the 32-bit words of scratch memory that a decision needs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_network_scratch(network: *const tpg_network_t, words: *mut usize) -> i32 {
    // SAFETY: the header's contract.
    let (model, words) = unsafe { (memory::content(network), memory::write(words)) };
    code::answer(model.map(Model::scratch), words)
}

/// Gives the count of numbers in a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_network_inputs(network: *const tpg_network_t, inputs: *mut usize) -> i32 {
    // SAFETY: the header's contract.
    let (model, inputs) = unsafe { (memory::content(network), memory::write(inputs)) };
    code::answer(model.map(Model::inputs), inputs)
}

/// Gives the count of outputs of the network: values, or actions to choose from.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_network_outputs(network: *const tpg_network_t, outputs: *mut usize) -> i32 {
    // SAFETY: the header's contract.
    let (model, outputs) = unsafe { (memory::content(network), memory::write(outputs)) };
    code::answer(model.map(Model::outputs), outputs)
}

/// The values that a network answers a state with. `scratch` is overwritten. TPG_LENGTH where `length` numbers of the state,
/// `words` of scratch memory or `count` values are too few; TPG_ARGUMENT for a network that does not answer with values.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_network_values(
    network: *const tpg_network_t,
    state: *const f32,
    length: usize,
    scratch: *mut u32,
    words: usize,
    values: *mut f32,
    count: usize,
) -> i32 {
    // SAFETY: the header's contract.
    let (model, state, scratch, values) = unsafe {
        (
            memory::content(network),
            memory::array(state, length),
            memory::array_mut(scratch, words),
            memory::array_mut(values, count),
        )
    };
    code::from_result(model.and_then(|model| {
        let (state, scratch, values) = (state?, scratch?, values?);
        if model.answer() != OutputKind::Values {
            return Err(Refusal(TPG_ARGUMENT));
        }
        if model.values(state, scratch, values) { Ok(()) } else { Err(Refusal(TPG_LENGTH)) }
    }))
}

/// The action that a network chooses in a state: the number of its greatest output, of equals the first. `scratch` is
/// overwritten. TPG_LENGTH where `length` numbers of the state or `words` of scratch memory are too few; TPG_ARGUMENT for a
/// network that does not choose.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn tpg_network_choose(
    network: *const tpg_network_t,
    state: *const f32,
    length: usize,
    scratch: *mut u32,
    words: usize,
    action: *mut u16,
) -> i32 {
    // SAFETY: the header's contract.
    let (model, state, scratch, action) = unsafe {
        (
            memory::content(network),
            memory::array(state, length),
            memory::array_mut(scratch, words),
            memory::write(action),
        )
    };
    let chosen = model.and_then(|model| {
        let (state, scratch) = (state?, scratch?);
        if model.answer() != OutputKind::Argmax {
            return Err(Refusal(TPG_ARGUMENT));
        }
        model.choose(state, scratch).ok_or(Refusal(TPG_LENGTH))
    });
    code::answer(chosen, action)
}
