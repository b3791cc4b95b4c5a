//! The bids behind a decision: what the generated code compares, and the teams that it goes through.
//!
//! The tables stand for the same optimised graph that the code was made of, operation by operation; a test holds that both
//! decide the same.

use tpg_runtime::ops;

/// A value that bids are made of; operands are places of earlier values.
#[derive(Clone, Copy, Debug)]
pub enum Value {
    /// A value of the state, by its place.
    Input(u8),
    /// A number.
    Constant(f32),
    /// An instruction on two earlier values, as a function: only those that a policy needs become part of the module.
    Operation(fn(f32, f32) -> f32, u8, u8),
}

/// The place where an edge leads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum To {
    /// To a team, by its place in [`Bids::teams`].
    Team(u8),
    /// To an action or a leaf.
    End(u8),
}

/// A bid for a destination.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// The place of the bid in [`Bids::values`].
    pub bid: u8,
    /// The destination.
    pub to: To,
}

/// The bids of a policy in `f32` with own maths.
#[derive(Clone, Copy, Debug)]
pub struct Bids {
    /// Every value once, operands before operations.
    pub values: &'static [Value],
    /// The edges of each team; the first team is the root.
    pub teams: &'static [&'static [Edge]],
}

/// The greatest number of values, edges or teams of a policy that a page can show.
pub const MOST: usize = 64;

/// The bids at a state, and the way that they lead.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decision {
    /// The bid of each edge, team after team; NaN counts as −∞. Zero behind the last edge.
    pub bids: [f32; MOST],
    /// The winning edges from the root on, counted over all teams; −1 behind the end.
    pub way: [i32; MOST],
    /// The action or the leaf.
    pub end: u8,
}

impl Bids {
    /// Computes every bid at a state, and follows the highest, of equal ones the last, from the root to an action or a leaf.
    pub fn decide(&self, state: &[f32]) -> Decision {
        let mut values = [0.0_f32; MOST];
        for (place, &value) in self.values.iter().enumerate().take(MOST) {
            values[place] = match value {
                Value::Input(input) => state.get(usize::from(input)).copied().unwrap_or(0.0),
                Value::Constant(number) => number,
                Value::Operation(instruction, a, b) => {
                    instruction(values[usize::from(a) % MOST], values[usize::from(b) % MOST])
                }
            };
        }
        let mut decision = Decision { bids: [0.0; MOST], way: [-1; MOST], end: 0 };
        for (slot, edge) in decision.bids.iter_mut().zip(self.teams.iter().copied().flatten()) {
            *slot = ops::bid(values[usize::from(edge.bid) % MOST]);
        }
        let mut team = 0;
        // A graph has no cycle, so a walk decides at most once in each team.
        for step in 0..self.teams.len().min(MOST) {
            let first: usize = self.teams[..team].iter().map(|edges| edges.len()).sum();
            let edges = self.teams[team];
            let best = (0..edges.len()).max_by(|&a, &b| {
                let [a, b] = [a, b].map(|edge| decision.bids[(first + edge) % MOST]);
                // Of equal bids `max_by` takes the last; no bid is NaN.
                a.partial_cmp(&b).unwrap_or(core::cmp::Ordering::Equal)
            });
            let Some(edge) = best else { break };
            decision.way[step] = (first + edge) as i32;
            match edges[edge].to {
                To::Team(next) => team = usize::from(next).min(self.teams.len() - 1),
                To::End(end) => {
                    decision.end = end;
                    break;
                }
            }
        }
        decision
    }
}
