//! A policy for asterix, score 18.77 in validation, trained by tpg-train 0.1.0 with seed 5.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix asterix --profile constant-time
//! Graph SHA-256: a3c82f56424c1df88866034091fa7737c88264df73cc0d7ed64bc0dbb1317f50
//! 11 teams (9 on the longest walk), 36 edges, 35 programs, 23 distinct operations.
//! A decision takes at most 36 bids and 23 operations.
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
/// - `s[0..1]`: player_at, -1 to 9
/// - `s[1..4]`: enemy_at, -1 to 9
/// - `s[4..11]`: enemy_near, 0 to 1
/// - `s[11..12]`: trail_at, -1 to 9
/// - `s[12..16]`: trail_near, 0 to 1
/// - `s[16..29]`: gold_near, 0 to 1
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
    pub const STATE: usize = 29;
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
    pub const DEPTH: usize = 9;
}

impl Policy for Asterix {
    type State = [f32; 29];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 29]) -> ActionId {
        let ct = ConstantTime::<f32>::default();

        // What is bid, as integers in the same order.
        let bid_0 = ct.order(0.04226071_f32 / s[0]);
        let bid_7 = -8388607_i32; // 0.0_f32
        let bid_3 = ct.order(ct.max(s[18], s[19]));
        let bid_6 = ct.order(ct.max(s[9], s[28]));
        let bid_8 = ct.order(0.03143443_f32 / s[3]);
        let bid_10 = ct.order(ct.max(s[18], s[21]));
        let bid_61 = ct.order(s[7] * s[2]);
        let bid_62 = ct.order(ct.max(s[10], s[27]));
        let bid_65 = ct.order(ct.max(s[8], 0.0_f32));
        let bid_31 = ct.order(ct.max(s[1], 0.0_f32));
        let bid_32 = ct.order(ct.max(s[17], s[16]));
        let bid_34 = ct.order(ct.max(s[10], s[25]));
        let bid_17 = ct.order(ct.negate_if_less(s[26], s[6]));
        let bid_53 = ct.order(ct.max(s[23], s[25]));
        let bid_55 = ct.order(ct.max(s[23], s[27]));
        let bid_46 = ct.order(ct.max(s[3], s[15]));
        let bid_35 = ct.order(s[11] / s[4]);
        let bid_19 = ct.order(s[11] - s[12]);
        let bid_21 = ct.order(s[2] - s[12]);
        let bid_42 = ct.order(ct.max(s[14], s[5]));
        let bid_23 = ct.order(ct.max(s[20], s[21]));
        let bid_26 = ct.order(ct.max(s[13], 0.0651647_f32));
        let bid_27 = ct.order(s[24] + s[24]);
        let bid_30 = ct.order(ct.max(s[20], s[22]));

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
        // Team 0
        let best = (bid_0, 1);
        let best = ct.challenge(best, (bid_3, 13));
        let best = ct.challenge(best, (bid_6, 15));
        let best = ct.challenge(best, (bid_7, 2));
        let t0 = best.1 as u8;
        // Team 1
        let best = (bid_8, 3);
        let best = ct.challenge(best, (bid_10, 13));
        let best = ct.challenge(best, (bid_7, 4));
        let t1 = best.1 as u8;
        // Team 5
        let best = (bid_31, 5);
        let best = ct.challenge(best, (bid_32, 6));
        let best = ct.challenge(best, (bid_7, 7));
        let best = ct.challenge(best, (bid_34, 15));
        let t2 = best.1 as u8;
        // Team 2
        let best = (bid_17, 15);
        let best = ct.challenge(best, (bid_7, 8));
        let t3 = best.1 as u8;
        // Team 12
        let best = (bid_61, 13);
        let best = ct.challenge(best, (bid_62, 15));
        let best = ct.challenge(best, (bid_65, 13));
        let best = ct.challenge(best, (bid_7, 11));
        let t4 = best.1 as u8;
        // Team 10
        let best = (bid_53, 15);
        let best = ct.challenge(best, (bid_55, 15));
        let best = ct.challenge(best, (bid_7, 4));
        let t5 = best.1 as u8;
        // Team 8
        let best = (bid_7, 4);
        let best = ct.challenge(best, (bid_46, 5));
        let t6 = best.1 as u8;
        // Team 6
        let best = (bid_35, 9);
        let best = ct.challenge(best, (bid_7, 11));
        let best = ct.challenge(best, (bid_34, 15));
        let t7 = best.1 as u8;
        // Team 3
        let best = (bid_19, 10);
        let best = ct.challenge(best, (bid_21, 10));
        let best = ct.challenge(best, (bid_7, 4));
        let t8 = best.1 as u8;
        // Team 7
        let best = (bid_55, 15);
        let best = ct.challenge(best, (bid_42, 4));
        let best = ct.challenge(best, (bid_53, 15));
        let best = ct.challenge(best, (bid_7, 4));
        let t9 = best.1 as u8;
        // Team 4
        let best = (bid_23, 13);
        let best = ct.challenge(best, (bid_26, 2));
        let best = ct.challenge(best, (bid_27, 15));
        let best = ct.challenge(best, (bid_30, 13));
        let t10 = best.1 as u8;

        // An action leads to itself, and so does what fills the array up to a power of two: it is never come to.
        let next: [u8; 16] = [
            t0, t1, t2, t3, t4, t5, t6, t7, t8, t9, t10, 11, 12, 13, 14, 15,
        ];
        // The longest walk decides 9 times; a shorter one waits at its action. No loop, and no end to check.
        let vertex = next[0];
        let vertex = next[(vertex & 15) as usize];
        let vertex = next[(vertex & 15) as usize];
        let vertex = next[(vertex & 15) as usize];
        let vertex = next[(vertex & 15) as usize];
        let vertex = next[(vertex & 15) as usize];
        let vertex = next[(vertex & 15) as usize];
        let vertex = next[(vertex & 15) as usize];
        let vertex = next[(vertex & 15) as usize];
        ActionId(vertex.wrapping_sub(11) as u16)
    }
}

impl Asterix {
    /// Rows, columns and channels of the image; a cell's channels are beside each other.
    pub const IMAGE: [usize; 3] = [10, 10, 4];

    /// Computes the values of a state that come from an image, whose rows begin `stride` bytes apart. Returns false where the
    /// image is too short; the state is then as it was.
    pub fn look(&self, image: &[u8], stride: usize, state: &mut [f32; 29]) -> bool {
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
        let place_1 = seen.first(1);
        let place_2 = seen.last(1);
        let place_3 = seen.last(2);
        state[0] = place_0.row as f32;
        state[1] = place_1.row as f32;
        state[2] = place_2.row as f32;
        state[3] = place_2.column as f32;
        state[4] = seen.from(1, place_0, -4, -2) as f32;
        state[5] = seen.from(1, place_0, -2, -3) as f32;
        state[6] = seen.from(1, place_0, -2, 3) as f32;
        state[7] = seen.from(1, place_0, 0, -1) as f32;
        state[8] = seen.from(1, place_0, 0, 1) as f32;
        state[9] = seen.from(1, place_0, 1, -3) as f32;
        state[10] = seen.from(1, place_0, 1, -2) as f32;
        state[11] = place_3.row as f32;
        state[12] = seen.from(2, place_0, -4, -2) as f32;
        state[13] = seen.from(2, place_0, -4, 2) as f32;
        state[14] = seen.from(2, place_0, -3, 1) as f32;
        state[15] = seen.from(2, place_0, 1, -1) as f32;
        state[16] = seen.from(3, place_0, -4, 2) as f32;
        state[17] = seen.from(3, place_0, -3, 1) as f32;
        state[18] = seen.from(3, place_0, -2, -1) as f32;
        state[19] = seen.from(3, place_0, -2, 0) as f32;
        state[20] = seen.from(3, place_0, -1, -1) as f32;
        state[21] = seen.from(3, place_0, -1, 0) as f32;
        state[22] = seen.from(3, place_0, -1, 1) as f32;
        state[23] = seen.from(3, place_0, 1, -2) as f32;
        state[24] = seen.from(3, place_0, 1, 0) as f32;
        state[25] = seen.from(3, place_0, 1, 2) as f32;
        state[26] = seen.from(3, place_0, 2, 0) as f32;
        state[27] = seen.from(3, place_0, 3, -1) as f32;
        state[28] = seen.from(3, place_0, 4, -1) as f32;
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
