//! Source locations: the line of the `.dot` file for each element of a document.

/// Line numbers in the file, indexed by position in the document.
#[derive(Debug, Default)]
pub(super) struct Lines {
    /// Line of the statement that names the root, or of the root's own node.
    pub(super) root: usize,
    /// Lines of each team.
    pub(super) teams: Vec<TeamLines>,
    /// Line of each leaf's node.
    pub(super) leaves: Vec<usize>,
    /// Lines of each program.
    pub(super) programs: Vec<ProgramLines>,
}

/// Lines of a team.
#[derive(Debug)]
pub(super) struct TeamLines {
    /// Line of its node.
    pub(super) node: usize,
    /// Lines of its edges.
    pub(super) edges: Vec<usize>,
}

/// Lines of a program.
#[derive(Clone, Copy, Debug)]
pub(super) struct ProgramLines {
    /// Line of its node.
    pub(super) node: usize,
    /// Line of the node that holds its program lines.
    pub(super) lines: usize,
}

impl Lines {
    /// Returns the line of the element that a JSON path names; `None` if the path leads into the sidecar.
    pub(super) fn line(&self, path: &str) -> Option<usize> {
        let mut steps = path.split(['.', '[', ']']).filter(|step| !step.is_empty() && *step != "$");
        let list = steps.next()?;
        if list == "root" {
            return Some(self.root);
        }
        let index: usize = steps.next()?.parse().ok()?;
        let inner = steps.next();
        match list {
            "teams" => {
                let team = self.teams.get(index)?;
                let edge = steps.next().and_then(|place| place.parse::<usize>().ok());
                Some(
                    edge.filter(|_| inner == Some("edges"))
                        .and_then(|edge| team.edges.get(edge).copied())
                        .unwrap_or(team.node),
                )
            }
            "leaves" => self.leaves.get(index).copied(),
            "programs" => {
                let program = self.programs.get(index)?;
                Some(if inner == Some("lines") { program.lines } else { program.node })
            }
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_path_finds_its_line() {
        let lines = Lines {
            root: 90,
            teams: vec![TeamLines { node: 4, edges: vec![10, 12] }],
            leaves: vec![9],
            programs: vec![ProgramLines { node: 7, lines: 8 }],
        };
        assert_eq!(lines.line("$.root"), Some(90));
        assert_eq!(lines.line("$.teams[0]"), Some(4));
        assert_eq!(lines.line("$.teams[0].edges"), Some(4));
        assert_eq!(lines.line("$.teams[0].edges[1].program"), Some(12));
        assert_eq!(lines.line("$.programs[0]"), Some(7));
        assert_eq!(lines.line("$.programs[0].lines[3].args[1]"), Some(8));
        assert_eq!(lines.line("$.leaves[0].programs[1]"), Some(9));
        assert_eq!(lines.line("$.sources[0].name"), None);
    }
}
