//! The materials of built-in scenes; files have one for all.

use super::material::Material;
use crate::workload::Triangle;
use glam::Vec3;

const WHITE: Material = Material::matt(0.75, 0.75, 0.72);
const RED: Material = Material::matt(0.70, 0.13, 0.10);
const GREEN: Material = Material::matt(0.16, 0.50, 0.14);
const LAMP: Material = Material { glows: true, ..Material::matt(1.0, 0.97, 0.88) };
const STEEL: Material = Material::polished(0.35, 0.40, 0.45, 0.6);
const CLAY: Material = Material::polished(0.72, 0.42, 0.25, 0.0);
const GRASS: Material = Material::matt(0.40, 0.50, 0.25);
const BLUE: Material = Material::polished(0.15, 0.35, 0.65, 0.15);
const USUAL: Material = Material::polished(0.60, 0.62, 0.66, 0.1);

/// The material of a triangle in the scene of that name (as the user wrote it, with or without a size).
/// Told by where the triangle is, which does not change with the scene's size.
pub(super) fn surface(scene: &str, triangle: &Triangle) -> Material {
    match scene.split(':').next() {
        Some("cornell-box") => cornell_box(triangle),
        Some("room-far") => room_far(triangle),
        Some("terrain") => GRASS,
        Some("icosphere") => BLUE,
        Some("needle-sphere") => CLAY,
        _ => USUAL,
    }
}

/// Whether all corners have this coordinate.
fn is_at(triangle: &Triangle, axis: usize, place: f32) -> bool {
    [triangle.a, triangle.b, triangle.c].iter().all(|corner| corner[axis] == place)
}

fn middle(triangle: &Triangle) -> Vec3 {
    (triangle.a + triangle.b + triangle.c) / 3.0
}

/// Walls at the sides of the cube from -1 to 1, a lamp just below the ceiling, two blocks.
fn cornell_box(triangle: &Triangle) -> Material {
    let is_wall = (0..3).any(|axis| is_at(triangle, axis, -1.0) || is_at(triangle, axis, 1.0));
    match triangle {
        wall if is_at(wall, 0, -1.0) => RED,
        wall if is_at(wall, 0, 1.0) => GREEN,
        _ if is_wall => WHITE,
        lamp if is_at(lamp, 1, 0.99) => LAMP,
        // The blocks stand apart on either side of the plane across the way from one to the other.
        block if middle(block).x * 0.7 + middle(block).z * 0.65 < 0.01 => STEEL,
        _ => WHITE,
    }
}

/// A room of 4 x 3 x 5 at 10^5, where f32 numbers are 1/128 apart: the ball is the upper of its things.
fn room_far(triangle: &Triangle) -> Material {
    const PLACE: f32 = 1e5;
    let size = [4.0, 3.0, 5.0];
    let is_wall = (0..3)
        .any(|axis| is_at(triangle, axis, PLACE) || is_at(triangle, axis, PLACE + size[axis]));
    match triangle {
        floor if is_at(floor, 1, PLACE) => CLAY,
        _ if is_wall => WHITE,
        thing if middle(thing).y > PLACE + 1.0 => STEEL,
        _ => BLUE,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::open;

    /// How many triangles of a scene have each of the materials.
    fn counts<const COUNT: usize>(scene: &str, materials: [Material; COUNT]) -> [usize; COUNT] {
        let triangles = open(scene).expect("it is built in").list();
        let painted: Vec<Material> = triangles.iter().map(|one| surface(scene, one)).collect();
        let of = |wanted: Material| painted.iter().filter(|one| **one == wanted).count();
        let counts = materials.map(of);
        assert_eq!(counts.iter().sum::<usize>(), triangles.len(), "{scene} has other materials");
        counts
    }

    #[test]
    fn parts_of_scenes_have_their_materials_at_every_size() {
        for side in [1, 3, 8] {
            let square = 2 * side * side;
            // Two side walls, a lamp, five faces of the tall block; three walls and the other block.
            let box_of = counts(&format!("cornell-box:{side}"), [RED, GREEN, LAMP, STEEL, WHITE]);
            assert_eq!(box_of, [square, square, 2, 5 * square, 8 * square]);
            // The floor, five walls, the ball, the board.
            let room = counts(&format!("room-far:{side}"), [CLAY, WHITE, STEEL, BLUE]);
            assert_eq!(room, [square, 5 * square, 320, 6 * square]);
        }
        assert_eq!(counts("terrain", [GRASS]), [2 * 64 * 64]);
        assert_eq!(counts("soup:9", [USUAL]), [9]);
    }
}
