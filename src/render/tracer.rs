//! What finds hits.

use crate::structure::{Hit, Leaf, Search, Structure};
use crate::workload::Ray;
use std::borrow::BorrowMut;

/// What finds hits: a kernel with a structure around its triangles, the exact answer, or a recording.
/// A picture is made with any of them, by the same code.
pub trait Tracer {
    /// The rays that follow belong to this pixel, counted by rows from the top left.
    fn begin(&mut self, _pixel: usize) {}
    /// The hit with the smallest t in the ray's range; of several at one distance the triangle with
    /// the lowest index.
    fn nearest(&mut self, ray: &Ray) -> Option<Hit>;
    /// Whether there is any hit in the ray's range.
    fn any(&mut self, ray: &Ray) -> bool;
    /// Tests of a ray against a triangle so far.
    fn triangles_tested(&self) -> u64;
}

/// The triangles of a kernel in a structure, with a search of its own or one that is lent.
pub struct Searcher<'a, S = Search> {
    structure: &'a dyn Structure,
    search: S,
}

impl<'a> Searcher<'a> {
    /// `structure` holds the triangles of the leaf.
    pub fn new(structure: &'a dyn Structure, leaf: Box<dyn Leaf>) -> Self {
        Searcher { structure, search: Search::new(leaf) }
    }
}

impl<'a> Searcher<'a, &'a mut Search> {
    /// The same of a search that goes on counting afterwards.
    pub(super) fn lent(structure: &'a dyn Structure, search: &'a mut Search) -> Self {
        Searcher { structure, search }
    }
}

impl<S: BorrowMut<Search>> Tracer for Searcher<'_, S> {
    fn nearest(&mut self, ray: &Ray) -> Option<Hit> {
        self.search.borrow_mut().nearest(self.structure, ray)
    }

    fn any(&mut self, ray: &Ray) -> bool {
        self.search.borrow_mut().any(self.structure, ray)
    }

    fn triangles_tested(&self) -> u64 {
        self.search.borrow().counts().triangles
    }
}
