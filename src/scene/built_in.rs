//! Scenes that are computed, not stored: the same on every machine, since only + - * / and square
//! roots of f32 are used.

mod cornell_box;
mod cuboid;
mod icosphere;
mod needle_sphere;
mod room_far;
mod shape;
mod soup;
mod terrain;
#[cfg(test)]
mod tests;

use super::mesh::{Dropped, Mesh, View};
use crate::check::read::ReadError;
use shape::Shape;

/// A scene with a size.
pub struct BuiltIn {
    /// Its word, before the colon.
    pub name: &'static str,
    /// What it is.
    pub about: &'static str,
    /// What the number behind the colon is.
    pub size: &'static str,
    /// The size where none is given.
    pub usual: u32,
    /// Smallest and largest size.
    pub sizes: [u32; 2],
    build: fn(u32) -> (Shape, Option<View>),
}

/// All of them.
pub const ALL: [BuiltIn; 6] = [
    cornell_box::CORNELL_BOX,
    icosphere::ICOSPHERE,
    needle_sphere::NEEDLE_SPHERE,
    terrain::TERRAIN,
    soup::SOUP,
    room_far::ROOM_FAR,
];

/// The scene that `text` names, as `icosphere` or `icosphere:5`; `None` if it names none.
///
/// # Errors
/// For a size that is no number, or not allowed.
pub fn named(text: &str) -> Option<Result<Mesh, ReadError>> {
    let (name, size) = match text.split_once(':') {
        Some((name, size)) => (name, Some(size)),
        None => (text, None),
    };
    let scene = ALL.iter().find(|scene| scene.name == name)?;
    let [least, most] = scene.sizes;
    let size = size.map_or(Some(scene.usual), |size| size.parse().ok());
    Some(match size.filter(|size| (least..=most).contains(size)) {
        Some(size) => Ok(scene.mesh(text, size)),
        None => {
            let what = scene.size;
            let message = format!("allowed behind the colon: {least} to {most} ({what})");
            Err(ReadError::Whole { file: text.to_owned(), message })
        }
    })
}

impl BuiltIn {
    fn mesh(&self, name: &str, size: u32) -> Mesh {
        let (shape, view) = (self.build)(size);
        let Shape { vertices, triangles } = shape;
        Mesh { name: name.to_owned(), vertices, triangles, dropped: Dropped::default(), view }
    }
}
