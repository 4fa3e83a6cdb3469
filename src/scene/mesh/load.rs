//! Which format a file has, and the mesh that it holds.

use super::{Mesh, obj, ply, stl};
use crate::check::read::ReadError;
use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Largest file, bytes: it is held in memory while it is read, with a mesh of about its size.
const LARGEST: u64 = 1 << 30;
/// So much of a file tells text from other bytes.
const START: usize = 4096;
/// What the formats are, for messages.
const ALLOWED: &str = "OBJ, PLY (ascii or binary), STL (ascii or binary)";

/// Formats of meshes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Format {
    /// Wavefront's text; it has no mark of its own.
    Obj,
    /// The Stanford format: text or binary behind a header of text.
    Ply,
    /// Stereolithography, text.
    StlAscii,
    /// Stereolithography, binary.
    StlBinary,
}

impl Format {
    /// By the content, and by the ending of the name where the content leaves it open.
    fn of(name: &str, bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(b"ply\n") || bytes.starts_with(b"ply\r") {
            return Some(Format::Ply);
        }
        // Binary files may begin with `solid`, too; their length is what tells.
        if stl::announced(bytes).is_some_and(|announced| announced == bytes.len() as u64) {
            return Some(Format::StlBinary);
        }
        let start = &bytes[..bytes.len().min(START)];
        let is_text = !start.contains(&0);
        if is_text && bytes.trim_ascii_start().starts_with(b"solid") {
            return Some(Format::StlAscii);
        }
        let ending = Path::new(name).extension().and_then(|ending| ending.to_str());
        match ending.map(str::to_ascii_lowercase).as_deref() {
            Some("ply") => Some(Format::Ply),
            Some("stl") => Some(if is_text { Format::StlAscii } else { Format::StlBinary }),
            Some("obj") => Some(Format::Obj),
            _ => (is_text && obj::has_a_vertex(start)).then_some(Format::Obj),
        }
    }
}

/// The mesh in a file.
///
/// # Errors
/// What is wrong with the file, where, and what is allowed.
pub fn load(path: &str) -> Result<Mesh, ReadError> {
    let failed = |source| ReadError::Io { file: path.to_owned(), source };
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(failed)?;
    // One byte more than is allowed shows that there are more.
    file.take(LARGEST + 1).read_to_end(&mut bytes).map_err(failed)?;
    read(path, bytes)
}

/// The mesh in the bytes of a file; `file` is its name, for its ending and for messages.
///
/// # Errors
/// As [`load`].
pub fn read(file: &str, bytes: Vec<u8>) -> Result<Mesh, ReadError> {
    let whole = |message: String| ReadError::Whole { file: file.to_owned(), message };
    if bytes.is_empty() {
        return Err(whole(format!("the file is empty; allowed: {ALLOWED}")));
    }
    if bytes.len() as u64 > LARGEST {
        return Err(whole(format!("the file is too large; allowed: {LARGEST} bytes")));
    }
    match Format::of(file, &bytes) {
        Some(Format::Obj) => obj::read(file, &bytes),
        Some(Format::Ply) => ply::read(file, &bytes),
        Some(Format::StlAscii) => stl::read_ascii(file, &bytes),
        Some(Format::StlBinary) => stl::read_binary(file, bytes),
        None => Err(whole(format!("the format is unknown; allowed: {ALLOWED}"))),
    }
}

/// Text for a message: the first line of what a loader says, not too long, without what a terminal
/// would take for a command.
pub(super) fn shortened(text: &str) -> String {
    const LONGEST: usize = 120;
    let line = text.lines().next().unwrap_or_default().trim_end_matches('.');
    let visible = line.chars().map(|c| if c.is_control() { '?' } else { c });
    let short: String = visible.take(LONGEST).collect();
    if short.len() < line.len() { format!("{short}...") } else { short }
}
