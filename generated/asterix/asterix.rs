//! A policy for asterix, score 18.18 in validation, trained by tpg-train 0.1.0 with seed 2.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix asterix --profile constant-time
//! Graph SHA-256: 4061f7d0b45d5d0664d2fb6680afe7f598172fed250250341c63b04254539c66
//! 14 teams (14 on the longest walk), 57 edges, 56 programs, 38 distinct operations.
//! A decision takes at most 57 bids and 38 operations.
//! Computes in f32 with own maths.
#![forbid(unsafe_code)]
#![allow(
    clippy::all,
    unused_variables,
    unused_assignments,
    reason = "evolved expressions need not make sense"
)]

use tpg_runtime::ops::constant_time::ConstantTime;
use tpg_runtime::policy::{ActionId, Policy};

/// A tangled program graph: branch-free, the same time for every state.
///
/// It sees, one after another:
/// - `s[0..3]`: player_at, -1 to 9
/// - `s[3..17]`: enemy_near, 0 to 1
/// - `s[17..23]`: trail_near, 0 to 1
/// - `s[23..27]`: gold_at, -1 to 9
/// - `s[27..36]`: gold_near, 0 to 1
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - 0: stay
/// - 1: left
/// - 2: up
/// - 3: right
/// - 4: down
#[derive(Clone, Copy, Debug, Default)]
pub struct Asterix;

impl Asterix {
    /// Values of a state.
    pub const STATE: usize = 36;
    /// Actions.
    pub const ACTIONS: usize = 5;
    /// An action.
    pub const STAY: ActionId = ActionId(0);
    /// An action.
    pub const LEFT: ActionId = ActionId(1);
    /// An action.
    pub const UP: ActionId = ActionId(2);
    /// An action.
    pub const RIGHT: ActionId = ActionId(3);
    /// An action.
    pub const DOWN: ActionId = ActionId(4);
    /// Teams on the longest walk.
    pub const DEPTH: usize = 14;
}

impl Policy for Asterix {
    type State = [f32; 36];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 36]) -> ActionId {
        let ct = ConstantTime::<f32>::default();
        let bid_20_value = ct.negate_if_less(ct.min(s[15], s[26]), -1.2375401_f32);

        // What is bid, as integers in the same order.
        let bid_1 = -8388607_i32; // 0.0_f32
        let bid_2 = ct.order(s[0] + s[34]);
        let bid_41 = ct.order(s[27] - s[7]);
        let bid_5 = ct.order(s[29] / s[22]);
        let bid_66 = ct.order(ct.negate_if_less(s[11], -0.084591985_f32));
        let bid_67 = ct.order(s[1] - s[23]);
        let bid_70 = ct.order(ct.max(f32::abs(s[19]), s[20]));
        let bid_50 = ct.order(s[17] - s[6]);
        let bid_45 = ct.order(s[30] / s[16]);
        let bid_10 = ct.order(ct.max(s[1], s[0]));
        let bid_11 = ct.order(s[33] / s[8]);
        let bid_12 = ct.order(s[30] / 0.0_f32);
        let bid_19 = ct.order(s[31] - s[7]);
        let bid_20 = ct.order(bid_20_value);
        let bid_24 = ct.order(s[14] - 0.058283113_f32);
        let bid_51 = ct.order(0.5620203_f32 / s[24]);
        let bid_52 = ct.order(s[26] / s[1]);
        let bid_53 = ct.order(s[35] / s[9]);
        let bid_54 = ct.order(s[23] / s[2]);
        let bid_55 = ct.order(ct.min(s[18], -0.026303096_f32));
        let bid_56 = ct.order(s[28] / s[16]);
        let bid_57 = ct.order(s[26] - s[1]);
        let bid_16 = ct.order(ct.negate_if_less(s[7], s[1]));
        let bid_17 = ct.order(f32::abs(s[5]));
        let bid_25 = ct.order(s[30] / s[14]);
        let bid_26 = ct.order(s[3] + 0.095409065_f32);
        let bid_28 = ct.order(s[32] / 0.0_f32);
        let bid_59 = ct.order(ct.negate_if_less(s[11], -0.08727101_f32));
        let bid_60 = ct.order(ct.negate_if_less(s[12], -1.0024955_f32));
        let bid_61 = 1005222905_i32; // 0.014311783_f32
        let bid_62 = ct.order(s[21] / s[16]);
        let bid_63 = ct.order(0.034219213_f32 * s[25]);
        let bid_64 = ct.order(0.033292964_f32 * s[25]);
        let bid_65 = ct.order(f32::abs(s[4]));
        let bid_35 = ct.order(f32::abs(s[13]));
        let bid_36 = ct.order(s[3] + 0.09617237_f32);
        let bid_38 = ct.order(s[5] * s[3]);
        let bid_39 = ct.order(f32::abs(s[10]));

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
        // Team 0
        let best = (bid_1, 1);
        let best = ct.challenge(best, (bid_2, 2));
        let t0 = best.1 as u8;
        // Team 9
        let best = (bid_1, 16);
        let best = ct.challenge(best, (bid_41, 3));
        let t1 = best.1 as u8;
        // Team 1
        let best = (bid_5, 16);
        let best = ct.challenge(best, (bid_1, 4));
        let t2 = best.1 as u8;
        // Team 10
        let best = (bid_1, 5);
        let best = ct.challenge(best, (bid_50, 6));
        let t3 = best.1 as u8;
        // Team 2
        let best = (bid_1, 7);
        let best = ct.challenge(best, (bid_11, 14));
        let best = ct.challenge(best, (bid_10, 8));
        let best = ct.challenge(best, (bid_12, 14));
        let t4 = best.1 as u8;
        // Team 13
        let best = (bid_66, 14);
        let best = ct.challenge(best, (bid_67, 16));
        let best = ct.challenge(best, (bid_70, 14));
        let best = ct.challenge(best, (bid_1, 18));
        let t5 = best.1 as u8;
        // Team 11
        let best = (bid_51, 14);
        let best = ct.challenge(best, (bid_52, 9));
        let best = ct.challenge(best, (bid_54, 9));
        let best = ct.challenge(best, (bid_55, 9));
        let best = ct.challenge(best, (bid_53, 16));
        let best = ct.challenge(best, (bid_56, 14));
        let best = ct.challenge(best, (bid_57, 9));
        let t6 = best.1 as u8;
        // Team 8
        let best = (bid_41, 3);
        let best = ct.challenge(best, (bid_1, 1));
        let best = ct.challenge(best, (bid_45, 14));
        let t7 = best.1 as u8;
        // Team 3
        let best = (bid_45, 6);
        let best = ct.challenge(best, (bid_16, 18));
        let best = ct.challenge(best, (bid_17, 14));
        let best = ct.challenge(best, (bid_1, 10));
        let t8 = best.1 as u8;
        // Team 12
        let best = (bid_17, 14);
        let best = ct.challenge(best, (bid_59, 14));
        let best = ct.challenge(best, (bid_60, 14));
        let best = ct.challenge(best, (bid_61, 14));
        let best = ct.challenge(best, (bid_62, 14));
        let best = ct.challenge(best, (bid_63, 5));
        let best = ct.challenge(best, (bid_64, 5));
        let best = ct.challenge(best, (bid_65, 14));
        let t9 = best.1 as u8;
        // Team 4
        let best = (bid_19, 14);
        let best = ct.challenge(best, (bid_20, 16));
        let best = ct.challenge(best, (bid_1, 11));
        let best = ct.challenge(best, (bid_24, 11));
        let t10 = best.1 as u8;
        // Team 5
        let best = (bid_25, 12);
        let best = ct.challenge(best, (bid_26, 13));
        let best = ct.challenge(best, (bid_28, 14));
        let best = ct.challenge(best, (bid_17, 14));
        let best = ct.challenge(best, (bid_56, 14));
        let best = ct.challenge(best, (bid_1, 7));
        let t11 = best.1 as u8;
        // Team 6
        let best = (bid_19, 14);
        let best = ct.challenge(best, (bid_35, 14));
        let best = ct.challenge(best, (bid_36, 13));
        let best = ct.challenge(best, (bid_1, 7));
        let best = ct.challenge(best, (bid_17, 14));
        let t12 = best.1 as u8;
        // Team 7
        let best = (bid_38, 15);
        let best = ct.challenge(best, (bid_39, 14));
        let best = ct.challenge(best, (bid_1, 7));
        let best = ct.challenge(best, (bid_41, 3));
        let t13 = best.1 as u8;

        // An action leads to itself, and so does what fills the array up to a power of two: it is never come to.
        let next: [u8; 32] = [
            t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, t11, t12, t13, 14, 15, 16, 17, 18, 19, 20,
            21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31,
        ];
        // The longest walk decides 14 times; a shorter one waits at its action. No loop, and no end to check.
        let vertex = next[0];
        let vertex = next[(vertex & 31) as usize];
        let vertex = next[(vertex & 31) as usize];
        let vertex = next[(vertex & 31) as usize];
        let vertex = next[(vertex & 31) as usize];
        let vertex = next[(vertex & 31) as usize];
        let vertex = next[(vertex & 31) as usize];
        let vertex = next[(vertex & 31) as usize];
        let vertex = next[(vertex & 31) as usize];
        let vertex = next[(vertex & 31) as usize];
        let vertex = next[(vertex & 31) as usize];
        let vertex = next[(vertex & 31) as usize];
        let vertex = next[(vertex & 31) as usize];
        let vertex = next[(vertex & 31) as usize];
        ActionId(vertex.wrapping_sub(14) as u16)
    }
}

impl Asterix {
    /// Rows, columns and channels of the image; a cell's channels are beside each other.
    pub const IMAGE: [usize; 3] = [10, 10, 4];

    /// Computes the values of a state that come from an image, whose rows begin `stride` bytes apart. Returns false where the
    /// image is too short; the state is then as it was.
    pub fn look(&self, image: &[u8], stride: usize, state: &mut [f32; 36]) -> bool {
        let before = stride.checked_mul(9);
        let needed = before.and_then(|bytes| bytes.checked_add(40));
        if stride < 40 || needed.is_none_or(|needed| image.len() < needed) {
            return false;
        }
        let seen = image::Image {
            bytes: image,
            stride,
        };
        let place_0 = seen.first(0);
        let place_1 = seen.last(0);
        let place_2 = seen.first(3);
        let place_3 = seen.last(3);
        state[0] = place_0.row as f32;
        state[1] = place_1.row as f32;
        state[2] = place_1.column as f32;
        state[3] = seen.from(1, place_0, -2, -2) as f32;
        state[4] = seen.from(1, place_0, -1, -1) as f32;
        state[5] = seen.from(1, place_0, -1, 0) as f32;
        state[6] = seen.from(1, place_0, 0, -1) as f32;
        state[7] = seen.from(1, place_0, 0, 1) as f32;
        state[8] = seen.from(1, place_0, 0, 2) as f32;
        state[9] = seen.from(1, place_0, 0, 3) as f32;
        state[10] = seen.from(1, place_0, 1, -1) as f32;
        state[11] = seen.from(1, place_0, 1, 0) as f32;
        state[12] = seen.from(1, place_0, 1, 1) as f32;
        state[13] = seen.from(1, place_0, 1, 3) as f32;
        state[14] = seen.from(1, place_0, 2, -2) as f32;
        state[15] = seen.from(1, place_0, 2, 0) as f32;
        state[16] = seen.from(1, place_0, 4, -1) as f32;
        state[17] = seen.from(2, place_0, -4, -2) as f32;
        state[18] = seen.from(2, place_0, -2, 2) as f32;
        state[19] = seen.from(2, place_0, -2, 3) as f32;
        state[20] = seen.from(2, place_0, 1, -4) as f32;
        state[21] = seen.from(2, place_0, 4, -4) as f32;
        state[22] = seen.from(2, place_0, 4, -1) as f32;
        state[23] = place_2.row as f32;
        state[24] = place_2.column as f32;
        state[25] = place_3.row as f32;
        state[26] = place_3.column as f32;
        state[27] = seen.from(3, place_0, -4, -2) as f32;
        state[28] = seen.from(3, place_0, -3, 2) as f32;
        state[29] = seen.from(3, place_0, -1, 0) as f32;
        state[30] = seen.from(3, place_0, 0, -2) as f32;
        state[31] = seen.from(3, place_0, 0, -1) as f32;
        state[32] = seen.from(3, place_0, 0, 1) as f32;
        state[33] = seen.from(3, place_0, 0, 2) as f32;
        state[34] = seen.from(3, place_0, 1, -4) as f32;
        state[35] = seen.from(3, place_0, 4, -1) as f32;
        true
    }
}

mod image {
    /// A place in an image; row −1 if there is none. A policy may read only a part of it.
    #[derive(Clone, Copy)]
    #[allow(dead_code)]
    pub(super) struct Place {
        pub(super) row: i32,
        pub(super) column: i32,
        pub(super) contrast: i32,
    }

    /// An image that is long enough.
    #[derive(Clone, Copy)]
    pub(super) struct Image<'a> {
        pub(super) bytes: &'a [u8],
        pub(super) stride: usize,
    }

    impl Image<'_> {
        fn cell(self, channel: usize, row: usize, column: usize) -> u32 {
            let place = row * self.stride + column * 4 + channel;
            self.bytes.get(place).map_or(0, |&byte| u32::from(byte))
        }

        /// The first cell that is not 0.
        pub(super) fn first(self, channel: usize) -> Place {
            for row in 0..10 {
                for column in 0..10 {
                    if self.cell(channel, row, column) != 0 {
                        return Place {
                            row: row as i32,
                            column: column as i32,
                            contrast: 0,
                        };
                    }
                }
            }
            Place {
                row: -1,
                column: -1,
                contrast: 0,
            }
        }

        /// The last cell that is not 0.
        pub(super) fn last(self, channel: usize) -> Place {
            for row in (0..10).rev() {
                for column in (0..10).rev() {
                    if self.cell(channel, row, column) != 0 {
                        return Place {
                            row: row as i32,
                            column: column as i32,
                            contrast: 0,
                        };
                    }
                }
            }
            Place {
                row: -1,
                column: -1,
                contrast: 0,
            }
        }

        /// The cell so far down and to the right of a place; 0 outside the image.
        pub(super) fn from(self, channel: usize, from: Place, down: i32, right: i32) -> u32 {
            let (row, column) = (from.row + down, from.column + right);
            if from.row < 0 || row < 0 || row >= 10 || column < 0 || column >= 10 {
                return 0;
            }
            self.cell(channel, row as usize, column as usize)
        }
    }
}
