//! Cheap and exact detection of cycles.
//!
//! A memoryless policy that returns to an earlier state repeats forever. An episode ends at its *first* repeat; finding
//! that directly needs a set of all visited keys, at the cost of a hash and a probe per step. Instead every key is
//! recorded and each new one is compared with two old ones. Only when that reveals a cycle (or at the very end of an
//! episode) is the list searched for the first repeat. The result is the same as with a set.

/// All keys of one episode, in order.
#[derive(Clone, Debug, Default)]
pub(super) struct History {
    keys: Vec<u64>,
    snapshot: u64,
    renew_at: usize,
}

/// The first return of an episode to an earlier key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Repeat {
    /// Number of the action that led back.
    pub(super) actions: u32,
    /// The repeated key.
    pub(super) key: u64,
}

impl History {
    /// Clears the history and begins at `start`.
    pub(super) fn reset(&mut self, start: u64) {
        self.keys.clear();
        self.keys.push(start);
        self.snapshot = start;
        self.renew_at = 16;
    }

    /// Adds the key after an action, without looking for a cycle.
    #[inline]
    pub(super) fn push(&mut self, key: u64) {
        self.keys.push(key);
    }

    /// Adds the key after an action; returns the first repeat of the episode if a cycle has been detected.
    ///
    /// A cycle of two is detected at once, any other one some rounds after it begins.
    #[inline]
    pub(super) fn push_and_look(&mut self, key: u64) -> Option<Repeat> {
        let new = self.keys.len();
        let back_and_forth = new >= 2 && self.keys[new - 2] == key;
        let seen = back_and_forth || self.snapshot == key;
        self.keys.push(key);
        if seen {
            return Some(self.first_repeat_of_cycle());
        }
        if new == self.renew_at {
            self.snapshot = key;
            // Often at first because most cycles are short; later at growing distances, so that every cycle is found.
            self.renew_at += (new / 4).max(16);
        }
        None
    }

    /// Searches the whole episode for its first repeat.
    pub(super) fn first_repeat(&self) -> Option<Repeat> {
        let mut order: Vec<usize> = (0..self.keys.len()).collect();
        order.sort_unstable_by_key(|&place| (self.keys[place], place));
        let repeats = order.windows(2).filter(|pair| self.keys[pair[0]] == self.keys[pair[1]]).map(|pair| pair[1]);
        repeats.min().map(|place| Repeat { actions: place as u32, key: self.keys[place] })
    }

    /// Finds the first repeat when the newest key is a repeat: given the cycle's length, it begins where keys start to
    /// repeat.
    fn first_repeat_of_cycle(&self) -> Repeat {
        let (last, before) = self.keys.split_last().expect("a key was just added");
        let length = 1 + before.iter().rev().position(|key| key == last).expect("the key was there before");
        let begin = (0..).find(|&begin| self.keys[begin] == self.keys[begin + length]).expect("it repeats at the end");
        Repeat { actions: (begin + length) as u32, key: self.keys[begin] }
    }
}

#[cfg(test)]
mod tests {
    use super::{History, Repeat};

    /// Returns a walk of `tail` fresh keys into a cycle of `length`.
    fn walk(tail: u64, length: u64) -> impl Fn(u64) -> u64 {
        move |step| if step < tail { 1_000_000 + step } else { (step - tail) % length }
    }

    #[test]
    fn the_first_repeat_is_found_whenever_the_cycle_is_noticed() {
        for tail in 0..60 {
            for length in 1..60 {
                let key = walk(tail, length);
                let mut history = History::default();
                history.reset(key(0));
                let found = (1..2000).find_map(|step| history.push_and_look(key(step)));
                let first = Repeat { actions: (tail + length) as u32, key: key(tail) };
                assert_eq!(found, Some(first), "tail {tail}, cycle {length}");
                assert_eq!(history.first_repeat(), Some(first), "tail {tail}, cycle {length}, searched");
            }
        }
    }

    #[test]
    fn a_walk_without_repeat_has_none() {
        let mut history = History::default();
        history.reset(0);
        assert!((1..5000).all(|key| history.push_and_look(key).is_none()));
        assert_eq!(history.first_repeat(), None);
    }

    #[test]
    fn a_long_cycle_is_noticed_soon_enough() {
        let key = walk(300, 500);
        let mut history = History::default();
        history.reset(key(0));
        let noticed = (1..).find(|&step| history.push_and_look(key(step)).is_some()).expect("an endless search");
        assert!(noticed < 3000, "noticed at step {noticed}");
    }
}
