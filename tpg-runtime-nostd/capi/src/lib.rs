//! The C interface of [`tpg_runtime`]: `libtpg_runtime.a`, with `include/tpg_runtime.h`.
//!
//! Nothing is decided here. Every function checks its pointers, calls the runtime and writes what it answered. The
//! caller's memory holds everything: no heap, no variables, so that any number of arms, policies and episodes live side by
//! side. The header is made from this text by cbindgen; the comments of the items say what its users must know.
//!
//! | module | subject |
//! | --- | --- |
//! | [`code`] | the codes that functions answer |
//! | [`memory`] | pointers from C, checked; opaque structures |
//! | [`arm`] | the arm, forward kinematics, collisions, one step |
//! | [`observation`] | observations, and a graph's sources |
//! | [`memo`] | the parts of sources that depend on the target alone |
//! | [`policy`] | the hook for generated code |
//! | [`network`] | a network in integers, for any problem |
//! | [`sac`] | the arm's network in integers |
//! | [`hybrid`] | a generated policy and a network that share an arm |
//! | [`dodge`] | the control step of an arm among moving balls |
//! | [`sensors`] | the watch over motors, for control loops without a hybrid |

#![cfg_attr(target_os = "none", no_std)]
#![allow(non_camel_case_types, reason = "these are C's names")]

pub mod arm;
pub mod code;
pub mod dodge;
pub mod hybrid;
pub mod memo;
pub mod memory;
pub mod network;
pub mod observation;
pub mod policy;
pub mod sac;
pub mod sensors;

/// Version of this header.
pub const TPG_VERSION: u32 = 0x0000_0100;

/// Version of the library, for comparison with TPG_VERSION: major << 16, minor << 8, patch.
#[unsafe(no_mangle)]
pub extern "C" fn tpg_version() -> u32 {
    TPG_VERSION
}

/// A core without an operating system needs one. Nothing in the library panics: the linker leaves it out, and a test
/// looks for it.
#[cfg(all(target_os = "none", not(test)))]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    loop {
        core::hint::spin_loop();
    }
}
