//! What the peers answer: at a plain place, beside each other, and to the oracle.

use glam::Vec3;
use ray_test::job::Answer;
use ray_test::oracle::Query;
use ray_test::registry::{Variant, asked_with_peers, variants};
use ray_test::table::Row;
use ray_test::workload::{PairSpec, Pairs, QueryKind, Ray, Triangle, Winding};

fn peers() -> Vec<&'static Variant> {
    let peers: Vec<_> = variants().iter().filter(|variant| variant.is_peer()).collect();
    assert!(peers.len() >= 10, "{} peers", peers.len());
    peers
}

/// Seen from the front by rays along z; twice its area is 16, and its edges are of few bits.
const TRIANGLE: Triangle = Triangle {
    a: Vec3::new(0.0, 0.0, 2.0),
    b: Vec3::new(0.0, 4.0, 2.0),
    c: Vec3::new(4.0, 0.0, 2.0),
};
const HIT: Ray = Ray {
    origin: Vec3::new(1.0, 2.0, 0.0),
    direction: Vec3::Z,
    end: Vec3::new(1.0, 2.0, 9.0),
    t_min: 0.0,
    t_max: f32::MAX,
};

fn answer(variant: &Variant, ray: Ray, triangle: Triangle) -> Answer {
    let bind = variant.pairs.as_ref().expect("peers run on pairs");
    bind(&[ray], &[triangle]).answers()[0]
}

/// t, u and v; nothing for a miss.
fn place(variant: &Variant, ray: Ray, triangle: Triangle) -> Option<[f64; 3]> {
    let answer = answer(variant, ray, triangle);
    assert_eq!(answer.code == 0, answer.triangle.is_some(), "{}", variant.id());
    answer.triangle.map(|_| [answer.t, answer.u, answer.v])
}

/// What a peer reports of a hit with these weights. The plain triangle of obvhs multiplies them by
/// the double area, as its `About` says.
fn reported(variant: &Variant, [t, u, v]: [f64; 3]) -> [f64; 3] {
    let axes = &variant.axes;
    match (axes.kernel, axes.stored, axes.output) {
        (_, _, "t") => [t, 0.0, 0.0],
        ("peer-obvhs", "vertices", _) => [t, 16.0 * u, 16.0 * v],
        _ => [t, u, v],
    }
}

#[test]
fn all_find_a_plain_hit_and_its_place() {
    for peer in peers() {
        let expected = reported(peer, [2.0, 0.5, 0.25]);
        assert_eq!(place(peer, HIT, TRIANGLE), Some(expected), "{}", peer.id());
        // The bound of t belongs to what counts.
        let bounded = Ray { t_max: 2.0, ..HIT };
        assert_eq!(place(peer, bounded, TRIANGLE), Some(expected), "{}", peer.id());
    }
}

#[test]
fn all_miss_plain_misses() {
    let behind = Ray { origin: Vec3::new(1.0, 2.0, 4.0), ..HIT };
    let beside = [(-1.0, 2.0), (1.0, -1.0), (3.0, 2.0)]
        .map(|(x, y)| Ray { origin: Vec3::new(x, y, 0.0), ..HIT });
    let before = Ray { t_max: 1.5, ..HIT };
    let along = Ray { direction: Vec3::X, ..HIT };
    for peer in peers() {
        for ray in beside.into_iter().chain([behind, before, along]) {
            assert_eq!(place(peer, ray, TRIANGLE), None, "{} {ray:?}", peer.id());
        }
        let point = Triangle { a: TRIANGLE.a, b: TRIANGLE.a, c: TRIANGLE.a };
        assert_eq!(place(peer, HIT, point), None, "{}", peer.id());
    }
}

#[test]
fn back_faces_are_missed_by_those_that_cull_and_hit_by_the_others() {
    let turned = Triangle { b: TRIANGLE.c, c: TRIANGLE.b, ..TRIANGLE };
    let mut culling = 0;
    for peer in peers() {
        let culls = peer.axes.cull == "on";
        let expected = (!culls).then_some(reported(peer, [2.0, 0.25, 0.5]));
        assert_eq!(place(peer, HIT, turned), expected, "{}", peer.id());
        culling += usize::from(culls);
    }
    assert_eq!(culling, 1);
}

/// Pairs that rounding does not decide, all seen from the front.
fn pairs() -> Pairs {
    let spec = PairSpec {
        query: QueryKind::Ray,
        winding: Winding::Facing,
        ..PairSpec::new(2000, 0.5, 11)
    };
    Pairs::draw(spec).expect("a plain specification")
}

#[test]
fn without_a_clock_they_answer_what_they_answer_with_one() {
    let pairs = pairs();
    let mut asked_peers = 0;
    for peer in peers().into_iter().filter(|peer| peer.axes.output == "tuv") {
        let id = peer.id();
        let asked = asked_with_peers().find(|asked| asked.id() == id);
        let asked = asked.unwrap_or_else(|| panic!("{id} cannot be asked"));
        let bind = peer.pairs.as_ref().expect("peers run on pairs");
        let answers = bind(&pairs.rays, &pairs.triangles).answers();
        for (place, answer) in answers.iter().enumerate() {
            let query = Query::of(&pairs.rays[place], &pairs.triangles[place]);
            let other = (asked.ask)(&query);
            assert_eq!(answer.triangle.is_some(), other.triangle.is_some(), "{id} {place}");
            assert_eq!([answer.t, answer.u, answer.v], [other.t, other.u, other.v], "{id} {place}");
        }
        asked_peers += 1;
    }
    assert_eq!(asked_peers, 7);
}

/// What a peer decides otherwise than the exact answer is counted, and it is timed all the same.
#[test]
fn a_wrong_decision_of_theirs_is_a_finding_and_no_failure() {
    let text = "id = 'test'\ntitle = 'A test'\nquestion = 'Does it run?'\nwhy = 'It must.'\n\
        feature = 'peers'\nvariants = ['^peer-.*$']\n[workload]\nkind = 'pairs'\ncount = 40\n\
        density = [0.5]\nquery = 'ray'\norders = ['fixed']\n[workload.stiff]\ncases = 500\n\
        knobs = { tiny = 4, near-edge = 4 }\n";
    let outcome = crate::support::run_all(text, 16);
    assert!(outcome.wrong.is_empty(), "{:?}", outcome.wrong);
    let (timed, stiff): (Vec<_>, Vec<_>) =
        outcome.rows.iter().partition(|row| row.workload == "pairs-ray");
    assert_eq!(timed.len(), peers().len());
    for row in timed {
        assert_eq!(row.status, "inexact", "{}", row.id);
        assert!(row.ns_per_test.is_some() && row.false_misses.is_some(), "{}", row.id);
    }
    let of = |workload: &str, kernel: &str| -> &Row {
        let found = stiff.iter().find(|row| row.workload == workload && row.kernel == kernel);
        found.unwrap_or_else(|| panic!("no {kernel} on {workload}"))
    };
    // A determinant of 10^-8 is below their epsilon of 1.2e-7, whatever the ray.
    for kernel in ["peer-glam", "peer-bvh"] {
        let row = of("tiny", kernel);
        assert!(row.exact_hits > Some(100), "{row:?}");
        assert_eq!((row.hits, row.false_misses), (Some(0), row.exact_hits), "{kernel}");
    }
    // Edges of eleven bits move a boundary by up to 2^-12 of them, across rays 10^-4 / 3 from it.
    let row = of("near-edge", "peer-obvhs-compressed");
    assert!(row.false_hits > Some(0) && row.false_misses > Some(0), "{row:?}");
    for kernel in ["peer-parry", "peer-obvhs", "peer-rayx"] {
        for workload in ["tiny", "near-edge"] {
            let row = of(workload, kernel);
            assert_eq!((row.false_hits, row.false_misses), (Some(0), Some(0)), "{row:?}");
        }
    }
}
