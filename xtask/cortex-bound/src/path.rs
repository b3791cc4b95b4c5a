//! Paths with shared prefixes: visits of nodes are counted only for the longest path.

/// The end of a path among [`Paths`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Step(usize);

#[derive(Clone, Copy, Debug)]
enum Link {
    /// A path followed by a node.
    Node(Option<Step>, usize),
    /// A path followed by a number of repetitions of another path.
    Times(Option<Step>, Step, u64),
}

/// All steps of a search.
#[derive(Debug, Default)]
pub(super) struct Paths(Vec<Link>);

impl Paths {
    fn add(&mut self, link: Link) -> Step {
        self.0.push(link);
        Step(self.0.len() - 1)
    }

    /// Appends a node to a path.
    pub(super) fn then(&mut self, path: Option<Step>, node: usize) -> Step {
        self.add(Link::Node(path, node))
    }

    /// Appends a number of repetitions of another path to a path.
    pub(super) fn repeat(&mut self, path: Option<Step>, turn: Option<Step>, times: u64) -> Option<Step> {
        match turn {
            Some(turn) if times > 0 => Some(self.add(Link::Times(path, turn, times))),
            _ => path,
        }
    }

    /// Appends another path to a path.
    pub(super) fn join(&mut self, path: Option<Step>, end: Option<Step>) -> Option<Step> {
        self.repeat(path, end, 1)
    }

    /// Returns the number of visits of each of `count` nodes on a path.
    pub(super) fn visits(&self, path: Option<Step>, count: usize) -> Vec<u64> {
        let mut visits = vec![0; count];
        let mut open: Vec<(Step, u64)> = path.into_iter().map(|step| (step, 1)).collect();
        while let Some((Step(at), times)) = open.pop() {
            let before = match self.0[at] {
                Link::Node(before, node) => {
                    visits[node] += times;
                    before
                }
                Link::Times(before, turn, more) => {
                    open.push((turn, times * more));
                    before
                }
            };
            open.extend(before.map(|step| (step, times)));
        }
        visits
    }
}
