//! What a form answers, and so what it is judged by.

/// What a form reports, and how it rounds.
#[derive(Clone, Copy, Debug)]
pub struct Reported {
    /// 2^-24 or 2^-53.
    pub unit_roundoff: f64,
    /// t is reported.
    pub t: bool,
    /// u and v are.
    pub uv: bool,
    /// The point and the normal are.
    pub surface: bool,
    /// Back faces are no hits.
    pub culls: bool,
}
