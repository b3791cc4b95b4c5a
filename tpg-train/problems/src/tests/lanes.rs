//! Comparison of lanes with episodes one by one.

use tpg_engine::random::{Purpose, Stream};
use tpg_engine::{Destination, Edge, Environment, EpisodeResult, Lanes, Limits, Line, Operand, Plan, PolicyGraph};
use tpg_runtime::ops::{Instruction, Maths, Own};
use tpg_runtime::scalar::Scalar;

/// An environment with the lanes that every problem has.
struct OneByOne<E>(E);

impl<S: Scalar, E: Environment<S>> Environment<S> for OneByOne<E> {
    type Task = E::Task;
    type Episode = E::Episode;

    tpg_engine::forward!(this => this.0; sources actions outcomes time_limit timeout draw start observe step);
}

/// Returns a policy whose output, or whose bid for the last of so many actions, is one operation on two operands; the bid for
/// the first is 0.
pub(crate) fn policy(instruction: Instruction, operands: [Operand; 2], actions: u16) -> PolicyGraph {
    let line = Line { to: 0, instruction: instruction.into(), operands };
    if actions > 0 {
        let edge = |action, program| Edge { program, to: Destination::Action(action) };
        return PolicyGraph::new(1, 0, vec![vec![edge(0, 0), edge(actions - 1, 1)]], vec![vec![], vec![line]]);
    }
    let team = vec![Edge { program: 0, to: Destination::Action(0) }];
    let limits = Limits { min: -2.0, max: 2.0, nan: 0.0 };
    PolicyGraph::new(1, 0, vec![team], vec![vec![line]]).with_outputs(vec![limits], vec![vec![0]])
}

/// Checks that episodes end as they do one by one, in any number of lanes; returns their endings.
pub(crate) fn same_as_one_by_one<E: Environment<f32> + Environment<f64> + Copy>(
    environment: E,
    policy: &PolicyGraph,
) -> Vec<EpisodeResult> {
    let single = endings::<f32, _>(&OneByOne(environment), policy, 1);
    let in_doubles = endings::<f64, _>(&OneByOne(environment), policy, 1);
    for lanes in [1, 7, 8, 19, 112] {
        assert_eq!(endings::<f32, _>(&environment, policy, lanes), single, "{lanes} lanes");
        assert_eq!(endings::<f64, _>(&environment, policy, lanes), in_doubles, "{lanes} lanes");
    }
    single.into_iter().map(|(ending, _)| ending).collect()
}

/// Returns the endings, and the bits of their scores: 0 and −0 are not the same.
fn endings<S: Scalar, E: Environment<S>>(
    environment: &E,
    policy: &PolicyGraph,
    lanes: usize,
) -> Vec<(EpisodeResult, u64)>
where
    Own: Maths<S>,
{
    let plan = Plan::new::<Own>(policy, &environment.sources());
    let draw = |index| environment.draw(&mut Stream::new(1, 0, Purpose::Test, index));
    let tasks: Vec<E::Task> = (0..30).map(draw).collect();
    let endings = Lanes::<S, Own, _>::new(environment, lanes).run(&plan, &tasks).expect("nothing fails");
    endings.into_iter().map(|ending| (ending, ending.score.to_bits())).collect()
}
