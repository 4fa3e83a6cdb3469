//! Law 2 for the published listings: return code, t, u and v, by their own conventions.
//!
//! They test no t: all of the line counts. The closed form beside each is the kernel of the same
//! algorithm, which obeys the law.

use std::collections::BTreeMap;

use ray_test::kernels::Corners;
use ray_test::kernels::listings::{Badouel, ChirkovLine, Listing, Literally, Moller, Returned};
use ray_test::number::{Element, Real, dominant};
use ray_test::policy::Ray;

use super::cases;
use super::exact::{Exact, reset};
use super::reference::{Meeting, Point, facing, meeting, normal};

type Run = fn(&Ray<Exact>, &Corners<Exact>) -> Returned<Exact>;
type Expected = fn(&Asked) -> u8;

/// A case with what the conventions ask of it.
struct Asked {
    corners: Corners<Exact>,
    meeting: Meeting,
    /// det of Moeller and Trumbore: positive for front faces.
    det: Exact,
    /// Direction . unit normal; undefined without area or where the length is not rational.
    cosine: Exact,
}

impl Asked {
    fn new(ray: &Ray<Exact>, corners: &Corners<Exact>) -> Self {
        let (facing, n) = (facing(ray, corners), normal(corners));
        let square = n.x() * n.x() + n.y() * n.y() + n.z() * n.z();
        Asked {
            corners: *corners,
            meeting: meeting(ray, corners),
            det: -facing,
            cosine: facing / square.sqrt(),
        }
    }
    fn point(&self) -> Point {
        match self.meeting {
            Meeting::Point(point) => point,
            _ => panic!("a det or cosine above epsilon without a point"),
        }
    }
    fn has_area(&self) -> bool {
        !matches!(self.meeting, Meeting::Degenerate)
    }
}

/// The f32 next to 0.000001, which every precision uses.
fn epsilon() -> Exact {
    Exact::from_f32(1e-6)
}

fn outside(x: Exact) -> bool {
    x.lt(Exact::ZERO) || x.gt(Exact::ONE)
}

/// Variant 0: |det| < eps misses, and codes do not tell the faces apart.
fn moller0(asked: &Asked) -> u8 {
    if asked.det.signed_by(asked.det).lt(epsilon()) {
        return 5;
    }
    inside_code(asked, 1)
}

/// Variants 1 to 3: |det| <= eps misses; codes 1 and 2 are the front's, 3 and 4 the back's.
fn moller(asked: &Asked) -> u8 {
    if asked.det.signed_by(asked.det).le(epsilon()) {
        return 5;
    }
    inside_code(asked, if asked.det.gt(Exact::ZERO) { 1 } else { 3 })
}

fn inside_code(asked: &Asked, first: u8) -> u8 {
    let [w, u, v] = asked.point().weights;
    if outside(u) {
        first
    } else if v.lt(Exact::ZERO) || w.lt(Exact::ZERO) {
        first + 1
    } else {
        0
    }
}

/// |N . D| < eps misses. Without area N is undefined, and a listing that asks what must not hold
/// takes it for a hit.
fn badouel(asked: &Asked) -> u8 {
    if !asked.has_area() {
        return 0;
    }
    if asked.cosine.signed_by(asked.cosine).lt(epsilon()) {
        return 1;
    }
    let [w, u, v] = asked.point().weights;
    let axis = dominant(normal(&asked.corners)) as usize;
    let first_edge = (asked.corners.b - asked.corners.a).0[(axis + 1) % 3];
    if outside(v) {
        return if first_edge.is_zero() { 2 } else { 3 };
    }
    if u.lt(Exact::ZERO) || w.lt(Exact::ZERO) { 4 } else { 0 }
}

/// The products of the edge functions, which have the signs of v u (wanted >= 0) and of -v w
/// (wanted < 0): with u + v + w = 1 that is u >= 0, v > 0 and w > 0. A line that is parallel to the
/// plane has v = u + w up to a factor for its edge functions, which no signs wanted here satisfy.
fn chirkov_line(asked: &Asked) -> u8 {
    let Meeting::Point(Point { weights: [w, u, v], .. }) = asked.meeting else { return 1 };
    u8::from(!(u.ge(Exact::ZERO) && v.gt(Exact::ZERO) && w.gt(Exact::ZERO)))
}

fn run<K: Listing, const UV: bool>(ray: &Ray<Exact>, corners: &Corners<Exact>) -> Returned<Exact> {
    K::run::<Exact, Literally, UV>(ray, &K::prepare(corners))
}

/// A listing with t alone and with u and v, whether it needs a unit normal, and its convention.
struct Held {
    id: &'static str,
    runs: [Run; 2],
    unit_normal: bool,
    expected: Expected,
}

fn held<K: Listing>(unit_normal: bool, expected: Expected) -> Held {
    Held { id: K::ABOUT.id, runs: [run::<K, false>, run::<K, true>], unit_normal, expected }
}

fn all() -> [Held; 6] {
    [
        held::<Moller<0>>(false, moller0),
        held::<Moller<1>>(false, moller),
        held::<Moller<2>>(false, moller),
        held::<Moller<3>>(false, moller),
        held::<Badouel>(true, badouel),
        held::<ChirkovLine>(true, chirkov_line),
    ]
}

/// The code by each listing's convention, and the values of a hit. True if the case could be asked.
fn check(held: &Held, ray: &Ray<Exact>, corners: &Corners<Exact>) -> Option<u8> {
    let asked = Asked::new(ray, corners);
    if held.unit_normal && asked.has_area() && !asked.cosine.is_defined() {
        return None;
    }
    let code = (held.expected)(&asked);
    for (uv, run) in held.runs.iter().enumerate() {
        let (found, t, u, v) = run(ray, corners);
        assert_eq!(
            found,
            code,
            "{} uv {uv} {:?} {ray:?}",
            held.id,
            asked.meeting,
            ray = ray.origin
        );
        if code == 0 {
            let (wanted_t, [_, wanted_u, wanted_v]) = match asked.meeting {
                Meeting::Point(point) => (point.t, point.weights),
                _ => (Exact::UNDEFINED, [Exact::UNDEFINED; 3]),
            };
            assert!(t.same(wanted_t), "{} t {t:?}, {:?}", held.id, asked.meeting);
            let same = u.same(wanted_u) && v.same(wanted_v);
            assert!(same || uv == 0, "{} u {u:?} v {v:?}, {:?}", held.id, asked.meeting);
        }
    }
    Some(code)
}

#[test]
fn listings_obey_their_own_conventions() {
    let mut tally: BTreeMap<(&str, u8), usize> = BTreeMap::new();
    for case in cases::all() {
        for held in &all() {
            if let Some(code) = check(held, &case.ray(false), &case.triangle()) {
                *tally.entry((held.id, code)).or_default() += 1;
            }
            reset();
        }
    }
    println!("{tally:?}");
    for held in all() {
        let codes = match held.id {
            "moller0" => [0, 1, 2, 5].as_slice(),
            "badouel" => &[0, 1, 2, 3, 4],
            "chirkov-line" => &[0, 1],
            _ => &[0, 1, 2, 3, 4, 5],
        };
        for &code in codes {
            let count = tally.get(&(held.id, code)).copied().unwrap_or(0);
            assert!(count >= 20, "{} code {code}: {count} cases", held.id);
        }
    }
}

/// Directions of such a length that det, or the cosine, is epsilon or half of it or twice it.
#[test]
fn epsilon_is_where_the_listings_put_it() {
    let mut tally: BTreeMap<(&str, usize), [usize; 2]> = BTreeMap::new();
    for case in cases::lattice(1000, 3) {
        // Chirkov has no epsilon.
        for held in all().iter().filter(|held| held.id != "chirkov-line") {
            for (step, times) in [0.5, 1.0, 2.0].into_iter().enumerate() {
                let (mut ray, corners) = (case.ray(false), case.triangle());
                let asked = Asked::new(&ray, &corners);
                let length = if held.unit_normal { asked.cosine } else { asked.det };
                if length.is_defined() && !length.is_zero() && asked.meeting.in_triangle().is_some()
                {
                    let factor = epsilon() * Exact::of(times) / length.signed_by(length);
                    ray.direction = ray.direction.scaled(factor);
                    let code = check(held, &ray, &corners).expect("a length that is rational");
                    tally.entry((held.id, step)).or_default()[usize::from(code == 0)] += 1;
                }
                reset();
            }
        }
    }
    println!("{tally:?}");
    for ((id, step), [missed, hit]) in tally {
        let hits = matches!((id, step), (_, 2) | ("moller0" | "badouel", 1));
        let (wanted, other) = if hits { (hit, missed) } else { (missed, hit) };
        assert!(wanted >= 30 && other == 0, "{id} {step}: {wanted} and {other}");
    }
}
