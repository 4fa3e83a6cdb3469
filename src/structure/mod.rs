//! Bounding volumes and structures around the triangles of any kernel: the ways of a lecture to test
//! fewer of them (J. Pelikan, "Speedup", Charles University, 2018), and what renderers use today.
//!
//! ```text
//!  triangles ─> Bounds ─> grid, octree, kd-tree, list of volumes, hierarchy ─┐
//!            └> KernelLeaf, one per kernel ──────────────────────────────────┴─> Search ─> Hit, Counts
//! ```
//!
//! **What is promised.** A list tests a ray against every triangle and keeps the hit with the smallest t,
//! of several at one distance that of the lowest index; the order of tests does not matter. A structure
//! does the same with fewer. It leaves a triangle out for one of two reasons only: the exact ray misses a
//! volume or all cells around the triangle, or enters them farther than [`SLACK`] beyond the best hit so
//! far. So if the list's answer is left out, it is no hit exactly (a false hit of the kernel, on a
//! triangle that is not there), or the kernel tells a t that is short of the exact one by more than
//! [`SLACK`]. In every other case the answers are the same, bit for bit. [`excuse`] says which it is.
//!
//! Triangles with a corner that is not finite are in no structure but the list: nothing hits them, by
//! rule.

mod beam;
mod best;
mod bounded;
mod compressed;
#[cfg(test)]
mod cost_tests;
mod counts;
mod excuse;
mod grid;
mod hierarchy;
mod insertion;
mod kd_tree;
mod kind;
mod leaf;
mod list;
mod mailbox;
mod octree;
mod placed;
mod ready_made;
mod search;
mod sorted;
mod structure_job;
mod surface_area;
#[cfg(test)]
mod tests;
mod topology;
pub mod volume;
mod volume_job;
pub mod wide;

pub use beam::Beam;
pub use best::{Best, Hit, SLACK};
pub use bounded::Bounded;
pub use compressed::Compressed;
pub use counts::{Counts, pays};
pub use excuse::{Excuse, excuse};
pub use grid::Grid;
pub use hierarchy::{Chance, Hierarchy};
pub use insertion::inserted;
pub use kd_tree::KdTree;
pub use kind::{KINDS, Kind, kind};
pub use leaf::{KernelLeaf, Leaf, ListingLeaf};
pub use list::List;
pub use octree::Octree;
pub use ready_made::from_obvhs;
pub use search::Search;
pub use sorted::SortedVolumes;
pub use structure_job::{SearchJob, StructureJob};
pub use surface_area::by_surface_area;
pub use topology::Topology;
pub use volume_job::{VOLUMES, VolumeForm};

/// Triangles, arranged for rays.
pub trait Structure {
    /// Takes a ray through it: every triangle that it may hit is tested, near ones first as far as the
    /// structure knows, until the search is over.
    fn walk(&self, beam: &Beam, search: &mut Search);
    /// Bytes of memory, that of the triangles excluded.
    fn bytes(&self) -> usize;
}
