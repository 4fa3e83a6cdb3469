//! A picture that shows where a kernel's answers differ from the exact ones.

use super::difference::{Difference, Way, of_any, of_nearest};
use super::exact::Exactly;
use super::picture::Picture;
use super::tracer::Tracer;
use crate::structure::Hit;
use crate::workload::Ray;
use glam::DVec3;

/// Differences of one kind.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// Rays.
    pub rays: u64,
    /// Those of them that rounding explains.
    pub excused: u64,
    /// Pixels, each counted once, for the first of the kinds that its rays have.
    pub pixels: u64,
}

/// The colour of a kind in pictures: of those of Okabe and Ito, 2008, which people with colour-blindness
/// tell apart: vermilion, blue, bluish green, orange, sky blue, and reddish purple.
pub fn colour(way: Way) -> DVec3 {
    let bytes = match way {
        Way::Crack => [213.0, 94.0, 0.0],
        Way::FalseHit => [0.0, 114.0, 178.0],
        Way::WrongTriangle => [0.0, 158.0, 115.0],
        Way::WrongDistance => [230.0, 159.0, 0.0],
        Way::Outline => [86.0, 180.0, 233.0],
        Way::Shadow => [204.0, 121.0, 167.0],
    };
    DVec3::from_array(bytes) / 255.0
}

/// A tracer whose every answer is held against the exact one about the same ray: so a ray in a mirror
/// counts by itself, whatever sent it there.
pub struct Compared<'a> {
    kernel: &'a mut dyn Tracer,
    exactly: Exactly<'a>,
    pixel: usize,
    /// The first kind of each pixel.
    ways: Vec<Option<Way>>,
    counts: [Count; Way::ALL.len()],
    first_wrong: Option<(usize, Way)>,
}

impl<'a> Compared<'a> {
    /// For a picture of so many pixels.
    pub fn new(kernel: &'a mut dyn Tracer, exactly: Exactly<'a>, pixels: usize) -> Self {
        let counts = [Count::default(); Way::ALL.len()];
        let ways = vec![None; pixels];
        Compared { kernel, exactly, pixel: 0, ways, counts, first_wrong: None }
    }

    /// Differences of a kind so far.
    pub fn count(&self, way: Way) -> Count {
        let pixels = self.ways.iter().filter(|one| **one == Some(way)).count() as u64;
        Count { pixels, ..self.counts[way as usize] }
    }

    /// Pixel and kind of the first difference that rounding does not explain.
    pub fn first_wrong(&self) -> Option<(usize, Way)> {
        self.first_wrong
    }

    /// The picture, pale, with the pixels that differ in the colours of their kinds, and half of that
    /// around each, so that single pixels are seen.
    pub fn painted(&self, picture: &Picture) -> Picture {
        let mut painted = picture.clone();
        let [columns, rows] = picture.size();
        // Grey, so that no colour is mistaken for a kind's; pale, so that all of them stand out.
        for pixel in painted.pixels_mut() {
            let grey = 0.3 * pixel.x + 0.6 * pixel.y + 0.1 * pixel.z;
            *pixel = DVec3::splat(0.6 + 0.4 * grey);
        }
        for row in 0..rows {
            for column in 0..columns {
                let own = self.ways[picture.index(column, row)];
                let pixel = &mut painted.pixels_mut()[picture.index(column, row)];
                match (own, self.nearby(picture, column, row)) {
                    (Some(way), _) => *pixel = colour(way),
                    (None, Some(way)) => *pixel = pixel.lerp(colour(way), 0.5),
                    (None, None) => {}
                }
            }
        }
        painted
    }

    /// The first kind of the pixels around one, up to eight of them.
    fn nearby(&self, picture: &Picture, column: u32, row: u32) -> Option<Way> {
        let [columns, rows] = picture.size();
        let around = |place: u32, count: u32| place.saturating_sub(1)..=(place + 1).min(count - 1);
        let of_row = |row| around(column, columns).map(move |column| (column, row));
        let pixels = around(row, rows).flat_map(of_row);
        pixels.filter_map(|(column, row)| self.ways[picture.index(column, row)]).min()
    }

    fn take(&mut self, difference: Option<Difference>) {
        let Some(Difference { way, is_excused }) = difference else { return };
        let count = &mut self.counts[way as usize];
        count.rays += 1;
        count.excused += u64::from(is_excused);
        let first = &mut self.ways[self.pixel];
        *first = Some(first.map_or(way, |other| other.min(way)));
        if !is_excused {
            self.first_wrong.get_or_insert((self.pixel, way));
        }
    }
}

impl Tracer for Compared<'_> {
    fn begin(&mut self, pixel: usize) {
        self.pixel = pixel;
        self.kernel.begin(pixel);
    }

    fn nearest(&mut self, ray: &Ray) -> Option<Hit> {
        let found = self.kernel.nearest(ray);
        let difference = of_nearest(found, ray, &mut self.exactly);
        self.take(difference);
        found
    }

    fn any(&mut self, ray: &Ray) -> bool {
        let found = self.kernel.any(ray);
        let difference = of_any(found, ray, self.kernel, &mut self.exactly);
        self.take(difference);
        found
    }

    fn triangles_tested(&self) -> u64 {
        self.kernel.triangles_tested()
    }
}
