//! What surfaces look like.

use glam::DVec3;

/// A surface. Shares are from 0 to 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Share of red, green and blue light that is thrown back to all sides (Lambert).
    pub colour: DVec3,
    /// Strength of highlights (Blinn).
    pub shine: f64,
    /// How small highlights are: the cosine to the power of 2 to this.
    pub sharpness: u32,
    /// Share that a mirror would show.
    pub mirror: f64,
    /// Shines by itself, in its colour.
    pub glows: bool,
}

impl Material {
    /// Neither shiny nor a mirror.
    pub const fn matt(red: f64, green: f64, blue: f64) -> Self {
        let colour = DVec3::new(red, green, blue);
        Material { colour, shine: 0.0, sharpness: 0, mirror: 0.0, glows: false }
    }

    /// With highlights, and that much of a mirror.
    pub const fn polished(red: f64, green: f64, blue: f64, mirror: f64) -> Self {
        Material { shine: 0.5, sharpness: 5, mirror, ..Material::matt(red, green, blue) }
    }
}
