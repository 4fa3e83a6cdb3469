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
    /// The nearest triangle is not hit, with surface on all sides: the ray sees what is behind.
    Crack,
    /// Something is hit where nothing is.
    FalseHit,
    /// Another triangle is hit, at the same distance as far as rounding tells, or one that is not there.
    WrongTriangle,
    /// The right triangle at a distance that rounding does not explain.
    WrongDistance,
    /// The nearest triangle is not hit within rounding of where the surface ends: nobody sees that.
    Outline,
    /// A shadow ray is stopped by nothing, or not by something.
    Shadow,
}

impl Way {
    /// All of them, in their order.
    pub const ALL: [Way; 6] = [
        Way::Crack,
        Way::FalseHit,
        Way::WrongTriangle,
        Way::WrongDistance,
        Way::Outline,
        Way::Shadow,
    ];
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
            Some(of_miss(ray, &exact, f64::INFINITY, is_excused, exactly))
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
    let (triangle, accepted) = match (found, exactly.nearest(ray)) {
        (false, None) | (true, Some(_)) => return None,
        (false, Some((triangle, _))) => (Some(triangle), false),
        (true, None) => (kernel.nearest(ray).map(|hit| hit.triangle), true),
    };
    let is_excused = triangle.is_some_and(|triangle| {
        let exact = solved(ray, triangle, exactly);
        is_doubtful(ray, triangle, &exact, accepted, exactly)
    });
    Some(Difference { way: Way::Shadow, is_excused })
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
    exactly: &mut Exactly<'_>,
) -> Difference {
    let of_found = solved(ray, found, exactly);
    let open = distance_error(ray, found, &of_found, exactly)
        + distance_error(ray, nearest, &exact, exactly);
    let is_hit = of_found.class.is_hit();
    let is_behind = is_hit && of_found.t - exact.t > open;
    let is_excused = is_doubtful(ray, found, &of_found, true, exactly)
        || is_doubtful(ray, nearest, &exact, false, exactly)
        || (is_hit && !is_behind);
    if is_behind {
        return of_miss(ray, &exact, of_found.t, is_excused, exactly);
    }
    Difference { way: Way::WrongTriangle, is_excused }
}

/// How far beside a ray its neighbours are, in parts of its direction: 256 times the rounding of a
/// direction, and less than a tenth of a pixel of a picture with 4000 rows.
const HAIR: f64 = 1.0 / 65_536.0;

/// The nearest triangle was missed, and what is at `behind` seen instead. It is a crack where the exact
/// rays a hair to every side meet something that is nearer to the triangle than to what is behind.
/// (Only a miss that rounding explains can be at an outline.)
fn of_miss(
    ray: &Ray,
    exact: &Exact,
    behind: f64,
    is_excused: bool,
    exactly: &mut Exactly<'_>,
) -> Difference {
    let direction = ray.direction.as_dvec3();
    let across = direction.any_orthogonal_vector().normalize_or_zero() * direction.length();
    let upwards = direction.cross(across).normalize_or_zero() * direction.length();
    let middle = exact.t + (behind - exact.t) / 2.0;
    let is_surrounded = [across, -across, upwards, -upwards].into_iter().all(|aside| {
        let beside = (direction + aside * HAIR).as_vec3();
        let length = ray.end.distance(ray.origin) / ray.direction.length();
        let beside = Ray { direction: beside, end: ray.origin + beside * length, ..*ray };
        exactly.nearest(&beside).is_some_and(|(_, exact)| exact.t < middle)
    });
    let way = if is_surrounded || !is_excused { Way::Crack } else { Way::Outline };
    Difference { way, is_excused }
}
