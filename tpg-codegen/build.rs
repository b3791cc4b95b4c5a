//! Tells the program which machine it is built for: what it generates is compiled for the same one.

use std::env;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-env=TPG_HOST={}", env::var("TARGET").expect("cargo sets TARGET"));
}
