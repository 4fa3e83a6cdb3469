//! Thesis B's random pairs, in its order of draws.

use super::{Generator, QueryKind, Ray, Triangle, Unit, WorkloadError};
use glam::Vec3;

/// Draws thesis B's pairs one after the other and hands each on as it falls, with no regard to
/// rounding (tables 4.5 and 4.7 count a million of them). The query is the line.
///
/// # Errors
/// [`WorkloadError::Seed`] for a seed that the generator cannot hold.
pub fn draw_pairs(
    generator: Generator,
    seed: u64,
    count: usize,
    mut take: impl FnMut(Ray, Triangle),
) -> Result<(), WorkloadError> {
    let mut source = generator.start(seed)?;
    for _ in 0..count {
        let (ray, triangle) = draw(&mut source, QueryKind::Line);
        take(ray, triangle);
    }
    Ok(())
}

/// One pair: vertices a, b, c, origin and end in this order, each x, y, z uniform in the unit cube.
pub(super) fn draw(source: &mut impl Unit, query: QueryKind) -> (Ray, Triangle) {
    let a = point(source);
    let b = point(source);
    let c = point(source);
    let origin = point(source);
    let end = point(source);
    (query.ray(origin, end), Triangle { a, b, c })
}

/// A point of the unit cube.
pub(super) fn point(source: &mut impl Unit) -> Vec3 {
    // One statement a draw: the order of draws is part of the workload.
    let x = source.unit();
    let y = source.unit();
    let z = source.unit();
    Vec3::new(x, y, z)
}

/// Length in f32, by plain sums and a square root (a vector type's own may fuse or reorder).
pub(super) fn length(v: Vec3) -> f32 {
    (v.x * v.x + v.y * v.y + v.z * v.z).sqrt()
}

/// `v / |v|`; 0 for a vector whose length is 0.
pub(crate) fn normalised(v: Vec3) -> Vec3 {
    let length = length(v);
    if length > 0.0 { Vec3::new(v.x / length, v.y / length, v.z / length) } else { Vec3::ZERO }
}

#[cfg(test)]
mod tests {
    use super::super::hash;
    use super::*;
    use crate::oracle::{Query, classify};

    /// Thesis B, table 4.5: 120 720 of a million pairs are line hits; a simulation of four
    /// million gives 12.09 %.
    #[test]
    fn the_share_of_line_hits_is_the_published_one() {
        for generator in [Generator::Pcg, Generator::Msvc] {
            let n = 1_000_000.0f64;
            let mut hits = 0.0f64;
            draw_pairs(generator, 11, 1_000_000, |ray, triangle| {
                hits += f64::from(u8::from(classify(&Query::of(&ray, &triangle)).is_hit()));
            })
            .unwrap();
            let (share, published) = (hits / n, 0.120_720);
            // Five standard errors of the difference of two million-draw samples.
            let tolerance = 5.0 * (2.0 * published * (1.0 - published) / n).sqrt();
            assert!((share - published).abs() < tolerance, "{generator:?} {share} {tolerance}");
        }
    }

    #[test]
    fn draws_are_golden() {
        let of = |generator| {
            let (mut rays, mut triangles) = (Vec::new(), Vec::new());
            draw_pairs(generator, 1, 1000, |ray, triangle| {
                rays.push(ray);
                triangles.push(triangle);
            })
            .unwrap();
            hash::workload(&rays, &triangles)
        };
        // Computed a second time from the definitions alone, in another language.
        let golden = [8_274_285_535_274_014_220, 2_164_952_581_424_765_224];
        assert_eq!([of(Generator::Pcg), of(Generator::Msvc)], golden);
    }
}
