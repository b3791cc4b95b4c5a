//! A policy for space-invaders, score 80.39 in validation, trained by tpg-train 0.1.0 with seed 1.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix space_invaders --profile constant-time
//! Graph SHA-256: aa7897b6b178fc99ebd8050d3e58d064855680089d016b30128b58cad8a6e11a
//! 6 teams (5 on the longest walk), 33 edges, 33 programs, 23 distinct operations.
//! A decision takes at most 33 bids and 23 operations.
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
/// - `s[0..4]`: cannon_at, -1 to 9
/// - `s[4..7]`: alien_at, -1 to 9
/// - `s[7..8]`: alien_left_at, -1 to 9
/// - `s[8..9]`: alien_left_near, 0 to 1
/// - `s[9..10]`: alien_right_near, 0 to 1
/// - `s[10..12]`: own_bullet_at, -1 to 9
/// - `s[12..13]`: own_bullet_near, 0 to 1
/// - `s[13..17]`: bullet_at, -1 to 9
/// - `s[17..20]`: bullet_near, 0 to 1
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - 0: stay
/// - 1: left
/// - 2: right
/// - 3: fire
#[derive(Clone, Copy, Debug, Default)]
pub struct SpaceInvaders;

impl SpaceInvaders {
    /// Values of a state.
    pub const STATE: usize = 20;
    /// Actions.
    pub const ACTIONS: usize = 4;
    /// An action.
    pub const STAY: ActionId = ActionId(0);
    /// An action.
    pub const LEFT: ActionId = ActionId(1);
    /// An action.
    pub const RIGHT: ActionId = ActionId(2);
    /// An action.
    pub const FIRE: ActionId = ActionId(3);
    /// Teams on the longest walk.
    pub const DEPTH: usize = 5;
}

impl Policy for SpaceInvaders {
    type State = [f32; 20];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 20]) -> ActionId {
        let ct = ConstantTime::<f32>::default();

        // What is bid, as integers in the same order.
        let bid_0 = ct.order(s[5] + s[6]);
        let bid_1 = ct.order(s[8] - 0.013731253_f32);
        let bid_2 = ct.order(s[3] + s[0]);
        let bid_4 = -8388607_i32; // 0.0_f32
        let bid_18 = ct.order(s[5] + s[4]);
        let bid_20 = ct.order(ct.negate_if_less(s[3], s[2]));
        let bid_22 = ct.order(s[1] + s[14]);
        let bid_5 = ct.order(s[4] + s[2]);
        let bid_6 = ct.order(s[7] + s[11]);
        let bid_10 = ct.order(ct.max(s[13], s[7]));
        let bid_12 = ct.order(0.0_f32 * s[9]);
        let bid_23 = ct.order(s[0] + s[14]);
        let bid_24 = ct.order(s[2] + s[1]);
        let bid_26 = ct.order(ct.negate_if_less(s[19], s[12]));
        let bid_27 = ct.order(ct.max(s[18], s[5]));
        let bid_28 = ct.order(s[1] + s[15]);
        let bid_15 = ct.order(s[3] + s[10]);
        let bid_29 = ct.order(ct.max(s[17], s[5]));
        let bid_30 = ct.order(s[0] * s[16]);
        let bid_31 = ct.order(s[3] * s[15]);
        let bid_32 = ct.order(s[3] + s[15]);
        let bid_33 = ct.order(s[4] - s[16]);
        let bid_34 = ct.order(s[13] / 0.16811664_f32);
        let bid_36 = ct.order(s[3] * s[13]);

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
        // Team 0
        let best = (bid_0, 1);
        let best = ct.challenge(best, (bid_1, 7));
        let best = ct.challenge(best, (bid_2, 2));
        let best = ct.challenge(best, (bid_4, 8));
        let t0 = best.1 as u8;
        // Team 3
        let best = (bid_18, 7);
        let best = ct.challenge(best, (bid_4, 6));
        let best = ct.challenge(best, (bid_20, 3));
        let best = ct.challenge(best, (bid_2, 3));
        let best = ct.challenge(best, (bid_22, 7));
        let t1 = best.1 as u8;
        // Team 1
        let best = (bid_5, 4);
        let best = ct.challenge(best, (bid_6, 7));
        let best = ct.challenge(best, (bid_4, 8));
        let best = ct.challenge(best, (bid_10, 9));
        let best = ct.challenge(best, (bid_18, 7));
        let best = ct.challenge(best, (bid_12, 3));
        let t2 = best.1 as u8;
        // Team 4
        let best = (bid_23, 9);
        let best = ct.challenge(best, (bid_24, 5));
        let best = ct.challenge(best, (bid_2, 5));
        let best = ct.challenge(best, (bid_26, 9));
        let best = ct.challenge(best, (bid_27, 9));
        let best = ct.challenge(best, (bid_28, 7));
        let t3 = best.1 as u8;
        // Team 2
        let best = (bid_18, 7);
        let best = ct.challenge(best, (bid_15, 3));
        let best = ct.challenge(best, (bid_4, 9));
        let best = ct.challenge(best, (bid_2, 3));
        let t4 = best.1 as u8;
        // Team 5
        let best = (bid_29, 9);
        let best = ct.challenge(best, (bid_30, 8));
        let best = ct.challenge(best, (bid_31, 9));
        let best = ct.challenge(best, (bid_32, 7));
        let best = ct.challenge(best, (bid_33, 9));
        let best = ct.challenge(best, (bid_34, 8));
        let best = ct.challenge(best, (bid_28, 7));
        let best = ct.challenge(best, (bid_36, 9));
        let t5 = best.1 as u8;

        // An action leads to itself, and so does what fills the array up to a power of two: it is never come to.
        let next: [u8; 16] = [t0, t1, t2, t3, t4, t5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15];
        // The longest walk decides 5 times; a shorter one waits at its action. No loop, and no end to check.
        let vertex = next[0];
        let vertex = next[(vertex & 15) as usize];
        let vertex = next[(vertex & 15) as usize];
        let vertex = next[(vertex & 15) as usize];
        let vertex = next[(vertex & 15) as usize];
        ActionId(vertex.wrapping_sub(6) as u16)
    }
}

impl SpaceInvaders {
    /// Rows, columns and channels of the image; a cell's channels are beside each other.
    pub const IMAGE: [usize; 3] = [10, 10, 6];

    /// Computes the values of a state that come from an image, whose rows begin `stride` bytes apart. Returns false where the
    /// image is too short; the state is then as it was.
    pub fn look(&self, image: &[u8], stride: usize, state: &mut [f32; 20]) -> bool {
        let before = stride.checked_mul(9);
        let needed = before.and_then(|bytes| bytes.checked_add(60));
        if stride < 60 || needed.is_none_or(|needed| image.len() < needed) {
            return false;
        }
        let seen = image::Image {
            bytes: image,
            stride,
        };
        let place_0 = seen.first(0);
        let place_1 = seen.last(0);
        let place_2 = seen.first(1);
        let place_3 = seen.last(1);
        let place_4 = seen.first(2);
        let place_5 = seen.first(4);
        let place_6 = seen.first(5);
        let place_7 = seen.last(5);
        state[0] = place_0.row as f32;
        state[1] = place_0.column as f32;
        state[2] = place_1.row as f32;
        state[3] = place_1.column as f32;
        state[4] = place_2.row as f32;
        state[5] = place_2.column as f32;
        state[6] = place_3.row as f32;
        state[7] = place_4.column as f32;
        state[8] = seen.from(2, place_0, 0, -1) as f32;
        state[9] = seen.from(3, place_0, 2, -4) as f32;
        state[10] = place_5.row as f32;
        state[11] = place_5.column as f32;
        state[12] = seen.from(4, place_0, 0, -1) as f32;
        state[13] = place_6.row as f32;
        state[14] = place_6.column as f32;
        state[15] = place_7.row as f32;
        state[16] = place_7.column as f32;
        state[17] = seen.from(5, place_0, -2, 2) as f32;
        state[18] = seen.from(5, place_0, -1, -4) as f32;
        state[19] = seen.from(5, place_0, 4, 0) as f32;
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
            let place = row * self.stride + column * 6 + channel;
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
