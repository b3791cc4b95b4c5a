//! The longest path through a graph whose loops have bounds.
//!
//! A loop is a strongly connected part with one entry. Between two times that control comes to the entry, it takes at most
//! the longest path from there back; a loop that turns at most n times costs n − 1 of those and then the longest path from
//! the entry to where it is left. Loops inside are found by cutting the ways back to the entry.

/// Why there is none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Endless {
    /// A loop at this node without a bound.
    Loop(usize),
    /// A loop at this node that has several entries.
    Tangled(usize),
}

/// For each node that can be reached, the most that a path from `entry` costs up to it, the node included.
pub(super) fn longest(
    next: &[Vec<usize>],
    cost: &[u64],
    entry: usize,
    turns: Option<u64>,
) -> Result<Vec<Option<u64>>, Endless> {
    // A node before the first, so that a loop may begin there.
    let next: Vec<Vec<usize>> = next.iter().cloned().chain([vec![entry]]).collect();
    let cost: Vec<u64> = cost.iter().copied().chain([0]).collect();
    let graph = Graph { next: &next, cost: &cost, turns };
    let mut found = walk(&graph, &vec![true; next.len()], next.len() - 1)?;
    found.pop();
    Ok(found)
}

struct Graph<'a> {
    next: &'a [Vec<usize>],
    cost: &'a [u64],
    turns: Option<u64>,
}

/// In the part of the graph that is `inside`, without ways back to `entry`.
fn walk(graph: &Graph<'_>, inside: &[bool], entry: usize) -> Result<Vec<Option<u64>>, Endless> {
    let parts = components(graph, inside, entry);
    let mut part_of = vec![usize::MAX; graph.next.len()];
    for (number, part) in parts.iter().enumerate() {
        part.iter().for_each(|&node| part_of[node] = number);
    }
    let mut found: Vec<Option<u64>> = vec![None; graph.next.len()];
    // The most that a path costs before it comes to a node.
    let mut before: Vec<Option<u64>> = vec![None; graph.next.len()];
    before[entry] = Some(0);
    // Components come last first.
    for part in parts.iter().rev() {
        let alone = part[0];
        let is_loop = part.len() > 1 || graph.next[alone].iter().any(|&to| to == alone && to != entry);
        if is_loop {
            let mut entries = part.iter().copied().filter(|&node| before[node].is_some());
            let (Some(header), None) = (entries.next(), entries.next()) else {
                return Err(Endless::Tangled(alone));
            };
            let turns = graph.turns.ok_or(Endless::Loop(header))?;
            let mut body = vec![false; graph.next.len()];
            part.iter().for_each(|&node| body[node] = true);
            let within = walk(graph, &body, header)?;
            let latches = part.iter().filter(|&&node| graph.next[node].contains(&header));
            let turn = latches.filter_map(|&node| within[node]).max().unwrap_or(0);
            let base = before[header].unwrap_or(0) + turns.saturating_sub(1) * turn;
            part.iter().for_each(|&node| found[node] = within[node].map(|cost| base + cost));
        } else {
            found[alone] = before[alone].map(|before| before + graph.cost[alone]);
        }
        for &node in part {
            for &to in graph.next[node].iter().filter(|&&to| inside[to] && to != entry) {
                if part_of[to] != part_of[node] {
                    before[to] = before[to].max(found[node]);
                }
            }
        }
    }
    Ok(found)
}

/// The strongly connected parts that can be reached from `entry` (Tarjan), each after those that it leads to. Without
/// recursion: functions have thousands of instructions.
fn components(graph: &Graph<'_>, inside: &[bool], entry: usize) -> Vec<Vec<usize>> {
    let count = graph.next.len();
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
        match graph.next[node].get(edge) {
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
    use super::{Endless, longest};

    fn most(next: &[&[usize]], turns: Option<u64>) -> Result<u64, Endless> {
        let next: Vec<Vec<usize>> = next.iter().map(|to| to.to_vec()).collect();
        let cost = vec![1; next.len()];
        longest(&next, &cost, 0, turns).map(|found| found.into_iter().flatten().max().unwrap_or(0))
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
        assert_eq!(most(looped, None), Err(Endless::Loop(1)));
        assert_eq!(most(looped, Some(10)), Ok(1 + 10 * 2 + 1));
        // A loop that is left at its entry: the last turn stops there.
        assert_eq!(most(&[&[1], &[2, 3], &[1], &[]], Some(10)), Ok(1 + 9 * 2 + 2));
        // A node that leads to itself.
        assert_eq!(most(&[&[1], &[1, 2], &[]], Some(4)), Ok(1 + 4 + 1));
    }

    #[test]
    fn loops_in_loops_multiply() {
        // 1 to 3 is the outer loop, 2 turns on itself.
        let nested: &[&[usize]] = &[&[1], &[2], &[2, 3], &[1, 4], &[]];
        assert_eq!(most(nested, Some(5)), Ok(1 + 5 * (1 + 5 + 1) + 1));
    }

    #[test]
    fn a_loop_back_to_the_first_instruction_is_found() {
        assert_eq!(most(&[&[1], &[0, 2], &[]], None), Err(Endless::Loop(0)));
        assert_eq!(most(&[&[1], &[0, 2], &[]], Some(3)), Ok(7));
    }

    #[test]
    fn two_entries_are_refused() {
        assert_eq!(most(&[&[1, 2], &[2], &[1, 3], &[]], Some(9)), Err(Endless::Tangled(1)));
    }
}
