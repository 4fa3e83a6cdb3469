//! A kernel's hits: every triangle that the ray may meet is tested, one by one.

use super::sieve::{Boxes, Line};
use super::tracer::{Hit, Tracer};
use crate::oracle::Query;
use crate::workload::{Ray, Triangle};

/// A search goes this much beyond the nearest hit so far, in parts of its distance: a thousand
/// roundings of f32, so that a triangle is found although a kernel takes another for a little nearer
/// than it is.
const SLACK: f64 = 1.0 / 16_384.0;

/// The triangles that rays are tested against.
#[derive(Clone, Copy, Debug)]
pub enum Sieve<'a> {
    /// All.
    List,
    /// Those in boxes that the ray meets.
    Boxes(&'a Boxes),
}

impl Sieve<'_> {
    /// Shows triangles, of `count`; `visit` tells the t beyond which nothing is wanted any more.
    pub(super) fn walk(&self, line: &Line, count: usize, visit: &mut dyn FnMut(u32) -> f64) {
        match self {
            Sieve::List => (0..count as u32).for_each(|one| {
                visit(one);
            }),
            Sieve::Boxes(boxes) => boxes.walk(line, visit),
        }
    }
}

/// What a kernel answers.
#[derive(Clone, Copy)]
pub struct Kernel<'a> {
    /// The t of a hit, in units of the query's direction; `None` for a miss.
    pub ask: &'a dyn Fn(&Query) -> Option<f64>,
    /// It answers about the segment from origin to end, not about the ray.
    pub is_segment: bool,
}

impl Kernel<'_> {
    /// What it is asked about a ray and a triangle.
    pub fn query(&self, ray: &Ray, triangle: &Triangle) -> Query {
        if self.is_segment { Query::of_segment(ray, triangle) } else { Query::of(ray, triangle) }
    }
}

/// A kernel and triangles.
pub struct Searcher<'a> {
    kernel: Kernel<'a>,
    triangles: &'a [Triangle],
    sieve: Sieve<'a>,
    tested: u64,
}

impl<'a> Searcher<'a> {
    /// `sieve` holds the same triangles.
    pub fn new(kernel: Kernel<'a>, triangles: &'a [Triangle], sieve: Sieve<'a>) -> Self {
        Searcher { kernel, triangles, sieve, tested: 0 }
    }

    fn search(&mut self, ray: &Ray, ends_at_any: bool) -> Option<Hit> {
        let mut best: Option<Hit> = None;
        let line = Line::new(ray, self.kernel.is_segment);
        self.sieve.walk(&line, self.triangles.len(), &mut |triangle| {
            if ends_at_any && best.is_some() {
                return f64::NEG_INFINITY;
            }
            self.tested += 1;
            let query = self.kernel.query(ray, &self.triangles[triangle as usize]);
            let hit = (self.kernel.ask)(&query).map(|t| Hit { triangle, t });
            if let Some(hit) = hit.filter(|hit| best.is_none_or(|best| hit.precedes(&best))) {
                best = Some(hit);
            }
            best.map_or(f64::INFINITY, |best| if ends_at_any { f64::NEG_INFINITY } else { best.t + best.t.abs() * SLACK })
        });
        best
    }
}

impl Tracer for Searcher<'_> {
    fn nearest(&mut self, ray: &Ray) -> Option<Hit> {
        self.search(ray, false)
    }

    fn any(&mut self, ray: &Ray) -> Option<Hit> {
        self.search(ray, true)
    }

    fn triangles_tested(&self) -> u64 {
        self.tested
    }
}
