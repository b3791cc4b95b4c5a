//! Many pendulums in parallel, eight at a time.

use super::{Pendulum, Physics, Swing, moved, wrapped};
use crate::circle::sincos;
use crate::eights::ByEight;
use core::f64::consts::{PI, TAU};

/// Angle, velocity, sine and cosine.
impl ByEight<4> for Pendulum {
    type State = Swing;

    const OBSERVED: &[usize] = &[3, 2, 1];
    const ROUNDS: bool = false;

    fn numbers(&Swing { angle, velocity, sine, cosine }: &Swing) -> [f64; 4] {
        [angle, velocity, sine, cosine]
    }

    fn episode([angle, velocity, sine, cosine]: [f64; 4]) -> Swing {
        Swing { angle, velocity, sine, cosine }
    }

    #[inline(always)]
    fn step_many<const L: usize>(
        numbers: &mut [[f64; L]; 4],
        torques: &[f64; L],
        rewards: &mut [f64; L],
        _ended: &mut [bool; L],
    ) {
        let [angle, velocity, sine, cosine] = numbers;
        let mut off = [0.0; L];
        wrap(angle, &mut off);
        let moments = angle.iter_mut().zip(velocity).zip(&*sine).zip(off).zip(torques).zip(rewards);
        for (((((angle, velocity), &sine), off), &torque), reward) in moments {
            let cost;
            (cost, *angle, *velocity) = moved(&Physics::STANDARD, (*angle, *velocity, sine), off, torque as f32);
            *reward = -cost;
        }
        [*sine, *cosine] = sincos(angle);
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
fn wrap<const L: usize>(angles: &[f64; L], off: &mut [f64; L]) {
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

#[cfg(test)]
mod tests {
    use super::{wrap, wrapped};
    use crate::Pendulum;
    use crate::tests::lanes::{policy, same_as_one_by_one};
    use core::f64::consts::PI;
    use tpg_engine::Operand;
    use tpg_runtime::ops::Instruction;

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
        // The first goes round and round.
        same_as_one_by_one(Pendulum, &policy(Instruction::Add, [velocity, Operand::Constant(2.0)], 0));
        same_as_one_by_one(Pendulum, &policy(Instruction::Sub, [sine, velocity], 0));
        same_as_one_by_one(Pendulum, &policy(Instruction::Mul, [cosine, velocity], 0));
    }
}
