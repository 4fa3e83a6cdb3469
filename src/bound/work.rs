//! What a test leaves to be done, by kind of operation.

use crate::batch::{Best, Kind, step};
use crate::kernels::{Corners, Kernel, Whole};
use crate::number::{Needed, Noted, Place, Spread, Traced, TracedOne, Vec3, needed};
use crate::policy::{Policy, Ray};

/// Operations by kind, in the order of [`Kind::ALL`].
pub type Counts = [u64; Kind::ALL.len()];

/// The operations of one test of a form that computes everything.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Of each ray, or each register of rays.
    pub each: Counts,
    /// Of a triangle, for all rays of a packet at once, and its stored numbers (loads).
    pub once: Counts,
}

impl Work {
    /// How many of a kind.
    pub fn each_of(&self, kind: Kind) -> u64 {
        self.each[kind as usize - 1]
    }
    /// How many of a kind, once for all rays.
    pub fn once_of(&self, kind: Kind) -> u64 {
        self.once[kind as usize - 1]
    }

    /// Counts. A comparison is one of these as far as its answer joins others: what joins is often
    /// part of the instruction, and the last answer may be no more than the condition of a selection.
    fn of(needed: &Needed) -> Self {
        let count = |noted: &[Noted]| {
            let mut counts = Counts::default();
            let (mut compares, mut joins) = (0, 0);
            for noted in noted {
                let kind = match noted {
                    Noted::Add => Kind::Add,
                    Noted::Multiply => Kind::Multiply,
                    Noted::Fused => Kind::Fused,
                    Noted::Divide => Kind::Divide,
                    Noted::Select => Kind::Select,
                    Noted::Flip => Kind::Flip,
                    Noted::OfTriangle(_) => Kind::Load,
                    Noted::Compare(_) => {
                        compares += 1;
                        continue;
                    }
                    Noted::Join(_) => {
                        joins += 1;
                        continue;
                    }
                    Noted::OfRay | Noted::OfBoth | Noted::Free(_) => continue,
                };
                counts[kind as usize - 1] += 1;
            }
            counts[Kind::Compare as usize - 1] = joins.min(compares);
            counts
        };
        Work { each: count(&needed.each), once: count(&needed.once) }
    }
}

/// A ray, and a triangle that it hits, without anything that happens to be 0 or equal.
const ORIGIN: [f64; 3] = [0.25, 0.375, -2.0];
const DIRECTION: [f64; 3] = [0.125, 0.0625, 1.5];
const CORNERS: [[f64; 3]; 3] = [[-1.0, -0.5, 2.0], [3.0, -0.75, 2.25], [0.5, 4.0, 1.75]];

/// The work of a kernel in the form `P`, which computes everything, in the search for the nearest
/// hit; `LANES` is 1 for single rays, above that for packets, which differ in how rays are picked from.
pub fn work<K: Kernel, P: Policy, const LANES: usize>() -> Work {
    let vector = |v: [f64; 3]| Vec3(v.map(<TracedOne as crate::number::Element>::from_f64));
    let [a, b, c] = CORNERS.map(vector);
    let record = K::prepare::<TracedOne>(&Corners { a, b, c });
    let needed = needed(|| {
        let number = |(place, number): (usize, &TracedOne)| {
            TracedOne::input(Noted::OfTriangle(place), crate::number::Element::to_f64(*number))
        };
        let stored: Vec<TracedOne> = record.as_ref().iter().enumerate().map(number).collect();
        let of_ray = |value| Traced::<LANES>::input(Noted::OfRay, value);
        let end = [0, 1, 2].map(|axis| ORIGIN[axis] + 4.0 * DIRECTION[axis]);
        let mut ray = Ray {
            origin: Vec3(ORIGIN.map(of_ray)),
            direction: Vec3(DIRECTION.map(of_ray)),
            end: Vec3(end.map(of_ray)),
            t_min: of_ray(0.0),
            t_max: Traced::input(Noted::OfBoth, 1e6),
        };
        let index = Traced::input(Noted::OfBoth, 1.0);
        let mut best = Best::nothing((), &ray);
        let aim = K::aim::<P, Traced<LANES>>(&ray);
        let met = Spread::spread((), K::read::<P, TracedOne, _>(&Whole(&stored)));
        step::<K, P, Traced<LANES>>(&mut ray, &aim, &met, index, &mut best);
        let (hit, numbers) = best.carried();
        let places = numbers.into_iter().map(Traced::place);
        places.chain([hit.place()]).collect::<Vec<Place>>()
    });
    Work::of(&needed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernels::{MollerTrumbore, PerpendicularPlanes, Wald};
    use crate::policy::{
        Compare, First, Form, Full, Fused, Inside, Last, Nearer, Plain, Surface, Tuv, TwoSided,
    };

    type Of<D, A, O = Tuv, L = crate::policy::Distance> =
        Form<Full, D, A, O, TwoSided, Compare, L, Nearer>;

    /// add, multiply, fused, divide, compare, select, flip.
    fn each(work: &Work) -> [u64; 7] {
        std::array::from_fn(|kind| work.each[kind])
    }

    /// The header of the kernel: 27 x, 24 +-, 1 /. The two edges (6 -) are the triangle's; the range
    /// of t is the search's.
    #[test]
    fn moller_trumbore_divided_first_is_what_its_header_says() {
        let work = work::<MollerTrumbore, Of<First, Plain, Tuv, Inside>, 2>();
        // det != 0, 0 <= u <= 1, v >= 0, u + v <= 1, t >= 0, t < best: of 7, 6 join; 4 numbers are kept.
        assert_eq!(each(&work), [18, 27, 0, 1, 6, 4, 0]);
        assert_eq!((work.once_of(Kind::Add), work.once_of(Kind::Load)), (6, 9));
    }

    /// Fused, a dot product is 1 multiplication and 2 fused, a cross product 3 and 3: of 4 and 2 of
    /// them, with a division and 3 multiplications by the reciprocal; differences stay: s (3), u + v.
    #[test]
    fn fused_moller_trumbore_is_what_its_products_are() {
        let work = work::<MollerTrumbore, Of<First, Fused, Tuv, Inside>, 2>();
        assert_eq!(each(&work), [4, 3 + 4 + 6, 8 + 6, 1, 6, 4, 0]);
    }

    /// The header: divided first 10 x, 12 +-, 1 /. The normal, which is not reported, is not there: 9
    /// numbers of the plane and the lines are loaded, and not its sign.
    #[test]
    fn wald_divided_first_is_what_its_header_says() {
        let work = work::<Wald, Of<First, Plain>, 2>();
        assert_eq!(each(&work), [12, 10, 0, 1, 5, 4, 0]);
        assert_eq!((work.once_of(Kind::Add), work.once_of(Kind::Load)), (0, 9));
        let fused = super::work::<Wald, Of<First, Fused>, 2>();
        assert_eq!(each(&fused), [2, 0, 10, 1, 5, 4, 0]);
    }

    /// The header: divided last 18 x, of which the search needs all but that of t_max, whose place the
    /// nearest hit so far takes. det's magnitude and t take the sign of det, and u and v come of t.
    /// det is above the subnormals, and its inverse is not 0: of 7 comparisons 6 join.
    #[test]
    fn wald_divided_last_is_what_its_header_says() {
        let work = work::<Wald, Of<Last, Plain>, 2>();
        assert_eq!(each(&work), [12, 17, 0, 1, 6, 4, 2]);
    }

    /// A surface keeps three numbers of the normal as well, and they are loaded.
    #[test]
    fn what_is_reported_is_needed() {
        let tuv = super::work::<PerpendicularPlanes, Of<First, Plain>, 2>();
        let surface = super::work::<PerpendicularPlanes, Of<First, Plain, Surface>, 2>();
        assert_eq!(surface.each_of(Kind::Select), tuv.each_of(Kind::Select) + 3);
        // The plane's normal is the triangle's, loaded already; its header: 15 x, 15 +-, 1 /.
        assert_eq!(each(&tuv), [15, 15, 0, 1, 5, 4, 0]);
        assert_eq!(surface.once_of(Kind::Load), tuv.once_of(Kind::Load));
    }
}
