//! The axes of a variant, their columns, and the id made of them.

use std::fmt::Write;

use crate::kernels::{About, Edges, Fallback, OneIndex, Projection};
use crate::policy::{Division, Exit, Facing, Leading, Output, Policy, Reciprocal, Rounding, Tests};

use super::Offers;

/// The place of a variant on every axis, in the words of the contract.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Axes {
    /// The kernel's id.
    pub kernel: &'static str,
    /// `f32` or `f64`.
    pub precision: &'static str,
    /// How it is driven: `single`, `packetN`, ...
    pub drive: String,
    /// The instruction-set level.
    pub level: &'static str,
    /// `early`, `once` or `full`.
    pub exit: &'static str,
    /// `first` or `last`.
    pub division: &'static str,
    /// `plain` or `fused`.
    pub rounding: &'static str,
    /// `hit`, `t`, `tuv` or `surface`.
    pub output: &'static str,
    /// `off` or `on`.
    pub cull: &'static str,
    /// `aos`, `soa` or `aosoa`.
    pub layout: &'static str,
    /// `distance` or `inside`: the test that comes first.
    pub leading: &'static str,
    /// Whether `leading` is the kernel's own.
    pub leading_is_native: bool,
    /// Listings only: the kind of operation that is done twice, or the control of that.
    pub priced: &'static str,
    /// `ray`, or `point` for the point of a plane.
    pub query: &'static str,
    /// What is stored of a triangle.
    pub stored: &'static str,
    /// Whether `stored` is the kernel's first or only form.
    pub stored_is_native: bool,
    /// `compare`, `sign-bits`, `sign-bits-safe` or `products`.
    pub tests: &'static str,
    /// `divide`, `estimate`, `newton` or `newton-2`.
    pub reciprocal: &'static str,
    /// How edge functions keep their signs: `fallback`, `no-fallback` or `exact-sign`; empty for
    /// kernels that have no such choice.
    pub edges: &'static str,
    /// How the axis of the projection is known: `one-index`, `three-indices`, `fixed` or `batches`; empty
    /// for kernels that have no such choice.
    pub projection: &'static str,
    /// Which cross product a weight's triple product is computed by: `edges`, those of the edges and the
    /// origin; empty for the kernel's own.
    pub cross: &'static str,
    /// Single rays with a vector in a register: `horizontal` sums or an `instruction` for dot products;
    /// empty where a vector is three numbers.
    pub dot: &'static str,
    /// `kept`, or `flushed` to zero.
    pub subnormals: &'static str,
    /// 0, or the number of a placebo.
    pub copy: usize,
}

/// The columns of `list variants` behind `id` and `available`.
pub const COLUMNS: [&str; 21] = [
    "kernel",
    "precision",
    "drive",
    "level",
    "exit",
    "division",
    "rounding",
    "output",
    "cull",
    "layout",
    "leading",
    "priced",
    "query",
    "stored",
    "tests",
    "reciprocal",
    "edges",
    "projection",
    "subnormals",
    "dot",
    "cross",
];

/// What the form `P` of a kernel is called: a constant, so that thousands of forms need no code for it.
struct Words {
    about: &'static About,
    exit: &'static str,
    division: &'static str,
    rounding: &'static str,
    output: &'static str,
    cull: &'static str,
    leading: &'static str,
    /// The kernel's own `leading`.
    native: &'static str,
    stored_is_native: bool,
    tests: &'static str,
    reciprocal: &'static str,
    edges: &'static str,
    projection: &'static str,
    cross: &'static str,
}

impl Words {
    const fn of<K: Offers, P: Policy>() -> Self {
        Words {
            about: &K::ABOUT,
            exit: P::Exit::NAME,
            division: P::Division::NAME,
            rounding: P::Rounding::NAME,
            output: P::Output::NAME,
            cull: P::Facing::NAME,
            leading: P::Leading::NAME,
            native: K::Native::NAME,
            stored_is_native: K::NATIVE_RECORD,
            tests: P::Tests::NAME,
            reciprocal: P::Reciprocal::NAME,
            edges: K::EDGES,
            projection: K::PROJECTION,
            cross: K::CROSS,
        }
    }
}

impl Axes {
    /// A single ray, everything else at its default, `early`, divided `last`, with t, u and v.
    pub fn usual(kernel: &'static str, precision: &'static str, level: &'static str) -> Self {
        Axes {
            kernel,
            precision,
            drive: "single".into(),
            level,
            exit: "early",
            division: "last",
            rounding: "plain",
            output: "tuv",
            cull: "off",
            layout: "aos",
            leading: "distance",
            leading_is_native: true,
            priced: "",
            query: "ray",
            stored: "vertices",
            stored_is_native: true,
            tests: "compare",
            reciprocal: "divide",
            edges: "",
            projection: "",
            cross: "",
            dot: "",
            subnormals: "kept",
            copy: 0,
        }
    }

    /// A single ray in the form `P` of a kernel, in the usual layout.
    pub fn of<K: Offers, P: Policy>(precision: &'static str, level: &'static str) -> Self {
        Axes::named(const { &Words::of::<K, P>() }, precision, level)
    }

    /// Built once for all forms.
    #[inline(never)]
    fn named(words: &Words, precision: &'static str, level: &'static str) -> Self {
        Axes {
            exit: words.exit,
            division: words.division,
            rounding: words.rounding,
            output: words.output,
            cull: words.cull,
            leading: words.leading,
            leading_is_native: words.leading == words.native,
            stored: words.about.stored,
            stored_is_native: words.stored_is_native,
            tests: words.tests,
            reciprocal: words.reciprocal,
            edges: words.edges,
            projection: words.projection,
            cross: words.cross,
            ..Axes::usual(words.about.id, precision, level)
        }
    }

    /// The values of [`COLUMNS`].
    pub fn values(&self) -> [&str; 21] {
        [
            self.kernel,
            self.precision,
            &self.drive,
            self.level,
            self.exit,
            self.division,
            self.rounding,
            self.output,
            self.cull,
            self.layout,
            self.leading,
            self.priced,
            self.query,
            self.stored,
            self.tests,
            self.reciprocal,
            self.edges,
            self.projection,
            self.subnormals,
            self.dot,
            self.cross,
        ]
    }

    /// kernel / precision / drive / level / exit / division / rounding / output, then every other
    /// axis that is off its default as `name=value`, in alphabetical order.
    pub fn id(&self) -> String {
        let mut id = self.values()[..8].join("/");
        let others = [
            ("copy", self.copy.to_string(), self.copy == 0),
            ("cross", self.cross.into(), self.cross.is_empty()),
            ("cull", self.cull.into(), self.cull == "off"),
            ("dot", self.dot.into(), ["", "horizontal"].contains(&self.dot)),
            ("edges", self.edges.into(), ["", Fallback::NAME].contains(&self.edges)),
            ("layout", self.layout.into(), self.layout == "aos"),
            ("leading", self.leading.into(), self.leading_is_native),
            ("priced", self.priced.into(), self.priced.is_empty()),
            ("projection", self.projection.into(), ["", OneIndex::NAME].contains(&self.projection)),
            ("query", self.query.into(), self.query == "ray"),
            ("reciprocal", self.reciprocal.into(), self.reciprocal == "divide"),
            ("stored", self.stored.into(), self.stored_is_native),
            ("subnormals", self.subnormals.into(), self.subnormals == "kept"),
            ("tests", self.tests.into(), self.tests == "compare"),
        ];
        for (name, value, is_default) in others {
            if !is_default {
                // Writing to a String cannot fail.
                let _ = write!(id, "/{name}={value}");
            }
        }
        id
    }
}
