//! What is asked, and what is known of the variants.

/// What must be reported of a hit; each includes the ones before it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Needs {
    /// Whether there is one.
    Hit,
    /// And where on the ray.
    T,
    /// And where on the triangle.
    #[default]
    Tuv,
    /// And the point in space with the normal.
    Surface,
}

impl Needs {
    /// The word of the column `output`.
    pub fn word(self) -> &'static str {
        match self {
            Needs::Hit => "hit",
            Needs::T => "t",
            Needs::Tuv => "tuv",
            Needs::Surface => "surface",
        }
    }

    /// What a form with that word in the column `output` reports; `None` for other words.
    pub(super) fn reported(output: &str) -> Option<Needs> {
        let all = [Needs::Hit, Needs::T, Needs::Tuv, Needs::Surface];
        all.into_iter().find(|needs| needs.word() == output)
    }
}

/// What is asked.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Question {
    /// `f32` or `f64`; either, if it is not given.
    pub precision: Option<String>,
    /// What must be reported.
    pub needs: Needs,
    /// How many rays a triangle is tested against before it changes, so that preparing it counts;
    /// without it preparing costs nothing.
    pub rays_per_triangle: Option<u64>,
    /// No ray through a shared edge or vertex may be lost.
    pub watertight: bool,
    /// Largest allowed absolute error of a barycentric weight, at the 99th percentile of random hits.
    pub tolerance: Option<f64>,
    /// Packets of rays are allowed beside single rays.
    pub packets: bool,
}

/// What the program knows of one of its variants.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct KnownVariant {
    /// Its id.
    pub id: String,
    /// Whether this processor has its level.
    pub available: bool,
    /// Whether its kernel is said to lose no ray through a shared edge or vertex.
    pub watertight: bool,
    /// What it does not do for any ray and triangle, as the end of "left out: 3 that ..."; empty if
    /// there is nothing.
    pub limits: String,
    /// Lines of Rust that call it.
    pub call: String,
}
