//! The loop that fills up a population with children.

use super::genome::{Destination, Genome, TeamId};
use super::stage::Moment;
use std::collections::BTreeMap;
use tpg_engine::random::{Purpose, Stream};

/// Adds children, which `child` makes of a root, until there are `wanted` roots (`TPGMutator::populateTPG`). If an edge of a
/// child leads to a root, that team is no longer a root, so roots are counted again after every child.
pub(super) fn add_children(
    genome: &mut Genome,
    wanted: usize,
    moment: Moment,
    mut child: impl FnMut(&mut Genome, TeamId, &mut Stream) -> TeamId,
) {
    let roots = genome.roots();
    let mut is_root: BTreeMap<TeamId, bool> = roots.iter().map(|&root| (root, true)).collect();
    let mut count = roots.len();
    for number in 0.. {
        if count >= wanted {
            break;
        }
        let mut stream = moment.stream(Purpose::Child, number);
        let parent = *stream.pick(&roots);
        let child = child(genome, parent, &mut stream);
        count += 1;
        for edge in genome.team(child) {
            if let Destination::Team(to) = edge.to
                && std::mem::replace(is_root.entry(to).or_insert(false), false)
            {
                count -= 1;
            }
        }
    }
}
