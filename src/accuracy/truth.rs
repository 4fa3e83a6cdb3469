//! The exact answers of a workload.

use crate::oracle::{Condition, Exact, Query, condition, nearest, solve};
use crate::workload::{Ray, Triangle};
use glam::DVec3;

/// The exact answer of one pair, with what rounding may do to it.
#[derive(Clone, Debug)]
pub struct Truth {
    /// What was asked.
    pub query: Query,
    /// The answer.
    pub exact: Exact,
    /// Its absolute condition numbers.
    pub condition: Condition,
    /// What t is divided by to be in units of the query's direction: 1, or the length of a segment
    /// whose kernel counts t in units of a direction of length 1.
    pub t_scale: f64,
    /// Whether the ray sees the front: a, b, c counter-clockwise. Told in f64, which matters to forms
    /// that cull alone.
    pub front: bool,
}

impl Truth {
    /// Of a ray, or line, with its own range of t.
    pub fn of(ray: &Ray, triangle: &Triangle) -> Self {
        Self::solved(Query::of(ray, triangle), 1.0, ray, triangle)
    }

    /// Of the segment from origin to end: what segment kernels are judged on.
    pub fn of_segment(ray: &Ray, triangle: &Triangle) -> Self {
        let length = (ray.end.as_dvec3() - ray.origin.as_dvec3()).length();
        Self::solved(Query::of_segment(ray, triangle), length, ray, triangle)
    }

    /// Of the point `ray.end`: whether its projection on the triangle's plane, along the normal,
    /// is inside. The point itself is not exactly in the plane.
    pub fn of_point(ray: &Ray, triangle: &Triangle) -> Self {
        let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|v| v.as_dvec3());
        let query = Query {
            origin: ray.end.as_dvec3().to_array(),
            direction: (b - a).cross(c - a).to_array(),
            end: None,
            triangle: [a.to_array(), b.to_array(), c.to_array()],
            t_min: f64::NEG_INFINITY,
            t_max: f64::INFINITY,
        };
        Self::solved(query, 1.0, ray, triangle)
    }

    /// Of any query, in f64 as well. Kernels count t in units of its direction, which for a segment
    /// is the (rounded) way from origin to end.
    pub fn of_query(query: Query) -> Self {
        let [a, b, c] = query.triangle.map(DVec3::from_array);
        let front = faces(a, b, c, DVec3::from_array(query.direction));
        let exact = solve(&query);
        Truth { condition: condition(&query, &exact), exact, query, t_scale: 1.0, front }
    }

    fn solved(query: Query, t_scale: f64, ray: &Ray, triangle: &Triangle) -> Self {
        Truth { t_scale, front: sees_front(ray, triangle), ..Truth::of_query(query) }
    }
}

/// The front faces the ray where d . ((b - a) x (c - a)) < 0. In f64, whose sign is right for f32
/// inputs unless the ray is parallel within 2^-50, where nothing is hit beyond doubt.
fn sees_front(ray: &Ray, triangle: &Triangle) -> bool {
    let [a, b, c] = [triangle.a, triangle.b, triangle.c].map(|v| v.as_dvec3());
    faces(a, b, c, ray.direction.as_dvec3())
}

fn faces(a: DVec3, b: DVec3, c: DVec3, direction: DVec3) -> bool {
    (b - a).cross(c - a).dot(direction) < 0.0
}

/// The nearest triangles of every ray of a set.
#[derive(Clone, Debug)]
pub struct NearestTruth {
    /// Per ray, the nearest triangle of any face.
    pub any: Vec<Option<(usize, Exact)>>,
    /// Per ray, the nearest triangle that shows its front.
    pub front: Vec<Option<(usize, Exact)>>,
}

impl NearestTruth {
    /// Computes both; one exact classification per ray and triangle.
    pub fn of(rays: &[Ray], triangles: &[Triangle]) -> Self {
        let front = |ray: &Ray| {
            let shown: Vec<usize> =
                (0..triangles.len()).filter(|&i| sees_front(ray, &triangles[i])).collect();
            let faces: Vec<Triangle> = shown.iter().map(|&i| triangles[i]).collect();
            nearest(ray, &faces).map(|(i, exact)| (shown[i], exact))
        };
        NearestTruth {
            any: rays.iter().map(|ray| nearest(ray, triangles)).collect(),
            front: rays.iter().map(front).collect(),
        }
    }
}
