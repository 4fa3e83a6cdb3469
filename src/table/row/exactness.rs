//! How exact the answers of a row are.

/// Adds its columns to those before, and passes them to the next list.
macro_rules! exactness_columns {
    ([$next:ident $($rest:ident)*] { $($before:tt)* }) => {
        $next! { [$($rest)*] { $($before)*
            /// Hash of the bits of all outputs of one pass.
            outputs_hash: String,
            /// Mean relative error of u.
            err_u_mean_rel: Option<f64>,
            /// Mean relative error of v.
            err_v_mean_rel: Option<f64>,
            /// Mean of the mean relative errors of t, u and v.
            err_tuv_mean_rel: Option<f64>,
            /// Largest relative error of any of the three.
            err_max_rel: Option<f64>,
            /// Hits whose errors are in the columns `err_...`: kernel's and exact, exactly inside.
            err_cases: Option<u64>,
            /// Cases exactly on an edge, at a vertex or at an end of the range of t: in no other count of
            /// wrong decisions and in no error.
            boundary_cases: Option<u64>,
            /// False hits that are wrong by a weight of 0.01 or by 1e-4 of the range of t.
            deep_false_hits: Option<u64>,
            /// False misses that are wrong by that much.
            deep_false_misses: Option<u64>,
            /// Wrong decisions that 16 condition numbers of rounding do not explain.
            inexcusable: Option<u64>,
            /// By how much the worst decision is wrong: weight, or share of the range of t.
            worst_depth: Option<f64>,
            /// Bits of t that are wrong: mean of log2(1 + floats between it and the exact one).
            t_bits_lost_mean: Option<f64>,
            /// Most of them.
            t_bits_lost_max: Option<f64>,
            /// Bits of u and v that are wrong, mean.
            uv_bits_lost_mean: Option<f64>,
            /// Most of them.
            uv_bits_lost_max: Option<f64>,
            /// Median error of t, in units in the last place.
            err_t_p50_ulp: Option<f64>,
            /// 99th percentile of it.
            err_t_p99_ulp: Option<f64>,
            /// Median of the largest absolute error of a hit's three weights.
            err_b_p50: Option<f64>,
            /// 99th percentile of it.
            err_b_p99: Option<f64>,
            /// 99.9th percentile of it.
            err_b_p999: Option<f64>,
            /// Largest of it.
            err_b_max: Option<f64>,
            /// Median backward error (relative change of the inputs that makes the outputs exact), in unit
            /// roundoffs.
            backward_p50_u: Option<f64>,
            /// 99th percentile of it.
            backward_p99_u: Option<f64>,
            /// Largest of it.
            backward_max_u: Option<f64>,
            /// Largest error of t over its condition number times the unit roundoff.
            t_excess_max: Option<f64>,
            /// The same of the weights.
            b_excess_max: Option<f64>,
            /// What the errors are against, where it is not the exact answer alone: `exact` or
            /// `moller-trumbore-f64`.
            err_against: String,
            /// `err_tuv_mean_rel` over that against the exact answer.
            err_ratio_to_exact: Option<f64>,
        } }
    };
}

pub(super) use exactness_columns;
