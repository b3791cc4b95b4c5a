#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| tpg_fuzzing::settings::urdf(data));
