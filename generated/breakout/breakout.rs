//! A policy for breakout, score 62.03 in validation, trained by tpg-train 0.1.0 with seed 1.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix breakout --profile constant-time
//! Graph SHA-256: 07cacc72ff4d8168b411fe5271192326d495f22fd6bbc61534f2b1b6fe3ba596
//! 5 teams (5 on the longest walk), 14 edges, 14 programs, 8 distinct operations.
//! A decision takes at most 14 bids and 8 operations.
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
/// - `s[0..3]`: paddle_at, -1 to 9
/// - `s[3..5]`: ball_at, -1 to 9
/// - `s[5..6]`: ball_near, 0 to 1
/// - `s[6..8]`: trail_at, -1 to 9
/// - `s[8..9]`: trail_near, 0 to 1
/// - `s[9..10]`: brick_near, 0 to 1
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - 0: stay
/// - 1: left
/// - 2: right
#[derive(Clone, Copy, Debug, Default)]
pub struct Breakout;

impl Breakout {
    /// Values of a state.
    pub const STATE: usize = 10;
    /// Actions.
    pub const ACTIONS: usize = 3;
    /// An action.
    pub const STAY: ActionId = ActionId(0);
    /// An action.
    pub const LEFT: ActionId = ActionId(1);
    /// An action.
    pub const RIGHT: ActionId = ActionId(2);
    /// Teams on the longest walk.
    pub const DEPTH: usize = 5;
}

impl Policy for Breakout {
    type State = [f32; 10];
    type Action = ActionId;

    fn decide(&self, s: &[f32; 10]) -> ActionId {
        let ct = ConstantTime::<f32>::default();

        // What is bid, as integers in the same order.
        let bid_3 = -8388607_i32; // 0.0_f32
        let bid_2 = ct.order(ct.negate_if_less(s[7], s[0]));
        let bid_20 = ct.order(s[4] - s[1]);
        let bid_21 = ct.order(ct.negate_if_less(s[3], s[6]));
        let bid_4 = ct.order(s[7] + s[9]);
        let bid_31 = ct.order(ct.negate_if_less(s[4], s[1]));
        let bid_29 = ct.order(ct.max(s[6], s[2]));
        let bid_14 = ct.order(s[5] / s[8]);
        let bid_15 = ct.order(ct.negate_if_less(s[7], s[1]));

        // Where each team leads: teams are numbered from 0, the root, and the actions follow them.
        // Team 0
        let best = (bid_2, 1);
        let best = ct.challenge(best, (bid_3, 2));
        let t0 = best.1 as u8;
        // Team 3
        let best = (bid_20, 7);
        let best = ct.challenge(best, (bid_21, 3));
        let best = ct.challenge(best, (bid_3, 6));
        let t1 = best.1 as u8;
        // Team 1
        let best = (bid_4, 4);
        let best = ct.challenge(best, (bid_3, 5));
        let best = ct.challenge(best, (bid_20, 7));
        let t2 = best.1 as u8;
        // Team 4
        let best = (bid_29, 6);
        let best = ct.challenge(best, (bid_3, 6));
        let best = ct.challenge(best, (bid_31, 7));
        let t3 = best.1 as u8;
        // Team 2
        let best = (bid_14, 5);
        let best = ct.challenge(best, (bid_3, 3));
        let best = ct.challenge(best, (bid_15, 1));
        let t4 = best.1 as u8;

        // An action leads to itself, and so does what fills the array up to a power of two: it is never come to.
        let next: [u8; 8] = [t0, t1, t2, t3, t4, 5, 6, 7];
        // The longest walk decides 5 times; a shorter one waits at its action. No loop, and no end to check.
        let vertex = next[0];
        let vertex = next[(vertex & 7) as usize];
        let vertex = next[(vertex & 7) as usize];
        let vertex = next[(vertex & 7) as usize];
        let vertex = next[(vertex & 7) as usize];
        ActionId(vertex.wrapping_sub(5) as u16)
    }
}

impl Breakout {
    /// Rows, columns and channels of the image; a cell's channels are beside each other.
    pub const IMAGE: [usize; 3] = [10, 10, 4];

    /// Computes the values of a state that come from an image, whose rows begin `stride` bytes apart. Returns false where the
    /// image is too short; the state is then as it was.
    pub fn look(&self, image: &[u8], stride: usize, state: &mut [f32; 10]) -> bool {
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
        let place_2 = seen.last(1);
        let place_3 = seen.first(2);
        let place_4 = seen.last(2);
        state[0] = place_0.row as f32;
        state[1] = place_0.column as f32;
        state[2] = place_1.column as f32;
        state[3] = place_2.row as f32;
        state[4] = place_2.column as f32;
        state[5] = seen.from(1, place_0, -1, 0) as f32;
        state[6] = place_3.column as f32;
        state[7] = place_4.column as f32;
        state[8] = seen.from(2, place_0, 0, 2) as f32;
        state[9] = seen.from(3, place_0, -2, 3) as f32;
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
