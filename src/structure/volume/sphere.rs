//! The sphere.

use super::{Beam, Bounds, Crossing, Volume};

/// A sphere around the middle of the box: not the least one, but at most 1.7 times as wide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre.
    pub centre: [f32; 3],
    /// Its radius.
    pub radius: f32,
}

/// What is prepared of a ray.
#[derive(Clone, Copy, Debug)]
pub struct Aim {
    /// 1 / length of the direction.
    inverse: f64,
}

/// Bounds the error of what is computed of l = centre - origin and the direction d, in parts of |l| or
/// |l| |d|: each component of l has one rounding and of a segment's d another; a component of l x d has
/// two more products and a difference, 5 u of |l| |d|, the three of them 5 * 1.8 u; the square root of
/// the squares and the division by |d| add 6 u. l . d / |d| errs by less. With u = 2^-53 and |l| replaced
/// by the larger sum of magnitudes, 16 u would do; this is 32 u.
const MARGIN: f64 = 32.0 * (f64::EPSILON / 2.0);

impl Sphere {
    /// Surface, in squares of the coordinates' unit.
    pub fn area(&self) -> f64 {
        4.0 * std::f64::consts::PI * f64::from(self.radius).powi(2)
    }
}

impl Volume for Sphere {
    const NAME: &'static str = "sphere";
    type Aim = Aim;

    fn around(points: &[[f32; 3]]) -> Self {
        let bounds = Bounds::around(points);
        let centre = [0, 1, 2].map(|axis| (0.5 * bounds.doubled_middle(axis)) as f32);
        let away = |point: &[f32; 3]| {
            let [x, y, z] = [0, 1, 2].map(|i| f64::from(point[i]) - f64::from(centre[i]));
            (x * x + y * y + z * z).sqrt()
        };
        let radius = points.iter().map(away).fold(0.0, f64::max);
        // One f32 up is more than both roundings, that of f64 and that to f32.
        Sphere { centre, radius: (radius as f32).next_up() }
    }

    #[inline(always)]
    fn aim(beam: &Beam) -> Aim {
        let [x, y, z] = beam.direction;
        Aim { inverse: 1.0 / (x * x + y * y + z * z).sqrt() }
    }

    /// In units of length along the ray: the centre is abreast at `along`, `beside` away, and half the
    /// chord is by Pythagoras. `margin` bounds the errors of all three.
    #[inline(always)]
    fn crossing(&self, beam: &Beam, aim: &Aim) -> Option<Crossing> {
        let [x, y, z] = [0, 1, 2].map(|i| f64::from(self.centre[i]) - beam.origin[i]);
        let [dx, dy, dz] = beam.direction;
        let margin = MARGIN * (x.abs() + y.abs() + z.abs());
        let radius = f64::from(self.radius);
        let across = [y * dz - z * dy, z * dx - x * dz, x * dy - y * dx];
        let squares = across[0] * across[0] + across[1] * across[1] + across[2] * across[2];
        let beside = squares.sqrt() * aim.inverse - margin;
        if beside > radius {
            return None;
        }
        let beside = beside.max(0.0);
        // A product of sum and difference: no cancellation of squares.
        let half = ((radius - beside) * (radius + beside)).sqrt() * (1.0 + MARGIN) + margin;
        let along = (x * dx + y * dy + z * dz) * aim.inverse;
        let near = ((along - half) * aim.inverse).max(beam.t_min);
        let far = ((along + half) * aim.inverse).min(beam.t_max);
        // Behind the sums: a rounding each of the larger of both, and of the product.
        let slack = MARGIN * (along.abs() + half) * aim.inverse;
        Crossing::new((near - slack).max(beam.t_min), far + slack)
    }
}
