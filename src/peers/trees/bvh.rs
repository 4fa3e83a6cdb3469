//! bvh: a binary hierarchy that yields the shapes whose boxes are met, the nearest first.

use bvh::aabb::{Aabb, Bounded};
use bvh::bounding_hierarchy::BHShape;
use bvh::bvh::Bvh;
use bvh::ray::Ray;
use nalgebra::{Point3, Vector3};

use super::Tree;
use crate::peers::finite_t_max;
use crate::workload::{self, Triangle};

/// Two children to a node.
pub struct Binary {
    tree: Bvh<f32, 3>,
    shapes: Vec<Shape>,
}

/// A triangle that knows its place in the tree.
#[derive(Clone, Copy)]
struct Shape {
    corners: [Point3<f32>; 3],
    bounds: Aabb<f32, 3>,
    triangle: u32,
    node: usize,
}

fn point(v: glam::Vec3) -> Point3<f32> {
    Point3::from(v.to_array())
}

impl Bounded<f32, 3> for Shape {
    fn aabb(&self) -> Aabb<f32, 3> {
        self.bounds
    }
}

impl BHShape<f32, 3> for Shape {
    fn set_bh_node_index(&mut self, node: usize) {
        self.node = node;
    }
    fn bh_node_index(&self) -> usize {
        self.node
    }
}

impl Tree for Binary {
    /// With the largest t.
    type Ray = (Ray<f32, 3>, f32);

    fn build(triangles: &[Triangle]) -> Self {
        let shape = |(triangle, one): (u32, &Triangle)| {
            let corners = [one.a, one.b, one.c].map(point);
            let bounds = Aabb::empty().grow(&corners[0]).grow(&corners[1]).grow(&corners[2]);
            Shape { corners, bounds, triangle, node: 0 }
        };
        let mut shapes: Vec<Shape> = (0u32..).zip(triangles).map(shape).collect();
        Binary { tree: Bvh::build(&mut shapes), shapes }
    }

    /// The fields are filled as they are: its constructor would normalise the direction.
    fn ray(ray: &workload::Ray) -> Self::Ray {
        let direction = Vector3::from(ray.direction.to_array());
        let inv_direction = direction.map(f32::recip);
        (Ray { origin: point(ray.origin), direction, inv_direction }, finite_t_max(ray))
    }

    fn nearest(&self, (ray, t_max): &Self::Ray) -> Option<(u32, f32)> {
        let mut best: Option<(u32, f32)> = None;
        for shape in self.tree.nearest_traverse_iterator(ray, &self.shapes) {
            let limit = best.map_or(*t_max, |(_, t)| t);
            let begins = ray.intersection_slice_for_aabb(&shape.bounds);
            if begins.is_some_and(|(near, _)| near > limit) {
                break;
            }
            let [a, b, c] = &shape.corners;
            let t = ray.intersects_triangle(a, b, c).distance;
            if t < limit {
                best = Some((shape.triangle, t));
            }
        }
        best
    }
}
