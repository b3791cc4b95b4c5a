//! The arm, the arm among moving balls, a camera and three problems of classic control with their shipped policies, for a page.
//!
//! The module has no imports. A page calls the functions of [`exports`] and reads plain structures from the module's memory;
//! every decision is that of the generated code, every motion that of the simulation that trained it.
//!
//! # Map
//!
//! | module | subject |
//! | --- | --- |
//! | [`arm`] | four arms with one target: the hybrid's, the graph's, the network's, a classical planner's |
//! | [`balls`] | two arms among moving balls: the shipped policy's, and one that walks straight |
//! | [`control`] | CartPole, Pendulum and MountainCar, driven by their generated code |
//! | [`eye`] | a camera that follows a ball |
//! | [`exports`] | the functions that a page calls |

pub mod arm;
pub mod balls;
pub mod control;
pub mod exports;
pub mod eye;

/// The page's allocator: less code than the standard one, for the one thread of a page.
#[cfg(target_arch = "wasm32")]
#[allow(unsafe_code, reason = "a module without threads: nothing else can be calling")]
#[global_allocator]
static ALLOCATOR: lol_alloc::AssumeSingleThreaded<lol_alloc::FreeListAllocator> =
    unsafe { lol_alloc::AssumeSingleThreaded::new(lol_alloc::FreeListAllocator::new()) };
