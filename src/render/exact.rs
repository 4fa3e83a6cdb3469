//! The exact answers about a ray and many triangles.

use crate::oracle::{Exact, Query, classify, nearest, solve};
use crate::structure::{Best, Hit, Leaf, Search, Structure};
use crate::workload::{Ray, Triangle};
use std::cell::RefCell;
use std::rc::Rc;

/// What a form of a kernel is asked about a ray and a triangle.
pub(super) fn query(ray: &Ray, triangle: &Triangle, is_segment: bool) -> Query {
    if is_segment { Query::of_segment(ray, triangle) } else { Query::of(ray, triangle) }
}

/// What the oracle said about the present ray: triangles that it hits, with the answers.
type Hits = Rc<RefCell<Vec<(u32, Exact)>>>;

/// Triangles that the oracle is asked about.
struct ExactLeaf {
    triangles: Rc<[Triangle]>,
    is_segment: bool,
    ray: Option<Ray>,
    hits: Hits,
}

impl Leaf for ExactLeaf {
    fn is_segment(&self) -> bool {
        self.is_segment
    }

    fn triangles(&self) -> usize {
        self.triangles.len()
    }

    fn bytes(&self) -> usize {
        size_of_val(self.triangles.as_ref())
    }

    fn aim(&mut self, ray: &Ray) {
        self.ray = Some(*ray);
        self.hits.borrow_mut().clear();
    }

    /// The exact distance is rounded to f32 where it bounds the search: far within the slack that
    /// every search has. So the exactly nearest is among the hits, and those as near.
    fn test(&mut self, indices: &[u32], best: &mut Best) {
        let Some(ray) = self.ray else { return };
        for &triangle in indices {
            let query = query(&ray, &self.triangles[triangle as usize], self.is_segment);
            if classify(&query).is_hit() {
                let exact = solve(&query);
                self.hits.borrow_mut().push((triangle, exact));
                let [t, u, v] = [exact.t, exact.u, exact.v].map(|x| x as f32);
                best.offer(Hit { triangle, t, u, v });
            }
        }
    }
}

/// The exact answers about triangles in a structure.
pub struct Exactly<'a> {
    triangles: Rc<[Triangle]>,
    structure: &'a dyn Structure,
    is_segment: bool,
    search: Search,
    hits: Hits,
}

impl<'a> Exactly<'a> {
    /// For segments from origin to end, or for rays. `structure` holds the triangles.
    pub fn new(triangles: &[Triangle], structure: &'a dyn Structure, is_segment: bool) -> Self {
        let (triangles, hits): (Rc<[Triangle]>, Hits) = (triangles.into(), Hits::default());
        let leaf = ExactLeaf {
            triangles: Rc::clone(&triangles),
            is_segment,
            ray: None,
            hits: Rc::clone(&hits),
        };
        Exactly { triangles, structure, is_segment, search: Search::new(Box::new(leaf)), hits }
    }

    /// What a kernel is asked about a ray and a triangle.
    pub fn query(&self, ray: &Ray, triangle: u32) -> Query {
        query(ray, &self.triangles[triangle as usize], self.is_segment)
    }

    /// The nearest triangle that is hit, of several at one distance the lowest index. Distances of
    /// rays are compared exactly, those of segments to 105 bits.
    pub fn nearest(&mut self, ray: &Ray) -> Option<(u32, Exact)> {
        self.search.nearest(self.structure, ray)?;
        let mut hits = self.hits.borrow_mut();
        hits.sort_by_key(|(triangle, _)| *triangle);
        if self.is_segment {
            let by_t = |a: &Exact, b: &Exact| a.t.total_cmp(&b.t).then(a.t_lo.total_cmp(&b.t_lo));
            return hits.iter().copied().min_by(|a, b| by_t(&a.1, &b.1));
        }
        let hit: Vec<Triangle> =
            hits.iter().map(|(triangle, _)| self.triangles[*triangle as usize]).collect();
        nearest(ray, &hit).map(|(place, exact)| (hits[place].0, exact))
    }
}
