//! Folders as runs leave them, read back.

mod broken;
mod machines;
mod shards;
mod support;
