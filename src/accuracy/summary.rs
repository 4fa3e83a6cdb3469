//! What is said of a variant's answers.

use super::quantiles::Quantiles;

/// What is to be said of the answers. Figures of outputs that are not reported are `None`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Accuracy {
    /// Cases seen.
    pub cases: u64,
    /// Cases that are exactly hits.
    pub exact_hits: u64,
    /// Hits of both, exactly inside: those whose errors are below.
    pub compared: u64,
    /// Cases exactly on an edge, at a vertex or at an end of the range: either answer is right, and
    /// they are in no other figure but `cases`, `exact_hits` and `non_finite`.
    pub boundary_cases: u64,
    /// Hits where the exact answer is a miss, or another triangle.
    pub false_hits: u64,
    /// Misses where the exact answer is a hit.
    pub false_misses: u64,
    /// False hits with a weight of at most -0.01, or t outside by 1e-4 of its range.
    pub deep_false_hits: u64,
    /// False misses with all weights at least 0.01, and t inside by 1e-4 of its range.
    pub deep_false_misses: u64,
    /// Wrong decisions that 16 condition numbers of rounding do not explain.
    pub inexcusable: u64,
    /// Depth of the worst wrong decision: weight, or share of t's range, by which it is wrong.
    pub worst_depth: Option<f64>,
    /// Hits with a reported output that is not finite. They have no errors but in `bits_lost`.
    pub non_finite: u64,
    /// Mean of |t - exact| / |exact|: the measure of thesis H. It has no limit as cases are added
    /// (the mean of 1/u does not exist), so it is for comparison with the thesis alone.
    pub t_mean_relative: Option<f64>,
    /// The same of u.
    pub u_mean_relative: Option<f64>,
    /// The same of v.
    pub v_mean_relative: Option<f64>,
    /// Mean of the three.
    pub mean_relative: Option<f64>,
    /// The largest relative error of any of the three.
    pub max_relative: Option<f64>,
    /// Mean of the bits lost by t: log2(1 + floats between it and the exact one).
    pub t_bits_lost_mean: Option<f64>,
    /// Most bits lost by t.
    pub t_bits_lost_max: Option<f64>,
    /// Mean of the bits lost by u and v.
    pub uv_bits_lost_mean: Option<f64>,
    /// Most bits lost by u or v.
    pub uv_bits_lost_max: Option<f64>,
    /// |t - exact| in units in the last place of the precision.
    pub t_ulp: Quantiles,
    /// |t - exact| / |exact|.
    pub t_relative: Quantiles,
    /// Largest |u - exact|.
    pub u_max: Option<f64>,
    /// Largest |v - exact|.
    pub v_max: Option<f64>,
    /// Largest absolute error of the three weights of a hit.
    pub barycentric: Quantiles,
    /// Smallest relative change of the inputs that makes the outputs exact, in unit roundoffs.
    pub backward: Quantiles,
    /// Largest error of t over its condition number times the unit roundoff.
    pub t_excess_max: Option<f64>,
    /// The same of the weights.
    pub barycentric_excess_max: Option<f64>,
}
