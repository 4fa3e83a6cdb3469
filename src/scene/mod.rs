//! Meshes, the rays that are asked of them, and what both are like: what can be left out of a test
//! without changing an answer is read off here.
//!
//! ```text
//! file, or a name ─> Mesh ─┬─> Rays (camera, shadow, ambient, random, a file) ─┐
//!                          └───────────────────────────────────────────────────┴─> Looks
//! ```

pub mod bounds;
pub mod built_in;
pub mod look;
pub mod mesh;
mod open;
pub mod rays;
mod weld;

pub use open::open;
