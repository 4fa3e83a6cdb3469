//! What a search did, counted.

use std::ops::AddAssign;

/// Sums over the rays that were searched for. All but `rays` and `hits` are costs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Rays.
    pub rays: u64,
    /// Rays with a hit.
    pub hits: u64,
    /// Nodes of a hierarchy, or inner nodes of a subdivision, that were opened.
    pub nodes: u64,
    /// Cells of a subdivision of space whose list was looked at.
    pub cells: u64,
    /// Bounding volumes that were tested.
    pub volumes: u64,
    /// Those of them that the ray met before its nearest hit so far.
    pub passed: u64,
    /// Triangles that were tested.
    pub triangles: u64,
    /// Triangles that were not, since the same ray had been tested against them in another cell.
    pub mailed: u64,
}

impl Counts {
    /// The share of tested volumes that were met, p of `B + p I < I`. Nothing where none was tested.
    pub fn share_passed(&self) -> Option<f64> {
        (self.volumes > 0).then(|| self.passed as f64 / self.volumes as f64)
    }

    /// Triangles tested per ray. Nothing where there was no ray.
    pub fn triangles_per_ray(&self) -> Option<f64> {
        (self.rays > 0).then(|| self.triangles as f64 / self.rays as f64)
    }
}

impl AddAssign for Counts {
    fn add_assign(&mut self, other: Self) {
        self.rays += other.rays;
        self.hits += other.hits;
        self.nodes += other.nodes;
        self.cells += other.cells;
        self.volumes += other.volumes;
        self.passed += other.passed;
        self.triangles += other.triangles;
        self.mailed += other.mailed;
    }
}

/// Whether a volume pays: whether testing it and, with a share `p` of rays, what is inside takes less
/// time than always testing what is inside (the lecture: B + p I < I).
///
/// `volume` and `inside` are times per ray in one unit.
pub fn pays(volume: f64, share: f64, inside: f64) -> bool {
    volume + share * inside < inside
}
