//! Validity of a policy that was read from a file.

use super::{Destination, Edge, Limits, Line, Operand, PolicyGraph};
use crate::action::ActionSpace;
use tpg_graph::error::Finding;

impl PolicyGraph {
    /// Checks every index: a policy that passes can be planned and run in an environment with that many values of the
    /// flat state and those actions.
    ///
    /// ```
    /// use tpg_engine::{ActionSpace, Destination, Edge, PolicyGraph};
    ///
    /// let edge = |program| Edge { program, to: Destination::Action(0) };
    /// let policy = |program| PolicyGraph::new(8, 0, vec![vec![edge(program)]], vec![vec![]]);
    /// let space = ActionSpace::discrete(["left", "right"]);
    /// assert_eq!(policy(0).check(8, 3, &space), Ok(()));
    /// let finding = policy(1).check(8, 3, &space).expect_err("there is one program");
    /// assert_eq!(finding.to_string(), "teams[0][0].program = 1; accepted: below 1");
    /// ```
    ///
    /// # Errors
    /// The first index without its object, or a team that is empty or leads back.
    pub fn check(&self, registers: u16, inputs: usize, space: &ActionSpace) -> Result<(), Finding> {
        let ends = self.check_leaves(space)?;
        if self.registers != registers {
            return Err(Finding::new("registers", self.registers, registers.to_string()));
        }
        if self.teams.is_empty() {
            return Err(Finding::new("teams", "no team", "one or more; the first is the root"));
        }
        for (team, edges) in self.teams.iter().enumerate() {
            if edges.is_empty() {
                return Err(Finding::new(format!("teams[{team}]"), "no edge", "one or more"));
            }
            for (place, edge) in edges.iter().enumerate() {
                self.check_edge(team, edge, ends)
                    .map_err(|finding| finding.within(&format!("teams[{team}][{place}]")))?;
            }
        }
        for (program, lines) in self.programs.iter().enumerate() {
            for (place, line) in lines.iter().enumerate() {
                check_line(line, registers, inputs)
                    .map_err(|finding| finding.within(&format!("programs[{program}][{place}]")))?;
            }
        }
        Ok(())
    }

    /// Checks the outputs and leaves; returns the number of actions or leaves that edges may lead to.
    fn check_leaves(&self, space: &ActionSpace) -> Result<usize, Finding> {
        let outputs = space.outputs().len();
        if self.outputs.len() != outputs {
            return Err(Finding::new("outputs", self.outputs.len(), outputs.to_string()));
        }
        for (place, Limits { min, max, nan }) in self.outputs.iter().enumerate() {
            if !(min <= nan && nan <= max && min.is_finite() && max.is_finite()) {
                let found = format!("min {min}, max {max}, nan {nan}");
                return Err(Finding::new(format!("outputs[{place}]"), found, "finite numbers, nan between the others"));
            }
        }
        for (place, leaf) in self.leaves.iter().enumerate() {
            let key = format!("leaves[{place}]");
            if leaf.len() != outputs {
                return Err(Finding::new(key, leaf.len(), format!("{outputs} programs")));
            }
            leaf.iter().try_for_each(|&program| Finding::below(&key, program as usize, self.programs.len()))?;
        }
        Ok(if outputs == 0 { space.count().unwrap_or(0) } else { self.leaves.len() })
    }

    fn check_edge(&self, team: usize, edge: &Edge, actions: usize) -> Result<(), Finding> {
        Finding::below("program", edge.program as usize, self.programs.len())?;
        match edge.to {
            Destination::Action(action) => Finding::below("to.action", action.into(), actions),
            Destination::Team(to) if (team + 1..self.teams.len()).contains(&(to as usize)) => Ok(()),
            Destination::Team(to) => {
                Err(Finding::new("to.team", to, format!("a later team than {team}, below {}", self.teams.len())))
            }
        }
    }
}

fn check_line(line: &Line, registers: u16, inputs: usize) -> Result<(), Finding> {
    Finding::below("to", line.to.into(), registers.into())?;
    line.operands.iter().enumerate().try_for_each(|(place, operand)| match *operand {
        Operand::Register(register) => {
            Finding::below(&format!("operands[{place}].register"), register.into(), registers.into())
        }
        Operand::Input(input) => Finding::below(&format!("operands[{place}].input"), input.into(), inputs),
        Operand::Constant(_) => Ok(()),
    })
}
