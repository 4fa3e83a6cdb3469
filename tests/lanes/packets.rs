//! Packets of rays against one triangle, in every corner of the floating-point numbers.

use ray_test::kernels::Corners;
use ray_test::number::{Element, Vec3};
use ray_test::policy::Ray;
use ray_test::workload::Pcg;

/// Rays of a packet: the widest width, so that every width divides it.
pub const RAYS: usize = 16;
const PACKETS: usize = 48;

/// The families of numbers that packets are drawn from.
pub const FAMILIES: [&str; 6] =
    ["random", "lattice", "signed zeros", "subnormal", "huge", "not finite"];

/// One triangle and the rays that are tested against it.
pub struct Packet<E> {
    /// Its family.
    pub family: &'static str,
    /// The triangle.
    pub corners: Corners<E>,
    /// The rays.
    pub rays: [Ray<E>; RAYS],
}

/// All families' packets.
pub fn packets<E: Element>() -> Vec<Packet<E>> {
    let mut draw = Pcg::new(5);
    let mut packets = Vec::new();
    for family in FAMILIES {
        for _ in 0..PACKETS {
            let corners = Corners {
                a: vector(&mut draw, family),
                b: vector(&mut draw, family),
                c: vector(&mut draw, family),
            };
            let rays = std::array::from_fn(|i| ray(&mut draw, family, &corners, i % 2 == 1));
            packets.push(Packet { family, corners, rays });
        }
    }
    packets
}

fn vector<E: Element>(draw: &mut Pcg, family: &str) -> Vec3<E> {
    Vec3([number(draw, family), number(draw, family), number(draw, family)])
}

/// A ray; `aimed` ones start from the triangle's weights, so that hits are not rare.
fn ray<E: Element>(draw: &mut Pcg, family: &str, corners: &Corners<E>, aimed: bool) -> Ray<E> {
    let origin = vector(draw, family);
    let direction = if aimed {
        let (u, v) = (draw.below(5), draw.below(5));
        let weight = |n: u64| E::from_f32(n as f32 / 8.0);
        let (e1, e2) = corners.edges();
        corners.a + e1.scaled(weight(u)) + e2.scaled(weight(v)) - origin
    } else {
        vector(draw, family)
    };
    let bound = |n: f32| E::from_f32(n);
    let t_min = [bound(0.0), bound(-0.0), bound(0.5), bound(-1.0)][draw.below(4) as usize];
    let t_max = [bound(1.0), bound(2.0), E::MAX, E::MAX][draw.below(4) as usize];
    Ray { origin, direction, end: origin + direction.scaled(bound(1.5)), t_min, t_max }
}

fn number<E: Element>(draw: &mut Pcg, family: &str) -> E {
    let unit = E::from_f32((draw.below(1 << 24) as f32 - 8_388_608.0) / 8_388_608.0);
    let infinity = E::MAX + E::MAX;
    let special = draw.below(12);
    match (family, special) {
        ("lattice", _) => E::from_f32(draw.below(5) as f32 - 2.0),
        ("signed zeros", _) => E::from_f32([0.0, -0.0, 1.0, -1.0][special as usize % 4]),
        ("subnormal", 0..8) => unit * E::LARGEST_SUBNORMAL,
        // The root's products are subnormal.
        ("subnormal", 8..11) => unit * E::LARGEST_SUBNORMAL.sqrt(),
        ("huge", 0..6) => unit * E::MAX,
        ("huge", 6..11) => unit * E::MAX.sqrt(),
        ("not finite", 0) => infinity,
        ("not finite", 1) => -infinity,
        ("not finite", 2) if draw.below(2) == 0 => infinity * E::ZERO,
        _ => unit,
    }
}
