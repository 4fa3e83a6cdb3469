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

/// Which packets of rays will do beside single rays.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Packets {
    /// None: rays come one by one.
    #[default]
    None,
    /// Those of any rays.
    OfAnyRays,
    /// Those as well whose rays start in one point.
    FromOnePoint,
}

impl Packets {
    /// Whether a form with that word in the column `drive` will do.
    ///
    /// # Errors
    /// Why not, as the end of "left out: 3 that ...".
    pub(super) fn admit(self, drive: &str) -> Result<(), &'static str> {
        if drive.starts_with("single") {
            return Ok(());
        }
        let Some(rays) = drive.strip_prefix("packet") else {
            return Err("take rays or triangles by groups or bundles");
        };
        match (self, rays.split_once('-').map(|(_, shared)| shared)) {
            (Packets::None, _) => Err("take rays in packets"),
            (_, None) | (Packets::FromOnePoint, Some("common-origin")) => Ok(()),
            _ => Err("take rays that share an origin or a direction"),
        }
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
    /// The packets of rays that are allowed beside single rays.
    pub packets: Packets,
}

impl Question {
    /// The arguments of `ray_test recommend` that ask it, each behind a space.
    pub fn arguments(&self) -> String {
        let mut words = String::new();
        let mut put = |word: String| words += &format!(" --{word}");
        self.precision.iter().for_each(|precision| put(format!("precision {precision}")));
        if self.needs != Needs::default() {
            put(format!("needs {}", self.needs.word()));
        }
        self.rays_per_triangle.iter().for_each(|rays| put(format!("rays-per-triangle {rays}")));
        if self.watertight {
            put("watertight".to_owned());
        }
        self.tolerance.iter().for_each(|tolerance| put(format!("tolerance {tolerance:e}")));
        match self.packets {
            Packets::None => {}
            Packets::OfAnyRays => put("packets".to_owned()),
            Packets::FromOnePoint => put("common-origin".to_owned()),
        }
        words
    }
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
