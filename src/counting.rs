//! What a test executes: operations by kind, per kernel and exit path, without a clock.
//!
//! Every kernel runs on [`Counted`] numbers. What is prepared per triangle is not counted; what is
//! prepared per ray, met per triangle and tested is, as for a single ray and a single triangle.

use crate::batch::widened;
use crate::kernels::listings::{Listing, Literally};
use crate::number::{Counted, Operations, count};
use crate::policy::{
    Compare, Division, Early, First, Form, FromZero, Last, Plain, Policy, Tuv, TwoSided,
};
use crate::registry::{
    KernelVisitor, ListingVisitor, Offers, corners, visit_kernels, visit_listings,
};
use crate::workload::{Ray, Triangle};

/// The exit code of a test (0 is a hit) and the operations that it executed.
pub type Counts = fn(&Ray, &Triangle) -> (u8, Operations);

/// One form whose operations can be counted.
#[derive(Clone, Copy, Debug)]
pub struct Counter {
    /// The kernel's id.
    pub kernel: &'static str,
    /// What is stored of a triangle.
    pub stored: &'static str,
    /// How edge functions keep their signs; empty where there is no such choice.
    pub edges: &'static str,
    /// Which cross product triple products are computed by; empty for the kernel's own.
    pub cross: &'static str,
    /// `first` or `last`.
    pub division: &'static str,
    /// `t` or `tuv`.
    pub output: &'static str,
    /// Counts one test.
    pub run: Counts,
}

/// The tests that ended at one exit of a kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExitPath {
    /// The kernel's id.
    pub kernel: &'static str,
    /// What is stored of a triangle.
    pub stored: &'static str,
    /// How edge functions keep their signs; empty where there is no such choice.
    pub edges: &'static str,
    /// Which cross product triple products are computed by; empty for the kernel's own.
    pub cross: &'static str,
    /// `first` or `last`.
    pub division: &'static str,
    /// `t` or `tuv`.
    pub output: &'static str,
    /// The exit: 0 is a hit.
    pub code: u8,
    /// Tests that ended here.
    pub calls: u64,
    /// Operations of the test that executed the fewest. Only listings, which branch between their
    /// exits, have more than one path to an exit.
    pub shortest: Operations,
    /// Operations of the test that executed the most.
    pub longest: Operations,
}

/// Every listing with both outputs, and every kernel's own form: early, from zero, plain, `tuv`.
pub fn counters() -> Vec<Counter> {
    let mut counters = Vec::new();
    visit_listings(&mut Counting(&mut counters));
    visit_kernels(&mut Counting(&mut counters));
    counters
}

struct Counting<'a>(&'a mut Vec<Counter>);

impl KernelVisitor for Counting<'_> {
    fn kernel<K: Offers>(&mut self) {
        divisions::<K>(self.0);
    }
}

impl ListingVisitor for Counting<'_> {
    fn listing<K: Listing>(&mut self, division: &'static str) {
        listing::<K>(self.0, division);
    }
}

/// The number that counts.
type Number = Counted<f32>;

fn listing<K: Listing>(counters: &mut Vec<Counter>, division: &'static str) {
    let of = |output, run| Counter {
        kernel: K::ABOUT.id,
        stored: K::ABOUT.stored,
        edges: "",
        cross: "",
        division,
        output,
        run,
    };
    counters.push(of("t", listed::<K, false>));
    counters.push(of("tuv", listed::<K, true>));
}

fn listed<K: Listing, const UV: bool>(ray: &Ray, triangle: &Triangle) -> (u8, Operations) {
    let record = K::prepare(&corners::<Number>(triangle));
    let ray = widened(ray);
    count(|| K::run::<Number, Literally, UV>(&ray, &record).0)
}

fn divisions<K: Offers>(counters: &mut Vec<Counter>) {
    if K::FIRST {
        counters.push(form::<K, First>());
    }
    if K::LAST {
        counters.push(form::<K, Last>());
    }
}

fn form<K: Offers, D: Division>() -> Counter {
    type Of<K, D> = Form<Early, D, Plain, Tuv, TwoSided, Compare, <K as Offers>::Native, FromZero>;
    Counter {
        kernel: K::ABOUT.id,
        stored: K::ABOUT.stored,
        edges: K::EDGES,
        cross: K::CROSS,
        division: D::NAME,
        output: if K::UV { "tuv" } else { "t" },
        run: tested::<K, Of<K, D>>,
    }
}

fn tested<K: Offers, P: Policy>(ray: &Ray, triangle: &Triangle) -> (u8, Operations) {
    let record = K::prepare(&corners::<Number>(triangle));
    let ray = widened(ray);
    let (found, operations) = count(|| {
        let met = K::meet::<P, Number>((), &record);
        K::test::<P, Number>(&ray, &K::aim::<P, Number>(&ray), &met)
    });
    (found.map_or_else(|miss| miss.0, |_| 0), operations)
}

impl Operations {
    /// Additions, subtractions, unary minuses, multiplications and divisions.
    pub fn arithmetic(&self) -> u64 {
        self.add + self.sub + self.neg + self.mul + self.div
    }
    /// What orders paths by length: arithmetic, then if-statements, then comparisons.
    fn length(&self) -> (u64, u64, u64) {
        (self.arithmetic(), self.condition, self.compare)
    }
    fn min_by_length(self, other: Self) -> Self {
        if other.length() < self.length() { other } else { self }
    }
    fn max_by_length(self, other: Self) -> Self {
        if other.length() > self.length() { other } else { self }
    }
}

/// Where the tests of ray i against triangle i end, in the order of codes; exits that none came to
/// are absent.
pub fn paths(counter: &Counter, rays: &[Ray], triangles: &[Triangle]) -> Vec<ExitPath> {
    let mut paths: Vec<ExitPath> = Vec::new();
    for (ray, triangle) in rays.iter().zip(triangles) {
        let (code, operations) = (counter.run)(ray, triangle);
        if let Some(path) = paths.iter_mut().find(|path| path.code == code) {
            path.calls += 1;
            path.shortest = path.shortest.min_by_length(operations);
            path.longest = path.longest.max_by_length(operations);
        } else {
            let Counter { kernel, stored, edges, cross, division, output, .. } = *counter;
            let (calls, shortest, longest) = (1, operations, operations);
            paths.push(ExitPath {
                kernel,
                stored,
                edges,
                cross,
                division,
                output,
                code,
                calls,
                shortest,
                longest,
            });
        }
    }
    paths.sort_by_key(|path| path.code);
    paths
}
