//! Small pictures whose pixels are known.

mod compared;
mod pixels;
mod subsampled;

use super::*;
use crate::oracle::solve;
use crate::scene::mesh::{Dropped, Mesh, View};
use crate::structure::{Structure, kind};
use crate::workload::Triangle;
use glam::Vec3;

/// Every ray followed, a ray for every pixel.
const FULL: Manner =
    Manner { following: Following { depth: 3, casts_only: false }, subsampling: Subsampling::NONE };

/// Seen from (0, 0, 5) towards the origin, light from (0, 0, 4) and half of the way to it. `terrain`
/// has a matt surface.
fn mesh(triangles: &[[Vec3; 3]]) -> Mesh {
    let count = triangles.len() as u32;
    Mesh {
        name: "terrain".into(),
        vertices: triangles.concat(),
        triangles: (0..count).map(|one| [0, 1, 2].map(|corner| 3 * one + corner)).collect(),
        dropped: Dropped::default(),
        view: Some(View {
            eye: Vec3::new(0.0, 0.0, 5.0),
            target: Vec3::ZERO,
            up: Vec3::Y,
            light: Vec3::new(0.0, 0.0, 4.0),
        }),
    }
}

/// A triangle across the line of sight, at height z; its incircle has a radius of about 0.6 of `size`.
fn facing(z: f32, size: f32) -> [Vec3; 3] {
    [[-1.0, -1.0], [1.0, -1.0], [0.0, 1.0]].map(|[x, y]| Vec3::new(x * size, y * size, z))
}

fn structure(triangles: &[Triangle]) -> Box<dyn Structure> {
    (kind("surface").expect("it is in the list").build)(triangles)
}

/// The exact answers, as a kernel gives them.
fn right() -> Ask {
    Box::new(|query| {
        let exact = solve(query);
        exact.class.is_hit().then_some([exact.t, exact.u, exact.v])
    })
}

/// A picture by a kernel.
fn picture(stage: &Stage, ask: Ask, manner: Manner) -> Frame {
    let structure = structure(&stage.triangles);
    let leaf = AskingLeaf::new(ask, &stage.triangles, false);
    let mut tracer = Searcher::new(structure.as_ref(), Box::new(leaf));
    frame(stage, &mut tracer, manner, &mut |_| true).expect("nobody interrupts")
}
