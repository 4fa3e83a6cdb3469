//! THE list of structures, by name.

use super::volume::{Both, Bounds, Slabs, Sphere, Volume};
use super::{
    Bounded, Compressed, Grid, Hierarchy, KdTree, List, Octree, SortedVolumes, Structure,
    by_surface_area, from_obvhs, inserted,
};
use crate::workload::Triangle;

/// A structure that can be built.
#[derive(Clone, Copy, Debug)]
pub struct Kind {
    /// Its name in configs and columns.
    pub id: &'static str,
    /// What it is.
    pub title: &'static str,
    /// Over triangles. The one whose result depends on their order takes them in the order given.
    pub build: fn(&[Triangle]) -> Box<dyn Structure>,
}

/// All of them: from the list on, in the order of the lecture, and what renderers use today.
pub const KINDS: [Kind; 17] = [
    Kind { id: "list", title: "every triangle", build: list },
    Kind { id: "sphere", title: "a sphere around all", build: bounded::<Sphere> },
    Kind { id: "box", title: "a box around all", build: bounded::<Bounds> },
    Kind { id: "slabs", title: "seven slabs around all", build: bounded::<Slabs> },
    Kind {
        id: "sphere-and-box",
        title: "a sphere, and a box in it",
        build: bounded::<SphereAndBox>,
    },
    Kind { id: "sorted-spheres", title: "a list of spheres by distance", build: sorted::<Sphere> },
    Kind { id: "sorted-boxes", title: "a list of boxes by distance", build: sorted::<Bounds> },
    Kind { id: "grid", title: "a uniform grid", build: grid },
    Kind { id: "octree", title: "an octree", build: octree },
    Kind { id: "kd-tree", title: "a kd-tree", build: kd_tree },
    Kind { id: "inserted", title: "boxes, by insertion", build: by_insertion },
    Kind { id: "surface", title: "boxes, by surface area", build: surface::<Bounds> },
    Kind { id: "surface-spheres", title: "spheres, by surface area", build: surface::<Sphere> },
    Kind { id: "surface-slabs", title: "slabs, by surface area", build: surface::<Slabs> },
    Kind { id: "obvhs", title: "boxes, by obvhs", build: obvhs },
    Kind { id: "compressed", title: "compressed boxes by eight, by obvhs", build: compressed },
    Kind {
        id: "surface-sphere-and-box",
        title: "spheres with boxes in them, by surface area",
        build: surface::<SphereAndBox>,
    },
];

/// The one with that name.
pub fn kind(id: &str) -> Option<&'static Kind> {
    KINDS.iter().find(|kind| kind.id == id)
}

type SphereAndBox = Both<Sphere, Bounds>;

fn list(triangles: &[Triangle]) -> Box<dyn Structure> {
    Box::new(List::new(triangles.len() as u32))
}

fn bounded<V: Volume>(triangles: &[Triangle]) -> Box<dyn Structure> {
    Box::new(Bounded::<V>::new(triangles))
}

fn sorted<V: Volume>(triangles: &[Triangle]) -> Box<dyn Structure> {
    Box::new(SortedVolumes::<V>::new(triangles))
}

fn grid(triangles: &[Triangle]) -> Box<dyn Structure> {
    Box::new(Grid::new(triangles))
}

fn octree(triangles: &[Triangle]) -> Box<dyn Structure> {
    Box::new(Octree::new(triangles))
}

fn kd_tree(triangles: &[Triangle]) -> Box<dyn Structure> {
    Box::new(KdTree::new(triangles))
}

fn by_insertion(triangles: &[Triangle]) -> Box<dyn Structure> {
    let order: Vec<u32> = (0..triangles.len() as u32).collect();
    Box::new(Hierarchy::<Bounds>::new(triangles, &inserted(triangles, &order)))
}

fn surface<V: Volume>(triangles: &[Triangle]) -> Box<dyn Structure> {
    Box::new(Hierarchy::<V>::new(triangles, &by_surface_area(triangles)))
}

fn obvhs(triangles: &[Triangle]) -> Box<dyn Structure> {
    Box::new(Hierarchy::<Bounds>::new(triangles, &from_obvhs(triangles)))
}

fn compressed(triangles: &[Triangle]) -> Box<dyn Structure> {
    Box::new(Compressed::new(triangles))
}
