//! Replay of all recorded episodes of a policy in lockstep, compared with the recording.
//!
//! Decisions come from an [`Engine`], which receives the states of all running episodes together, so that an engine in
//! another process costs one exchange per step instead of one per episode.

use super::binding::Binding;
use super::chain::Chain;
use super::data::{ByRow, End, Task};
use super::episode::{EndState, Episode, Rules};
use std::io;
use tpg_arm::Pose;
use tpg_graph::engine::Engine;
use tpg_graph::interpret::Answer;
use tpg_runtime::policy::ActionId;

/// A finished episode.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Done {
    /// The pose after each action.
    pub poses: Vec<Pose>,
    /// End state.
    pub end: EndState,
}

/// A running episode.
struct ReplayLane<'a> {
    row: u32,
    episode: Episode<'a>,
    poses: Vec<Pose>,
    over: bool,
}

/// Runs all tasks with an engine, in lockstep.
///
/// # Errors
/// If the engine fails, or gives an answer that no policy can give.
pub fn run(
    chain: &Chain,
    rules: Rules,
    tasks: &ByRow<Task>,
    binding: &Binding,
    engine: &mut dyn Engine,
) -> io::Result<ByRow<Done>> {
    let mut lanes: Vec<ReplayLane<'_>> = (tasks.iter())
        .map(|(&row, task)| ReplayLane {
            row,
            episode: Episode::new(chain, rules, task.start, task.target),
            poses: Vec::new(),
            over: false,
        })
        .collect();
    let mut states = Vec::new();
    loop {
        let mut live: Vec<&mut ReplayLane<'_>> = lanes.iter_mut().filter(|lane| !lane.over).collect();
        if live.is_empty() {
            break;
        }
        states.clear();
        live.iter().for_each(|lane| binding.push_state(lane.episode.observation(), &mut states));
        let actions = ask(engine, &states, live.len())?;
        for (lane, ActionId(action)) in live.iter_mut().zip(actions) {
            let wanted = *binding.moves.get(usize::from(action)).ok_or_else(|| {
                failed(engine, &format!("answered action {action} where the policy has no such action"))
            })?;
            lane.over = lane.episode.advance(wanted);
            lane.poses.push(lane.episode.observation().pose);
        }
    }
    Ok(lanes.into_iter().map(|lane| (lane.row, Done { poses: lane.poses, end: lane.episode.end_state() })).collect())
}

fn ask(engine: &mut dyn Engine, states: &[f64], count: usize) -> io::Result<Vec<ActionId>> {
    let mut answers = Vec::with_capacity(count);
    engine.answer(states, &mut answers).map_err(|error| failed(engine, &format!("failed: {error}")))?;
    let action = |answer| match answer {
        Answer::Action(action) => Some(action),
        Answer::Values(_) => None,
    };
    let actions: Vec<ActionId> = answers.into_iter().filter_map(action).collect();
    if actions.len() == count {
        return Ok(actions);
    }
    Err(failed(engine, &format!("answered {} actions where {count} states were given", actions.len())))
}

fn failed(engine: &dyn Engine, what: &str) -> io::Error {
    io::Error::other(format!("the engine {} {what}", engine.name()))
}

/// Result of comparing a replay with a recorded file.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Comparison {
    /// Number of recorded episodes.
    pub rows: usize,
    /// Number of episodes that are entirely equal.
    pub exact_rows: usize,
    /// Description of the first row that differs.
    pub first_difference: Option<String>,
}

impl Comparison {
    /// True if everything is equal.
    pub fn is_exact(&self) -> bool {
        self.exact_rows == self.rows
    }
}

/// Compares what was recorded of each episode with what was done.
pub fn compare<R>(
    recorded: &ByRow<R>,
    done: &ByRow<Done>,
    difference: impl Fn(&R, &Done) -> Option<String>,
) -> Comparison {
    let mut comparison = Comparison::default();
    for (row, recorded) in recorded {
        let replayed = done.get(row);
        let difference = replayed.map_or(Some("it was not replayed".to_owned()), |done| difference(recorded, done));
        comparison.rows += 1;
        comparison.exact_rows += usize::from(difference.is_none());
        let described = difference.map(|difference| format!("row {row}: {difference}"));
        comparison.first_difference = comparison.first_difference.or(described);
    }
    comparison
}

/// Describes the recorded columns of an end state that differ.
pub fn end_difference(recorded: &End, done: &Done) -> Option<String> {
    let (state, replayed) = (&recorded.state, &done.end);
    let columns = [
        ("score_x1000", state.score_x1000, replayed.score_x1000),
        ("distance_um", state.distance_um, replayed.distance_um),
        ("success", state.success.into(), replayed.success.into()),
        ("collision", state.collision.into(), replayed.collision.into()),
        ("nb_actions", state.actions.into(), replayed.actions.into()),
    ];
    // Every action of a replayed graph is the TPG's.
    let tpg_actions = recorded.tpg_actions.map(|n| ("nb_tpg_actions", i64::from(n), i64::from(replayed.actions)));
    let differences: Vec<String> = (columns.into_iter().chain(tpg_actions))
        .filter(|(_, recorded, replayed)| recorded != replayed)
        .map(|(name, recorded, replayed)| format!("{name} {replayed} instead of {recorded}"))
        .collect();
    (!differences.is_empty()).then(|| differences.join(", "))
}

#[cfg(test)]
mod tests {
    use super::{Done, compare, end_difference, run};
    use crate::binding::Binding;
    use crate::chain::Chain;
    use crate::data::{ByRow, End, Task};
    use crate::episode::{EndState, Rules};
    use std::io;
    use tpg_arm::observation::Source;
    use tpg_arm::{Joint, Move, Pose, WIDOWX};
    use tpg_graph::ScalarType;
    use tpg_graph::engine::Engine;
    use tpg_graph::interpret::Answer;
    use tpg_runtime::policy::ActionId;

    /// Decides with a function of the whole batch, and records the sizes of the batches.
    struct Scripted<F> {
        decide: F,
        batches: Vec<usize>,
    }

    impl<F: FnMut(&[f64]) -> io::Result<Vec<u16>>> Engine for Scripted<F> {
        fn name(&self) -> &str {
            "script"
        }

        fn answer(&mut self, states: &[f64], answers: &mut Vec<Answer>) -> io::Result<()> {
            self.batches.push(states.len() / 6);
            answers.extend((self.decide)(states)?.into_iter().map(|action| Answer::Action(ActionId(action))));
            Ok(())
        }
    }

    fn scripted<F: FnMut(&[f64]) -> io::Result<Vec<u16>>>(decide: F) -> Scripted<F> {
        Scripted { decide, batches: Vec::new() }
    }

    /// Three arms, 1, 2 and 3 steps below the base's limit.
    fn tasks() -> ByRow<Task> {
        let task = |n: i16| Task { start: Pose([4094 - 3 * n, 2048, 2048, 2048]), target: [0.0, 0.0, 1000.0] };
        [(5, task(1)), (6, task(2)), (9, task(3))].into_iter().collect()
    }

    fn replay(engine: &mut dyn Engine) -> io::Result<ByRow<Done>> {
        let moves = vec![Move::single(Joint(0), 3), Move::STOP];
        let binding = Binding { scalar: ScalarType::F64, sources: vec![Source::Servos], moves };
        let rules = Rules { max_actions: 100, tolerance: 3.0 };
        run(&Chain::new(WIDOWX), rules, &tasks(), &binding, engine)
    }

    #[test]
    fn rows_run_in_lockstep_until_each_is_over() {
        let mut engine = scripted(|states: &[f64]| Ok(vec![0; states.len() / 6]));
        let done = replay(&mut engine).unwrap();
        assert_eq!(engine.batches, [3, 3, 2, 1]);
        let actions: Vec<(u32, u32)> = done.iter().map(|(&row, done)| (row, done.end.actions)).collect();
        assert_eq!(actions, [(5, 2), (6, 3), (9, 4)]);
        assert!(done.values().all(|done| done.end.collision && done.poses.len() == done.end.actions as usize));
    }

    #[test]
    fn each_row_gets_the_answer_to_its_own_state() {
        // Only the arm that starts highest stops; its episode is over at once.
        let mut engine = scripted(|states: &[f64]| {
            Ok(states
                .chunks(6)
                .map(|servos| u16::from(servos == [4091.0, 2048.0, 2048.0, 2048.0, 512.0, 256.0]))
                .collect())
        });
        let done = replay(&mut engine).unwrap();
        let ends: Vec<(i16, u32)> = done.values().map(|done| (done.poses[0].0[0], done.end.actions)).collect();
        assert_eq!(ends, [(4091, 1), (4091, 2), (4088, 3)]);
    }

    #[test]
    fn what_differs_is_counted_and_described() {
        let [a, b] = [4091, 4094].map(|base| Pose([base, 2048, 2048, 2048]));
        let end = EndState { score_x1000: -9, distance_um: 9, success: false, collision: true, actions: 2 };
        let done: ByRow<Done> = [(7, Done { poses: vec![a, b], end })].into();
        let ends = |state: EndState, tpg_actions| {
            compare(&[(7, End { row: 7, state, tpg_actions })].into(), &done, end_difference)
        };
        assert!(ends(end, None).is_exact() && ends(end, Some(2)).is_exact());
        let other = ends(EndState { success: true, ..end }, Some(1));
        assert!(!other.is_exact());
        let difference = "row 7: success 0 instead of 1, nb_tpg_actions 2 instead of 1";
        assert_eq!(other.first_difference.as_deref(), Some(difference));
        let unknown = [(8, End { row: 8, state: end, tpg_actions: None })].into();
        assert!(!compare(&unknown, &done, end_difference).is_exact());
    }

    #[test]
    fn an_engine_that_fails_or_answers_nonsense_is_named() {
        let error = |engine: &mut dyn Engine| replay(engine).unwrap_err().to_string();
        let dead = error(&mut scripted(|_: &[f64]| Err(io::Error::other("it died"))));
        assert_eq!(dead, "the engine script failed: it died");
        let few = error(&mut scripted(|_: &[f64]| Ok(vec![0, 0])));
        assert_eq!(few, "the engine script answered 2 actions where 3 states were given");
        let unknown = error(&mut scripted(|_: &[f64]| Ok(vec![0, 2, 0])));
        assert_eq!(unknown, "the engine script answered action 2 where the policy has no such action");
    }
}
