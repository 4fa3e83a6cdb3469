//! The answer that kernels are held to, by elimination: no determinant, no cross product and no
//! plane, which are what kernels are made of.

use ray_test::kernels::Corners;
use ray_test::number::{Element, Real, Vec3};
use ray_test::oracle::Class;
use ray_test::policy::Ray;

use super::exact::Exact;

/// Where the line and the plane of the triangle meet.
#[derive(Clone, Copy, Debug)]
pub enum Meeting {
    /// The triangle has no area, so no plane.
    Degenerate,
    /// The line lies in the plane (or is a point of it).
    Coplanar,
    /// The line is off the plane (or is a point off it).
    Parallel,
    /// One point.
    Point(Point),
}

/// One point of line and plane.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Distance in units of the direction.
    pub t: Exact,
    /// Weights of a, b and c.
    pub weights: [Exact; 3],
}

/// Solves a + u (b - a) + v (c - a) = o + t d for u, v and t by Gauss-Jordan elimination.
pub fn meeting(ray: &Ray<Exact>, corners: &Corners<Exact>) -> Meeting {
    let (e1, e2) = corners.edges();
    let s = ray.origin - corners.a;
    let mut rows: [[Exact; 4]; 3] =
        std::array::from_fn(|i| [e1.0[i], e2.0[i], -ray.direction.0[i], s.0[i]]);
    for column in 0..3 {
        let Some(pivot) = (column..3).find(|&row| !rows[row][column].is_zero()) else {
            return match (column, rows[2][3].is_zero()) {
                (2, true) => Meeting::Coplanar,
                (2, false) => Meeting::Parallel,
                _ => Meeting::Degenerate,
            };
        };
        rows.swap(column, pivot);
        let divisor = rows[column][column];
        rows[column] = rows[column].map(|x| x / divisor);
        let [first, second] = [(column + 1) % 3, (column + 2) % 3];
        for other in [first, second] {
            let factor = rows[other][column];
            rows[other] = std::array::from_fn(|i| rows[other][i] - factor * rows[column][i]);
        }
    }
    let [u, v, t] = rows.map(|row| row[3]);
    Meeting::Point(Point { t, weights: [Exact::ONE - u - v, u, v] })
}

impl Meeting {
    /// The point of the line, if it is in the closed triangle.
    pub fn in_triangle(&self) -> Option<Point> {
        match self {
            Meeting::Point(point) if point.weights.iter().all(|w| w.ge(Exact::ZERO)) => {
                Some(*point)
            }
            _ => None,
        }
    }

    /// The oracle's word for it.
    pub fn class(&self, t_min: Exact, t_max: Exact) -> Class {
        let point = match (self, self.in_triangle()) {
            (Meeting::Degenerate, _) => return Class::Degenerate,
            (Meeting::Coplanar, _) => return Class::Coplanar,
            (_, None) => return Class::Outside,
            (_, Some(point)) => point,
        };
        if point.t.lt(t_min) || point.t.gt(t_max) {
            return Class::Behind;
        }
        match point.weights.iter().filter(|w| w.is_zero()).count() {
            0 => Class::Interior,
            1 => Class::Edge,
            _ => Class::Vertex,
        }
    }
}

/// The determinant of three columns, by its first row.
pub fn determinant(a: Vec3<Exact>, b: Vec3<Exact>, c: Vec3<Exact>) -> Exact {
    let minor = |i: usize, j: usize| b.0[i] * c.0[j] - b.0[j] * c.0[i];
    a.0[0] * minor(1, 2) - a.0[1] * minor(0, 2) + a.0[2] * minor(0, 1)
}

/// (b - a) x (c - a), the side from which a, b, c is counter-clockwise.
pub fn normal(corners: &Corners<Exact>) -> Vec3<Exact> {
    let (e1, e2) = corners.edges();
    let axis =
        |i: usize| Vec3(std::array::from_fn(|j| if i == j { Exact::ONE } else { Exact::ZERO }));
    Vec3(std::array::from_fn(|i| determinant(axis(i), e1, e2)))
}

/// direction . normal: negative where the ray sees the front.
pub fn facing(ray: &Ray<Exact>, corners: &Corners<Exact>) -> Exact {
    let (e1, e2) = corners.edges();
    determinant(ray.direction, e1, e2)
}
