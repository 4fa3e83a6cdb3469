//! The plain list: every ray against every triangle.

use super::{Beam, Search, Structure};

/// Every triangle, in order.
#[derive(Clone, Debug)]
pub struct List {
    indices: Vec<u32>,
}

impl List {
    /// Of the first `count` triangles.
    pub fn new(count: u32) -> Self {
        List { indices: (0..count).collect() }
    }
}

impl Structure for List {
    fn walk(&self, _: &Beam, search: &mut Search) {
        search.test(&self.indices);
    }

    fn bytes(&self) -> usize {
        size_of_val(self.indices.as_slice())
    }
}
