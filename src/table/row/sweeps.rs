//! Stability: what sweeps without a clock find.

/// Adds its columns to those before, and passes them to the next list.
macro_rules! sweeps_columns {
    ([$next:ident $($rest:ident)*] { $($before:tt)* }) => {
        $next! { [$($rest)*] { $($before)*
            /// Stability: what the row is about: `cases`, `rays`, `spawned`, `metamorphic`, or, summed up,
            /// `knee`, `leaks`.
            record: String,
            /// Family of cases.
            family: String,
            /// Setting of the family's knob.
            knob: Option<f64> [signed],
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
            /// What rays are aimed at: `random`, `edge`, `vertex`, `exact edge`, `exact vertex`. Searches: where
            /// they come from, `primary` or `random`.
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
            knee: Option<f64> [signed],
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
            /// `divide`, or `estimate`, `newton`, `newton-2`: how reciprocals are computed.
            reciprocal: String,
            /// How the axis of a projection is known: `one-index`, `three-indices`, `fixed` or `batches`.
            projection: String,
            /// Single rays with a vector in a register: `horizontal` sums across its lanes, or an
            /// `instruction` for dot products.
            dot: String,
            /// Which cross product Kensler-Shirley's triple products are computed by, if not the usual one:
            /// `edges`, those of the edges and the origin.
            cross: String,
            /// Bunches of rays: how far they lie apart, in radii of the scene.
            spread: Option<f64>,
            /// Packets that leave early: operations that their rays' own tests would do, over those
            /// that the packets do.
            useful_lanes: Option<f64>,
        } }
    };
}

pub(super) use sweeps_columns;
