//! Cycle detection: has this been here before?
//!
//! A memoryless policy in a deterministic world repeats for ever what it repeats once. A key identifies the state: motor
//! positions, say. Equal keys must mean equal states.
//!
//! ```
//! use tpg_runtime::cycle::{Brent, CycleDetector, Visited};
//!
//! let walk = [3, 1, 4, 2, 1, 4, 2, 1, 4, 2];
//! let first = |detector: &mut dyn CycleDetector<u8>| {
//!     detector.reset(walk[0]);
//!     (1..walk.len()).find(|&step| detector.repeats(walk[step]))
//! };
//! assert_eq!(first(&mut Visited::<u8, 16>::new()), Some(4));
//! assert_eq!(first(&mut Brent::new()), Some(6));
//! ```

use core::hash::Hash;
use heapless::index_set::FnvIndexSet;

/// A watch over the keys of one episode.
pub trait CycleDetector<K> {
    /// Forgets everything and starts an episode at `start`.
    fn reset(&mut self, start: K);
    /// Returns true if the episode is known to cycle once it has come to `key`.
    fn repeats(&mut self, key: K) -> bool;
}

/// The exact set of visited keys: reports the first repeat.
///
/// Costs one hash and probe a step and, for capacity `N` (a power of two above the episode's action limit), 12·`N`
/// bytes with keys of 8 bytes. A full set remembers no more keys: it can then miss a repeat, never invent one.
#[derive(Clone, Debug)]
pub struct Visited<K: Eq + Hash, const N: usize> {
    keys: FnvIndexSet<K, N>,
}

impl<K: Eq + Hash, const N: usize> Visited<K, N> {
    /// An empty set.
    pub fn new() -> Self {
        Self::default()
    }
}

impl<K: Eq + Hash, const N: usize> Default for Visited<K, N> {
    fn default() -> Self {
        Self { keys: FnvIndexSet::new() }
    }
}

impl<K: Eq + Hash, const N: usize> CycleDetector<K> for Visited<K, N> {
    fn reset(&mut self, start: K) {
        self.keys.clear();
        self.repeats(start);
    }

    fn repeats(&mut self, key: K) -> bool {
        matches!(self.keys.insert(key), Ok(false))
    }
}

/// Brent's detector: compares with one earlier key, taken anew at every power of two.
///
/// Costs one comparison a step and 8 bytes and a key. It reports a repeat that is real, but later than [`Visited`]: for a
/// cycle of length λ entered after μ steps, at most 2·max(μ, λ) + λ steps into the episode.
#[derive(Clone, Copy, Debug)]
pub struct Brent<K> {
    landmark: K,
    steps: u32,
    renew_at: u32,
}

impl<K: Default> Brent<K> {
    /// A detector that must be [`reset`](CycleDetector::reset) before an episode.
    pub fn new() -> Self {
        Self::at(K::default())
    }
}

impl<K> Brent<K> {
    const fn at(landmark: K) -> Self {
        Self { landmark, steps: 0, renew_at: 1 }
    }
}

impl<K: Default> Default for Brent<K> {
    fn default() -> Self {
        Self::new()
    }
}

impl<K: Copy + Eq> CycleDetector<K> for Brent<K> {
    fn reset(&mut self, start: K) {
        *self = Self::at(start);
    }

    fn repeats(&mut self, key: K) -> bool {
        if key == self.landmark {
            return true;
        }
        self.steps = self.steps.saturating_add(1);
        if self.steps == self.renew_at {
            self.landmark = key;
            self.steps = 0;
            self.renew_at = self.renew_at.saturating_mul(2);
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::{Brent, CycleDetector, Visited};

    /// The step at which a detector reports a walk of `tail` fresh keys followed by a cycle of `cycle` keys.
    fn reported_at(detector: &mut impl CycleDetector<i16>, tail: i16, cycle: i16) -> Option<i16> {
        let key = |step: i16| if step < tail { step } else { tail + (step - tail) % cycle };
        detector.reset(key(0));
        (1..2000).find(|&step| detector.repeats(key(step)))
    }

    #[test]
    fn visited_reports_the_first_repeat_and_brent_no_later_than_its_bound() {
        for tail in 0..20 {
            for cycle in 1..20 {
                let first = tail + cycle;
                assert_eq!(reported_at(&mut Visited::<i16, 64>::new(), tail, cycle), Some(first));
                let brent = reported_at(&mut Brent::new(), tail, cycle).expect("the walk cycles");
                assert!(brent >= first, "tail {tail}, cycle {cycle}: reported before the repeat");
                assert!(brent <= 2 * tail.max(cycle) + cycle, "tail {tail}, cycle {cycle}: reported at {brent}");
            }
        }
    }

    #[test]
    fn a_full_set_invents_no_repeat() {
        let mut visited = Visited::<i16, 4>::new();
        visited.reset(0);
        assert!((1..100).all(|step| !visited.repeats(step)));
        assert!(visited.repeats(1));
    }
}
