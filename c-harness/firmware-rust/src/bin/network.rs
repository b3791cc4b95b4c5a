//! A network of another problem than the arm's on recorded observations: a hash of its values' bits.

#![no_std]
#![no_main]

use core::hint::black_box;
use cortex_m::singleton;
use cortex_m_rt::entry;
use tpg_firmware::{Tally, run};
use tpg_runtime::net::Model;

include!(concat!(env!("TPG_GENERATED"), "/observations.rs"));

#[entry]
fn main() -> ! {
    run(|counter| {
        let Ok(model) = Model::parse(&WORDS) else { return None };
        let Some(scratch) = singleton!(: [u32; SCRATCH] = [0; SCRATCH]) else { return None };
        let mut tally = Tally::new();
        for state in &OBSERVATIONS {
            let mut values = [0f32; OUTPUTS];
            let (asked, count) = counter.measure(|| model.values(black_box(state), scratch, &mut values));
            if !asked {
                return None;
            }
            tally.add(count);
            values.iter().for_each(|value| tally.hash.add(u64::from(value.to_bits())));
        }
        tally.print_with_hash("answers pendulum");
        Some(())
    })
}
