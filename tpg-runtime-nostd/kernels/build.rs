//! Names what the target's core can do: `cfg(target_feature = "dsp")` is not there in stable Rust.

use std::env;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let target = env::var("TARGET").unwrap_or_default();
    // Armv7E-M is Armv7-M with the DSP extension.
    if target.starts_with("thumbv7em-") {
        println!("cargo::rustc-cfg=tpg_dsp");
        if target.ends_with("-eabihf") {
            println!("cargo::rustc-cfg=tpg_fpu");
        }
    }
}
