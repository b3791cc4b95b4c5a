//! The inner loops of a network in integers, and a square root: for these plain Rust compiles to too many instructions.
//!
//! Weights lie in blocks of four rows, so that one load of four registers fetches the same columns of four rows (on a
//! Cortex-M) or one vector register (on x86-64). A block is, in 32-bit words:
//!
//! | words | what |
//! | --- | --- |
//! | 4 | biases |
//! | 4 (`i8`) or 8 (`i16`) for every 4 columns | weights, word by word of the four rows |
//! | 4 | multipliers: an output is (accumulator · multiplier + 2³¹) >> 32 |
//!
//! Columns are padded with zeros to a multiple of [`COLUMNS`]. The [`Kind`] says which weights a word holds. The
//! arithmetic is exact integer arithmetic modulo 2³²: every form of a
//! kernel gives the same bits, whatever the numbers are.
//!
//! | form | where | module |
//! | --- | --- | --- |
//! | SMLAD, by inline assembly | `thumbv7em-*` | `thumb2` |
//! | MLA, by inline assembly | `thumbv7m-*`, `thumbv8m.main-*` | `thumb2` |
//! | MULS, by inline assembly | `thumbv6m-*`, `thumbv8m.base-*` | `thumb1` |
//! | plain Rust, a load for each weight | `riscv32*` | `scalar` |
//! | AVX2 | `x86_64` that has it, looked for once | `avx2` |
//! | plain Rust | everywhere else; always there to compare with | [`portable`] |
//!
//! This is the one crate under `tpg-runtime` with `unsafe` code: calls of assembly and AVX2, behind functions
//! that check their preconditions, and views of words as bytes.

#![no_std]

mod activations;
mod kind;
pub mod portable;
mod root;
#[cfg(any(tpg_scalar, all(test, target_endian = "little")))]
mod scalar;

#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(tpg_thumb1)]
mod thumb1;
#[cfg(tpg_thumb2)]
mod thumb2;

pub use activations::pair_inputs;
pub use kind::{COLUMNS, Kind, ROWS};
pub use root::sqrt;

#[cfg(not(any(tpg_thumb1, tpg_thumb2, tpg_scalar)))]
use portable as chosen;
#[cfg(tpg_scalar)]
use scalar as chosen;
#[cfg(tpg_thumb1)]
use thumb1 as chosen;
#[cfg(tpg_thumb2)]
use thumb2 as chosen;

/// Words of inputs for [`COLUMNS`] columns.
const TURN: usize = COLUMNS / 2;

/// Returns true if there are inputs, as many columns as padding leaves.
#[inline(always)]
fn whole(inputs: &[u32]) -> bool {
    !inputs.is_empty() && inputs.len().is_multiple_of(TURN)
}

/// A hidden layer: its outputs behind their ReLU, as the next layer's inputs.
///
/// `blocks` are whole blocks for as many columns as `inputs` has, a multiple of [`COLUMNS`]: for others nothing is written. Two
/// words come out of every block; what does not fit into `outputs`, or an incomplete block, is left out.
#[inline(never)] // its loop is not its caller's: a static bound multiplies nested ones
pub fn hidden(kind: Kind, blocks: &[u32], inputs: &[u32], outputs: &mut [u32]) {
    if !whole(inputs) {
        return;
    }
    #[cfg(target_arch = "x86_64")]
    if avx2::layer(kind, blocks, inputs, outputs) {
        return;
    }
    #[cfg(tpg_thumb2)]
    chosen::layer(kind, blocks, inputs, outputs);
    // A loop for each kind, so that none asks which it is.
    #[cfg(not(tpg_thumb2))]
    match kind {
        Kind::W8A16 => each(Kind::W8A16, blocks, inputs, outputs),
        Kind::W16A16 => each(Kind::W16A16, blocks, inputs, outputs),
    }
}

#[cfg(not(tpg_thumb2))]
#[inline(always)]
fn each(kind: Kind, blocks: &[u32], inputs: &[u32], outputs: &mut [u32]) {
    for (block, outputs) in blocks.chunks_exact(kind.block(inputs.len())).zip(outputs.as_chunks_mut::<2>().0) {
        *outputs = portable::clip(portable::rescale(kind, block, inputs, chosen::accumulate(kind, block, inputs)));
    }
}

/// The outputs of one block of the last layer: no ReLU, no clipping. Zeros where its columns are no multiple of [`COLUMNS`], or
/// the block is incomplete.
pub fn last(kind: Kind, block: &[u32], inputs: &[u32]) -> [i32; ROWS] {
    if !whole(inputs) {
        return [0; ROWS];
    }
    let accumulators = chosen::accumulate(kind, block, inputs);
    portable::rescale(kind, block, inputs, accumulators)
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use proptest::prelude::*;
    use std::vec::Vec;

    /// Words at random, and the extreme ones.
    fn words(length: usize) -> impl Strategy<Value = Vec<u32>> {
        let extreme = prop_oneof![Just(0x8000_8000u32), Just(0x7fff_7fff), Just(0x8080_8080), Just(0x7f7f_7f7f)];
        prop::collection::vec(prop_oneof![4 => any::<u32>(), 1 => extreme], length)
    }

    proptest! {
        #[test]
        fn the_chosen_form_is_the_portable_one(
            (kind, eights, seed) in (prop::sample::select(&Kind::ALL[..]), 0usize..9, any::<u64>())
                .prop_flat_map(|(kind, eights, _)| {
                    let length = kind.block(eights * 4) + eights * 4;
                    (Just(kind), Just(eights), words(length))
                }),
        ) {
            let (block, inputs) = seed.split_at(kind.block(eights * 4));
            prop_assert_eq!(
                chosen::accumulate(kind, block, inputs), portable::accumulate(kind, block, inputs)
            );
            #[cfg(target_endian = "little")]
            prop_assert_eq!(
                scalar::accumulate(kind, block, inputs), portable::accumulate(kind, block, inputs)
            );
        }
    }

    proptest! {
        #[test]
        fn a_layer_is_its_portable_blocks(
            (kind, columns, layer) in (prop::sample::select(&Kind::ALL[..]), 1usize..5, 0usize..5)
                .prop_flat_map(|(kind, eights, blocks)| {
                    let inputs = eights * 4;
                    (Just(kind), Just(inputs), words(inputs + blocks * kind.block(inputs)))
                }),
        ) {
            let (inputs, blocks) = layer.split_at(columns);
            let each = blocks.chunks_exact(kind.block(columns));
            let expected: Vec<u32> = each.flat_map(|block| portable::hidden(kind, block, inputs)).collect();
            let mut outputs = std::vec![0; expected.len()];
            hidden(kind, blocks, inputs, &mut outputs);
            prop_assert_eq!(outputs, expected);
        }
    }

    #[test]
    fn what_is_too_short_is_left_out() {
        let mut outputs = [7; 5];
        hidden(Kind::W8A16, &[1; 15], &[1; 4], &mut outputs);
        assert_eq!(outputs, [7; 5], "a block has 16 words");
        assert_eq!(last(Kind::W16A16, &[1; 3], &[1; 4]), [0; 4]);
        for no_turn in [&[][..], &[1; 6]] {
            hidden(Kind::W8A16, &[1; 40], no_turn, &mut outputs);
            assert_eq!(outputs, [7; 5]);
            assert_eq!(last(Kind::W8A16, &[1; 40], no_turn), [0; 4]);
        }
    }
}
