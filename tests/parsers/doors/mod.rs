//! One function for each thing that the program reads: bytes in, as a user's file or command line has them, and
//! through the same code that the verbs use, past reading to whatever is made of it before anything is measured.
//! What is refused is refused; nothing may panic, hang, or ask for more memory than its input is worth.
#![allow(dead_code, reason = "each fuzzed program needs one of them")]

mod folder;
mod lines;
mod meshes;
mod papers;
#[path = "../../support/picture.rs"]
mod picture;
mod rows;

pub use lines::{arguments, cases, config, rays};
pub use meshes::{obj, ply, stl};
pub use papers::papers;
pub use rows::{report, rows_json, stored};

/// Reads bytes.
pub type Door = fn(&[u8]);

/// All of them, by the names of their folders of files.
pub const ALL: [(&str, Door); 11] = [
    ("arguments", arguments),
    ("config", config),
    ("cases", cases),
    ("rays", rays),
    ("stored", stored),
    ("rows_json", rows_json),
    ("report", report),
    ("obj", obj),
    ("ply", ply),
    ("stl", stl),
    ("papers", papers),
];
