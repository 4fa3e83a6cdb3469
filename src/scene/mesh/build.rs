//! A mesh as it is read: vertex by vertex, face by face.

use super::{Dropped, Mesh};
use crate::check::read::ReadError;
use glam::Vec3;

/// The part of a mesh that was read so far.
#[derive(Default)]
pub(super) struct Builder {
    vertices: Vec<Vec3>,
    triangles: Vec<[u32; 3]>,
    /// What was left out so far.
    pub(super) dropped: Dropped,
}

impl Builder {
    /// Adds a vertex; else says what is wrong with it.
    pub(super) fn vertex(&mut self, coordinates: [f64; 3]) -> Result<(), String> {
        if self.vertices.len() >= u32::MAX as usize {
            return Err(format!("too many vertices; allowed: {}", u32::MAX));
        }
        for (axis, x) in ["x", "y", "z"].into_iter().zip(coordinates) {
            if !(x as f32).is_finite() {
                let most = f32::MAX;
                return Err(format!("{axis} is {x}; allowed: numbers from -{most:e} to {most:e}"));
            }
            self.dropped.rounds(x);
        }
        self.vertices.push(Vec3::from_array(coordinates.map(|x| x as f32)));
        Ok(())
    }

    /// Adds a face, a fan around its first corner; else says which corner is no vertex.
    pub(super) fn face(&mut self, corners: &[i64]) -> Result<(), String> {
        let count = self.vertices.len();
        let known = |index: &i64| u32::try_from(*index).ok().filter(|i| (*i as usize) < count);
        let Some(indices) = corners.iter().map(known).collect::<Option<Vec<u32>>>() else {
            let wrong = corners.iter().find(|index| known(index).is_none()).unwrap_or(&-1);
            let last = count.saturating_sub(1);
            return Err(format!("vertex {wrong} does not exist; allowed: 0 to {last}"));
        };
        match indices.as_slice() {
            [first, rest @ ..] if rest.len() >= 2 => {
                self.dropped.polygons += u64::from(rest.len() > 2);
                let fan = rest.windows(2).map(|pair| [*first, pair[0], pair[1]]);
                self.triangles.extend(fan);
            }
            _ => self.dropped.faces += 1,
        }
        Ok(())
    }

    /// The mesh, if there is a triangle.
    pub(super) fn finish(self, file: &str) -> Result<Mesh, ReadError> {
        if self.triangles.is_empty() {
            let vertices = self.vertices.len();
            let message = format!("{vertices} vertices, no face; allowed: at least one triangle");
            return Err(ReadError::Whole { file: file.to_owned(), message });
        }
        Ok(Mesh {
            name: file.to_owned(),
            vertices: self.vertices,
            triangles: self.triangles,
            dropped: self.dropped,
            view: None,
        })
    }
}
