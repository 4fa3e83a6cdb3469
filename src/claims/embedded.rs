//! The ledger's files, which the program carries with it; `build.rs` lists them, so that a new file
//! needs no line of code.

include!(concat!(env!("OUT_DIR"), "/papers.rs"));
