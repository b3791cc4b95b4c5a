//! Validity of a policy that was read from a file.

use super::{Destination, Edge, Line, Operand, Policy};
use tpg_graph::error::Finding;

impl Policy {
    /// Checks every index: a policy that passes can be planned and run in an environment with that many values of the
    /// flat state and that many actions.
    ///
    /// ```
    /// use tpg_engine::{Destination, Edge, Policy};
    ///
    /// let edge = |program| Edge { program, to: Destination::Action(0) };
    /// let policy = |program| Policy { registers: 8, teams: vec![vec![edge(program)]], programs: vec![vec![]] };
    /// assert_eq!(policy(0).check(8, 3, 2), Ok(()));
    /// let finding = policy(1).check(8, 3, 2).expect_err("there is one program");
    /// assert_eq!(finding.to_string(), "teams[0][0].program = 1; accepted: below 1");
    /// ```
    ///
    /// # Errors
    /// The first index without its object, or a team that is empty or leads back.
    pub fn check(&self, registers: u16, inputs: usize, actions: usize) -> Result<(), Finding> {
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
                self.check_edge(team, edge, actions)
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
