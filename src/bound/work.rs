//! What a test leaves to be done, by kind of operation.

use crate::batch::{Best, Kind, step, step_shared};
use crate::kernels::{Common, Corners, Kernel, Shares, Whole};
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
    /// Whether what is done once is done of as many triangles at a time as a register has lanes.
    pub in_groups: bool,
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
                    Noted::OfTriangle(_) | Noted::Kept => Kind::Load,
                    Noted::Compare(_) => {
                        compares += 1;
                        continue;
                    }
                    Noted::Join(_) => {
                        joins += 1;
                        continue;
                    }
                    Noted::OfRay | Noted::OfGroup(_) | Noted::OfBoth | Noted::Free(_) => continue,
                };
                counts[kind as usize - 1] += 1;
            }
            counts[Kind::Compare as usize - 1] = joins.min(compares);
            counts
        };
        Work { each: count(&needed.each), once: count(&needed.once), in_groups: false }
    }
}

/// A ray, and a triangle that it hits, without anything that happens to be 0 or equal.
const ORIGIN: [f64; 3] = [0.25, 0.375, -2.0];
const DIRECTION: [f64; 3] = [0.125, 0.0625, 1.5];
const CORNERS: [[f64; 3]; 3] = [[-1.0, -0.5, 2.0], [3.0, -0.75, 2.25], [0.5, 4.0, 1.75]];

/// The work of a kernel in the form `P`, which computes everything, in the search for the nearest
/// hit; `LANES` is 1 for single rays, above that for packets, which differ in how rays are picked from.
pub fn work<K: Kernel, P: Policy, const LANES: usize>() -> Work {
    let needed = needed(|| {
        let number = |(place, value)| TracedOne::input(Noted::OfTriangle(place), value);
        let stored: Vec<TracedOne> = record::<K>().into_iter().enumerate().map(number).collect();
        let mut ray = ray::<LANES>();
        let mut best = Best::nothing((), &ray);
        let aim = K::aim::<P, Traced<LANES>>(&ray);
        let met = Spread::spread((), K::read::<P, TracedOne, _>(&Whole(&stored)));
        step::<K, P, Traced<LANES>>(&mut ray, &aim, &met, index(), &mut best);
        results(&best)
    });
    Work::of(&needed)
}

/// [`work`] where the rays of a packet have something in common.
pub fn shared_work<K: Shares<C>, P: Policy, C: Common>() -> Work {
    let needed = needed(|| {
        let number = |(place, value)| Traced::<2>::input(Noted::OfGroup(place), value);
        let stored: Vec<Traced<2>> = record::<K>().into_iter().enumerate().map(number).collect();
        let mut ray = ray::<2>();
        let mut best = Best::nothing((), &ray);
        let aim = K::aim::<P, Traced<2>>(&ray);
        let met = K::read::<P, Traced<2>, _>(&Whole(&stored));
        let shared = <K as Shares<C>>::share::<P, Traced<2>>(&common_ray(stored.len()), &met);
        let shared: Vec<Traced<2>> = shared.as_ref().iter().map(|number| number.kept()).collect();
        step_shared::<K, P, _, C, _>(&mut ray, &aim, &Whole(&shared), index(), &mut best);
        results(&best)
    });
    Work { in_groups: true, ..Work::of(&needed) }
}

/// What is stored of the triangle.
fn record<K: Kernel>() -> Vec<f64> {
    let [a, b, c] = CORNERS.map(Vec3);
    K::prepare::<f64>(&Corners { a, b, c }).as_ref().to_vec()
}

/// The ray, whose numbers are made by `number`; its bound is the search's.
fn ray_of<const LANES: usize>(mut number: impl FnMut(f64) -> Traced<LANES>) -> Ray<Traced<LANES>> {
    let end = [0, 1, 2].map(|axis| ORIGIN[axis] + 4.0 * DIRECTION[axis]);
    Ray {
        origin: Vec3(ORIGIN.map(&mut number)),
        direction: Vec3(DIRECTION.map(&mut number)),
        end: Vec3(end.map(&mut number)),
        t_min: number(0.0),
        t_max: Traced::input(Noted::OfBoth, 1e6),
    }
}

/// A ray of a packet.
fn ray<const LANES: usize>() -> Ray<Traced<LANES>> {
    ray_of(|value| Traced::input(Noted::OfRay, value))
}

/// The ray that stands for all of a packet; its numbers are told from others by their places.
fn common_ray(mut place: usize) -> Ray<Traced<2>> {
    ray_of(|value| {
        place += 1;
        Traced::input(Noted::OfGroup(place), value)
    })
}

/// The number of the triangle, which counts in every lane.
fn index<const LANES: usize>() -> Traced<LANES> {
    Traced::input(Noted::OfBoth, 1.0)
}

/// What goes from test to test.
fn results<const LANES: usize>(best: &Best<Traced<LANES>>) -> Vec<Place> {
    let (hit, numbers) = best.carried();
    numbers.into_iter().map(Traced::place).chain([hit.place()]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernels::{CommonOrigin, MollerTrumbore, Parallel, PerpendicularPlanes, Wald};
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
        // u >= 0, v >= 0, u + v <= 1 (and so u <= 1), t >= 0, t < best: of 5, 4 join; 4 numbers are kept.
        assert_eq!(each(&work), [18, 27, 0, 1, 4, 4, 0]);
        assert_eq!((work.once_of(Kind::Add), work.once_of(Kind::Load)), (6, 9));
    }

    /// Fused, a dot product is 1 multiplication and 2 fused, a cross product 3 and 3: of 4 and 2 of
    /// them, with a division and 3 multiplications by the reciprocal; differences stay: s (3), u + v.
    #[test]
    fn fused_moller_trumbore_is_what_its_products_are() {
        let work = work::<MollerTrumbore, Of<First, Fused, Tuv, Inside>, 2>();
        assert_eq!(each(&work), [4, 3 + 4 + 6, 8 + 6, 1, 4, 4, 0]);
    }

    /// The header: divided first 10 x, 12 +-, 1 /. The normal, which is not reported, is not there: 9
    /// numbers of the plane and the lines are loaded, and not its sign.
    #[test]
    fn wald_divided_first_is_what_its_header_says() {
        let work = work::<Wald, Of<First, Plain>, 2>();
        assert_eq!(each(&work), [12, 10, 0, 1, 4, 4, 0]);
        assert_eq!((work.once_of(Kind::Add), work.once_of(Kind::Load)), (0, 9));
        let fused = super::work::<Wald, Of<First, Fused>, 2>();
        assert_eq!(each(&fused), [2, 0, 10, 1, 4, 4, 0]);
    }

    /// The header: divided last 18 x, of which the search needs all but that of t_max, whose place the
    /// nearest hit so far takes. det's magnitude and t take the sign of det, and u and v come of t.
    /// det is above the subnormals, and its inverse is not 0: of 7 comparisons 6 join.
    #[test]
    fn wald_divided_last_is_what_its_header_says() {
        let work = work::<Wald, Of<Last, Plain>, 2>();
        assert_eq!(each(&work), [12, 17, 0, 1, 6, 4, 2]);
    }

    /// Of the planes' 15 x 13 are fused (n . o and n . direction begin with one that is not). n . o, 2 of
    /// them, is the same for a common origin, n . direction, with its reciprocal, for a common direction.
    #[test]
    fn what_rays_share_is_done_once() {
        type Planes = PerpendicularPlanes;
        let general = super::work::<Planes, Of<Last, Fused>, 2>();
        let origin = shared_work::<Planes, Of<Last, Fused>, CommonOrigin>();
        let parallel = shared_work::<Planes, Of<Last, Fused>, Parallel>();
        assert!(origin.in_groups && parallel.in_groups && !general.in_groups);
        let fused = |work: &Work| [work.each_of(Kind::Fused), work.once_of(Kind::Fused)];
        assert_eq!(
            [fused(&general), fused(&origin), fused(&parallel)],
            [[13, 0], [11, 2], [11, 2]]
        );
        let divisions = |work: &Work| [work.each_of(Kind::Divide), work.once_of(Kind::Divide)];
        assert_eq!([divisions(&origin), divisions(&parallel)], [[1, 0], [0, 1]]);
        assert_eq!([general.once_of(Kind::Load), origin.once_of(Kind::Load)], [12, 12]);
        assert_eq!(parallel.once_of(Kind::Load), 14);
    }

    /// A surface keeps three numbers of the normal as well, and they are loaded.
    #[test]
    fn what_is_reported_is_needed() {
        let tuv = super::work::<PerpendicularPlanes, Of<First, Plain>, 2>();
        let surface = super::work::<PerpendicularPlanes, Of<First, Plain, Surface>, 2>();
        assert_eq!(surface.each_of(Kind::Select), tuv.each_of(Kind::Select) + 3);
        // The plane's normal is the triangle's, loaded already; its header: 15 x, 15 +-, 1 /.
        assert_eq!(each(&tuv), [15, 15, 0, 1, 4, 4, 0]);
        assert_eq!(surface.once_of(Kind::Load), tuv.once_of(Kind::Load));
    }
}
