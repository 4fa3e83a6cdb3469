//! The nearest hit so far.

use super::{WIDEST, surface_point};
use crate::number::{Element, Real, Vec3};
use crate::policy::{Exit, Found, Output, Policy, Ray};

/// Numbers of an answer: triangle (as a number; -1 without a hit), t, u, v, point, normal.
pub const ANSWER_NUMBERS: usize = 10;

/// What is known so far of a ray, a packet of rays, or a ray against one triangle per lane.
#[derive(Clone, Copy)]
pub struct Best<R: Real> {
    hit: R::Mask,
    triangle: R,
    t: R,
    u: R,
    v: R,
    normal: Vec3<R>,
}

impl<R: Real> Best<R> {
    /// Nothing: t is the ray's bound.
    #[inline(always)]
    pub fn nothing(token: R::Token, ray: &Ray<R>) -> Self {
        let zero = R::splat(token, R::Element::ZERO);
        Best {
            hit: R::mask(token, false),
            triangle: -R::splat(token, R::Element::ONE),
            t: ray.t_max,
            u: zero,
            v: zero,
            normal: Vec3([zero; 3]),
        }
    }

    /// Takes over a hit where it is nearer. With `t` wanted, the triangle says whether there is a
    /// hit; without, the mask does: either way it is one register less in the loop.
    #[inline(always)]
    pub fn update<P: Policy>(
        &mut self,
        ray: &mut Ray<R>,
        found: &Found<R>,
        index: R,
        normal: Vec3<R>,
    ) {
        if !P::Output::T {
            self.hit = self.hit | found.hit;
            return;
        }
        let nearer = found.t.lt_where(self.t, found.hit);
        let Found { t, u, v, .. } = *found;
        if P::Output::SURFACE {
            let ([x, y, z], [ox, oy, oz]) = (normal.0, self.normal.0);
            let old = [self.t, self.triangle, self.u, self.v, ox, oy, oz];
            let new = P::Exit::select(nearer, [t, index, u, v, x, y, z], old);
            [self.t, self.triangle, self.u, self.v] = [new[0], new[1], new[2], new[3]];
            self.normal = Vec3([new[4], new[5], new[6]]);
        } else if P::Output::UV {
            let old = [self.t, self.triangle, self.u, self.v];
            let new = P::Exit::select(nearer, [t, index, u, v], old);
            [self.t, self.triangle, self.u, self.v] = new;
        } else {
            let new = P::Exit::select(nearer, [t, index], [self.t, self.triangle]);
            [self.t, self.triangle] = new;
        }
        ray.t_max = self.t;
    }

    /// What goes from test to test: whether there is a hit, and its triangle, t, u, v and normal.
    pub fn carried(&self) -> (R::Mask, [R; 7]) {
        let [x, y, z] = self.normal.0;
        (self.hit, [self.triangle, self.t, self.u, self.v, x, y, z])
    }

    /// The answer: triangle, t, u, v, point, normal.
    #[inline(always)]
    pub fn rows<P: Policy>(&self, ray: &Ray<R>) -> [R; ANSWER_NUMBERS] {
        let point = if P::Output::SURFACE {
            surface_point(ray.origin, ray.direction, self.t)
        } else {
            self.normal
        };
        let [x, y, z] = point.0;
        let [nx, ny, nz] = self.normal.0;
        // Where only the hit is wanted no triangle was noted; 0 stands for "one of them".
        let mut triangle = [self.triangle];
        if !P::Output::T {
            triangle = P::Exit::select(self.hit, [self.triangle.zero()], triangle);
        }
        [triangle[0], self.t, self.u, self.v, x, y, z, nx, ny, nz]
    }

    /// Stores the answer: ten rows of [`Real::LANES`] numbers.
    #[inline(always)]
    pub fn write<P: Policy>(&self, ray: &Ray<R>, answer: &mut [R::Element]) {
        let places = answer.chunks_exact_mut(R::LANES);
        for (row, place) in self.rows::<P>(ray).into_iter().zip(places) {
            row.store(place);
        }
    }

    /// The smallest distance of all lanes, whose number is a power of two: by halves, which takes
    /// fewer registers than one after the other.
    #[inline(always)]
    pub fn nearest_t(&self) -> R::Element {
        let mut lanes = lanes_of(self.t);
        let mut half = R::LANES / 2;
        while half > 0 {
            for lane in 0..half {
                let (t, other) = (lanes[lane], lanes[lane + half]);
                lanes[lane] = R::Element::select(other.lt(t), other, t);
            }
            half /= 2;
        }
        lanes[0]
    }
}

/// A number's lanes, the first [`Real::LANES`] of the array.
#[inline(always)]
pub fn lanes_of<R: Real>(number: R) -> [R::Element; WIDEST] {
    let mut lanes = [R::Element::ZERO; WIDEST];
    number.store(&mut lanes);
    lanes
}
