//! Generated Rust behind C's calling convention, so that one program times both languages.

#[path = "timed.rs"]
mod policy;

use tpg_runtime::policy::{ActionId, Policy};

#[unsafe(no_mangle)]
pub extern "C" fn timed_infer(state: &[{{ scalar }}; {{ length }}]) -> u16 {
    let ActionId(action) = policy::{{ name }}.decide(state);
    action
}
