//! Many pendulums in parallel, eight at a time.

use super::{ACTIONS, Pendulum, Physics, Swing, moved, wrapped};
use crate::circle::sincos;
use core::f64::consts::{PI, TAU};
use fearless_simd::{Level, dispatch};
use tpg_engine::{Acts, End, Ending, Environment, Episodes, EvaluationError, SourceSet, View};
use tpg_runtime::scalar::Scalar;

/// The lanes of [`Pendulum`].
pub(super) struct Swings {
    eights: Vec<Eight>,
    lanes: usize,
    level: Level,
}

/// Eight episodes.
#[derive(Clone, Default)]
struct Eight {
    angle: [f64; 8],
    velocity: [f64; 8],
    sine: [f64; 8],
    cosine: [f64; 8],
    score: [f64; 8],
    actions: [u32; 8],
}

impl Eight {
    fn get(&self, lane: usize) -> (Swing, f64, u32) {
        let Self { angle, velocity, sine, cosine, score, actions } = self;
        let [angle, velocity, sine, cosine] = [angle, velocity, sine, cosine].map(|values| values[lane]);
        (Swing { angle, velocity, sine, cosine }, score[lane], actions[lane])
    }

    fn set(&mut self, lane: usize, (swing, score, actions): (Swing, f64, u32)) {
        self.angle[lane] = swing.angle;
        self.velocity[lane] = swing.velocity;
        self.sine[lane] = swing.sine;
        self.cosine[lane] = swing.cosine;
        self.score[lane] = score;
        self.actions[lane] = actions;
    }

    #[inline(always)]
    fn step(&mut self, torques: &[f32; 8]) {
        let Self { angle, velocity, sine, cosine, score, actions } = self;
        let mut off = [0.0; 8];
        wrap(angle, &mut off);
        let moments = angle.iter_mut().zip(velocity).zip(&*sine).zip(off).zip(torques).zip(score);
        for (((((angle, velocity), &sine), off), &torque), score) in moments {
            let cost;
            (cost, *angle, *velocity) = moved(&Physics::STANDARD, (*angle, *velocity, sine), off, torque);
            *score -= cost;
        }
        actions.iter_mut().for_each(|actions| *actions += 1);
        sincos(angle, sine, cosine);
    }
}

/// A turn in two parts: times a whole number below 2048, each is exact.
const TAU_HIGH: f64 = f64::from_bits(TAU.to_bits() & !0x7ff);
const TAU_LOW: f64 = TAU - TAU_HIGH;

/// Writes what [`wrapped`] makes of each angle.
///
/// Below 2048 the remainder is exact: whole turns are taken off in two parts, both differences are multiples of 2⁻⁵⁰ below 8,
/// and where the quotient was rounded up to a whole number, the turn too many is put back.
#[inline(always)]
fn wrap(angles: &[f64; 8], off: &mut [f64; 8]) {
    let mut any_is_far = false;
    for (off, &angle) in off.iter_mut().zip(angles) {
        let turned = angle + PI;
        any_is_far |= (turned.abs() >= 2048.0) | turned.is_nan();
        let turns = (turned / TAU).trunc();
        let rest = (turned - turns * TAU_HIGH) - turns * TAU_LOW;
        *off = if rest < 0.0 { rest + TAU } else { rest } - PI;
    }
    if any_is_far {
        off.iter_mut().zip(angles).for_each(|(off, &angle)| *off = wrapped(angle));
    }
}

impl Swings {
    pub(super) fn new() -> Self {
        Self { eights: Vec::new(), lanes: 0, level: Level::new() }
    }

    #[inline(always)]
    fn step_in_vectors<S: Scalar>(&mut self, values: &[S]) {
        for (eight, values) in self.eights.iter_mut().zip(values.chunks(8)) {
            let mut torques = [0.0; 8];
            torques.iter_mut().zip(values).for_each(|(torque, value)| *torque = value.to_f64() as f32);
            eight.step(&torques);
        }
    }
}

impl<S: Scalar> Episodes<S, [f64; 2]> for Swings {
    fn begin(&mut self, lane: usize, task: &[f64; 2]) -> Result<(), EvaluationError> {
        self.lanes = self.lanes.max(lane + 1);
        self.eights.resize_with(self.lanes.div_ceil(8), Eight::default);
        self.eights[lane / 8].set(lane % 8, (Environment::<S>::start(&Pendulum, task), 0.0, 0));
        Ok(())
    }

    fn step(&mut self, acts: Acts<'_, S>, ended: &mut Vec<(usize, Ending)>) -> Result<(), EvaluationError> {
        let values = acts.values();
        dispatch!(self.level, _ => self.step_in_vectors(values));
        for lane in (0..self.lanes).filter(|lane| self.eights[lane / 8].actions[lane % 8] >= ACTIONS) {
            let (swing, score, actions) = self.eights[lane / 8].get(lane % 8);
            let End { outcome, success, measure, .. } = Environment::<S>::timeout(&Pendulum, &swing);
            ended.push((lane, Ending { outcome, success, score, measure, actions }));
        }
        Ok(())
    }

    fn keys(&self) -> &[u64] {
        &[]
    }

    fn cycle(&self, _lane: usize, _key: u64, _actions: u32) -> Option<Ending> {
        None
    }

    fn observe(&mut self, _wanted: SourceSet, view: &mut View<'_, S>) -> Result<(), EvaluationError> {
        let sources: [fn(&Eight) -> &[f64; 8]; 3] =
            [|eight| &eight.cosine, |eight| &eight.sine, |eight| &eight.velocity];
        for (input, source) in sources.into_iter().enumerate() {
            if let Some(column) = view.column(input) {
                for (slots, eight) in column.as_flattened_mut().chunks_exact_mut(8).zip(&self.eights) {
                    slots.iter_mut().zip(source(eight)).for_each(|(slot, value)| *slot = S::from_f64(*value));
                }
            }
        }
        Ok(())
    }

    fn close_up(&mut self, lane: usize) {
        self.lanes -= 1;
        let last = self.eights[self.lanes / 8].get(self.lanes % 8);
        self.eights[lane / 8].set(lane % 8, last);
        self.eights.truncate(self.lanes.div_ceil(8));
    }
}

#[cfg(test)]
mod tests {
    use super::{wrap, wrapped};
    use crate::Pendulum;
    use core::f64::consts::PI;
    use tpg_engine::random::{Purpose, Stream};
    use tpg_engine::{Destination, Edge, EngineOptions, Environment, Lanes, Limits, Line, Operand, Plan, PolicyGraph};
    use tpg_runtime::ops::{Instruction, Maths, Own};
    use tpg_runtime::scalar::Scalar;

    /// An environment with the lanes that every problem has.
    struct Usual<E>(E);

    impl<S: Scalar, E: Environment<S>> Environment<S> for Usual<E> {
        type Task = E::Task;
        type Episode = E::Episode;

        tpg_engine::forward!(this => this.0; sources actions outcomes time_limit timeout draw start observe step);
    }

    /// A policy whose torque is one operation on two operands.
    fn policy(instruction: Instruction, operands: [Operand; 2]) -> PolicyGraph {
        let team = vec![Edge { program: 0, to: Destination::Action(0) }];
        let line = Line { to: 0, instruction: instruction.into(), operands };
        let limits = Limits { min: -2.0, max: 2.0, nan: 0.0 };
        PolicyGraph::new(1, 0, vec![team], vec![vec![line]]).with_outputs(vec![limits], vec![vec![0]])
    }

    fn scores<S: Scalar, E: Environment<S, Task = [f64; 2]>>(
        environment: &E,
        policy: &PolicyGraph,
        lanes: usize,
    ) -> Vec<u64>
    where
        Own: Maths<S>,
    {
        let options = EngineOptions { lanes, ..EngineOptions::default() };
        let plan = Plan::new::<Own>(policy, &environment.sources(), options);
        let draw = |index| environment.draw(&mut Stream::new(1, 0, Purpose::Test, index));
        let tasks: Vec<[f64; 2]> = (0..30).map(draw).collect();
        let endings = Lanes::<S, Own, _>::new(environment, options).run(&plan, &tasks).expect("nothing fails");
        endings.iter().map(|ending| ending.score.to_bits() ^ u64::from(ending.actions) << 1).collect()
    }

    #[test]
    fn eight_angles_are_wrapped_as_one() {
        let turns = (-400..400).map(|turn| f64::from(turn) * PI);
        let near = |angle: f64| (0..50).map(move |bit| f64::from_bits(angle.to_bits() ^ 1 << bit));
        let angles: Vec<f64> = turns.flat_map(near).chain((-9000..9000).map(|step| f64::from(step) * 0.37)).collect();
        for eight in angles.as_chunks::<8>().0 {
            let mut off = [0.0; 8];
            wrap(eight, &mut off);
            assert_eq!(off.map(f64::to_bits), eight.map(|angle| wrapped(angle).to_bits()), "{eight:?}");
        }
    }

    #[test]
    fn eight_at_once_swing_as_one() {
        let [cosine, sine, velocity] = [0, 1, 2].map(Operand::Input);
        let same = |policy: &PolicyGraph| {
            for lanes in [1, 7, 8, 19, 112] {
                assert_eq!(
                    scores::<f32, _>(&Pendulum, policy, lanes),
                    scores::<f32, _>(&Usual(Pendulum), policy, lanes)
                );
                assert_eq!(
                    scores::<f64, _>(&Pendulum, policy, lanes),
                    scores::<f64, _>(&Usual(Pendulum), policy, lanes)
                );
            }
        };
        // The first goes round and round.
        same(&policy(Instruction::Add, [velocity, Operand::Constant(2.0)]));
        same(&policy(Instruction::Sub, [sine, velocity]));
        same(&policy(Instruction::Mul, [cosine, velocity]));
    }
}
