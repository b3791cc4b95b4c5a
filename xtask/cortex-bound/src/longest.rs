//! The longest path through a graph whose loops are bounded.
//!
//! A loop is a strongly connected component with one entry, its header. Each iteration costs at most the longest path
//! from the header back to it; a loop of at most n iterations costs n − 1 of those plus the longest path from the
//! header to the exit. Nested loops are found by removing the edges back to the header. In a loop with several entries, as hand-written
//! code has, every instruction counts n times.

use std::collections::BTreeMap;

/// Returns the cost of the longest path from `entry`, or a loop without a bound. `turns` holds the maximum iterations of the loop of
/// each header.
pub(super) fn longest(
    next: &[Vec<usize>],
    cost: &[u64],
    entry: usize,
    turns: &BTreeMap<usize, u64>,
) -> Result<u64, Header> {
    let found = Search::new(next, cost, entry, Some(turns)).walk(&vec![true; next.len() + 1], next.len())?;
    Ok(found.into_iter().flatten().max().unwrap_or(0))
}

/// A loop, by its first node.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Header {
    pub(super) node: usize,
    /// Number of loops around it.
    pub(super) depth: usize,
    /// The loop has other entries, too; the node is its first.
    pub(super) is_tangled: bool,
}

/// Returns all loops, in the order of the nodes.
pub(super) fn headers(next: &[Vec<usize>], entry: usize) -> Vec<Header> {
    let cost = vec![0; next.len()];
    let mut search = Search::new(next, &cost, entry, None);
    search.walk(&vec![true; next.len() + 1], next.len()).expect("every loop has a bound");
    search.headers.sort_unstable();
    search.headers
}

struct Search<'a> {
    next: Vec<Vec<usize>>,
    cost: Vec<u64>,
    /// If `None`, every loop has one iteration: used to find the loops.
    turns: Option<&'a BTreeMap<usize, u64>>,
    headers: Vec<Header>,
    /// Number of loops around the subgraph that is walked.
    depth: usize,
}

impl<'a> Search<'a> {
    fn new(next: &[Vec<usize>], cost: &[u64], entry: usize, turns: Option<&'a BTreeMap<usize, u64>>) -> Self {
        Self {
            // A virtual node before the first one, so that a loop may begin there.
            next: next.iter().cloned().chain([vec![entry]]).collect(),
            cost: cost.iter().copied().chain([0]).collect(),
            turns,
            headers: Vec::new(),
            depth: 0,
        }
    }

    /// Finds the cost of the longest path to each node of the subgraph `inside`, the node included, ignoring edges back to `entry`.
    fn walk(&mut self, inside: &[bool], entry: usize) -> Result<Vec<Option<u64>>, Header> {
        let parts = components(&self.next, inside, entry);
        let mut part_of = vec![usize::MAX; self.next.len()];
        for (number, part) in parts.iter().enumerate() {
            part.iter().for_each(|&node| part_of[node] = number);
        }
        let mut found: Vec<Option<u64>> = vec![None; self.next.len()];
        // The longest path before a node.
        let mut before: Vec<Option<u64>> = vec![None; self.next.len()];
        before[entry] = Some(0);
        // Components are in reverse topological order.
        for part in parts.iter().rev() {
            let alone = part[0];
            if part.len() > 1 || self.next[alone].iter().any(|&to| to == alone && to != entry) {
                self.turn(part, &before, &mut found)?;
            } else {
                found[alone] = before[alone].map(|cost| cost + self.cost[alone]);
            }
            for &node in part {
                let Some(cost) = found[node] else { continue };
                for &to in self.next[node].iter().filter(|&&to| inside[to] && to != entry) {
                    if part_of[to] != part_of[node] {
                        before[to] = before[to].max(Some(cost));
                    }
                }
            }
        }
        Ok(found)
    }

    /// Handles a loop.
    fn turn(&mut self, part: &[usize], before: &[Option<u64>], found: &mut [Option<u64>]) -> Result<(), Header> {
        let mut entries = part.iter().copied().filter(|&node| before[node].is_some());
        let first = entries.next();
        let is_tangled = entries.next().is_some();
        let node = first.filter(|_| !is_tangled).unwrap_or(part[0]);
        let header = Header { node, depth: self.depth, is_tangled };
        let turns = match self.turns {
            Some(turns) => *turns.get(&node).ok_or_else(|| header.clone())?,
            None => 1,
        };
        let mut body = vec![false; self.next.len()];
        part.iter().for_each(|&node| body[node] = true);
        self.headers.push(header);
        if is_tangled {
            // Each of its instructions is reached at most so many times.
            let once: u64 = part.iter().map(|&node| self.cost[node]).sum();
            let entered = part.iter().filter_map(|&node| before[node]).max().unwrap_or(0);
            part.iter().for_each(|&node| found[node] = Some(entered + turns * once));
            return Ok(());
        }
        self.depth += 1;
        let within = self.walk(&body, node)?;
        self.depth -= 1;
        let latches = part.iter().filter(|&&latch| self.next[latch].contains(&node));
        let turn = latches.filter_map(|&node| within[node]).max().unwrap_or(0);
        let base = before[node].unwrap_or(0) + turns.saturating_sub(1) * turn;
        part.iter().for_each(|&node| found[node] = within[node].map(|cost| base + cost));
        Ok(())
    }
}

/// Returns the strongly connected components reachable from `entry` (Tarjan), each after its successors. Iterative
/// because functions have thousands of instructions.
fn components(next: &[Vec<usize>], inside: &[bool], entry: usize) -> Vec<Vec<usize>> {
    let count = next.len();
    let (mut number, mut low) = (vec![usize::MAX; count], vec![0; count]);
    let mut on_stack = vec![false; count];
    let (mut stack, mut parts, mut counter) = (Vec::new(), Vec::new(), 0);
    let mut open = vec![(entry, 0)];
    while let Some((node, edge)) = open.pop() {
        if edge == 0 {
            number[node] = counter;
            low[node] = counter;
            counter += 1;
            stack.push(node);
            on_stack[node] = true;
        }
        match next[node].get(edge) {
            Some(&to) => {
                open.push((node, edge + 1));
                if to == entry || !inside[to] {
                    continue;
                }
                if number[to] == usize::MAX {
                    open.push((to, 0));
                } else if on_stack[to] {
                    low[node] = low[node].min(number[to]);
                }
            }
            None => {
                if let Some(&(parent, _)) = open.last() {
                    low[parent] = low[parent].min(low[node]);
                }
                if low[node] == number[node] {
                    let mut part = Vec::new();
                    while let Some(member) = stack.pop() {
                        on_stack[member] = false;
                        part.push(member);
                        if member == node {
                            break;
                        }
                    }
                    part.sort_unstable();
                    parts.push(part);
                }
            }
        }
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::{Header, headers, longest};
    use std::collections::BTreeMap;

    fn graph(next: &[&[usize]]) -> Vec<Vec<usize>> {
        next.iter().map(|to| to.to_vec()).collect()
    }

    /// Returns the cost if every loop has the same bound, or none has.
    fn most(next: &[&[usize]], turns: Option<u64>) -> Result<u64, Header> {
        let next = graph(next);
        let headers = if turns.is_some() { headers(&next, 0) } else { vec![] };
        let turns: BTreeMap<usize, u64> =
            headers.into_iter().map(|header| header.node).zip(turns.into_iter().cycle()).collect();
        longest(&next, &vec![1; next.len()], 0, &turns)
    }

    fn header(node: usize, depth: usize) -> Header {
        Header { node, depth, is_tangled: false }
    }

    #[test]
    fn the_longer_arm_counts() {
        assert_eq!(most(&[&[1, 2], &[3], &[3], &[]], None), Ok(3));
        assert_eq!(most(&[&[1, 4], &[2], &[3], &[4], &[]], None), Ok(5));
    }

    #[test]
    fn loops_need_a_bound() {
        // 0, then 1 2 in a loop, then 3.
        let looped: &[&[usize]] = &[&[1], &[2], &[1, 3], &[]];
        assert_eq!(most(looped, None), Err(header(1, 0)));
        assert_eq!(most(looped, Some(10)), Ok(1 + 10 * 2 + 1));
        // A loop that is left at its entry: the last iteration stops there.
        assert_eq!(most(&[&[1], &[2, 3], &[1], &[]], Some(10)), Ok(1 + 9 * 2 + 2));
        // A node with an edge to itself.
        assert_eq!(most(&[&[1], &[1, 2], &[]], Some(4)), Ok(1 + 4 + 1));
    }

    #[test]
    fn loops_in_loops_multiply() {
        // 1 to 3 form the outer loop, 2 loops on itself.
        let nested: &[&[usize]] = &[&[1], &[2], &[2, 3], &[1, 4], &[]];
        assert_eq!(most(nested, Some(5)), Ok(1 + 5 * (1 + 5 + 1) + 1));
    }

    #[test]
    fn each_loop_has_its_own_bound() {
        let next = graph(&[&[1], &[2], &[2, 3], &[1, 4], &[]]);
        assert_eq!(headers(&next, 0), [header(1, 0), header(2, 1)]);
        let turns = BTreeMap::from([(1, 3), (2, 7)]);
        assert_eq!(longest(&next, &[1, 10, 100, 1000, 1], 0, &turns), Ok(1 + 3 * (10 + 7 * 100 + 1000) + 1));
    }

    #[test]
    fn a_loop_back_to_the_first_instruction_is_found() {
        assert_eq!(most(&[&[1], &[0, 2], &[]], None), Err(header(0, 0)));
        assert_eq!(most(&[&[1], &[0, 2], &[]], Some(3)), Ok(7));
    }

    #[test]
    fn with_two_entries_everything_counts_each_time() {
        let tangled: &[&[usize]] = &[&[1, 2], &[2], &[1, 3], &[]];
        assert_eq!(most(tangled, None), Err(Header { is_tangled: true, ..header(1, 0) }));
        assert_eq!(most(tangled, Some(9)), Ok(1 + 9 * 2 + 1));
    }
}
