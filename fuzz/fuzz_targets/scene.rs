#![no_main]

libfuzzer_sys::fuzz_target!(|input: &[u8]| mdr_fuzz::scene(input));
