//! The shipped policy of CartPole in every profile, in closed loop with the cart and its pole, which are generated code, too: a hash
//! of every push and observation, and the instructions of the policy.

#![no_std]
#![no_main]

use core::hint::black_box;
use cortex_m_rt::entry;
use tpg_firmware::{Counter, Tally, run};
use tpg_runtime::policy::{ActionId, Policy};

include!(concat!(env!("TPG_GENERATED"), "/poles.rs"));

/// Runs the episodes of a profile.
fn episodes(words: &str, counter: &mut Counter, policy: impl Policy<State = [f32; 4], Action = ActionId>) {
    let mut tally = Tally::new();
    for start in &STARTS {
        // What is remembered is what is seen.
        let mut seen = *start;
        for _ in 0..STEPS {
            let (ActionId(push), count) = counter.measure(|| policy.decide(black_box(&seen)));
            tally.add(count);
            let shown = cart::Cart.infer(&[f32::from(push)], &mut seen);
            tally.hash.add(u64::from(push));
            shown.iter().for_each(|value| tally.hash.add(u64::from(value.to_bits())));
        }
    }
    tally.print_with_hash(words);
}

#[entry]
fn main() -> ! {
    run(|counter| {
        episodes("cost pole fast", counter, pole_fast::PoleFast);
        episodes("cost pole balanced", counter, pole_balanced::PoleBalanced);
        episodes("cost pole small", counter, pole_small::PoleSmall);
        episodes("cost pole constant", counter, pole_constant::PoleConstant);
        Some(())
    })
}
