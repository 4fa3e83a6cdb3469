//! See `doors::cases`.
#![no_main]

#[path = "../../parsers/doors/mod.rs"]
mod doors;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| doors::cases(bytes));
