//! A control loop as a task of RTIC: a generated policy drives, a network helps, the arm goes to a target.
//!
//! On a real arm [`Motors`] talks to the servos; here it is a model of them.

#![no_std]
#![no_main]

use rtic_monotonics::systick::prelude::*;
use tpg_arm::{Arm, Move, Pose, WIDOWX};

systick_monotonic!(Mono, 1000);

static ARM: Arm<f32> = WIDOWX.to_f32();

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

#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    cortex_m_semihosting::hprintln!("panicked");
    cortex_m_semihosting::debug::exit(cortex_m_semihosting::debug::EXIT_FAILURE);
    loop {
        cortex_m::asm::nop();
    }
}

#[rtic::app(device = lm3s6965, dispatchers = [GPIOA, GPIOB], peripherals = true)]
mod app {
    use super::{ARM, Mono, Motors};
    use cortex_m_semihosting::{debug, hprintln};
    use rtic_monotonics::systick::prelude::*;
    use tpg_arm::binding;
    use tpg_arm::cycle::Brent;
    use tpg_arm::hybrid::{Control, Hybrid};
    use tpg_arm::observation::{ArmPolicy, Observation};
    use tpg_arm::sac::packed::{Model, PackedPolicy};
    use tpg_arm::sensors::Watch;
    use tpg_generated::{widowx_fs_fast::WidowxFsFast, widowx_fs_hybrid, widowx_sac};

    type Network = PackedPolicy<'static, { widowx_sac::SCRATCH }>;

    const TOLERANCE_MM: f32 = 3.0;
    const MOST_STEPS: u32 = 1707;

    #[shared]
    struct Shared {
        target: [f32; 3],
    }

    #[local]
    struct Local {
        motors: Motors,
    }

    #[init]
    fn init(context: init::Context) -> (Shared, Local) {
        Mono::start(context.core.SYST, 12_000_000);
        // Both are free: neither runs yet.
        let _ = aim::spawn();
        let _ = control::spawn();
        (Shared { target: [0.0; 3] }, Local { motors: Motors { ticks: ARM.home } })
    }

    /// Somebody who wants the hand somewhere.
    #[task(priority = 2, shared = [target])]
    async fn aim(mut context: aim::Context) {
        context.shared.target.lock(|target| *target = [-250.0, 239.0, 267.0]);
    }

    /// A decision each millisecond, until the hand is there.
    #[task(priority = 1, shared = [target], local = [motors])]
    async fn control(mut context: control::Context) {
        let motors = context.local.motors;
        let target = context.shared.target.lock(|target| *target);
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
        let Ok(mut state) = Control::new(&ARM, settings, Watch::DEFAULT, Brent::new(), &seen) else {
            return debug::exit(debug::EXIT_FAILURE);
        };
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
            Mono::delay(1.millis()).await;
        }
        let [base, shoulder, elbow, wrist] = motors.read().0;
        hprintln!("stopped actions={} base={} shoulder={} elbow={} wrist={}", actions, base, shoulder, elbow, wrist);
        hprintln!("done");
        debug::exit(debug::EXIT_SUCCESS);
    }
}
