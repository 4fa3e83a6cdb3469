//! A family of stiff or extreme cases: its knob, and what is drawn at each setting.

use super::draw::Draw;
use super::precision::Precision;
use crate::accuracy::Truth;
use crate::oracle::Query;

/// How often a case is drawn again until it is what was wanted.
const REDRAWS: usize = 30;
/// What was wanted keeps this distance from an edge, in weights.
const MARGIN: f64 = 0.02;

/// A family.
pub struct Family {
    /// Its id, in words.
    pub id: &'static str,
    /// What the knob is, with its unit; `k` is the number in the column `knob`.
    pub knob: &'static str,
    /// Settings of the knob, from harmless to hard.
    pub knobs: fn(Precision) -> Vec<f64>,
    /// What is done at each setting.
    pub work: Work,
    /// What a kernel has to do to pass.
    pub passes: &'static str,
}

/// What is done at a setting of the knob.
#[derive(Clone, Copy)]
pub enum Work {
    /// Single rays against single triangles. The generator is asked for hits and misses alike; it
    /// gets `true` where a hit is wanted.
    Aimed(Generator),
    /// The same, but every draw is taken as it comes.
    Free(Generator),
    /// Rays through the edges and vertices of a closed mesh.
    Mesh(MeshKind),
    /// Rays that start where a kernel said that another one hit.
    Spawned,
    /// The same cases again, transformed so that no answer may change.
    Metamorphic(Transform),
}

/// Draws one case: source, knob, whether a hit is wanted.
pub type Generator = fn(&mut Draw, f64, bool) -> Query;

/// The closed meshes. All are star-shaped around their centre before their vertices are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MeshKind {
    /// Vertices are even whole numbers, origins too: edges and vertices are met exactly.
    Lattice,
    /// A sphere of 1280 well-shaped triangles.
    Sphere,
    /// A sphere of 1024 meridians and 4 bands: needles.
    Needles,
    /// The sphere, flattened to a ten-thousandth.
    Squashed,
}

/// What leaves decisions as they are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Transform {
    /// All coordinates times 2^k: u and v keep their bits.
    Scale,
    /// x to y, y to z, z to x.
    Axes,
    /// a to b, b to c, c to a.
    Vertices,
}

/// A case, and whether it is what was wanted.
pub struct Case {
    /// What kernels on rays are judged by.
    pub truth: Truth,
    /// What kernels on segments are judged by, where there are any.
    pub segment: Option<Truth>,
    /// Exactly a hit, or exactly none, as wanted, and not near an edge.
    pub attained: bool,
}

impl Family {
    /// Whether the knob has settings that get harder.
    pub fn has_knee(&self) -> bool {
        matches!(self.work, Work::Aimed(_) | Work::Free(_))
            && (self.knobs)(Precision::F64).len() > 1
            && !self.knob.starts_with("kind")
    }

    /// The range of the knob in words.
    pub fn range(&self) -> String {
        let of = |precision: Precision| {
            let knobs = (self.knobs)(precision);
            match knobs.as_slice() {
                [] => "none".to_owned(),
                [only] => format!("{only}"),
                knobs => {
                    let least = knobs.iter().copied().fold(f64::INFINITY, f64::min);
                    let most = knobs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                    format!("{least} to {most}")
                }
            }
        };
        let [narrow, wide] = Precision::ALL.map(of);
        if narrow == wide { narrow } else { format!("f32 {narrow}, f64 {wide}") }
    }

    /// Draws cases; half of them are wanted to be hits. With `segments`, for kernels on segments
    /// as well.
    pub fn cases(&self, draw: &mut Draw, knob: f64, count: usize, segments: bool) -> Vec<Case> {
        let case = |draw: &mut Draw| {
            let (truth, attained) = match self.work {
                Work::Aimed(generator) => aimed(generator, draw, knob),
                Work::Free(generator) => {
                    let hit = draw.chance(0.5);
                    (Truth::of_query(generator(draw, knob, hit)), true)
                }
                Work::Mesh(_) | Work::Spawned | Work::Metamorphic(_) => return None,
            };
            let segment = segments.then(|| Truth::of_query(segment_of(&truth.query, draw)));
            Some(Case { truth, segment, attained })
        };
        (0..count).filter_map(|_| case(draw)).collect()
    }
}

fn aimed(generator: Generator, draw: &mut Draw, knob: f64) -> (Truth, bool) {
    let hit = draw.chance(0.5);
    let mut truth = Truth::of_query(generator(draw, knob, hit));
    for _ in 0..REDRAWS {
        if is_clearly(&truth, hit) {
            return (truth, true);
        }
        truth = Truth::of_query(generator(draw, knob, hit));
    }
    let attained = is_clearly(&truth, hit);
    (truth, attained)
}

fn is_clearly(truth: &Truth, hit: bool) -> bool {
    let exact = &truth.exact;
    let least = exact.u.min(exact.v).min(exact.w);
    exact.class.is_hit() == hit && least.abs() >= MARGIN
}

/// The ray up to its end: from the origin to the rounded point at t_max.
pub fn segment_of(query: &Query, draw: &Draw) -> Query {
    let end = |i: usize| draw.precision.round(query.origin[i] + query.t_max * query.direction[i]);
    Query::segment(query.origin, [end(0), end(1), end(2)], query.triangle)
}

/// A family of aimed rays.
pub fn aimed_family(
    id: &'static str,
    knob: &'static str,
    knobs: fn(Precision) -> Vec<f64>,
    generator: Generator,
    passes: &'static str,
) -> Family {
    Family { id, knob, knobs, work: Work::Aimed(generator), passes }
}

impl Work {
    /// The word in the column `record`.
    pub fn record(&self) -> &'static str {
        match self {
            Work::Aimed(_) | Work::Free(_) => "cases",
            Work::Mesh(_) => "rays",
            Work::Spawned => "spawned",
            Work::Metamorphic(_) => "metamorphic",
        }
    }
}
