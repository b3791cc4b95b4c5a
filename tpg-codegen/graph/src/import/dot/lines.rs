//! Where in the `.dot` file the things of a document stand.

/// Lines of the file, by place in the document.
#[derive(Debug, Default)]
pub(super) struct Lines {
    /// Of the statement that says what the root is, or of the root itself.
    pub(super) root: usize,
    /// Of each team.
    pub(super) teams: Vec<TeamLines>,
    /// Of each program.
    pub(super) programs: Vec<ProgramLines>,
}

/// Where a team stands.
#[derive(Debug)]
pub(super) struct TeamLines {
    /// Its node.
    pub(super) node: usize,
    /// Its edges.
    pub(super) edges: Vec<usize>,
}

/// Where a program stands.
#[derive(Clone, Copy, Debug)]
pub(super) struct ProgramLines {
    /// Its node.
    pub(super) node: usize,
    /// The node of its lines.
    pub(super) lines: usize,
}

impl Lines {
    /// The line of what a JSON path names; `None` where the path leads into what the sidecar says.
    pub(super) fn of(&self, path: &str) -> Option<usize> {
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
            programs: vec![ProgramLines { node: 7, lines: 8 }],
        };
        assert_eq!(lines.of("$.root"), Some(90));
        assert_eq!(lines.of("$.teams[0]"), Some(4));
        assert_eq!(lines.of("$.teams[0].edges"), Some(4));
        assert_eq!(lines.of("$.teams[0].edges[1].program"), Some(12));
        assert_eq!(lines.of("$.programs[0]"), Some(7));
        assert_eq!(lines.of("$.programs[0].lines[3].args[1]"), Some(8));
        assert_eq!(lines.of("$.sources[0].name"), None);
    }
}
