//! What a row is about beyond the contract, and what the clock said.

/// Adds its columns to those before, and passes them to the next list.
macro_rules! timing_columns {
    ([$next:ident $($rest:ident)*] { $($before:tt)* }) => {
        $next! { [$($rest)*] { $($before)*
            /// The variant's id: its axes joined by slashes.
            id: String,
            /// What is stored per triangle.
            stored: String,
            /// `on` where back faces are culled.
            cull: String,
            /// `sign-bits` where the inside tests look at sign bits (the axis `tests`).
            tests_form: String,
            /// Which test comes first: `distance` or `inside`.
            leading: String,
            /// `ray`, `segment`, `line` or `point`.
            query: String,
            /// Which way round the triangles are.
            winding: String,
            /// Random generator of the workload.
            generator: String,
            /// Build of the program: target and optimisation level.
            build: String,
            /// Machine and build that the row comes from, where results of several are put together.
            machine: String,
            /// Why the status is not `ok`.
            reason: String,
            /// Calls that end with `code`.
            calls: Option<u64>,
            /// Share of the calls that end with `code`.
            share: Option<f64>,
            /// Repeats of each test, where the thesis's loop is run.
            repeats: Option<u64>,
            /// Time of tests x repeats.
            seconds: Option<f64>,
            /// (Mean of the kernel's row) / (smallest such mean) - 1, in percent.
            percent_slower: Option<f64> [signed],
            /// Mean of `seconds` over the densities, within each order.
            seconds_mean: Option<f64>,
            /// Listings: the kind of operation that is priced.
            priced: String,
            /// What that kind of operation costs, as a share of the test's time.
            price: Option<f64> [signed],
            /// Lower end of its interval.
            price_low: Option<f64> [signed],
            /// Upper end of its interval.
            price_high: Option<f64> [signed],
            /// `ratio_to_reference` of the first half of the rounds alone.
            ratio_first_half: Option<f64>,
            /// `ratio_to_reference` of the second half of the rounds alone.
            ratio_second_half: Option<f64>,
            /// Ratio of the placebo to the reference: what this machine calls a difference.
            ratio_placebo: Option<f64>,
            /// An empty loop's time over this one's, both per test.
            empty_loop_share: Option<f64>,
            /// Hash of the workload, so that figures of different inputs are not compared.
            workload_hash: String,
            /// Against the reference: `faster`, `slower`, `same`, `unresolved` or `invalid`; the
            /// reference itself has none.
            verdict: String,
            /// Probability of such a ratio if there were no difference beyond the margin: sign test,
            /// corrected for the family of the group (Holm).
            p_value: Option<f64>,
            /// Smallest relative difference that the group could tell from chance and code placement.
            noise_floor: Option<f64>,
            /// Where `unresolved`: about how many more rounds would decide.
            more_rounds: Option<u64>,
            /// Where `cycles_per_test` comes from: `counter` or `chain`.
            cycles_source: String,
            /// Lower end of the interval of `cycles_per_test`.
            cycles_low: Option<f64> [signed],
            /// Upper end of it.
            cycles_high: Option<f64> [signed],
            /// `cycles_per_test` of the first half of the rounds alone.
            cycles_first_half: Option<f64>,
            /// `cycles_per_test` of the second half of the rounds alone.
            cycles_second_half: Option<f64>,
            /// Order `fixed`: time among the others of the group over time alone. Above 1 where the set
            /// is more than the branch predictor remembers.
            solo_ratio: Option<f64>,
            /// Share of the rounds in which a neighbour used the core as well; above 0 only where there were
            /// too few rounds without one.
            crowded_share: Option<f64>,
            /// Single rays: median time from one answer to the next where each call waits for the answer
            /// before it. A call is a test of a pair, or the walk of a ray over all triangles; the time is
            /// that of a test, here and in the columns that follow.
            latency_ns_per_test: Option<f64>,
            /// Lower end of its interval.
            latency_ns_low: Option<f64>,
            /// Upper end of its interval.
            latency_ns_high: Option<f64>,
            /// The same in processor cycles.
            latency_cycles_per_test: Option<f64>,
            /// Latency over the reference's, paired.
            latency_ratio_to_reference: Option<f64>,
            /// Lower end of its interval.
            latency_ratio_low: Option<f64>,
            /// Upper end of its interval.
            latency_ratio_high: Option<f64>,
            /// Latency of a call that tests nothing.
            latency_floor_ns: Option<f64>,
            /// Single rays: median time of one call with its code and its branches forgotten.
            cold_ns_per_test: Option<f64>,
            /// Lower end of its interval.
            cold_ns_low: Option<f64>,
            /// Upper end of its interval.
            cold_ns_high: Option<f64>,
            /// Cold time over the reference's, paired.
            cold_ratio_to_reference: Option<f64>,
            /// Lower end of its interval.
            cold_ratio_low: Option<f64>,
            /// Upper end of its interval.
            cold_ratio_high: Option<f64>,
            /// Cold time of a call that tests nothing: clock and call by themselves.
            cold_floor_ns: Option<f64>,
            /// Least cycles of a test by its own operations, on units as fast as were measured here.
            bound_cycles_per_test: Option<f64>,
            /// What those cycles are spent on: a kind of operation, kinds that share units, `vector units`.
            bound_resource: String,
            /// `bound_cycles_per_test` over `cycles_per_test`: 1 is the limit of the machine.
            bound_fraction: Option<f64>,
            /// Bytes of all triangles as stored, where sets of several sizes are compared.
            set_bytes: Option<u64>,
            /// Bytes of the machine's first data cache.
            l1_bytes: Option<u64>,
            /// Bytes of its second cache.
            l2_bytes: Option<u64>,
            /// Bytes of its third cache, which cores share.
            l3_bytes: Option<u64>,
            /// Median time of preparing what is stored of a triangle.
            prepare_ns_per_triangle: Option<f64>,
            /// Lower end of its interval.
            prepare_ns_low: Option<f64>,
            /// Upper end of its interval.
            prepare_ns_high: Option<f64>,
            /// The same in processor cycles.
            prepare_cycles_per_triangle: Option<f64>,
            /// Lower end of its interval.
            prepare_cycles_low: Option<f64>,
            /// Upper end of its interval.
            prepare_cycles_high: Option<f64>,
            /// The kernel whose form that prepares nothing is compared with.
            pays_against: String,
            /// Rays per triangle from which on preparing costs less; empty where it never does.
            pays_from_rays: Option<f64>,
            /// The least that the intervals leave possible.
            pays_from_low: Option<f64>,
            /// The most; empty where the intervals do not exclude that it never pays.
            pays_from_high: Option<f64>,
            /// Rays per triangle that the row is about.
            rays_per_triangle: Option<u64>,
            /// Cycles of preparing a triangle and testing it that often.
            total_cycles_per_triangle: Option<f64>,
            /// The same per ray.
            total_cycles_per_ray: Option<f64>,
            /// With both at the lower ends of their intervals.
            total_cycles_per_ray_low: Option<f64>,
            /// With both at the upper ends.
            total_cycles_per_ray_high: Option<f64>,
        } }
    };
}

pub(super) use timing_columns;
