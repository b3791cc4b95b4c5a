//! A network of another problem than the arm's on recorded observations: a hash of its values' bits.

#![no_std]
#![no_main]

mod platform;
#[path = "../../src/record.rs"]
mod record;
mod report;

use core::hint::black_box;
use cortex_m::singleton;
use cortex_m_rt::entry;
use platform::Counter;
use record::Hash;
use report::Report;
use tpg_runtime::net::Model;

include!(concat!(env!("TPG_GENERATED"), "/observations.rs"));

#[entry]
fn main() -> ! {
    let stack = platform::paint_stack();
    let Some(peripherals) = cortex_m::Peripherals::take() else { platform::exit(false) };
    let mut counter = Counter::new(peripherals.SYST);
    let Ok(model) = Model::parse(&WORDS) else { platform::exit(false) };
    let Some(scratch) = singleton!(: [u32; SCRATCH] = [0; SCRATCH]) else { platform::exit(false) };
    let (mut instructions, mut worst, mut hash) = (0u32, 0u32, Hash::new());
    for state in &OBSERVATIONS {
        let mut values = [0f32; OUTPUTS];
        let (asked, count) = counter.measure(|| model.values(black_box(state), scratch, &mut values));
        if !asked {
            platform::exit(false);
        }
        instructions += count;
        worst = worst.max(count);
        values.iter().for_each(|value| hash.add(u64::from(value.to_bits())));
    }
    Report::new("actions pendulum")
        .unsigned("observations", OBSERVATIONS.len() as u32)
        .unsigned("instructions", instructions)
        .unsigned("worst", worst)
        .hexadecimal("hash", hash.0)
        .print();
    Report::new("done").unsigned("stack", platform::stack_used(stack)).print();
    platform::exit(true)
}
