//! Which triangles a ray can meet at all, so that exact answers need not ask every triangle.

use crate::oracle::{self, Exact};
use crate::structure::{Beam, Best, Leaf, Search, Structure, kind};
use crate::workload::{Ray, Triangle};
use std::cell::RefCell;
use std::rc::Rc;

/// Triangles in a hierarchy that misses none ([`crate::structure::volume`]).
pub struct Nearby<'a> {
    triangles: &'a [Triangle],
    structure: Box<dyn Structure>,
    search: Search,
    seen: Rc<RefCell<Vec<u32>>>,
}

/// A leaf that tests nothing and remembers what it was asked about, so that a search goes everywhere
/// that the ray does.
struct Remembering {
    triangles: usize,
    seen: Rc<RefCell<Vec<u32>>>,
}

impl Leaf for Remembering {
    fn is_segment(&self) -> bool {
        false
    }

    fn triangles(&self) -> usize {
        self.triangles
    }

    fn bytes(&self) -> usize {
        0
    }

    fn aim(&mut self, _: &Ray) {
        self.seen.borrow_mut().clear();
    }

    fn test(&mut self, indices: &[u32], _: &mut Best) {
        self.seen.borrow_mut().extend_from_slice(indices);
    }
}

/// The structure that is walked; all of them miss nothing, and this one is built the fastest.
const KIND: &str = "obvhs";

impl<'a> Nearby<'a> {
    /// Of those triangles.
    pub fn new(triangles: &'a [Triangle]) -> Self {
        let seen = Rc::new(RefCell::new(Vec::new()));
        let leaf = Remembering { triangles: triangles.len(), seen: Rc::clone(&seen) };
        let built = kind(KIND).map(|kind| (kind.build)(triangles));
        let list = || Box::new(crate::structure::List::new(triangles.len() as u32)) as Box<_>;
        let structure: Box<dyn Structure> = built.unwrap_or_else(list);
        Nearby { triangles, structure, search: Search::new(Box::new(leaf)), seen }
    }

    /// All triangles.
    pub fn triangles(&self) -> &'a [Triangle] {
        self.triangles
    }

    /// In ascending order, the indices of all triangles that the ray may meet within its range, and of
    /// some that it does not.
    pub fn of(&mut self, ray: &Ray) -> Vec<u32> {
        // A ray that no beam can be made of would leave the last ray's triangles.
        if Beam::of_ray(ray).is_none() {
            return Vec::new();
        }
        // Nothing is ever offered, so nothing is found.
        let _ = self.search.nearest(self.structure.as_ref(), ray);
        let mut seen = self.seen.borrow().clone();
        seen.sort_unstable();
        seen.dedup();
        seen
    }

    /// Those triangles themselves.
    pub fn taken(&self, indices: &[u32]) -> Vec<Triangle> {
        indices.iter().map(|index| self.triangles[*index as usize]).collect()
    }

    /// The exact nearest triangle; equal distances go to the lowest index.
    pub fn nearest(&mut self, ray: &Ray) -> Option<(usize, Exact)> {
        let near = self.of(ray);
        let (place, exact) = oracle::nearest(ray, &self.taken(&near))?;
        Some((near[place] as usize, exact))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::rays::{Asking, draw};
    use crate::plan::usage::Wanted;
    use crate::scene::built_in::named;
    use crate::scene::rays::Asked;

    #[test]
    fn the_exact_nearest_is_that_of_all_triangles() {
        let mut hits = 0;
        for model in ["cornell-box", "icosphere:2", "soup"] {
            let mesh = named(model).expect("a name").expect("a size");
            let list = mesh.list();
            let mut nearby = Nearby::new(&list);
            let wanted = Wanted::of(None, None, Some(Asked::Random));
            let crowd = draw(&wanted, &mesh, Asking::new(1), |_| None).expect("rays");
            for ray in crowd.rays.iter().step_by(97) {
                let exact = oracle::nearest(ray, &list).map(|(index, exact)| (index, exact.t));
                let found = nearby.nearest(ray).map(|(index, exact)| (index, exact.t));
                assert_eq!(found, exact, "{model}");
                hits += usize::from(exact.is_some());
            }
        }
        assert!(hits > 50, "{hits}");
    }

    #[test]
    fn few_are_near_and_a_ray_without_a_direction_is_near_nothing() {
        let mesh = named("icosphere:3").expect("a name").expect("a size");
        let list = mesh.list();
        let mut nearby = Nearby::new(&list);
        let crowd =
            draw(&Wanted::of(None, None, None), &mesh, Asking::new(1), |_| None).expect("rays");
        let middle = crowd.rays[64 * 128 + 64];
        assert!((2..list.len() / 4).contains(&nearby.of(&middle).len()));
        assert!(nearby.of(&Ray { direction: glam::Vec3::ZERO, ..middle }).is_empty());
    }
}
