//! Groups of roots whose episodes run side by side.

use crate::view::BLOCK;
use crate::work::{Piece, Work};

/// Least number of groups for each thread: a thread whose groups were short takes over others'.
const OF_A_THREAD: usize = 4;
/// Most episodes of a root that others join: more fill the lanes well enough.
const FEW: usize = BLOCK;
/// Most places of a group's roots: a plan numbers teams and actions in 16 bits.
const PLACES: usize = 1 << 15;

/// Cuts pieces into groups of neighbours whose episodes fit side by side into so many lanes.
pub(super) fn side_by_side<'p, Task>(
    work: &Work<Task>,
    pieces: &'p [Piece],
    lanes: usize,
    threads: usize,
) -> Vec<&'p [Piece]> {
    let most = pieces.len().div_ceil(OF_A_THREAD * threads);
    let policy = |piece: &Piece| &work.policies[piece.policy];
    let mut groups = Vec::new();
    let mut rest = pieces;
    while let Some(first) = rest.first() {
        let (mut episodes, mut places) = (0, 0);
        let outputs = &policy(first).outputs;
        let fits = |piece: &&Piece| {
            let policy = policy(piece);
            episodes += piece.tasks.len();
            // Each edge leads to one action at most.
            places += policy.teams.iter().map(|edges| 1 + edges.len()).sum::<usize>();
            policy.outputs == *outputs && piece.tasks.len() <= FEW && episodes <= lanes && places <= PLACES
        };
        let count = rest.iter().take(most).take_while(fits).count().max(1);
        let (group, others) = rest.split_at(count);
        groups.push(group);
        rest = others;
    }
    groups
}

#[cfg(test)]
mod tests {
    use super::side_by_side;
    use crate::{Destination, Edge, Piece, PolicyGraph, Work};

    /// Returns the sizes of the groups of roots with so many edges.
    fn sizes(roots: usize, edges: usize, tasks: usize, lanes: usize, threads: usize) -> Vec<usize> {
        let edge = Edge { program: 0, to: Destination::Action(0) };
        let policy = PolicyGraph::new(1, 0, vec![vec![edge; edges]], vec![vec![]]);
        let work = Work { tasks: vec![(); tasks], policies: vec![policy; roots] };
        let pieces = Piece::cut(roots, tasks, 1);
        let groups = side_by_side(&work, &pieces, lanes, threads);
        assert_eq!(groups.concat(), pieces, "every piece is in a group, in order");
        groups.iter().map(|group| group.len()).collect()
    }

    #[test]
    fn groups_fill_the_lanes_and_leave_every_thread_some() {
        assert_eq!(sizes(100, 1, 5, 112, 1), [22, 22, 22, 22, 12]);
        assert_eq!(sizes(100, 1, 5, 112, 5), [5; 20]);
        assert_eq!(sizes(9, 1, 5, 4, 1), [1; 9], "no root fits");
        assert_eq!(sizes(3, 1, 17, 112, 1), [1; 3], "many episodes fill the lanes well enough");
        assert_eq!(sizes(8, 1, 0, 112, 1), [2; 4]);
        assert_eq!(sizes(0, 1, 5, 112, 1), [0; 0]);
        assert_eq!(sizes(9, 20_000, 5, 112, 1), [1; 9], "two of them have too many places");
        assert_eq!(sizes(9, 15_000, 5, 112, 1), [2, 2, 2, 2, 1]);
    }
}
