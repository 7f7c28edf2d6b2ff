//! See `probewright_fuzz::read`.
#![no_main]

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| probewright_fuzz::read(bytes, probewright_fuzz::Extent::Drawn));
