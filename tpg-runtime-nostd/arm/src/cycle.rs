//! Cycle detection: has the arm been here before?
//!
//! The policies are memoryless and the arm deterministic, so a position that repeats repeats for ever.

use crate::arm::Pose;
use heapless::index_set::FnvIndexSet;

/// Watches the poses of one episode.
pub trait CycleDetector {
    /// Forgets everything and starts an episode at `start`.
    fn reset(&mut self, start: Pose);
    /// Whether the episode is known to cycle once it has come to `pose`.
    fn repeats(&mut self, pose: Pose) -> bool;
}

/// The exact set of visited poses: reports the first repeat.
///
/// Costs one hash and probe a step and, for capacity `N` (a power of two above the episode's action limit), 12·`N`
/// bytes. A full set remembers no more poses: it can then miss a repeat, never invent one.
#[derive(Clone, Debug, Default)]
pub struct Visited<const N: usize> {
    poses: FnvIndexSet<u64, N>,
}

impl<const N: usize> Visited<N> {
    /// An empty set.
    pub fn new() -> Self {
        Self::default()
    }
}

impl<const N: usize> CycleDetector for Visited<N> {
    fn reset(&mut self, start: Pose) {
        self.poses.clear();
        self.repeats(start);
    }

    fn repeats(&mut self, pose: Pose) -> bool {
        matches!(self.poses.insert(pose.packed()), Ok(false))
    }
}

/// Brent's detector: compares with one earlier pose, taken anew at every power of two.
///
/// Costs one comparison a step and 16 bytes. It reports a repeat that is real, but later than [`Visited`]: for a cycle
/// of length λ entered after μ steps, at most 2·max(μ, λ) + λ steps into the episode.
#[derive(Clone, Copy, Debug)]
pub struct Brent {
    landmark: Pose,
    steps: u32,
    renew_at: u32,
}

impl Brent {
    /// A detector that must be [`reset`](CycleDetector::reset) before an episode.
    pub const fn new() -> Self {
        Self { landmark: Pose([0; 4]), steps: 0, renew_at: 1 }
    }
}

impl Default for Brent {
    fn default() -> Self {
        Self::new()
    }
}

impl CycleDetector for Brent {
    fn reset(&mut self, start: Pose) {
        *self = Self { landmark: start, ..Self::new() };
    }

    fn repeats(&mut self, pose: Pose) -> bool {
        if pose == self.landmark {
            return true;
        }
        self.steps = self.steps.saturating_add(1);
        if self.steps == self.renew_at {
            self.landmark = pose;
            self.steps = 0;
            self.renew_at = self.renew_at.saturating_mul(2);
        }
        false
    }
}

#[cfg(test)]
mod tests {
    use super::{Brent, CycleDetector, Visited};
    use crate::arm::Pose;

    /// The step at which a detector reports a walk of `tail` fresh poses followed by a cycle of `cycle` poses.
    fn reported_at(detector: &mut impl CycleDetector, tail: i16, cycle: i16) -> Option<i16> {
        let pose = |step: i16| {
            let place = if step < tail { step } else { tail + (step - tail) % cycle };
            Pose([place, 0, 0, -place])
        };
        detector.reset(pose(0));
        (1..2000).find(|&step| detector.repeats(pose(step)))
    }

    #[test]
    fn visited_reports_the_first_repeat_and_brent_no_later_than_its_bound() {
        for tail in 0..20 {
            for cycle in 1..20 {
                let first = tail + cycle;
                assert_eq!(reported_at(&mut Visited::<64>::new(), tail, cycle), Some(first));
                let brent = reported_at(&mut Brent::new(), tail, cycle).expect("the walk cycles");
                assert!(brent >= first, "tail {tail}, cycle {cycle}: reported before the repeat");
                assert!(brent <= 2 * tail.max(cycle) + cycle, "tail {tail}, cycle {cycle}: reported at {brent}");
            }
        }
    }

    #[test]
    fn a_full_set_invents_no_repeat() {
        let mut visited = Visited::<4>::new();
        visited.reset(Pose([0; 4]));
        assert!((1..100).all(|step| !visited.repeats(Pose([step; 4]))));
        assert!(visited.repeats(Pose([1; 4])));
    }
}
