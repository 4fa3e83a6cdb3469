//! What a plan knows of a variant: which pieces of work it does.

/// A single-ray form of a kernel, as the registry names it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Form {
    /// Its id in the registry.
    pub id: String,
    /// The kernel.
    pub kernel: String,
    /// It computes in f64.
    pub in_f64: bool,
    /// What it reports.
    pub output: Output,
    /// It divides, if at all, behind the last test.
    pub divides_last: bool,
    /// Back faces are no hits.
    pub culls: bool,
    /// All triangles are projected along the z axis.
    pub projects_along_z: bool,
    /// More is stored of a triangle than its three vertices.
    pub prepares: bool,
    /// Rays through shared edges are not lost.
    pub watertight: bool,
    /// Where an edge function is 0 in f32, it is computed again with more digits.
    pub falls_back: bool,
    /// It subtracts the ray's origin, or a vertex, before it multiplies.
    pub translates: bool,
}

/// What a form reports of a hit, less to more.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Output {
    /// Whether there is one.
    Hit,
    /// And the distance.
    T,
    /// And the weights u and v.
    Tuv,
    /// And the point and the normal.
    Surface,
}

/// Kernels whose records hold products of coordinates as they are: a plane's distance from the origin
/// of coordinates, or Pluecker's coordinates of an edge. They cancel far from that origin; the head of
/// each kernel's file says so.
const ABSOLUTE: [&str; 8] = [
    "wald",
    "badouel-cramer",
    "shevtsov",
    "perpendicular-planes",
    "baldwin-weber",
    "woop-affine",
    "plucker",
    "chirkov",
];

/// Whether a kernel subtracts before it multiplies.
pub fn translates(kernel: &str) -> bool {
    !ABSOLUTE.contains(&kernel)
}

impl Output {
    /// The word on the axis `output`.
    pub fn word(self) -> &'static str {
        match self {
            Output::Hit => "hit",
            Output::T => "t",
            Output::Tuv => "tuv",
            Output::Surface => "surface",
        }
    }

    /// By its word.
    pub fn of(word: &str) -> Option<Self> {
        [Output::Hit, Output::T, Output::Tuv, Output::Surface]
            .into_iter()
            .find(|output| output.word() == word)
    }
}
