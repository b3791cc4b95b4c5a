//! States to look for a difference in: in the ranges, at their ends and beyond, ties, NaN, infinities and any bits.

use crate::graph::Graph;
use crate::term::Border;

/// A stream of numbers: SplitMix64.
#[derive(Clone)]
pub(crate) struct Stream(u64);

impl Stream {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut mixed = self.0;
        mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        mixed ^ (mixed >> 31)
    }

    /// A number from 0 to 1.
    fn share(&mut self) -> f32 {
        (self.next() >> 40) as f32 / 16_777_216.0
    }

    fn below(&mut self, count: usize) -> usize {
        (self.next() % count.max(1) as u64) as usize
    }

    /// A state of a graph as bits.
    pub(crate) fn state(&mut self, graph: &Graph, inside: bool) -> Vec<u32> {
        if graph.is_whole() {
            return self.counts(graph, inside);
        }
        let special: Vec<_> = graph.constants().into_iter().map(|value| value as f32).collect();
        let mut state: Vec<f32> = Vec::new();
        for [low, high] in graph.ranges.iter().map(|range| range.map(|end| end as f32)) {
            let within = low + (high - low) * self.share();
            let value = match self.below(16) {
                0..8 => within,
                8 => [low, high][self.below(2)],
                9 => [0.0, -0.0, 1.0, -1.0][self.below(4)],
                10 if !special.is_empty() => special[self.below(special.len())] * [1.0, -1.0][self.below(2)],
                11 if !state.is_empty() => state[self.below(state.len())] * [1.0, -1.0][self.below(2)],
                12 => (self.share() - 0.5) * 4.0,
                13 => (self.share() - 0.5) * 1000.0,
                14 => [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN_POSITIVE][self.below(5)],
                _ => f32::from_bits(self.next() as u32),
            };
            state.push(if inside && !(low..=high).contains(&value) { within } else { value });
        }
        state.into_iter().map(f32::to_bits).collect()
    }

    /// Moves a state to a border or next to it, by two of its counts. It stays where it is if they cannot.
    pub(crate) fn approach(&mut self, border: &Border, graph: &Graph, inside: bool, state: &mut [u32]) {
        let count = |index: u32| i128::from(state[index as usize] as i32);
        let sum = border.plus + border.factors.iter().map(|&(index, by)| by * count(index)).sum::<i128>();
        let at = sum.checked_div_euclid(border.step).unwrap_or_default() * border.step;
        let change = at - sum + self.below(3) as i128 - 1;
        let [(i, a), (j, b)] = [0, 1].map(|_| border.factors[self.below(border.factors.len())]);
        let b = if i == j { 0 } else { b };
        // divisor = a * inverse but for a multiple of b
        let ((mut divisor, mut inverse), mut next) = ((a, 1), (b, 0));
        while next.0 != 0 {
            let times = divisor / next.0;
            ((divisor, inverse), next) = (next, (divisor - times * next.0, inverse - times * next.1));
        }
        if change % divisor != 0 {
            return;
        }
        // a * x + b * y = change, where y is small
        let (a, b, change) = (a / divisor, b / divisor, change / divisor);
        let (x, y) = match b {
            0 => (change / a, 0),
            _ => {
                let x = change % b * inverse % b;
                let x = x + (change / a - x) / b * b;
                (x, (change - a * x) / b)
            }
        };
        let moved = [(i, count(i) + x), (j, count(j) + y)];
        let fits = |&(index, value): &(u32, i128)| {
            let [low, high] = limits(graph, inside, index as usize);
            low <= value && value <= high
        };
        if moved.iter().all(fits) {
            for (index, value) in moved.into_iter().take(if b == 0 { 1 } else { 2 }) {
                state[index as usize] = value as i32 as u32;
            }
        }
    }

    /// A state of whole numbers: anywhere between the limits, near 0, and at the limits.
    fn counts(&mut self, graph: &Graph, inside: bool) -> Vec<u32> {
        let mut state: Vec<i128> = Vec::new();
        for index in 0..graph.ranges.len() {
            let [low, high] = limits(graph, inside, index);
            let value = match self.below(16) {
                0..8 => low + i128::from(self.next()) % (high - low + 1),
                8 => [low, high][self.below(2)],
                9 if !state.is_empty() => state[self.below(state.len())] * [1, -1][self.below(2)],
                10..12 => self.below(5) as i128 - 2,
                _ => (self.next() >> (48 + self.below(16))) as i128 * [1, -1][self.below(2)],
            };
            state.push(value.clamp(low, high));
        }
        state.into_iter().map(|value| value as i32 as u32).collect()
    }
}

/// The lowest and the highest count of a value: there is, or in its range.
fn limits(graph: &Graph, inside: bool, index: usize) -> [i128; 2] {
    let [low, high] = graph.interface().counts[index];
    let range = graph.ranges[index].map(|end| end as i128);
    if inside { [low.max(range[0]), high.min(range[1])] } else { [low, high] }
}
