//! The shipped policies in generated Rust, as `cargo xtask cores` asks them: a state in, the bits of the answer out. Beside them
//! [networks](layers).

#![cfg_attr(target_os = "none", no_std)]

pub mod layers;

use tpg_generated::acrobot::Acrobot;
use tpg_generated::bipedal_walker::BipedalWalker;
use tpg_generated::cartpole::Cartpole;
use tpg_generated::dodge::Dodge;
use tpg_generated::half_cheetah::HalfCheetah;
use tpg_generated::hopper::Hopper;
use tpg_generated::inverted_double_pendulum::InvertedDoublePendulum;
use tpg_generated::lunar_lander::LunarLander;
use tpg_generated::lunar_lander_continuous::LunarLanderContinuous;
use tpg_generated::mountain_car::MountainCar;
use tpg_generated::mountain_car_continuous::MountainCarContinuous;
use tpg_generated::pendulum::Pendulum;
use tpg_generated::swimmer::Swimmer;
use tpg_generated::widowx_fs::WidowxFs;
use tpg_generated::widowx_rs::WidowxRs;
use tpg_runtime::policy::{ActionId, Policy};

/// An answer, as words.
trait Bits<const N: usize> {
    fn bits(self) -> [u32; N];
}

impl Bits<1> for ActionId {
    fn bits(self) -> [u32; 1] {
        [u32::from(self.0)]
    }
}

impl<const N: usize> Bits<N> for [f32; N] {
    fn bits(self) -> [u32; N] {
        self.map(f32::to_bits)
    }
}

/// Exports policies: the name in C, the type, values of a state, words of an answer.
macro_rules! exported {
    ($($name:ident $policy:ident $inputs:literal $answers:literal)*) => {$(
        /// Answers a state.
        #[allow(unsafe_code, reason = "C finds it by this name")]
        #[unsafe(no_mangle)]
        pub extern "C" fn $name(state: &[f32; $inputs], bits: &mut [u32; $answers]) {
            *bits = $policy.decide(state).bits();
        }
    )*};
}

exported! {
    rust_acrobot Acrobot 6 1
    rust_bipedal_walker BipedalWalker 24 4
    rust_cartpole Cartpole 4 1
    rust_dodge Dodge 17 1
    rust_half_cheetah HalfCheetah 17 6
    rust_hopper Hopper 11 3
    rust_inverted_double_pendulum InvertedDoublePendulum 9 1
    rust_lunar_lander LunarLander 8 1
    rust_lunar_lander_continuous LunarLanderContinuous 8 2
    rust_mountain_car MountainCar 2 1
    rust_mountain_car_continuous MountainCarContinuous 2 1
    rust_pendulum Pendulum 3 1
    rust_swimmer Swimmer 8 2
    rust_widowx_fs WidowxFs 3 1
    rust_widowx_rs WidowxRs 5 1
}

/// A core without an operating system needs one; nothing here panics.
#[cfg(all(target_os = "none", not(test)))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
