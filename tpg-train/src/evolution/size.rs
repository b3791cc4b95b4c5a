//! The size of a policy.

use std::collections::BTreeSet;
use tpg_engine::Policy;
use tpg_graph::dataflow::effective;

/// Returns the number of lines with an effect; a bid without a rival has none.
pub fn lines(policy: &Policy) -> usize {
    let has_rivals = !matches!(&policy.teams[..], [team] if team.len() == 1);
    let bids = policy.teams.iter().flatten().map(|edge| edge.program).filter(|_| has_rivals);
    let programs: BTreeSet<u32> = bids.chain(policy.leaves.iter().flatten().copied()).collect();
    let count = |&program: &u32| {
        let effective = effective(policy.registers.into(), &policy.programs[program as usize]);
        effective.into_iter().filter(|&effective| effective).count()
    };
    programs.iter().map(count).sum()
}
