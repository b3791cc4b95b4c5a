//! A policy for space-invaders, score 66.88 in validation, trained by tpg-train 0.1.0 with seed 4.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix space_invaders --profile constant-time
//! Graph SHA-256: 2a7b9c8d4594307dd8bf2ad54345a496599b5de7ca0dfd4ea2d75fa06ffc0f6d
//! 5 teams (5 on the longest walk), 25 edges, 25 programs, 18 distinct operations.
//! A decision takes at most 25 bids and 18 operations.
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
/// - `s[0..2]`: cannon_at, -1 to 9
/// - `s[2..4]`: alien_at, -1 to 9
/// - `s[4..5]`: alien_near, 0 to 1
/// - `s[5..8]`: alien_left_near, 0 to 1
/// - `s[8..10]`: alien_right_at, -1 to 9
/// - `s[10..11]`: own_bullet_near, 0 to 1
/// - `s[11..13]`: bullet_at, -1 to 9
/// - `s[13..18]`: bullet_near, 0 to 1
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
    pub const STATE: usize = 18;
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
    type State = [f32; 18];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 18]) -> ActionId {
        let ct = ConstantTime::<f32>::default();

        // What is bid, as integers in the same order.
        let bid_2 = ct.order(s[17] * s[11]);
        let bid_1 = ct.order(ct.max(-0.009387939_f32, s[2]));
        let bid_3 = ct.order(s[11] * s[14]);
        let bid_4 = ct.order(ct.max(-0.025351083_f32, s[2]));
        let bid_11 = ct.order(ct.max(0.005276723_f32, s[3]));
        let bid_12 = ct.order(ct.min(s[1], s[13]));
        let bid_13 = ct.order(s[15] * s[0]);
        let bid_16 = ct.order(s[16] * s[12]);
        let bid_17 = ct.order(ct.min(s[1], s[8]));
        let bid_18 = ct.order(s[1] * s[15]);
        let bid_6 = ct.order(ct.max(-0.011006754_f32, s[2]));
        let bid_7 = ct.order(ct.min(s[12], s[8]));
        let bid_30 = -8388607_i32; // 0.0_f32
        let bid_10 = ct.order(ct.min(0.0_f32, s[10]));
        let bid_27 = ct.order(s[9] + s[7]);
        let bid_28 = ct.order(ct.negate_if_less(s[6], s[5]));
        let bid_29 = ct.order(s[15] * s[12]);
        let bid_21 = ct.order(ct.min(s[4], s[3]));
        let bid_22 = ct.order(ct.max(0.006655848_f32, s[3]));

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
        // Team 0
        let best = (bid_1, 1);
        let best = ct.challenge(best, (bid_2, 6));
        let best = ct.challenge(best, (bid_3, 6));
        let best = ct.challenge(best, (bid_4, 2));
        let t0 = best.1 as u8;
        // Team 2
        let best = (bid_11, 3);
        let best = ct.challenge(best, (bid_12, 7));
        let best = ct.challenge(best, (bid_13, 6));
        let best = ct.challenge(best, (bid_3, 6));
        let best = ct.challenge(best, (bid_16, 6));
        let best = ct.challenge(best, (bid_17, 4));
        let best = ct.challenge(best, (bid_18, 6));
        let t1 = best.1 as u8;
        // Team 1
        let best = (bid_6, 1);
        let best = ct.challenge(best, (bid_7, 4));
        let best = ct.challenge(best, (bid_2, 6));
        let best = ct.challenge(best, (bid_10, 4));
        let t2 = best.1 as u8;
        // Team 4
        let best = (bid_27, 8);
        let best = ct.challenge(best, (bid_28, 8));
        let best = ct.challenge(best, (bid_29, 6));
        let best = ct.challenge(best, (bid_30, 8));
        let t3 = best.1 as u8;
        // Team 3
        let best = (bid_17, 7);
        let best = ct.challenge(best, (bid_21, 8));
        let best = ct.challenge(best, (bid_22, 3));
        let best = ct.challenge(best, (bid_12, 7));
        let best = ct.challenge(best, (bid_29, 6));
        let best = ct.challenge(best, (bid_3, 6));
        let t4 = best.1 as u8;

        // An action leads to itself, and so does what fills the array up to a power of two: it is never come to.
        let next: [u8; 16] = [t0, t1, t2, t3, t4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15];
        // The longest walk decides 5 times; a shorter one waits at its action. No loop, and no end to check.
        let vertex = next[0];
        let vertex = next[(vertex & 15) as usize];
        let vertex = next[(vertex & 15) as usize];
        let vertex = next[(vertex & 15) as usize];
        let vertex = next[(vertex & 15) as usize];
        ActionId(vertex.wrapping_sub(5) as u16)
    }
}

impl SpaceInvaders {
    /// Rows, columns and channels of the image; a cell's channels are beside each other.
    pub const IMAGE: [usize; 3] = [10, 10, 6];

    /// Computes the values of a state that come from an image, whose rows begin `stride` bytes apart. Returns false where the
    /// image is too short; the state is then as it was.
    pub fn look(&self, image: &[u8], stride: usize, state: &mut [f32; 18]) -> bool {
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
        let place_3 = seen.first(3);
        let place_4 = seen.last(3);
        let place_5 = seen.first(5);
        let place_6 = seen.last(5);
        state[0] = place_0.column as f32;
        state[1] = place_1.row as f32;
        state[2] = place_2.row as f32;
        state[3] = place_2.column as f32;
        state[4] = seen.from(1, place_0, -1, -2) as f32;
        state[5] = seen.from(2, place_0, -2, 1) as f32;
        state[6] = seen.from(2, place_0, -1, 3) as f32;
        state[7] = seen.from(2, place_0, 4, -4) as f32;
        state[8] = place_3.row as f32;
        state[9] = place_4.column as f32;
        state[10] = seen.from(4, place_0, -4, 0) as f32;
        state[11] = place_5.column as f32;
        state[12] = place_6.row as f32;
        state[13] = seen.from(5, place_0, -4, 0) as f32;
        state[14] = seen.from(5, place_0, -3, 0) as f32;
        state[15] = seen.from(5, place_0, -2, 0) as f32;
        state[16] = seen.from(5, place_0, -2, 1) as f32;
        state[17] = seen.from(5, place_0, -1, 0) as f32;
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
