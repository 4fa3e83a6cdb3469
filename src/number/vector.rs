//! Three numbers: a point, or a free vector.

use std::ops::{Add, Sub};

use super::Real;

/// Three numbers. An array, so that a kernel can index it where memory holds it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vec3<R>(pub [R; 3]);

impl<R: Copy> Vec3<R> {
    /// First component.
    #[inline(always)]
    pub fn x(self) -> R {
        self.0[0]
    }
    /// Second component.
    #[inline(always)]
    pub fn y(self) -> R {
        self.0[1]
    }
    /// Third component.
    #[inline(always)]
    pub fn z(self) -> R {
        self.0[2]
    }
}

impl<R: Real> Vec3<R> {
    /// The same vector in every lane. Components one by one: a `map` with a closure is not always
    /// inlined into the level's shell.
    #[inline(always)]
    pub fn splat(token: R::Token, v: Vec3<R::Element>) -> Self {
        Vec3([R::splat(token, v.0[0]), R::splat(token, v.0[1]), R::splat(token, v.0[2])])
    }
    /// `self * factor`, component by component.
    #[inline(always)]
    pub fn scaled(self, factor: R) -> Self {
        Vec3([self.0[0] * factor, self.0[1] * factor, self.0[2] * factor])
    }
}

impl<R: Real> Add for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Vec3([self.0[0] + other.0[0], self.0[1] + other.0[1], self.0[2] + other.0[2]])
    }
}

impl<R: Real> Sub for Vec3<R> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Vec3([self.0[0] - other.0[0], self.0[1] - other.0[1], self.0[2] - other.0[2]])
    }
}
