//! Rays through the edges and vertices of closed meshes: which are lost, which are met twice.
//!
//! A kernel is asked about the triangles around the edge or vertex that a ray is aimed at, about
//! those that the ray exactly meets, and about the neighbours of these; all others it misses by
//! far more than rounding can do. That none of the others is exactly met is known where the ring
//! around the aim holds a whole crossing and the origin sees the front of no triangle (then every
//! ray crosses once); elsewhere all triangles are searched.

use super::draw::{Draw, REACH};
use super::family::MeshKind;
use super::mesh::Mesh;
use crate::job::Answer;
use crate::oracle::{Class, Query, classify};
use glam::DVec3;

/// Origins of rays, per setting.
const ORIGINS: usize = 64;
/// A determinant's rounding error over its permanent, as in the oracle's filter.
const BOUND: f64 = 8.0 * f64::EPSILON;

/// What rays are aimed at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RayClass {
    /// Nothing: random directions.
    Random,
    /// A point of an edge, which rounding moves off it.
    Edge,
    /// A vertex, likewise.
    Vertex,
    /// A point that is on an edge exactly.
    ExactEdge,
    /// A vertex, exactly.
    ExactVertex,
}

impl RayClass {
    /// All of them, in the order of tables.
    pub const ALL: [RayClass; 5] = [
        RayClass::Random,
        RayClass::Edge,
        RayClass::Vertex,
        RayClass::ExactEdge,
        RayClass::ExactVertex,
    ];

    /// The word in the column `ray_class`.
    pub fn word(self) -> &'static str {
        match self {
            RayClass::Random => "random",
            RayClass::Edge => "edge",
            RayClass::Vertex => "vertex",
            RayClass::ExactEdge => "exact edge",
            RayClass::ExactVertex => "exact vertex",
        }
    }

    /// The classes that a mesh is shot with.
    pub fn of(kind: MeshKind) -> &'static [RayClass] {
        match kind {
            MeshKind::Lattice => &[RayClass::ExactEdge, RayClass::ExactVertex],
            _ => &[RayClass::Random, RayClass::Edge, RayClass::Vertex],
        }
    }
}

/// A mesh, with what is needed to shoot at it.
pub struct Range<'a> {
    mesh: &'a Mesh,
    class: RayClass,
    origins: Vec<Origin>,
    balls: Vec<(DVec3, f64)>,
}

struct Origin {
    place: DVec3,
    /// Whether it certainly sees the back of every triangle.
    sees_all: bool,
}

/// The triangles that matter to a ray.
pub struct Met {
    /// Whether the ray exactly leaves the mesh, in one point. Where rounding has made the mesh fold
    /// over, or has put the origin outside, it does not, and is in no count.
    pub is_one: bool,
    /// Those that kernels are asked about.
    asked: Vec<u32>,
}

impl<'a> Range<'a> {
    /// A mesh to be shot at from places inside of it.
    pub fn new(mesh: &'a Mesh, kind: MeshKind, class: RayClass, draw: &mut Draw) -> Self {
        let mut origin = || {
            let inside = loop {
                let point = draw.cube();
                if point.length_squared() <= 1.0 {
                    break point;
                }
            };
            let place = mesh.centre + inside * mesh.inner;
            let place = match kind {
                MeshKind::Lattice => (place / 2.0).round() * 2.0,
                _ => draw.round(place),
            };
            Origin { place, sees_all: sees_all(mesh, place) }
        };
        let origins = (0..ORIGINS).map(|_| origin()).collect();
        let ball = |triangle: u32| {
            let corners = mesh.corners(triangle);
            let centre = (corners[0] + corners[1] + corners[2]) / 3.0;
            let square = corners.iter().map(|p| p.distance_squared(centre)).fold(0.0, f64::max);
            (centre, square)
        };
        let balls = (0..mesh.triangles.len() as u32).map(ball).collect();
        Range { mesh, class, origins, balls }
    }

    /// A ray, the triangles around what it is aimed at, and whether its origin sees them all.
    pub fn shot(&self, draw: &mut Draw) -> (Query, Vec<u32>, bool) {
        let origin = &self.origins[draw.below(self.origins.len() as u64) as usize];
        let mesh = self.mesh;
        let from = origin.place;
        let (way, aim) = match self.class {
            RayClass::Random => (draw.direction(), Vec::new()),
            RayClass::Edge | RayClass::ExactEdge => {
                let edge = mesh.edges[draw.below(mesh.edges.len() as u64) as usize];
                let [one, other] = edge.ends.map(|end| mesh.vertices[end as usize]);
                let way = if self.class == RayClass::Edge {
                    one + (other - one) * draw.between(0.0, 1.0) - from
                } else {
                    // Four times a half, or a quarter, of even numbers: whole.
                    let part = if draw.chance(0.5) { 2.0 } else { 1.0 };
                    (one - from) * 4.0 + (other - one) * part
                };
                (way, self.with_neighbours(&edge.sides))
            }
            RayClass::Vertex | RayClass::ExactVertex => {
                let vertex = draw.below(mesh.vertices.len() as u64) as usize;
                (mesh.vertices[vertex] - from, mesh.around[vertex].clone())
            }
        };
        let query = draw.ray(from, way, [DVec3::ZERO; 3], (0.0, REACH));
        (query, aim, origin.sees_all)
    }

    fn with_neighbours(&self, triangles: &[u32]) -> Vec<u32> {
        let across = triangles.iter().flat_map(|triangle| self.mesh.across[*triangle as usize]);
        let mut all: Vec<u32> = triangles.iter().copied().chain(across).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    fn against(&self, query: &Query, triangle: u32) -> Query {
        Query { triangle: self.mesh.corners(triangle).map(|p| p.to_array()), ..*query }
    }

    /// What a ray exactly meets, `aim` being the triangles around what it is aimed at.
    pub fn met(&self, query: &Query, aim: &[u32], sees_all: bool) -> Met {
        // An origin in the surface itself, where rounding has flattened a mesh, is not inside: the
        // hit at t = 0 is the family `t-zero`.
        let query = &Query { t_min: f64::MIN_POSITIVE, ..*query };
        let exactly = |triangles: &[u32]| -> Vec<(u32, Class)> {
            let class = |triangle: &u32| (*triangle, classify(&self.against(query, *triangle)));
            triangles.iter().map(class).filter(|(_, class)| class.is_hit()).collect()
        };
        let mut hits = exactly(aim);
        if !(sees_all && is_one_point(&hits)) {
            hits = exactly(&self.near(query));
        }
        let hit: Vec<u32> = hits.iter().map(|(triangle, _)| *triangle).collect();
        let is_one = is_one_point(&hits) && (sees_all || self.leaves(query, &hit));
        let mut asked = self.with_neighbours(&hit);
        asked.extend(aim);
        asked.sort_unstable();
        asked.dedup();
        Met { is_one, asked }
    }

    /// Whether a ray certainly meets the back of each of these: it does not only touch the mesh.
    fn leaves(&self, query: &Query, triangles: &[u32]) -> bool {
        let direction = DVec3::from_array(query.direction);
        triangles.iter().all(|triangle| {
            let [a, b, c] = self.mesh.corners(*triangle);
            is_right_handed(direction, b - a, c - a)
        })
    }

    /// The triangles whose ball the ray's line meets, with a margin far above rounding.
    fn near(&self, query: &Query) -> Vec<u32> {
        let origin = DVec3::from_array(query.origin);
        let direction = DVec3::from_array(query.direction);
        let square = direction.length_squared();
        let meets = |(centre, radius_squared): &(DVec3, f64)| {
            let to = *centre - origin;
            let (along, length) = (to.dot(direction), to.length_squared());
            // |to|^2 |d|^2 - (to.d)^2 is the squared distance, times |d|^2.
            length * square - along * along
                <= (radius_squared * (1.0 + 1e-9) + 1e-12 * length) * square
        };
        let balls = (0u32..).zip(&self.balls);
        balls.filter(|(_, ball)| meets(ball)).map(|(triangle, _)| triangle).collect()
    }

    /// Hits that a kernel reports of the triangles that matter, and how many of them with an output
    /// that is not finite.
    pub fn hits(&self, ask: fn(&Query) -> Answer, query: &Query, met: &Met) -> (u64, u64) {
        let (mut hits, mut non_finite) = (0, 0);
        for triangle in &met.asked {
            let answer = ask(&self.against(query, *triangle));
            let finite = answer.t.is_finite() && answer.u.is_finite() && answer.v.is_finite();
            let hit = answer.triangle.is_some();
            hits += u64::from(hit);
            non_finite += u64::from(hit && !finite);
        }
        (hits, non_finite)
    }
}

/// One point is met in the inside of a triangle, on the edge of two, or at a vertex of three or
/// more.
fn is_one_point(hits: &[(u32, Class)]) -> bool {
    let count = |class: Class| hits.iter().filter(|(_, other)| *other == class).count();
    let counts = (count(Class::Interior), count(Class::Edge), count(Class::Vertex));
    matches!(counts, (1, 0, 0) | (0, 2, 0) | (0, 0, 3..))
}

/// Whether a point certainly sees the back of every triangle: then it is inside, and every ray
/// from it leaves the mesh once.
fn sees_all(mesh: &Mesh, from: DVec3) -> bool {
    (0..mesh.triangles.len() as u32).all(|triangle| {
        let [a, b, c] = mesh.corners(triangle).map(|p| p - from);
        is_right_handed(a, b, c)
    })
}

/// Whether a . (b x c) is positive beyond what rounding can do.
fn is_right_handed(a: DVec3, b: DVec3, c: DVec3) -> bool {
    let minors = DVec3::new(
        (b.y * c.z).abs() + (b.z * c.y).abs(),
        (b.z * c.x).abs() + (b.x * c.z).abs(),
        (b.x * c.y).abs() + (b.y * c.x).abs(),
    );
    a.dot(b.cross(c)) > BOUND * a.abs().dot(minors)
}
