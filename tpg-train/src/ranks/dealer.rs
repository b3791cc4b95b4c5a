//! The order and the size of what is handed out to ranks.

/// Hands out jobs, the most expensive first, in shares that become smaller towards the end, so that ranks of any speed are
/// done at about the same time.
#[derive(Clone, Debug)]
pub(crate) struct Dealer {
    /// The jobs that are left with their costs; the most expensive is the last.
    left: Vec<(usize, u64)>,
    /// Sum of the costs that are left.
    cost: u64,
    /// Number of threads of all ranks.
    threads: u64,
}

impl Dealer {
    /// Fraction of a fair share of what is left that is handed out at once, as its inverse.
    const PARTS: u64 = 2;

    /// Prepares jobs of the given expected costs, in any unit, for `threads` threads in all. A cost of 0 counts as 1.
    pub(crate) fn new(costs: &[u64], threads: usize) -> Self {
        let mut left: Vec<(usize, u64)> = costs.iter().map(|&cost| cost.max(1)).enumerate().collect();
        // Stable: equal jobs are handed out in their order.
        left.reverse();
        left.sort_by_key(|&(_, cost)| cost);
        let cost = left.iter().map(|&(_, cost)| cost).sum();
        Self { left, cost, threads: threads.max(1) as u64 }
    }

    /// Returns the next share for a rank of `threads` threads: at least a job for each thread; empty if none is left.
    pub(crate) fn deal(&mut self, threads: usize) -> Vec<usize> {
        let fair = self.cost / (Self::PARTS * self.threads) * threads as u64;
        let (mut share, mut cost) = (Vec::new(), 0);
        while let Some(&(job, next)) = self.left.last()
            && (share.len() < threads.max(1) || cost + next <= fair)
        {
            share.push(job);
            cost += next;
            self.left.pop();
        }
        self.cost -= cost;
        share
    }
}

/// Pieces for each thread: with fewer, threads wait at the end of a question; with more, rank 0 is busy with messages.
const PIECES: usize = 8;

/// Returns the number of pieces into which each unit's tasks are cut: where there are few units, several for each of all
/// `threads`, so that there is something to do for all of them until the end of a question.
pub(crate) fn parts(units: usize, threads: usize) -> usize {
    (PIECES * threads).div_ceil(units.max(1)).max(1)
}

#[cfg(test)]
mod tests {
    use super::Dealer;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn every_job_is_dealt_once_and_shares_do_not_grow(
            costs in proptest::collection::vec(0_u64..1000, 0..200),
            threads in 1_usize..9,
        ) {
            let mut dealer = Dealer::new(&costs, threads);
            let mut dealt = Vec::new();
            let mut last = u64::MAX;
            loop {
                let share = dealer.deal(1);
                if share.is_empty() {
                    break;
                }
                let cost: u64 = share.iter().map(|&job| costs[job].max(1)).sum();
                // A share is a single job, or within half of a fair part of what was left.
                let left: u64 = costs.iter().map(|&cost| cost.max(1)).sum::<u64>()
                    - dealt.iter().map(|&job: &usize| costs[job].max(1)).sum::<u64>();
                prop_assert!(share.len() == 1 || cost <= left / (2 * threads as u64));
                prop_assert!(share.len() > 1 || cost <= last, "the most expensive comes first");
                if share.len() == 1 {
                    last = cost;
                }
                dealt.extend(share);
            }
            dealt.sort_unstable();
            prop_assert_eq!(dealt, (0..costs.len()).collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_rank_with_more_threads_gets_more() {
        let mut dealer = Dealer::new(&[1; 64], 8);
        assert_eq!((dealer.deal(4).len(), dealer.deal(1).len()), (16, 3));
    }
}
