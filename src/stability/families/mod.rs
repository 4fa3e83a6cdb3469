//! The families, one file per group.

mod angle;
mod place;
mod range;
mod shape;
mod size;
mod special;
#[cfg(test)]
mod tests;

#[cfg(feature = "cli")]
pub(super) use range::near_edge;

use super::family::{Family, MeshKind, Transform, Work};
use super::precision::Precision;

/// Every family, in the order of tables and charts.
pub fn families() -> Vec<Family> {
    let groups = [
        shape::families(),
        size::families(),
        place::families(),
        angle::families(),
        range::families(),
        special::families(),
        meshes(),
        rays_off_surfaces(),
    ];
    groups.into_iter().flatten().collect()
}

/// The family of that id.
pub fn find(id: &str) -> Option<Family> {
    families().into_iter().find(|family| family.id == id)
}

/// Exponents from 0 to the last of the precision, in steps.
fn exponents(precision: Precision, narrow: (i32, usize), wide: (i32, usize)) -> Vec<f64> {
    let (last, step) = match precision {
        Precision::F32 => narrow,
        Precision::F64 => wide,
    };
    (0..=last).step_by(step).map(f64::from).collect()
}

/// 0 to 8, or 0 to 16.
fn digits(precision: Precision) -> Vec<f64> {
    exponents(precision, (8, 1), (16, 2))
}

/// Distances of a mesh's centre from the coordinates' origin; the last is that of Embree's test of
/// watertightness, whose mesh has the same radius.
fn offsets(_: Precision) -> Vec<f64> {
    vec![0.0, 1e2, 1e3, 1e4, 2.7e5]
}

fn single(_: Precision) -> Vec<f64> {
    vec![0.0]
}

fn meshes() -> Vec<Family> {
    let leaks = "no ray lost; hits of two triangles are reported";
    let mesh =
        |id, kind, knob, knobs| Family { id, knob, knobs, work: Work::Mesh(kind), passes: leaks };
    let offset = "distance of the mesh (radius 2) from 0: k";
    vec![
        mesh("lattice-mesh", MeshKind::Lattice, "none", single as fn(_) -> _),
        mesh("closed-sphere", MeshKind::Sphere, offset, offsets),
        mesh("closed-needles", MeshKind::Needles, offset, offsets),
        mesh("closed-squashed", MeshKind::Squashed, offset, offsets),
    ]
}

fn rays_off_surfaces() -> Vec<Family> {
    let metamorphic = |id, transform, knob, knobs, passes| Family {
        id,
        knob,
        knobs,
        work: Work::Metamorphic(transform),
        passes,
    };
    let unchanged = "no decision changes";
    vec![
        Family {
            id: "spawned-rays",
            knob: "distance of the triangle from 0: 10^k",
            knobs: |precision| exponents(precision, (6, 1), (14, 2)),
            work: Work::Spawned,
            passes: "reported, no pass line: how far off the surface a ray must start",
        },
        metamorphic(
            "scaled-by-powers-of-two",
            Transform::Scale,
            "all coordinates times 2^k",
            scales as fn(_) -> _,
            "u and v keep their bits until something under- or overflows",
        ),
        metamorphic(
            "permuted-axes",
            Transform::Axes,
            "weight of the target: 10^-k",
            near_edges,
            unchanged,
        ),
        metamorphic(
            "rotated-vertices",
            Transform::Vertices,
            "weight of the target: 10^-k",
            near_edges,
            unchanged,
        ),
    ]
}

/// Powers of two, up and down by turns.
fn scales(precision: Precision) -> Vec<f64> {
    let sizes: &[i32] = match precision {
        Precision::F32 => &[1, 16, 32, 48, 64],
        Precision::F64 => &[1, 128, 256, 384, 512],
    };
    sizes.iter().flat_map(|size| [-f64::from(*size), f64::from(*size)]).collect()
}

/// Targets well inside, and ever nearer to an edge.
fn near_edges(precision: Precision) -> Vec<f64> {
    exponents(precision, (8, 2), (16, 4))
}
