//! Names what the target's core can do: `cfg(target_feature = "dsp")` is not there in stable Rust.

use std::env;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let target = env::var("TARGET").unwrap_or_default();
    let have = |name| println!("cargo::rustc-cfg={name}");
    // Their assembly is for words whose first byte is the lowest.
    match target.split('-').next().unwrap_or_default() {
        "thumbv6m" | "thumbv8m.base" => have("tpg_thumb1"),
        "thumbv7m" | "thumbv8m.main" => have("tpg_thumb2"),
        // Armv7E-M is Armv7-M with the DSP extension.
        "thumbv7em" => {
            have("tpg_thumb2");
            have("tpg_dsp");
            if target.ends_with("-eabihf") {
                have("tpg_fpu");
            }
        }
        riscv if riscv.starts_with("riscv32") => have("tpg_scalar"),
        _ => {}
    }
}
