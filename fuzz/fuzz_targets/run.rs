//! See `probewright_fuzz::run`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| probewright_fuzz::run(bytes, probewright_fuzz::Extent::Drawn));
