//! OBJ, by the crate `tobj`.

use super::Mesh;
use super::build::Builder;
use super::sieve::{Seen, Sieve};
use crate::check::read::ReadError;
use tobj::{LoadError, LoadOptions};

/// Triangles only, one index a corner.
const OPTIONS: LoadOptions =
    LoadOptions { single_index: true, triangulate: true, ignore_points: true, ignore_lines: true };

/// What some editors write in front of a text in UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// Whether some line of a text begins as a vertex does.
pub(super) fn has_a_vertex(text: &[u8]) -> bool {
    text.split(|byte| *byte == b'\n').any(|line| line.starts_with(b"v "))
}

/// The mesh of all objects and groups in the file.
pub(super) fn read(file: &str, bytes: &[u8]) -> Result<Mesh, ReadError> {
    // With it the first vertex would not be one, and all faces would count from the second.
    let bytes = bytes.strip_prefix(BYTE_ORDER_MARK).unwrap_or(bytes);
    // The loader tells of an index that is too large when all the rest is built.
    let looked = Sieve::new(bytes).look();
    if looked.refused.is_some() || looked.largest.0 > looked.vertices as i64 {
        return Err(refusal(file, &looked, LoadError::FaceVertexOutOfBounds));
    }
    let mut sieve = Sieve::new(bytes);
    // Materials are never asked for: their lines do not pass the sieve.
    let loaded = tobj::load_obj_buf(&mut sieve, &OPTIONS, |_| Err(LoadError::GenericFailure));
    let seen = sieve.seen;
    let models = match loaded {
        Ok((models, _)) => models,
        Err(error) => return Err(refusal(file, &seen, error)),
    };
    let mut builder = Builder::default();
    builder.dropped = seen.dropped;
    for mesh in models.into_iter().map(|model| model.mesh) {
        for [x, y, z] in mesh.positions.as_chunks().0 {
            let line = || not_finite(bytes).unwrap_or(seen.line);
            builder.vertex([*x, *y, *z]).map_err(|message| bad(file, line(), message))?;
        }
        for corners in mesh.indices.as_chunks::<3>().0 {
            let face = builder.face(&corners.map(i64::from));
            face.map_err(|message| bad(file, seen.line, message))?;
        }
    }
    let mut mesh = builder.finish(file)?;
    mesh.dropped.vertices = seen.vertices.saturating_sub(mesh.vertices.len() as u64);
    Ok(mesh)
}

fn bad(file: &str, line: u64, message: String) -> ReadError {
    ReadError::Line { file: file.to_owned(), line, place: String::new(), message }
}

/// What is wrong: the sieve's own words, or the loader's with what is allowed.
fn refusal(file: &str, seen: &Seen, error: LoadError) -> ReadError {
    if let Some(message) = &seen.refused {
        return bad(file, seen.line, message.clone());
    }
    match error {
        LoadError::FaceVertexOutOfBounds => {
            let (index, line) = seen.largest;
            let count = seen.vertices;
            let message = format!("vertex {index} does not exist; allowed: 1 to {count}");
            bad(file, line, message)
        }
        LoadError::ReadError => bad(file, seen.line, "not UTF-8; allowed: UTF-8".into()),
        error => {
            let allowed = "'v x y z', with a weight other than 0 or a colour behind it, and 'f' \
                           with three or more vertices";
            bad(file, seen.line, format!("{error}; allowed: {allowed}"))
        }
    }
}

/// Line of the first vertex that f32 cannot hold.
fn not_finite(bytes: &[u8]) -> Option<u64> {
    let mut lines = (1u64..).zip(bytes.split(|byte| *byte == b'\n'));
    let bad = |line: &[u8]| {
        let text = String::from_utf8_lossy(line);
        let mut words = text.split_whitespace();
        let is_vertex = words.next() == Some("v");
        let numbers: Vec<f64> = words.map_while(|word| word.parse().ok()).collect();
        let weight = if numbers.len() == 4 { numbers[3] } else { 1.0 };
        is_vertex && numbers.iter().take(3).any(|x| !((x / weight) as f32).is_finite())
    };
    lines.find(|(_, line)| bad(line)).map(|(number, _)| number)
}
