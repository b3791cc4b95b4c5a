#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| tpg_fuzzing::settings::tpg_config(data));
