//! Policies that answer with values, one of them with memory, in closed loop with a pendulum, which is generated code, too:
//! a hash of every torque and observation, and the instructions of the policies.

#![no_std]
#![no_main]

mod platform;
#[path = "../../src/record.rs"]
mod record;
mod report;

use core::hint::black_box;
use cortex_m_rt::entry;
use platform::Counter;
use record::Hash;
use report::Report;
use tpg_runtime::policy::Policy;

include!(concat!(env!("TPG_GENERATED"), "/starts.rs"));

/// Runs the episodes of a policy: `torque` answers what the pendulum shows.
fn run<M: Copy>(words: &str, counter: &mut Counter, initial: M, torque: impl Fn(&[f32; 3], &mut M) -> f32) {
    let (mut instructions, mut worst, mut actions, mut hash) = (0_u32, 0_u32, 0_u32, Hash::new());
    for &(mut swing, mut seen) in &STARTS {
        let mut memory = initial;
        for _ in 0..STEPS {
            let (torque, count) = counter.measure(|| torque(black_box(&seen), &mut memory));
            instructions += count;
            worst = worst.max(count);
            actions += 1;
            seen = plant::Plant.infer(&[torque], &mut swing);
            for value in [torque, seen[0], seen[1], seen[2]] {
                hash.add(u64::from(value.to_bits()));
            }
        }
    }
    Report::new(words)
        .unsigned("actions", actions)
        .unsigned("instructions", instructions)
        .unsigned("worst", worst)
        .hexadecimal("hash", hash.0)
        .print();
}

#[entry]
fn main() -> ! {
    let stack = platform::paint_stack();
    let Some(peripherals) = cortex_m::Peripherals::take() else { platform::exit(false) };
    let mut counter = Counter::new(peripherals.SYST);
    macro_rules! without_memory {
        ($words:literal, $policy:expr) => {
            run($words, &mut counter, (), |seen, ()| $policy.decide(seen)[0]);
        };
    }
    macro_rules! with_memory {
        ($words:literal, $module:ident :: $policy:ident) => {
            run($words, &mut counter, $module::$policy::INITIAL, |seen, memory| {
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
    Report::new("done").unsigned("stack", platform::stack_used(stack)).print();
    platform::exit(true)
}
