//! Many pairs of links in parallel, eight at a time.

use super::{Acrobot, Angles, Links, Physics, moved, wrapped};
use crate::circle::sincos;
use crate::eights::ByEight;
use core::f64::consts::PI;

impl ByEight<8> for Acrobot {
    type State = Links;

    const OBSERVED: &[usize] = &[6, 4, 7, 5, 2, 3];
    const ROUNDS: bool = true;

    fn numbers(links: &Links) -> [f64; 8] {
        links.0
    }

    fn episode(numbers: [f64; 8]) -> Links {
        Links(numbers)
    }

    #[inline(always)]
    fn step_many<const L: usize>(
        numbers: &mut [[f64; L]; 8],
        acts: &[f64; L],
        rewards: &mut [f64; L],
        ended: &mut [bool; L],
    ) {
        let mut torques = *acts;
        torques.iter_mut().for_each(|torque| *torque -= 1.0);
        *ended = moved::<L, Several>(&Physics::STANDARD, numbers, &torques);
        rewards.iter_mut().zip(ended).for_each(|(reward, ended)| *reward = if *ended { 0.0 } else { -1.0 });
    }
}

/// The angles of several pairs of links.
struct Several;

impl<const L: usize> Angles<L> for Several {
    #[inline(always)]
    fn wrap(angles: &mut [f64; L]) {
        let (far, mut any_is_far) = (*angles, false);
        for angle in &mut *angles {
            let (less, more) = (*angle - 2.0 * PI, *angle + 2.0 * PI);
            *angle = if *angle > PI { less } else { *angle };
            *angle = if *angle < -PI { more } else { *angle };
            any_is_far |= (*angle > PI) | (*angle < -PI);
        }
        // Few are further away than one turn.
        if any_is_far {
            angles.iter_mut().zip(far).for_each(|(angle, far)| *angle = wrapped(far));
        }
    }

    #[inline(always)]
    fn sincos(angles: &[f64; L]) -> [[f64; L]; 2] {
        sincos(angles)
    }
}

#[cfg(test)]
mod tests {
    use super::{Angles, Several, wrapped};
    use crate::Acrobot;
    use crate::tests::lanes::{policy, same_as_one_by_one};
    use core::f64::consts::PI;
    use tpg_engine::Operand;
    use tpg_runtime::ops::Instruction;

    #[test]
    fn eight_angles_are_wrapped_as_one() {
        let turns = (-9..=9).map(|half| f64::from(half) * PI);
        let near = |angle: f64| (0..50).map(move |bit| f64::from_bits(angle.to_bits() ^ 1 << bit));
        let angles: Vec<f64> = turns.flat_map(near).chain((-900..900).map(|step| f64::from(step) * 0.0137)).collect();
        for eight in angles.as_chunks::<8>().0.iter().chain(&[[f64::NAN, 0.0, -0.0, 1.0, -1.0, 4.0, -4.0, 0.5]]) {
            let bits = |angles: [f64; 8]| angles.map(|angle| if angle.is_nan() { 0 } else { angle.to_bits() });
            let mut near = *eight;
            Several::wrap(&mut near);
            assert_eq!(bits(near), bits(eight.map(wrapped)), "{eight:?}");
        }
    }

    #[test]
    fn eight_pairs_swing_as_one() {
        let [sin_2, omega_1, omega_2] = [3, 4, 5].map(Operand::Input);
        let mut ends = Vec::new();
        for operands in [[omega_1, omega_2], [omega_2, sin_2], [sin_2, Operand::Constant(0.1)]] {
            ends.extend(same_as_one_by_one(Acrobot, &policy(Instruction::Sub, operands, 3)));
        }
        ends.extend(same_as_one_by_one(Acrobot, &policy(Instruction::Mul, [omega_1, Operand::Constant(1.0)], 3)));
        assert!(ends.iter().any(|ending| ending.outcome == 0) && ends.iter().any(|ending| ending.outcome == 1));
    }
}
