//! Every form of every kernel over exact numbers, in groups that must agree.

use ray_test::kernels::{Corners, Kernel};
use ray_test::policy::{
    Between, Compare, Cull, Divide, Division, Early, Estimated, Exit, Facing, First, Form,
    FromZero, Full, Fused, Last, Leading, Once, Plain, Policy, Products, Ray, Reciprocal, Rounding,
    SignBits, SignBitsSafe, Span, Tests, Tuv, TwoSided,
};
use ray_test::registry::{KernelVisitor, Offers, Other, visit_kernels};

use super::exact::Exact;

/// t, u and v of a hit.
pub type Answer = Option<[Exact; 3]>;

/// One form, from a triangle's corners on.
pub type Run = fn(&Ray<Exact>, &Corners<Exact>) -> Answer;

/// The forms of a kernel that differ in no convention, only in how the work is done.
pub struct Group {
    /// The kernel's id.
    pub kernel: &'static str,
    /// What is stored.
    pub stored: &'static str,
    /// `compare`, `sign-bits`, `sign-bits-safe` or `products`.
    pub tests: &'static str,
    /// Back faces are missed.
    pub culls: bool,
    /// t_min is zero and not read.
    pub from_zero: bool,
    /// The forms with their axes.
    pub forms: Vec<(String, Run)>,
}

/// Every group.
pub fn groups() -> Vec<Group> {
    let mut groups = Vec::new();
    visit_kernels(&mut Laws(&mut groups));
    groups
}

struct Laws<'a>(&'a mut Vec<Group>);

impl KernelVisitor for Laws<'_> {
    /// But the sum of angles, whose arc cosines are not rational. In f64 is no exception: an exact
    /// number is as wide as it gets and widens to itself.
    fn kernel<K: Offers>(&mut self) {
        if K::ABOUT.id != "angle-sum" {
            kernel::<K>(self.0);
        }
    }
}

fn kernel<K: Offers>(groups: &mut Vec<Group>) {
    spans::<K, TwoSided, Compare>(groups);
    if K::CULLS {
        spans::<K, Cull, Compare>(groups);
    }
    if K::SIGN_BITS {
        spans::<K, TwoSided, SignBits>(groups);
        spans::<K, TwoSided, SignBitsSafe>(groups);
    }
    if K::PRODUCTS {
        spans::<K, TwoSided, Products>(groups);
    }
}

fn spans<K: Offers, F: Facing, C: Tests>(groups: &mut Vec<Group>) {
    groups.push(group::<K, F, C, FromZero>());
    groups.push(group::<K, F, C, Between>());
}

fn group<K: Offers, F: Facing, C: Tests, S: Span>() -> Group {
    let mut forms = Vec::new();
    if K::FIRST && !C::SIGN_BITS {
        exits::<K, First, F, C, S>(&mut forms);
    }
    if K::LAST {
        exits::<K, Last, F, C, S>(&mut forms);
    }
    Group {
        kernel: K::ABOUT.id,
        stored: K::ABOUT.stored,
        tests: C::NAME,
        culls: F::CULLS,
        from_zero: S::FROM_ZERO,
        forms,
    }
}

fn exits<K: Offers, D: Division, F: Facing, C: Tests, S: Span>(forms: &mut Vec<(String, Run)>) {
    orders::<K, Early, D, Plain, F, C, S>(forms);
    orders::<K, Early, D, Fused, F, C, S>(forms);
    orders::<K, Full, D, Plain, F, C, S>(forms);
    orders::<K, Full, D, Fused, F, C, S>(forms);
    if K::TECHNIQUES {
        orders::<K, Once, D, Plain, F, C, S>(forms);
        // An exact number has no estimate; that of 1 / x is kept by Newton's steps.
        one::<K, Early, D, Fused, F, C, S, Estimated<0>>(forms);
        one::<K, Full, D, Fused, F, C, S, Estimated<1>>(forms);
        one::<K, Full, D, Plain, F, C, S, Estimated<2>>(forms);
    }
}

/// In the kernel's own order, with reciprocals `V`.
fn one<K, E, D, A, F, C, S, V>(forms: &mut Vec<(String, Run)>)
where
    K: Offers,
    E: Exit,
    D: Division,
    A: Rounding,
    F: Facing,
    C: Tests,
    S: Span,
    V: Reciprocal,
{
    let axes = format!("{}/{}/{}/{}/{}", E::NAME, D::NAME, A::NAME, K::Native::NAME, V::NAME);
    forms.push((axes, run::<K, Form<E, D, A, Tuv, F, C, K::Native, S, V>>));
}

fn orders<K, E, D, A, F, C, S>(forms: &mut Vec<(String, Run)>)
where
    K: Offers,
    E: Exit,
    D: Division,
    A: Rounding,
    F: Facing,
    C: Tests,
    S: Span,
{
    let axes = |order: &str| format!("{}/{}/{}/{order}", E::NAME, D::NAME, A::NAME);
    one::<K, E, D, A, F, C, S, Divide>(forms);
    if K::BOTH_ORDERS {
        type Swapped<K> = <<K as Offers>::Native as Other>::Other;
        forms.push((axes(Swapped::<K>::NAME), run::<K, Form<E, D, A, Tuv, F, C, Swapped<K>, S>>));
    }
}

fn run<K: Kernel, P: Policy>(ray: &Ray<Exact>, corners: &Corners<Exact>) -> Answer {
    let met = K::meet::<P, Exact>((), &K::prepare(corners));
    match K::test::<P, Exact>(ray, &K::aim::<P, Exact>(ray), &met) {
        Ok(found) if found.hit => Some([found.t, found.u, found.v]),
        _ => None,
    }
}

/// Whether two answers are the same.
pub fn same(a: &Answer, b: &Answer) -> bool {
    match (a, b) {
        (Some(a), Some(b)) => a.iter().zip(b).all(|(a, b)| a.same(*b)),
        (None, None) => true,
        _ => false,
    }
}
