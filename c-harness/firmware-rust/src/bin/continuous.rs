//! Policies that answer with values, one of them with memory, in closed loop with a pendulum, which is generated code, too:
//! a hash of every torque and observation, and the instructions of the policies.

#![no_std]
#![no_main]

use core::hint::black_box;
use cortex_m_rt::entry;
use tpg_firmware::{Counter, Tally, run};
use tpg_runtime::policy::Policy;

include!(concat!(env!("TPG_GENERATED"), "/starts.rs"));

/// Runs the episodes of a policy: `torque` answers what the pendulum shows.
fn episodes<M: Copy>(words: &str, counter: &mut Counter, initial: M, torque: impl Fn(&[f32; 3], &mut M) -> f32) {
    let mut tally = Tally::new();
    for &[angle, velocity, cos, sin, omega] in &STARTS {
        let (mut swing, mut seen) = ([angle, velocity], [cos, sin, omega]);
        let mut memory = initial;
        for _ in 0..STEPS {
            let (torque, count) = counter.measure(|| torque(black_box(&seen), &mut memory));
            tally.add(count);
            seen = plant::Plant.infer(&[torque], &mut swing);
            for value in [torque, seen[0], seen[1], seen[2]] {
                tally.hash.add(u64::from(value.to_bits()));
            }
        }
    }
    tally.print_with_hash(words);
}

#[entry]
fn main() -> ! {
    run(|counter| {
        macro_rules! without_memory {
            ($words:literal, $policy:expr) => {
                episodes($words, counter, (), |seen, ()| $policy.decide(seen)[0]);
            };
        }
        macro_rules! with_memory {
            ($words:literal, $module:ident :: $policy:ident) => {
                episodes($words, counter, $module::$policy::INITIAL, |seen, memory| {
                    $module::$policy.infer(&[seen[0], seen[1]], memory)[0]
                });
            };
        }
        without_memory!("cost swing fast", swing_fast::SwingFast);
        without_memory!("cost swing balanced", swing_balanced::SwingBalanced);
        without_memory!("cost swing small", swing_small::SwingSmall);
        without_memory!("cost swing constant", swing_constant::SwingConstant);
        with_memory!("cost recall fast", recall_fast::RecallFast);
        with_memory!("cost recall balanced", recall_balanced::RecallBalanced);
        with_memory!("cost recall small", recall_small::RecallSmall);
        with_memory!("cost recall constant", recall_constant::RecallConstant);
        Some(())
    })
}
