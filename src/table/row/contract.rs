//! The columns that the contract asks for, in its order.

/// Adds its columns to those before, and passes them to the next list.
macro_rules! contract_columns {
    ([$next:ident $($rest:ident)*] { $($before:tt)* }) => {
        $next! { [$($rest)*] { $($before)*
            /// Experiment id.
            experiment: String,
            /// Kernel id, or the word given in the thesis form.
            kernel: String,
            /// `f32` or `f64`.
            precision: String,
            /// `single`, `packet8`, ...
            drive: String,
            /// Instruction-set level.
            level: String,
            /// `early` or `full`.
            exit: String,
            /// `first` or `last`.
            division: String,
            /// `plain` or `fused`.
            rounding: String,
            /// `hit`, `t`, `tuv` or `surface`.
            output: String,
            /// `aos`, `soa` or `aosoa`.
            layout: String,
            /// Starts with `pairs`, `nearest`, `scene` or the family's name.
            workload: String,
            /// `literal`, `fixed` or `reshuffled`.
            order: String,
            /// Share of the pairs that hit, as effective.
            density: Option<f64>,
            /// Triangles in the workload.
            triangles: Option<u64>,
            /// Rays in the workload.
            rays: Option<u64>,
            /// Ray-triangle tests of one pass.
            tests: Option<u64>,
            /// Hits among them (rays with a hit, for nearest-hit work).
            hits: Option<u64>,
            /// `ok`, `wrong-result`, `skipped`, ...
            status: String,
            /// Median time of a test.
            ns_per_test: Option<f64>,
            /// Lower end of its interval.
            ns_low: Option<f64>,
            /// Upper end of its interval.
            ns_high: Option<f64>,
            /// Fastest block.
            min_ns: Option<f64>,
            /// Million tests a second.
            mtests_per_s: Option<f64>,
            /// Processor cycles of a test.
            cycles_per_test: Option<f64> [signed],
            /// Rounds measured.
            rounds: Option<u64>,
            /// Rounds thrown away as disturbed.
            dirty_rounds: Option<u64>,
            /// Time over the reference's, paired.
            ratio_to_reference: Option<f64>,
            /// Lower end of its interval.
            ratio_low: Option<f64>,
            /// Upper end of its interval.
            ratio_high: Option<f64>,
            /// Instructions of a test.
            instructions_per_test: Option<f64>,
            /// Mispredicted branches of a test.
            mispredicts_per_test: Option<f64>,
            /// Bytes stored for a triangle.
            bytes_per_triangle: Option<u64>,
            /// Additions.
            ops_add: Option<u64>,
            /// Subtractions.
            ops_sub: Option<u64>,
            /// Changes of sign.
            ops_neg: Option<u64>,
            /// Multiplications.
            ops_mul: Option<u64>,
            /// Divisions.
            ops_div: Option<u64>,
            /// Conditions.
            ops_condition: Option<u64>,
            /// Return code that the row is about.
            code: Option<u64>,
            /// Hits where the exact answer is a miss.
            false_hits: Option<u64>,
            /// Misses where the exact answer is a hit.
            false_misses: Option<u64>,
            /// Answers with a NaN in them.
            nan_outputs: Option<u64>,
            /// Mean relative error of t.
            err_t_mean_rel: Option<f64>,
            /// 99.9th percentile of the error of t, in units in the last place.
            err_t_p999_ulp: Option<f64>,
            /// Largest error of t, in units in the last place.
            err_t_max_ulp: Option<f64>,
            /// Largest error of u.
            err_u_max_abs: Option<f64>,
            /// Largest error of v.
            err_v_max_abs: Option<f64>,
            /// Seed of the workload.
            seed: Option<u64>,
        } }
    };
}

pub(super) use contract_columns;
