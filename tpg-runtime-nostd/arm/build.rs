//! Writes the quarter-wave sine tables: the values of `libm::sin` at the 1,025 motor positions of a quarter turn.
//!
//! The crate `libm` is plain Rust, so the tables are the same whatever machine builds them; a test recomputes them.

use std::fmt::Write as _;
use std::{env, error::Error, f64::consts::PI, fs, path::PathBuf};

const QUARTER: u32 = 1024;

fn main() -> Result<(), Box<dyn Error>> {
    println!("cargo::rerun-if-changed=build.rs");
    let sines = || (0..=QUARTER).map(|k| libm::sin(f64::from(k) * PI / f64::from(2 * QUARTER)));

    let mut text = String::new();
    writeln!(text, "static SINE_F32: [f32; {}] = [", QUARTER + 1)?;
    for sine in sines() {
        writeln!(text, "    {:?},", sine as f32)?;
    }
    writeln!(text, "];\nstatic SINE_F64: [f64; {}] = [", QUARTER + 1)?;
    for sine in sines() {
        writeln!(text, "    {sine:?},")?;
    }
    writeln!(text, "];")?;

    let out = PathBuf::from(env::var("OUT_DIR")?).join("sine.rs");
    fs::write(out, text)?;
    Ok(())
}
