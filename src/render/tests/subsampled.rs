//! Which pixels get a ray, and what the others show.

use super::*;
use crate::render::subsample::Sampler;
use glam::DVec3;

/// A picture of `size` by a rule, and the pixels that were traced, in their order.
fn sampled(
    size: [u32; 2],
    subsampling: Subsampling,
    rule: impl Fn(u32, u32) -> DVec3,
) -> (Picture, Vec<[u32; 2]>) {
    let mut picture = Picture::new(size);
    let mut traced = Vec::new();
    let mut sampler = Sampler::new(subsampling, &mut picture);
    for band in 0..sampler.bands() {
        sampler.band(band, &mut |column, row| {
            traced.push([column, row]);
            rule(column, row)
        });
    }
    (picture, traced)
}

fn every(grid: [u32; 2], tolerance: f64, interpolation: Interpolation) -> Subsampling {
    Subsampling { grid, tolerance, interpolation }
}

#[test]
fn without_tolerance_every_pixel_has_its_ray_once() {
    // All of one colour: only the tolerance can be what keeps it from being filled.
    for size in [[1, 1], [1, 9], [9, 1], [2, 2], [13, 8], [16, 16]] {
        for grid in [[1, 1], [4, 4], [7, 3], [100, 2], [u32::MAX, u32::MAX]] {
            let manner = every(grid, 0.0, Interpolation::Bilinear);
            let (picture, mut traced) = sampled(size, manner, |_, _| DVec3::ONE);
            assert!(picture.pixels().iter().all(|pixel| *pixel == DVec3::ONE), "{size:?} {grid:?}");
            traced.sort_unstable();
            let all = (0..size[0]).flat_map(|column| (0..size[1]).map(move |row| [column, row]));
            assert_eq!(traced, all.collect::<Vec<_>>(), "{size:?} {grid:?}");
        }
    }
}

#[test]
fn a_full_picture_and_one_without_tolerance_are_the_same() {
    let stage = Stage::new(&mesh(&[facing(0.0, 1.0), facing(-1.0, 2.0)]), [21, 14]);
    let full = picture(&stage, right(), FULL);
    let subsampling = every([8, 5], 0.0, Interpolation::Nearest);
    assert_eq!(picture(&stage, right(), Manner { subsampling, ..FULL }).picture, full.picture);
    assert_eq!(full.saved(), 0);
}

#[test]
fn beyond_all_differences_only_the_grid_is_traced_and_planes_come_out_exactly() {
    // Quarters of 1/64: every share, product and sum is exact.
    let plane = |column: u32, row: u32| {
        DVec3::new(f64::from(column), f64::from(row), f64::from(column + row)) / 64.0
    };
    let (picture, traced) = sampled([9, 13], every([4, 4], 2.0, Interpolation::Bilinear), plane);
    assert_eq!(traced.len(), 3 * 4);
    for row in 0..13 {
        for column in 0..9 {
            assert_eq!(picture.pixels()[picture.index(column, row)], plane(column, row));
        }
    }
    let (picture, _) = sampled([9, 13], every([4, 4], 2.0, Interpolation::Nearest), plane);
    assert_eq!(picture.pixels()[picture.index(1, 1)], plane(0, 0));
    assert_eq!(picture.pixels()[picture.index(3, 2)], plane(4, 4));
}

#[test]
fn an_edge_is_followed_and_flat_parts_are_saved() {
    let edge = |column: u32, _: u32| DVec3::splat(f64::from(u8::from(column >= 6)));
    let (picture, traced) = sampled([17, 17], every([8, 8], 0.5, Interpolation::Bilinear), edge);
    for row in 0..17 {
        for column in 0..17 {
            assert_eq!(picture.pixels()[picture.index(column, row)], edge(column, row));
        }
    }
    // Three columns of the grid, and the halves of the cells with the edge: 0, 4, 6 (its neighbours 5
    // and 6 differ), 8, and 16.
    assert!(traced.iter().all(|[column, _]| [0, 4, 5, 6, 8, 16].contains(column)), "{traced:?}");
    assert!(traced.len() < 17 * 6);
}
