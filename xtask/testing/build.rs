//! Passes the target triple to the program.

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rustc-env=XTASK_HOST={}", std::env::var("TARGET").unwrap_or_default());
}
