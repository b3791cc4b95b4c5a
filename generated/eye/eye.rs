//! A policy for eye, score 83.64 in validation, trained by tpg-train 0.1.0 with seed 1.
//! Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
//! Options: --lang rust --prefix eye --profile constant-time
//! Graph SHA-256: 341c772999931a4009a4dfc71578afe431a9c97694bd8bc3198e804daaa27ff4
//! 1 team, 2 edges, 2 programs, 10 distinct operations.
//! A decision takes at most 2 bids and 10 operations.
//! Computes in f32 with own maths.
#![forbid(unsafe_code)]
#![allow(
    clippy::all,
    unused_variables,
    unused_assignments,
    reason = "evolved expressions need not make sense"
)]

use tpg_runtime::ops::constant_time::ConstantTime;
use tpg_runtime::policy::Policy;

/// A tangled program graph: branch-free, the same time for every state.
///
/// It sees, one after another:
/// - `s[0..3]`: image_bright, 0 to 23; 0 to 31; 0 to 2295
/// - `s[3..6]`: image_dark, 0 to 23; 0 to 31; 0 to 2295
///
/// Values outside the ranges are legal, NaN and infinities too. It answers:
/// - `[0]`: tilt, pixels, -2 to 2; 0 for NaN
/// - `[1]`: pan, pixels, -2 to 2; 0 for NaN
#[derive(Clone, Copy, Debug, Default)]
pub struct Eye;

impl Eye {
    /// Values of a state.
    pub const STATE: usize = 6;
    /// Outputs.
    pub const OUTPUTS: usize = 2;
    /// Teams on the longest walk.
    pub const DEPTH: usize = 1;
}

impl Policy for Eye {
    type State = [f32; 6];
    type Action = [f32; 2];

    fn decide(&self, s: &[f32; 6]) -> [f32; 2] {
        let ct = ConstantTime::<f32>::default();

        // What is bid, as integers in the same order.
        let bid_0 = ct.order(f32::abs(s[2]));
        let bid_1 = ct.order(f32::abs(s[5]));

        // Where the team leads: the number behind the best bid.
        // Team 0
        let best = (bid_0, 0);
        let best = ct.challenge(best, (bid_1, 1));

        let leaf = best.1;
        // Every leaf's values, and the choice among them.
        let tilt = 1.1559905_f32 * s[0] - 13.0104475_f32;
        let pan = 1.4439558_f32 * s[1] - 22.61637_f32;
        let tilt = ct.if_equal(leaf, 1, 1.2042711_f32 * s[3] - 13.660074_f32, tilt);
        let pan = ct.if_equal(leaf, 1, 1.4263186_f32 * s[4] - 22.020496_f32, pan);
        [
            ct.clamp(tilt, -2.0_f32, 2.0_f32, 0.0_f32),
            ct.clamp(pan, -2.0_f32, 2.0_f32, 0.0_f32),
        ]
    }
}

impl Eye {
    /// Rows, columns and channels of the image; a cell's channels are beside each other.
    pub const IMAGE: [usize; 3] = [24, 32, 1];

    /// Computes the values of a state that come from an image, whose rows begin `stride` bytes apart. Returns false where the
    /// image is too short; the state is then as it was.
    pub fn look(&self, image: &[u8], stride: usize, state: &mut [f32; 6]) -> bool {
        let before = stride.checked_mul(23);
        let needed = before.and_then(|bytes| bytes.checked_add(32));
        if stride < 32 || needed.is_none_or(|needed| image.len() < needed) {
            return false;
        }
        let seen = image::Image {
            bytes: image,
            stride,
        };
        let windows_0 = seen.windows::<3>(0);
        state[0] = windows_0.bright.row as f32;
        state[1] = windows_0.bright.column as f32;
        state[2] = windows_0.bright.contrast as f32;
        state[3] = windows_0.dark.row as f32;
        state[4] = windows_0.dark.column as f32;
        state[5] = windows_0.dark.contrast as f32;
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

    /// The brightest window, and the darkest.
    #[allow(dead_code)]
    pub(super) struct Windows {
        pub(super) bright: Place,
        pub(super) dark: Place,
    }

    /// An image that is long enough.
    #[derive(Clone, Copy)]
    pub(super) struct Image<'a> {
        pub(super) bytes: &'a [u8],
        pub(super) stride: usize,
    }

    impl Image<'_> {
        fn cell(self, channel: usize, row: usize, column: usize) -> u32 {
            let place = row * self.stride + column * 1 + channel;
            self.bytes.get(place).map_or(0, |&byte| u32::from(byte))
        }

        /// The windows of `SIZE` by `SIZE` cells with the greatest and with the smallest sum; the first of equal ones.
        pub(super) fn windows<const SIZE: usize>(self, channel: usize) -> Windows {
            let (down, across) = (25 - SIZE, 33 - SIZE);
            let (mut high, mut low, mut total) = (-1, i32::MAX, 0);
            // Windows that follow, below the sum: one comparison finds the first of equal ones.
            let mut left = (down * across) as i32;
            for row in 0..down {
                let mut columns = [0; SIZE];
                for column in 0..32 {
                    let top = self.cell(channel, row, column);
                    let mut newest = top;
                    for below in row + 1..row + SIZE {
                        newest += self.cell(channel, below, column);
                    }
                    total += top;
                    columns.rotate_left(1);
                    if let Some(last) = columns.last_mut() {
                        *last = newest;
                    }
                    if column + 1 >= SIZE {
                        let sum = columns.iter().sum::<u32>() as i32 * 65536;
                        left -= 1;
                        high = high.max(sum + left);
                        low = low.min(sum - left);
                    }
                }
            }
            for row in down..24 {
                for column in 0..32 {
                    total += self.cell(channel, row, column);
                }
            }
            let mean = (total * (SIZE * SIZE) as u32 / 768) as i32;
            let middle = |left: i32, contrast: i32| {
                let number = (down * across) as i32 - 1 - left;
                Place {
                    row: number / across as i32 + (SIZE / 2) as i32,
                    column: number % across as i32 + (SIZE / 2) as i32,
                    contrast,
                }
            };
            let lowest = (low + 65535) / 65536;
            Windows {
                bright: middle(high % 65536, high / 65536 - mean),
                dark: middle(lowest * 65536 - low, mean - lowest),
            }
        }
    }
}
