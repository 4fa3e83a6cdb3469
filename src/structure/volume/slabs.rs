//! An intersection of slabs: the box, and four more pairs of planes across the diagonals of a cube (a
//! 14-dop; Kay and Kajiya, "Ray Tracing Complex Scenes", 1986; Klosowski and others, 1998).

use super::{Beam, Bounds, Crossing, Volume};

/// A box with its corners cut off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slabs {
    /// Across the axes.
    pub bounds: Bounds,
    /// Least and greatest n . p for the four `NORMALS`, rounded outwards.
    pub diagonal: [[f32; 2]; 4],
}

/// What the planes are across: sums and differences of coordinates, without a product.
pub const NORMALS: [[f64; 3]; 4] =
    [[1.0, 1.0, 1.0], [1.0, 1.0, -1.0], [1.0, -1.0, 1.0], [-1.0, 1.0, 1.0]];

/// A ray as one pair of planes sees it.
#[derive(Clone, Copy, Debug)]
pub struct Slant {
    /// n . o
    origin: f64,
    /// 1 / n . d; 0 where too little is known of it.
    inverse: f64,
    /// How much the error of n . o moves a t; infinite where the pair is left out.
    margin: f64,
    is_backward: bool,
}

const UNIT_ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// n . d is a sum of three, each (of a segment) rounded once: it errs by at most 3.01 u of the sum of
/// magnitudes. Pairs whose n . d is below 2^-20 of that sum are left out, so its relative error is at
/// most 3.01 * 2^-33; the difference, the reciprocal and the product add 3 u. This is 2^-30.
const SLANTED_WIDER: f64 = 1.0 / (1u64 << 30) as f64;
const LEAST_SLOPE: f64 = 1.0 / (1u64 << 20) as f64;

/// The sum, and the sum of the magnitudes that it was summed from.
#[inline(always)]
fn sum(normal: [f64; 3], v: [f64; 3]) -> (f64, f64) {
    let [x, y, z] = [normal[0] * v[0], normal[1] * v[1], normal[2] * v[2]];
    (x + y + z, x.abs() + y.abs() + z.abs())
}

impl Slant {
    #[inline(always)]
    fn new(normal: [f64; 3], beam: &Beam) -> Self {
        let (origin, magnitudes) = sum(normal, beam.origin);
        let (slope, slopes) = sum(normal, beam.direction);
        if slope.abs() < LEAST_SLOPE * slopes {
            return Slant { origin, inverse: 0.0, margin: f64::INFINITY, is_backward: false };
        }
        let inverse = 1.0 / slope;
        // Two roundings of the sum, doubled.
        let margin = 4.0 * UNIT_ROUNDOFF * magnitudes * inverse.abs();
        Slant { origin, inverse, margin, is_backward: slope < 0.0 }
    }
}

impl Volume for Slabs {
    const NAME: &'static str = "slabs";
    type Aim = [Slant; 4];

    fn around(points: &[[f32; 3]]) -> Self {
        let diagonal = NORMALS.map(|normal| {
            let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
            for point in points {
                let (place, magnitudes) = sum(normal, point.map(f64::from));
                let error = 4.0 * UNIT_ROUNDOFF * magnitudes;
                (low, high) = (low.min(place - error), high.max(place + error));
            }
            // Rounding to f32 is at most half a step; one step out is more.
            [(low as f32).next_down(), (high as f32).next_up()]
        });
        Slabs { bounds: Bounds::around(points), diagonal }
    }

    #[inline(always)]
    fn aim(beam: &Beam) -> [Slant; 4] {
        NORMALS.map(|normal| Slant::new(normal, beam))
    }

    /// Where a pair is left out, 0 - infinity and 0 + infinity bound nothing.
    #[inline(always)]
    fn crossing(&self, beam: &Beam, slants: &[Slant; 4]) -> Option<Crossing> {
        let Crossing { mut near, mut far } = self.bounds.crossing(beam, &())?;
        for (slant, [low, high]) in slants.iter().zip(&self.diagonal) {
            let (first, last) = if slant.is_backward { (high, low) } else { (low, high) };
            let enters = (f64::from(*first) - slant.origin) * slant.inverse;
            let leaves = (f64::from(*last) - slant.origin) * slant.inverse;
            let enters = enters - (enters.abs() * SLANTED_WIDER + slant.margin);
            let leaves = leaves + (leaves.abs() * SLANTED_WIDER + slant.margin);
            near = if enters > near { enters } else { near };
            far = if leaves < far { leaves } else { far };
        }
        Crossing::new(near, far)
    }
}
