//! The two analyses that every consumer of a graph needs: liveness of a program's lines, and a depth-first order of
//! teams.

/// A line of a program, as seen by the liveness analysis.
pub trait Assignment {
    /// Returns the register that the line writes.
    fn writes(&self) -> usize;
    /// Returns the registers that the line reads.
    fn reads(&self) -> impl Iterator<Item = usize>;
}

/// Finds the lines that can change register 0 by backward liveness analysis.
///
/// ```
/// use tpg_graph::dataflow::{Assignment, effective};
///
/// /// The written register and the two registers that are read.
/// struct Line(usize, [usize; 2]);
///
/// impl Assignment for Line {
///     fn writes(&self) -> usize {
///         self.0
///     }
///     fn reads(&self) -> impl Iterator<Item = usize> {
///         self.1.into_iter()
///     }
/// }
///
/// // The second line is overwritten before anything reads it.
/// let lines = [Line(1, [0, 0]), Line(0, [2, 2]), Line(0, [1, 1])];
/// assert_eq!(effective(3, &lines), [true, false, true]);
/// ```
///
/// # Panics
/// If there are no registers, or a line names one outside `registers`.
pub fn effective<L: Assignment>(registers: usize, lines: &[L]) -> Vec<bool> {
    let mut live = vec![false; registers];
    live[0] = true;
    let mut effective = vec![false; lines.len()];
    for (line, effective) in lines.iter().zip(&mut effective).rev() {
        if std::mem::replace(&mut live[line.writes()], false) {
            *effective = true;
            line.reads().for_each(|register| live[register] = true);
        }
    }
    effective
}

/// A cycle among nodes that should have none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cycle {
    /// Nodes on the cycle, in order.
    pub nodes: Vec<usize>,
    /// The edge that closes the cycle: a node and the position of the edge among that node's edges.
    pub closed_by: (usize, usize),
}

/// Orders the nodes reachable from `starts` topologically: each node comes before its successors. This is reverse
/// post-order of a depth-first search, which keeps its own stack because a graph may be deeper than the machine stack.
///
/// `edge` returns the edge of a node at a position: `None` past the last one, `Some(None)` for an edge that leads to no
/// node.
///
/// ```
/// use tpg_graph::dataflow::depth_first;
///
/// let edges = [vec![2, 1], vec![3], vec![1], vec![]];
/// let order = depth_first(4, [0], |node: usize, place| edges[node].get(place).copied().map(Some));
/// assert_eq!(order, Ok(vec![0, 2, 1, 3]));
/// ```
///
/// # Errors
/// The first cycle found.
pub fn depth_first(
    nodes: usize,
    starts: impl IntoIterator<Item = usize>,
    edge: impl Fn(usize, usize) -> Option<Option<usize>>,
) -> Result<Vec<usize>, Cycle> {
    let mut seen = vec![false; nodes];
    let mut done = vec![false; nodes];
    let mut finished = Vec::new();
    for start in starts {
        if std::mem::replace(&mut seen[start], true) {
            continue;
        }
        let mut path = vec![(start, 0)];
        while let Some((node, place)) = path.last_mut() {
            let (from, at) = (*node, *place);
            *place += 1;
            match edge(from, at) {
                None => {
                    done[from] = true;
                    finished.push(from);
                    path.pop();
                }
                Some(Some(to)) if seen[to] && !done[to] => {
                    let first = path.iter().position(|&(open, _)| open == to).unwrap_or(0);
                    let nodes = path[first..].iter().map(|&(open, _)| open).collect();
                    return Err(Cycle { nodes, closed_by: (from, at) });
                }
                Some(Some(to)) if !seen[to] => {
                    seen[to] = true;
                    path.push((to, 0));
                }
                Some(_) => {}
            }
        }
    }
    finished.reverse();
    Ok(finished)
}

impl Assignment for crate::model::graph::Line {
    fn writes(&self) -> usize {
        self.to.index()
    }

    fn reads(&self) -> impl Iterator<Item = usize> {
        let operands = self.operands.iter().take(self.instruction.arity()).filter_map(|operand| match operand {
            crate::model::graph::Operand::Register(register) => Some(register.index()),
            crate::model::graph::Operand::Input(_) | crate::model::graph::Operand::Constant(_) => None,
        });
        operands.chain(self.instruction.reads_destination().then(|| self.to.index()))
    }
}

#[cfg(test)]
mod tests {
    use super::{Cycle, depth_first};

    #[test]
    fn a_cycle_is_told_by_its_nodes_and_its_last_edge() {
        let edges = [vec![None, Some(1)], vec![Some(2)], vec![None, Some(1)]];
        let found = depth_first(3, 0..3, |node: usize, place| edges[node].get(place).copied());
        assert_eq!(found, Err(Cycle { nodes: vec![1, 2], closed_by: (2, 1) }));
    }

    #[test]
    fn a_long_chain_needs_no_deep_stack() {
        let next = |node: usize, place| (place == 0 && node + 1 < 100_000).then_some(Some(node + 1));
        assert_eq!(depth_first(100_000, [0], next).map(|order| order.len()), Ok(100_000));
    }
}
