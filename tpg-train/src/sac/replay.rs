//! The replay buffer: the latest transitions.

use serde::{Deserialize, Serialize};
use tpg_engine::Sample;
use tpg_engine::random::Stream;
use tpg_nn::Experience;

/// A ring of transitions of `inputs` values a state and `actions` components an action.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Replay {
    inputs: usize,
    actions: usize,
    capacity: usize,
    /// Transitions ever added; the newest is at (added − 1) mod capacity.
    pub(crate) added: u64,
    /// Row by row: state, action, reward, discount, next state.
    rows: Vec<f32>,
}

impl Replay {
    /// Creates an empty buffer. It grows up to `capacity` transitions.
    ///
    /// # Panics
    /// If `capacity` is 0.
    pub(crate) fn new(inputs: usize, actions: usize, capacity: usize) -> Self {
        assert!(capacity > 0, "a buffer for nothing");
        Self { inputs, actions, capacity, added: 0, rows: Vec::new() }
    }

    fn width(&self) -> usize {
        2 * self.inputs + self.actions + 2
    }

    /// Returns the number of transitions held.
    pub(crate) fn len(&self) -> usize {
        self.rows.len() / self.width()
    }

    /// Adds a transition: the inputs before, an action, each component in −1..1, its reward, the factor of the next state's value (γ to the
    /// number of elementary steps, 0 where the episode ended), and the inputs afterwards. Replaces the oldest if the buffer is full.
    ///
    /// # Panics
    /// If a state has another number of values than the buffer's.
    pub(crate) fn push(&mut self, state: &[f32], action: &[f32], [reward, discount]: [f32; 2], next: &[f32]) {
        assert!(state.len() == self.inputs && next.len() == self.inputs, "another state");
        let row = [state, action, &[reward, discount], next].concat();
        let at = (self.added % self.capacity as u64) as usize * row.len();
        if self.rows.len() < at + row.len() {
            self.rows.resize(at + row.len(), 0.0);
        }
        self.rows[at..][..row.len()].copy_from_slice(&row);
        self.added += 1;
    }

    /// Returns mean and standard deviation of each input, in the states before.
    pub(crate) fn moments(&self) -> Vec<Sample> {
        let states = || self.rows.chunks_exact(self.width());
        let values = |input: usize| states().map(|row| f64::from(row[input])).collect::<Vec<_>>();
        (0..self.inputs).map(|input| Sample::new(&values(input))).collect()
    }

    /// Changes every state.
    pub(crate) fn map_states(&mut self, mut change: impl FnMut(&mut [f32])) {
        let (width, inputs) = (self.width(), self.inputs);
        for row in self.rows.chunks_exact_mut(width) {
            change(&mut row[..inputs]);
            change(&mut row[width - inputs..]);
        }
    }

    /// Draws a batch of that many samples without noise, every transition held equally likely, with repeats.
    ///
    /// # Panics
    /// If the buffer is empty.
    pub(crate) fn draw(&self, random: &mut Stream, size: usize) -> Experience {
        let (width, mut batch) = (self.width(), Experience::default());
        for _ in 0..size {
            let row = &self.rows[random.below(self.len()) * width..][..width];
            let (state, rest) = row.split_at(self.inputs);
            let (action, rest) = rest.split_at(self.actions);
            batch.states.extend(state);
            batch.actions.extend(action);
            batch.rewards.push(rest[0]);
            batch.discounts.push(rest[1]);
            batch.next.extend(&rest[2..]);
        }
        batch
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use tpg_engine::random::Purpose;

    fn push(buffer: &mut Replay, value: f32) {
        let (state, next) = ([value; 3], [value + 0.5; 3]);
        buffer.push(&state, &[value; 4], [value, 0.9], &next);
    }

    #[test]
    fn the_newest_transitions_stay_whole() {
        let mut buffer = Replay::new(3, 4, 10);
        (0..25).for_each(|value| push(&mut buffer, value as f32));
        let batch = buffer.draw(&mut Stream::new(1, 0, Purpose::Test, 1), 400);
        let mut seen = [0; 25];
        for (i, &reward) in batch.rewards.iter().enumerate() {
            seen[reward as usize] += 1;
            assert_eq!(batch.states[3 * i..][..3], [reward; 3]);
            assert_eq!(batch.actions[4 * i..][..4], [reward; 4]);
            assert_eq!(batch.next[3 * i..][..3], [reward + 0.5; 3]);
        }
        assert!(seen[..15].iter().all(|&count| count == 0) && seen[15..].iter().all(|&count| count > 15), "{seen:?}");
    }
}
