//! STL, by the crate `stl_io`.
//!
//! It is told what the file is instead of guessing by its first word, and is handed one line at a
//! time, so that the place of an error is known.

use super::Mesh;
use super::build::Builder;
use super::load::shortened;
use super::stl_lines::Lines;
use crate::check::read::ReadError;
use crate::scene::weld::Weld;
use std::cell::Cell;
use std::io::{self, Cursor};

/// A name, which nothing reads.
const HEADER: usize = 80;
/// Header and number of triangles.
const START: usize = HEADER + 4;
/// Normal and three vertices as f32, and two bytes that nothing reads.
const TRIANGLE: u64 = 50;

/// What the lines of a text may be.
const FACETS: &str = "allowed: 'facet normal x y z', 'outer loop', three times 'vertex x y z' with \
                      finite numbers, 'endloop', 'endfacet', and at last 'endsolid'";

/// The length that the header of a binary file announces, bytes.
pub(super) fn announced(bytes: &[u8]) -> Option<u64> {
    let count = bytes.get(HEADER..START)?.try_into().ok().map(u32::from_le_bytes)?;
    Some(START as u64 + TRIANGLE * u64::from(count))
}

/// A binary file.
pub(super) fn read_binary(file: &str, mut bytes: Vec<u8>) -> Result<Mesh, ReadError> {
    let whole = |message: String| ReadError::Whole { file: file.to_owned(), message };
    let length = bytes.len() as u64;
    match announced(&bytes) {
        Some(announced) if announced == length => {}
        Some(announced) => {
            let count = (announced - START as u64) / TRIANGLE;
            return Err(whole(format!(
                "{length} bytes, but byte {HEADER} announces {count} triangles; allowed: \
                 {announced} bytes"
            )));
        }
        None => return Err(whole(format!("{length} bytes; allowed: at least {START}"))),
    }
    // A name that begins with `solid` would make the loader take it for text.
    bytes[..HEADER].fill(b' ');
    let mut solids = Solids::default();
    let mut cursor = Cursor::new(bytes);
    let reader = stl_io::create_stl_reader(&mut cursor);
    let triangles = reader.map_err(|error| whole(shortened(&error.to_string())))?;
    for (index, triangle) in triangles.enumerate() {
        let added = triangle.map_err(|error| error.to_string()).and_then(|t| solids.add(&t));
        added.map_err(|message| whole(format!("triangle {index}: {message}")))?;
    }
    solids.builder.finish(file)
}

/// A file of text: one solid, or several in a row.
pub(super) fn read_ascii(file: &str, bytes: &[u8]) -> Result<Mesh, ReadError> {
    let number = Cell::new(0);
    let bad = |message: String| {
        let (file, place) = (file.to_owned(), String::new());
        ReadError::Line { file, line: number.get(), place, message }
    };
    let unlike = |error: io::Error| bad(format!("{}; {FACETS}", shortened(&error.to_string())));
    let mut solids = Solids::default();
    let mut rest = bytes;
    while !rest.trim_ascii_start().is_empty() {
        let Some(mut lines) = Lines::new(rest, &number) else {
            return Err(bad("allowed: 'solid' and a name, or a binary file".into()));
        };
        let reader = stl_io::create_stl_reader(&mut lines);
        let triangles = reader.map_err(unlike)?;
        for triangle in triangles {
            let triangle = triangle.map_err(unlike)?;
            solids.add(&triangle).map_err(bad)?;
        }
        let rounded = lines.rounded;
        let dropped = &mut solids.builder.dropped;
        dropped.coordinates_rounded += rounded.coordinates_rounded;
        dropped.largest_rounding = dropped.largest_rounding.max(rounded.largest_rounding);
        rest = lines.rest;
    }
    solids.builder.finish(file)
}

/// Triangles so far, those that meet joined at their corners.
#[derive(Default)]
struct Solids {
    builder: Builder,
    weld: Weld,
}

impl Solids {
    fn add(&mut self, triangle: &stl_io::Triangle) -> Result<(), String> {
        let mut corners = [0; 3];
        for (corner, vertex) in corners.iter_mut().zip(triangle.vertices) {
            let (index, is_new) = self.weld.index(vertex.0.into());
            if is_new {
                self.builder.vertex(vertex.0.map(f64::from))?;
            }
            *corner = i64::from(index);
        }
        self.builder.face(&corners)
    }
}
