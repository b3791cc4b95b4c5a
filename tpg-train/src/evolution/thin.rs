//! Thinning: at the end of a run, versions of the best policy without the lines that matter least enter the hall of fame.

use super::export;
use super::generation::Evolution;
use super::state::{State, actions};
use super::validate::along;
use tpg_engine::{Environment, EvaluationError, PolicyGraph, remembered};
use tpg_graph::Provenance;
use tpg_graph::dataflow::effective;
use tpg_graph::interpret::{self, Answer};
use tpg_runtime::scalar::Scalar;

/// Parts of the lines that stay, in eighths.
const KEPT: [usize; 4] = [7, 6, 4, 2];
/// Number of episodes whose states show what a line is for, and of states in each.
const EPISODES: usize = 4;
const STATES: u32 = 64;

/// The place of a line: its program, and its index there.
type Place = (usize, usize);

impl<S: Scalar, E: Environment<S>> Evolution<'_, S, E> {
    /// Enters ever smaller versions of the best policy, until one has lost half of what the run has gained; each plays so many
    /// validation episodes.
    pub(super) fn thin(&self, state: &mut State<E::Task>, episodes: usize) -> Result<(), EvaluationError> {
        let Some(policy) = state.best.as_ref().map(|best| best.policy.clone()) else { return Ok(()) };
        let first = state.rows.first().map_or(f64::NEG_INFINITY, |first| first.median_score);
        let lines = self.by_effect(state, &policy)?;
        let mut sizes = KEPT.map(|kept| lines.len() * kept / 8).to_vec();
        sizes.dedup();
        for kept in sizes.into_iter().filter(|&kept| kept > 0 && kept < lines.len()) {
            let thinned = without(&policy, &lines[..lines.len() - kept]);
            let endings = self.endings([&thinned], &self.selection_tasks[..episodes])?.concat();
            state.count_selection(&endings);
            let result = self.enter(state, thinned, &endings)?;
            let best = state.best.as_ref().map_or(f64::NAN, |best| best.result.score);
            if result.score < 0.5 * (first + best) {
                break;
            }
        }
        Ok(())
    }

    /// Returns the lines that have an effect, those first without which a policy's answers to the states of its episodes change
    /// least.
    fn by_effect(&self, state: &mut State<E::Task>, policy: &PolicyGraph) -> Result<Vec<Place>, EvaluationError> {
        let tasks = &self.selection_tasks[..EPISODES.min(self.selection_tasks.len())];
        let endings = self.endings([policy], tasks)?.concat();
        let plays: Vec<_> =
            tasks.iter().zip(&endings).map(|(task, ending)| along(policy, task, ending, STATES)).collect();
        state.steps += 2 * actions(&endings);
        state.selection_steps += 2 * actions(&endings);
        let states: Vec<f64> = self.states(&plays)?.into_iter().flatten().collect();
        let (sources, actions) = (self.environment.sources(), self.environment.actions());
        let memory = remembered(&sources, &actions);
        let answers = |policy: &PolicyGraph| {
            let (sources, actions) = (sources.iter().cloned().map(export::finite).collect(), actions.clone());
            let graph = export::graph(policy, self.vocabulary(), sources, actions, memory, Provenance::default());
            graph.map(|graph| interpret::answers(&graph, &states)).map_err(EvaluationError::new)
        };
        let (whole, registers) = (answers(policy)?, usize::from(policy.registers));
        let lines = (policy.programs.iter().enumerate()).flat_map(|(program, lines)| {
            let effective = effective(registers, lines).into_iter().enumerate();
            effective.filter(|(_, effective)| *effective).map(move |(line, _)| (program, line))
        });
        let mut ranked = Vec::new();
        for place in lines {
            let answers = answers(&without(policy, &[place]))?;
            let change: f64 = whole.iter().zip(&answers).map(|(old, new)| distance(policy, old, new)).sum();
            ranked.push((change, place));
        }
        ranked.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        Ok(ranked.into_iter().map(|(_, place)| place).collect())
    }
}

/// Returns how far two answers of a policy are apart: actions 0 or 1, values by shares of their ranges.
fn distance(policy: &PolicyGraph, old: &Answer, new: &Answer) -> f64 {
    match (old, new) {
        (Answer::Values(old), Answer::Values(new)) => (old.iter().zip(new).zip(&policy.outputs))
            .map(|((old, new), limits)| (old - new).abs() / (limits.max - limits.min))
            .sum(),
        _ => f64::from(u8::from(old != new)),
    }
}

/// Returns a policy without some lines.
fn without(policy: &PolicyGraph, left_out: &[Place]) -> PolicyGraph {
    let mut policy = policy.clone();
    for (program, lines) in policy.programs.iter_mut().enumerate() {
        let stays = |(line, _): &(usize, _)| !left_out.contains(&(program, *line));
        *lines = lines.iter().enumerate().filter(stays).map(|(_, line)| *line).collect();
    }
    policy
}

#[cfg(test)]
mod tests {
    use super::{Place, distance, without};
    use tpg_engine::{Destination, Edge, Limits, Line, Operand, PolicyGraph};
    use tpg_graph::Word;
    use tpg_graph::interpret::Answer;

    #[test]
    fn lines_are_left_out_and_answers_have_a_distance() {
        let line = |input| Line {
            to: 0,
            instruction: Word::from_name("add").expect("a word"),
            operands: [Operand::Register(0), Operand::Input(input)],
        };
        let team = vec![Edge { program: 0, to: Destination::Action(0) }];
        let limits = Limits { min: -2.0, max: 2.0, nan: 0.0 };
        let policy = PolicyGraph::new(1, 0, vec![team], vec![vec![], (0..4).map(line).collect()])
            .with_outputs(vec![limits], vec![vec![1]]);
        let thinned = |places: &[Place]| without(&policy, places).lines();
        assert_eq!((thinned(&[]), thinned(&[(1, 0)]), thinned(&[(1, 3), (1, 1), (0, 2)])), (4, 3, 2));
        let far = |old, new| distance(&policy, &Answer::Values(vec![old]), &Answer::Values(vec![new]));
        assert_eq!((far(1.0, 1.0), far(-1.0, 1.0)), (0.0, 0.5));
    }
}
