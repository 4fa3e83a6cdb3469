//! Where the line, or the ray, meets the triangle.

/// The exact relation of a ray and a triangle. The first that applies, in this order, is the class.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Class {
    /// The triangle has no area.
    Degenerate,
    /// Direction in the triangle's plane, and the origin too. A miss by convention.
    Coplanar,
    /// The line misses the closed triangle, or is parallel to its plane and off it. A zero
    /// direction counts as parallel. Input that is not finite is put here.
    Outside,
    /// The line meets the closed triangle, at a t outside the closed range.
    Behind,
    /// A hit at a vertex.
    Vertex,
    /// A hit on an edge, not at a vertex.
    Edge,
    /// A hit inside the triangle.
    Interior,
}

impl Class {
    /// Every class, in order of precedence.
    pub const ALL: [Class; 7] = [
        Class::Degenerate,
        Class::Coplanar,
        Class::Outside,
        Class::Behind,
        Class::Vertex,
        Class::Edge,
        Class::Interior,
    ];

    /// Whether the closed ray meets the closed triangle in a single point.
    pub fn is_hit(self) -> bool {
        matches!(self, Class::Vertex | Class::Edge | Class::Interior)
    }

    /// The word that tables use.
    pub fn name(self) -> &'static str {
        match self {
            Class::Degenerate => "degenerate",
            Class::Coplanar => "coplanar",
            Class::Outside => "outside",
            Class::Behind => "behind",
            Class::Vertex => "vertex",
            Class::Edge => "edge",
            Class::Interior => "interior",
        }
    }
}
