//! One row: one variant on one workload cell, every axis a column, then figures.

use super::cell::{Cell, Field};
use super::columns::columns;
use serde::ser::{Serialize, SerializeMap, Serializer};

/// How many of [`COLUMNS`] the contract asks for; a file without one of them is refused.
pub const REQUIRED: usize = 48;

columns! {
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
    cycles_per_test: Option<f64>,
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
    percent_slower: Option<f64>,
    /// Listings: the kind of operation that is priced.
    priced: String,
    /// What that kind of operation costs, as a share of the test's time.
    price: Option<f64>,
    /// Lower end of its interval.
    price_low: Option<f64>,
    /// Upper end of its interval.
    price_high: Option<f64>,
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
    cycles_low: Option<f64>,
    /// Upper end of it.
    cycles_high: Option<f64>,
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
    /// Stability: what the row is about: `cases`, `rays`, `spawned`, `metamorphic`, or, summed up,
    /// `knee`, `leaks`.
    record: String,
    /// Family of cases.
    family: String,
    /// Setting of the family's knob.
    knob: Option<f64>,
    /// What the knob is, where the row is about all of its settings; k is one of them.
    knob_name: String,
    /// The form's name in tables and charts: its kernel, and what is unusual about it.
    form: String,
    /// Cases put to the kernel: of rays, those that exactly leave the mesh in one point.
    cases: Option<u64>,
    /// Cases that are exactly hits.
    exact_hits: Option<u64>,
    /// Share of the cases that are clearly what was wanted, a hit or a miss.
    attained_share: Option<f64>,
    /// Median relative error of t.
    err_t_p50_rel: Option<f64>,
    /// 99th percentile of it.
    err_t_p99_rel: Option<f64>,
    /// 99th percentile, over the exact hits, of the condition number of t relative to t.
    kappa_t_p99: Option<f64>,
    /// The same of the largest absolute condition number of a weight.
    kappa_b_p99: Option<f64>,
    /// Hits reported of cases whose input is not finite.
    hits_of_not_finite: Option<u64>,
    /// What rays are aimed at: `random`, `edge`, `vertex`, `exact edge`, `exact vertex`.
    ray_class: String,
    /// Rays that exactly leave the mesh, and hit no triangle.
    leaks: Option<u64>,
    /// Rays that exactly leave the mesh, in one point, and hit several triangles.
    double_hits: Option<u64>,
    /// Leaks in a million rays.
    leaks_per_million: Option<f64>,
    /// Where no leak was seen, the rate that they are below with a probability of 95 %.
    leaks_bound_per_million: Option<f64>,
    /// Double hits in a million rays.
    double_hits_per_million: Option<f64>,
    /// First setting of the knob at which the kernel fails; empty where it never does.
    knee: Option<f64>,
    /// Its place in the sweep, 0 the first setting; 1 where there is none.
    knee_share: Option<f64>,
    /// Rays from a computed hit point that hit the same triangle again.
    spawned_hits: Option<u64>,
    /// Smallest offset along the normal at which none does, in unit roundoffs of the largest
    /// coordinate: a power of two. Empty where 2^23 of them do not suffice.
    spawned_offset: Option<f64>,
    /// Decisions that a transformation changed which may change none.
    metamorphic_decisions: Option<u64>,
    /// Hits of both whose u or v changed a bit.
    metamorphic_uv: Option<u64>,
    /// How edge functions keep their signs: `fallback`, `no-fallback` or `exact-sign`.
    edges: String,
    /// `kept`, or `flushed` to zero.
    subnormals: String,
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
}

impl Serialize for Row {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        for (place, column) in COLUMNS.iter().enumerate() {
            let cell = self.cell(column).unwrap_or(Cell::Missing);
            // The contract's columns are always there, but for the many rows of a sweep without a
            // clock, most of which are about a clock. Of ours, an empty one would only take room.
            let always = place < REQUIRED && self.record.is_empty();
            if always || cell != Cell::Missing {
                map.serialize_entry(column, &cell)?;
            }
        }
        map.end()
    }
}
