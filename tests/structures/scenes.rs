//! What is hard for structures: shared edges and vertices, faces in planes of cells, triangles without
//! area, large ones; rays along axes and in planes, at vertices, from inside and from far away.

use glam::Vec3;
use ray_test::workload::{Pcg, Ray, Triangle};

/// Triangles, and rays at them.
pub struct Scene {
    pub triangles: Vec<Triangle>,
    pub rays: Vec<Ray>,
}

/// All of them.
pub fn all() -> Vec<Scene> {
    let mut pcg = Pcg::new(21);
    [cube(), soup(&mut pcg, 0.2), soup(&mut pcg, 1.0), fan()]
        .into_iter()
        .map(|triangles| Scene { rays: rays(&mut pcg, &triangles), triangles })
        .collect()
}

/// A closed cube of whole numbers, and triangles without area on it.
fn cube() -> Vec<Triangle> {
    let mut triangles = Vec::new();
    for axis in 0..3 {
        for height in [-2.0, 2.0] {
            for square in 0..16 {
                let at = |x: i32, y: i32| {
                    let mut place = [height; 3];
                    place[(axis + 1) % 3] = (square % 4 - 2 + x) as f32;
                    place[(axis + 2) % 3] = (square / 4 - 2 + y) as f32;
                    Vec3::from(place)
                };
                let (a, b, c, d) = (at(0, 0), at(1, 0), at(1, 1), at(0, 1));
                triangles.extend([Triangle { a, b, c }, Triangle { a, b: c, c: d }]);
            }
            let a = Vec3::from([height; 3]);
            triangles.extend([Triangle { a, b: a, c: a }, Triangle { a, b: -a, c: a * 0.5 }]);
        }
    }
    triangles
}

fn point(pcg: &mut Pcg) -> Vec3 {
    let mut number = || (pcg.unit_f64() * 2.0 - 1.0) as f32;
    Vec3::new(number(), number(), number())
}

fn soup(pcg: &mut Pcg, size: f32) -> Vec<Triangle> {
    let mut one = || {
        let place = point(pcg);
        let [a, b, c] = [(); 3].map(|()| place + point(pcg) * size);
        Triangle { a, b, c }
    };
    (0..150).map(|_| one()).collect()
}

/// Needles around one vertex, in a plane and out of it; every other twice.
fn fan() -> Vec<Triangle> {
    let tip = |index: i32| {
        let (x, y) = (index - 32, 64 - (index - 32).abs());
        Vec3::new(x as f32, y as f32, if index % 3 == 0 { 1.0 } else { 0.0 }) / 32.0
    };
    let needle = |index: i32| Triangle { a: Vec3::ZERO, b: tip(index), c: tip(index + 1) };
    (0..64).chain((0..64).step_by(2)).map(needle).collect()
}

fn rays(pcg: &mut Pcg, triangles: &[Triangle]) -> Vec<Ray> {
    let mut one = |kind: u64| {
        let aim = triangles[pcg.below(triangles.len() as u64) as usize];
        let target = match pcg.below(3) {
            0 => aim.a,
            1 => (aim.b + aim.c) * 0.5,
            _ => (aim.a + aim.b + aim.c) / 3.0,
        };
        let axis = Vec3::AXES[pcg.below(3) as usize] * if pcg.below(2) == 0 { 1.0 } else { -1.0 };
        let (origin, direction) = match kind {
            0 => (target + axis * 8.0, -axis),
            1 => (target - axis * 8.0, axis + Vec3::AXES[pcg.below(3) as usize]),
            2 => (target, point(pcg)),
            3 => (point(pcg) * 300.0, Vec3::ZERO),
            4 => (point(pcg) * 0.5, Vec3::ZERO),
            _ => (point(pcg) * 4.0, Vec3::ZERO),
        };
        let way = target - origin;
        let direction = if direction == Vec3::ZERO { way } else { direction };
        let t_max = if pcg.below(4) == 0 { 9.0 } else { f32::MAX };
        Ray { origin, direction, end: target + way, t_min: 0.0, t_max }
    };
    (0..96).map(|index| one(index % 7)).collect()
}
