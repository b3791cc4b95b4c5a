//! A control loop as a task of Embassy: a generated policy drives, a network helps, the arm goes to a target.
//!
//! On a real arm [`Motors`] talks to the servos; here it is a model of them. On a chip that Embassy has a HAL for, its time driver takes
//! the place of the one on SysTick.

#![no_std]
#![no_main]

use cortex_m_semihosting::{debug, hprintln};
use embassy_executor::Spawner;
use embassy_sync::blocking_mutex::raw::ThreadModeRawMutex;
use embassy_sync::signal::Signal;
use embassy_time::{Duration, Ticker};
use systick_timer::SystickDriver;
use tpg_arm::binding;
use tpg_arm::cycle::Brent;
use tpg_arm::hybrid::{Control, Hybrid};
use tpg_arm::observation::{ArmPolicy, Observation};
use tpg_arm::sac::packed::{Model, PackedPolicy};
use tpg_arm::sensors::{Limits, Watch};
use tpg_arm::{Arm, Move, Pose, WIDOWX};
use tpg_generated::{widowx_fs_fast::WidowxFsFast, widowx_fs_hybrid, widowx_sac};

type Network = PackedPolicy<'static, { widowx_sac::SCRATCH }>;

const CLOCK_HZ: u64 = 12_000_000;
const TOLERANCE_MM: f32 = 3.0;
const MOST_STEPS: u32 = 1707;

static ARM: Arm<f32> = WIDOWX.to_f32();

/// The target of the hand.
static TARGET: Signal<ThreadModeRawMutex, [f32; 3]> = Signal::new();

// An interrupt each millisecond.
embassy_time_driver::time_driver_impl!(static TIME: SystickDriver<4> = SystickDriver::new(CLOCK_HZ, 11_999));

#[cortex_m_rt::exception]
fn SysTick() {
    TIME.systick_interrupt();
}

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    hprintln!("panicked");
    debug::exit(debug::EXIT_FAILURE);
    loop {
        cortex_m::asm::nop();
    }
}

/// The servos: what they are told, and where they are.
struct Motors {
    ticks: Pose,
}

impl Motors {
    fn read(&self) -> Pose {
        self.ticks
    }

    fn write(&mut self, wanted: Move) {
        self.ticks = ARM.step(self.ticks, wanted).pose;
    }
}

#[embassy_executor::main]
async fn main(spawner: Spawner) {
    let (Some(mut core), Ok(control), Ok(aim)) = (cortex_m::Peripherals::take(), control(), aim()) else {
        return debug::exit(debug::EXIT_FAILURE);
    };
    TIME.start(&mut core.SYST);
    spawner.spawn(control);
    spawner.spawn(aim);
}

/// Somebody who wants the hand somewhere.
#[embassy_executor::task]
async fn aim() {
    TARGET.signal([-250.0, 239.0, 267.0]);
}

/// A decision each millisecond, until the hand is there.
#[embassy_executor::task]
async fn control() {
    let mut motors = Motors { ticks: ARM.home };
    let target = TARGET.wait().await;
    let Some(sac) = Model::parse(&widowx_sac::MODEL).ok().and_then(|model| Network::new(&ARM, model)) else {
        return debug::exit(debug::EXIT_FAILURE);
    };
    let tpg = ArmPolicy::new(
        WidowxFsFast,
        &ARM,
        &const { binding::sources(WidowxFsFast::SOURCES) },
        &const { binding::moves(WidowxFsFast::MOVES) },
    );
    let settings = widowx_fs_hybrid::SETTINGS;
    let hybrid = Hybrid { arm: &ARM, tpg, sac, settings };
    let seen = Observation::at(&ARM, motors.read(), target);
    let Ok(mut state) = Control::new(Limits::new(&ARM), settings, Watch::DEFAULT, Brent::new(), &seen) else {
        return debug::exit(debug::EXIT_FAILURE);
    };
    let mut tick = Ticker::every(Duration::from_millis(1));
    let mut actions = 0u32;
    for _ in 0..MOST_STEPS {
        // A reading that cannot be moves nothing; the next one may be good.
        if let Ok((seen, chosen)) = hybrid.step(&mut state, motors.read(), target) {
            if seen.distance() < TOLERANCE_MM {
                break;
            }
            motors.write(chosen.wanted);
            actions += 1;
        }
        tick.next().await;
    }
    let [base, shoulder, elbow, wrist] = motors.read().0;
    hprintln!("stopped actions={} base={} shoulder={} elbow={} wrist={}", actions, base, shoulder, elbow, wrist);
    hprintln!("done");
    debug::exit(debug::EXIT_SUCCESS);
}
