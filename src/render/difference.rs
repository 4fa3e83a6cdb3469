//! How a kernel's answer about a ray differs from the exact one, and whether rounding explains it.

use super::exact::Exactly;
use super::tracer::Tracer;
use crate::oracle::{Exact, condition, excusable, output_error_limit, solve};
use crate::structure::Hit;
use crate::workload::Ray;

/// Unit roundoff of f32, which the kernels of pictures compute in.
const UNIT_ROUNDOFF: f64 = f32::EPSILON as f64 / 2.0;

/// In which way an answer differs. In the order in which a pixel is painted where its rays differ in
/// several.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Way {
    /// The nearest triangle is not hit: the ray goes through a crack, and sees what is behind or
    /// nothing. A shadow ray lets light through.
    Missed,
    /// Something is hit where nothing is.
    FalseHit,
    /// Another triangle is hit, at the same distance as far as rounding tells, or one that is not there.
    WrongTriangle,
    /// The right triangle at a distance that rounding does not explain.
    WrongDistance,
}

impl Way {
    /// All of them, in their order.
    pub const ALL: [Way; 4] =
        [Way::Missed, Way::FalseHit, Way::WrongTriangle, Way::WrongDistance];
}

/// A difference.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Difference {
    /// Of what kind.
    pub way: Way,
    /// Rounding explains it, by the margins that timed answers are judged by.
    pub is_excused: bool,
}

/// The difference of a nearest hit, if there is one.
pub fn of_nearest(found: Option<Hit>, ray: &Ray, exactly: &mut Exactly<'_>) -> Option<Difference> {
    let wanted = exactly.nearest(ray);
    match (found, wanted) {
        (None, None) => None,
        (Some(hit), Some((triangle, exact))) if hit.triangle == triangle => {
            let allowed = distance_error(ray, triangle, &exact, exactly);
            let error = (f64::from(hit.t) - exact.t) - exact.t_lo;
            // A NaN is no distance.
            let is_off = error.is_nan() || error.abs() > allowed;
            is_off.then_some(Difference { way: Way::WrongDistance, is_excused: false })
        }
        (None, Some((triangle, exact))) => {
            let is_excused = is_doubtful(ray, triangle, &exact, false, exactly);
            Some(Difference { way: Way::Missed, is_excused })
        }
        (Some(hit), None) => {
            let exact = solved(ray, hit.triangle, exactly);
            let is_excused = is_doubtful(ray, hit.triangle, &exact, true, exactly);
            Some(Difference { way: Way::FalseHit, is_excused })
        }
        (Some(hit), Some(wanted)) => Some(of_exchange(ray, hit.triangle, wanted, exactly)),
    }
}

/// The difference of an answer about any hit, if there is one. `kernel` gave the answer; where it
/// differs, it is asked for the triangle.
pub fn of_any(
    found: bool,
    ray: &Ray,
    kernel: &mut dyn Tracer,
    exactly: &mut Exactly<'_>,
) -> Option<Difference> {
    match (found, exactly.nearest(ray)) {
        (false, None) | (true, Some(_)) => None,
        (true, None) => of_nearest(kernel.nearest(ray), ray, exactly),
        (false, Some(_)) => of_nearest(None, ray, exactly),
    }
}

fn solved(ray: &Ray, triangle: u32, exactly: &Exactly<'_>) -> Exact {
    solve(&exactly.query(ray, triangle))
}

/// Whether rounding explains a wrong decision about a triangle. A right decision explains nothing.
fn is_doubtful(
    ray: &Ray,
    triangle: u32,
    exact: &Exact,
    accepted: bool,
    exactly: &Exactly<'_>,
) -> bool {
    let query = exactly.query(ray, triangle);
    accepted != exact.class.is_hit() && excusable(&query, exact, UNIT_ROUNDOFF, accepted)
}

/// How far rounding may take a distance off.
fn distance_error(ray: &Ray, triangle: u32, exact: &Exact, exactly: &Exactly<'_>) -> f64 {
    let query = exactly.query(ray, triangle);
    output_error_limit(&condition(&query, exact), UNIT_ROUNDOFF)[0]
}

/// One triangle was taken for another. Rounding explains it where the one that was found is a doubtful
/// hit, or the nearest is a doubtful miss, or both are hit so near to each other that what rounding may
/// do to either distance leaves open which comes first.
fn of_exchange(
    ray: &Ray,
    found: u32,
    (nearest, exact): (u32, Exact),
    exactly: &Exactly<'_>,
) -> Difference {
    let of_found = solved(ray, found, exactly);
    let open = distance_error(ray, found, &of_found, exactly)
        + distance_error(ray, nearest, &exact, exactly);
    let is_hit = of_found.class.is_hit();
    let is_behind = is_hit && of_found.t - exact.t > open;
    let is_doubtful = is_doubtful(ray, found, &of_found, true, exactly)
        || is_doubtful(ray, nearest, &exact, false, exactly);
    Difference {
        way: if is_behind { Way::Missed } else { Way::WrongTriangle },
        is_excused: is_doubtful || (is_hit && !is_behind),
    }
}
