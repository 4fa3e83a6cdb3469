//! How a listing's operations are carried out: literally, or with one kind of them done twice so
//! that its price can be measured.

use std::hint::black_box;

use crate::number::{Element, Vec3};

/// The five kinds of operation whose share of the time thesis B measures (4.4).
pub trait Script: Copy + 'static {
    /// The column `priced`, empty for the literal form.
    const NAME: &'static str;
    /// The kind of operation that is done twice, if any.
    const KIND: Option<Cost>;
    /// `false`: the operands of that kind pass through the same opaque barrier as for a second
    /// operation, which is left out. The difference of both is the operation's price alone.
    const TWICE: bool;

    /// a . b, summed from the left.
    #[inline(always)]
    fn dot<E: Element>(a: Vec3<E>, b: Vec3<E>) -> E {
        if Self::KIND == Some(Cost::Dot) {
            let other = opaque(a);
            black_box(if Self::TWICE { plain_dot(other, b) } else { other.x() });
        }
        plain_dot(a, b)
    }
    /// a x b
    #[inline(always)]
    fn cross<E: Element>(a: Vec3<E>, b: Vec3<E>) -> Vec3<E> {
        if Self::KIND == Some(Cost::Cross) {
            let other = opaque(a);
            opaque(if Self::TWICE { plain_cross(other, b) } else { other });
        }
        plain_cross(a, b)
    }
    /// a - b
    #[inline(always)]
    fn difference<E: Element>(a: Vec3<E>, b: Vec3<E>) -> Vec3<E> {
        if Self::KIND == Some(Cost::Difference) {
            let other = opaque(a);
            opaque(if Self::TWICE { other - b } else { other });
        }
        a - b
    }
    /// a / b
    #[inline(always)]
    fn divide<E: Element>(a: E, b: E) -> E {
        if Self::KIND == Some(Cost::Division) {
            let other = black_box(a);
            black_box(if Self::TWICE { other / b } else { other });
        }
        a / b
    }
    /// if (truth)
    #[inline(always)]
    fn condition<E: Element>(truth: bool) -> bool {
        if Self::KIND == Some(Cost::Condition) {
            let other = black_box(truth);
            // The barrier inside the branch keeps it a branch.
            if Self::TWICE && other {
                black_box(());
            }
        }
        E::condition(truth)
    }
}

/// A vector that the optimiser knows nothing of, number by number: a barrier around all three at
/// once stores them one by one and loads them together, and a processor stalls on that.
#[inline(always)]
fn opaque<E: Element>(v: Vec3<E>) -> Vec3<E> {
    Vec3([black_box(v.x()), black_box(v.y()), black_box(v.z())])
}

#[inline(always)]
fn plain_dot<E: Element>(a: Vec3<E>, b: Vec3<E>) -> E {
    a.x() * b.x() + a.y() * b.y() + a.z() * b.z()
}

#[inline(always)]
fn plain_cross<E: Element>(a: Vec3<E>, b: Vec3<E>) -> Vec3<E> {
    Vec3([
        a.y() * b.z() - a.z() * b.y(),
        a.z() * b.x() - a.x() * b.z(),
        a.x() * b.y() - a.y() * b.x(),
    ])
}

/// A kind of operation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cost {
    /// Dot product of two vectors.
    Dot,
    /// Cross product of two vectors.
    Cross,
    /// Difference of two vectors.
    Difference,
    /// Division of two numbers.
    Division,
    /// An if-statement.
    Condition,
}

/// As printed.
#[derive(Clone, Copy)]
pub struct Literally;

impl Script for Literally {
    const NAME: &'static str = "";
    const KIND: Option<Cost> = None;
    const TWICE: bool = false;
}

/// Operations of kind `K` (an index into [`Priced::KINDS`]) twice, or the control of that.
#[derive(Clone, Copy)]
pub struct Priced<const K: usize, const TWICE: bool>;

impl<const K: usize, const TWICE: bool> Priced<K, TWICE> {
    /// The kinds, with the values of the column `priced` for twice and for the control.
    pub const KINDS: [(Cost, &'static str, &'static str); 5] = [
        (Cost::Dot, "dot", "dot-control"),
        (Cost::Cross, "cross", "cross-control"),
        (Cost::Difference, "difference", "difference-control"),
        (Cost::Division, "division", "division-control"),
        (Cost::Condition, "condition", "condition-control"),
    ];
}

impl<const K: usize, const TWICE: bool> Script for Priced<K, TWICE> {
    const NAME: &'static str = if TWICE { Self::KINDS[K].1 } else { Self::KINDS[K].2 };
    const KIND: Option<Cost> = Some(Self::KINDS[K].0);
    const TWICE: bool = TWICE;
}
