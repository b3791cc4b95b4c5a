//! The shipped policy of CartPole in every profile, in closed loop with the cart and its pole, which are generated code, too: a hash
//! of every push and observation, and the instructions of the policy.

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
use tpg_runtime::policy::{ActionId, Policy};

include!(concat!(env!("TPG_GENERATED"), "/poles.rs"));

/// Runs the episodes of a profile.
fn run(words: &str, counter: &mut Counter, policy: impl Policy<State = [f32; 4], Action = ActionId>) {
    let (mut instructions, mut worst, mut actions, mut hash) = (0_u32, 0_u32, 0_u32, Hash::new());
    for start in &STARTS {
        // What is remembered is what is seen.
        let mut seen = *start;
        for _ in 0..STEPS {
            let (ActionId(push), count) = counter.measure(|| policy.decide(black_box(&seen)));
            instructions += count;
            worst = worst.max(count);
            actions += 1;
            let shown = cart::Cart.infer(&[f32::from(push)], &mut seen);
            hash.add(u64::from(push));
            shown.iter().for_each(|value| hash.add(u64::from(value.to_bits())));
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
    run("cost pole fast", &mut counter, pole_fast::PoleFast);
    run("cost pole balanced", &mut counter, pole_balanced::PoleBalanced);
    run("cost pole small", &mut counter, pole_small::PoleSmall);
    run("cost pole constant", &mut counter, pole_constant::PoleConstant);
    Report::new("done").unsigned("stack", platform::stack_used(stack)).print();
    platform::exit(true)
}
