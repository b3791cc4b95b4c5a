//! A graph that asks another policy where it is unsure.

use super::document::ActionDocument;
use super::graph::{Destination, Edge, Graph, Line, Operand, Program, ProgramId, Reg, Team};
use crate::error::InputError;
use crate::word::Word;
use std::collections::BTreeMap;
use tpg_runtime::ops::Instruction;
use tpg_runtime::policy::ActionId;

const ADD: Word = Word::Instruction(Instruction::Add);
const MIN: Word = Word::Instruction(Instruction::Min);
const MAX: Word = Word::Instruction(Instruction::Max);

impl Graph {
    /// Returns this graph with one more action, its last, which asks `policy` where the highest bid of a team exceeds the
    /// highest for any other destination by less than `margin`.
    ///
    /// The action's bid is a program like any other: the second highest of the destinations' bids, plus `margin`.
    ///
    /// # Errors
    /// For a policy with outputs, for one that asks `policy` already, and where the bids of a team need more registers than a
    /// program can have.
    pub fn asking(mut self, policy: &str, margin: f64) -> Result<Self, InputError> {
        let action = ActionId(self.actions.len() as u16);
        let (id, name) = (u32::from(action.0), format!("ask_{policy}"));
        self.actions.push(ActionDocument { id, name, effect: None, ask: Some(policy.to_owned()) });
        for word in [ADD, MIN, MAX] {
            if !self.instructions.contains(&word) {
                self.instructions.push(word);
            }
        }
        let margin = Operand::Constant(self.scalar.round(margin));
        for team in &mut self.teams {
            let Some(lines) = second_highest_plus(margin, team, &self.programs) else { continue };
            let registers = lines.iter().map(|line| line.to.0.saturating_add(1)).max().unwrap_or(0);
            self.registers = self.registers.max(registers);
            let label = self.programs.iter().map(|program| program.label + 1).max().unwrap_or(0);
            team.edges.push(Edge { program: ProgramId(self.programs.len() as u32), to: Destination::Action(action) });
            self.programs.push(Program { label, lines });
        }
        Self::from_document("the graph that asks", self.to_document())
    }
}

/// Returns lines that compute the bids of a team side by side, in registers of their own, and the second highest of its
/// destinations' plus `margin`; none for a team with one destination.
fn second_highest_plus(margin: Operand, team: &Team, programs: &[Program]) -> Option<Vec<Line>> {
    let mut lines = Vec::new();
    let line = |to: u16, instruction, operands| Line { to: Reg(to), instruction, operands };
    let of = |to: u16, word, registers: [u16; 2]| line(to, word, registers.map(|place| Operand::Register(Reg(place))));
    let mut free = 0_u16;
    let mut highest = BTreeMap::new();
    for edge in &team.edges {
        let bid = free;
        free = free.saturating_add(moved(&programs[edge.program.index()], bid, &mut lines));
        let of_destination = *highest.entry(edge.to).or_insert(bid);
        if of_destination != bid {
            lines.push(of(of_destination, MAX, [of_destination, bid]));
        }
    }
    let [first, second, others @ ..] = &*highest.into_values().collect::<Vec<u16>>() else { return None };
    let [high, low, lesser] = [0, 1, 2].map(|place| free.saturating_add(place));
    lines.extend([of(high, MAX, [*first, *second]), of(low, MIN, [*first, *second])]);
    for &bid in others {
        lines.extend([of(lesser, MIN, [high, bid]), of(low, MAX, [low, lesser]), of(high, MAX, [high, bid])]);
    }
    lines.push(line(0, ADD, [Operand::Register(Reg(low)), margin]));
    Some(lines)
}

/// Appends the lines of a program with its registers from `first` on, and returns how many it has.
fn moved(program: &Program, first: u16, lines: &mut Vec<Line>) -> u16 {
    let mut used = 1;
    for line in &program.lines {
        let mut place = |reg: Reg| {
            used = used.max(reg.0 + 1);
            Reg(first.saturating_add(reg.0))
        };
        let operands = line.operands.map(|operand| match operand {
            Operand::Register(reg) => Operand::Register(place(reg)),
            other => other,
        });
        lines.push(Line { to: place(line.to), operands, ..*line });
    }
    used
}

#[cfg(test)]
mod tests {
    use crate::interpret::Interpreter;
    use crate::sample::{self, Shape};
    use crate::{Destination, Graph, MathsProvider, ScalarType, states};
    use std::collections::BTreeMap;
    use tpg_runtime::ops::Own;

    const MARGIN: f32 = 0.25;

    /// Tests whether a team of the walk through a graph is unsure; nothing where a bid is NaN.
    fn is_unsure(graph: &Graph, state: &[f32]) -> Option<bool> {
        let interpreter = Interpreter::<f32, Own>::new(graph);
        let mut team = graph.root();
        loop {
            let mut highest = BTreeMap::new();
            for edge in &graph.team(team).edges {
                let bid = interpreter.run(graph.program(edge.program), state);
                let known = highest.entry(edge.to).or_insert(bid);
                *known = known.max(bid);
                if bid.is_nan() {
                    return None;
                }
            }
            let mut bids: Vec<f32> = highest.into_values().collect();
            bids.sort_by(f32::total_cmp);
            if let [.., second, first] = bids[..]
                && second + MARGIN >= first
            {
                return Some(true);
            }
            match interpreter.decide_team(team, state).to {
                Destination::Team(next) => team = next,
                Destination::Action(_) => return Some(false),
            }
        }
    }

    #[test]
    fn a_graph_asks_where_two_destinations_bid_nearly_alike() {
        let (mut asked, mut answered) = (0, 0);
        for seed in 0..100 {
            let shape = Shape { scalar: ScalarType::F32, maths: MathsProvider::Own, ..Shape::random(seed) };
            let graph = sample::graph(&shape, seed);
            let Ok(asking) = graph.clone().asking("network", f64::from(MARGIN)) else { continue };
            let (before, after) = (Interpreter::<f32, Own>::new(&graph), Interpreter::<f32, Own>::new(&asking));
            let values = states::sample_in_range(&graph, 100, seed);
            for state in values.chunks(graph.state_length()) {
                let state: Vec<f32> = state.iter().map(|&value| value as f32).collect();
                let (found, own) = (after.walk(&state).1, before.walk(&state).1);
                match is_unsure(&graph, &state) {
                    Some(true) => {
                        assert_eq!(usize::from(found.0), graph.actions().len(), "{seed}: {state:?}");
                        asked += 1;
                    }
                    Some(false) => {
                        assert_eq!(found, own, "{seed}: {state:?}");
                        answered += 1;
                    }
                    None => {}
                }
            }
        }
        assert!(asked > 500 && answered > 500, "{asked} asked, {answered} answered");
    }

    #[test]
    fn what_cannot_ask_is_refused() {
        let graph = sample::graph(&Shape { outputs: 1, ..Shape::default() }, 1);
        assert!(graph.asking("network", 0.1).is_err(), "values");
        let graph = sample::graph(&Shape::default(), 1).asking("network", 0.1).expect("actions");
        assert!(graph.asking("network", 0.1).is_err(), "twice");
        let many = Shape { teams: 1, edges: 12..=12, lines: 200..=200, registers: 100, ..Shape::default() };
        let error = sample::graph(&many, 1).asking("network", 0.1).expect_err("registers").to_string();
        assert!(error.starts_with("the graph that asks: $.registers: "), "{error}");
    }
}
