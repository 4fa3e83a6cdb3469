//! Operations by kind, without a clock: the theses' tables, and the counts in the kernels' headers.

use glam::Vec3;
use ray_test::counting::{Counter, ExitPath, counters, paths};
use ray_test::number::Operations;
use ray_test::workload::{Generator, Ray, Triangle, draw_pairs};

const DRAWN: usize = 30_000;

/// Pairs of thesis B, and two that badouel's branch for u1 = 0 takes, a hit and a miss.
fn pairs() -> (Vec<Ray>, Vec<Triangle>) {
    let (mut rays, mut triangles) = (Vec::new(), Vec::new());
    draw_pairs(Generator::Pcg, 7, DRAWN, |mut ray, triangle| {
        // Rays from the origin on, so that the exits by distance are met, too.
        ray.t_min = 0.0;
        rays.push(ray);
        triangles.push(triangle);
    })
    .unwrap();
    for x in [0.25, -0.5] {
        let (origin, direction) = (Vec3::new(x, 0.25, 1.0), Vec3::NEG_Z);
        let end = origin + 2.0 * direction;
        rays.push(Ray { origin, direction, end, t_min: 0.0, t_max: f32::MAX });
        triangles.push(Triangle { a: Vec3::ZERO, b: Vec3::Y, c: Vec3::X });
    }
    (rays, triangles)
}

fn every_path() -> Vec<(Counter, Vec<ExitPath>)> {
    let (rays, triangles) = pairs();
    counters().into_iter().map(|c| (c, paths(&c, &rays, &triangles))).collect()
}

fn longest(paths: &[ExitPath]) -> Operations {
    paths.iter().map(|path| path.longest).max_by_key(Operations::arithmetic).unwrap()
}

/// Tables 4.4, 4.6, 4.8 and 4.9: + - * / and conditions, t only; a unary minus is a subtraction.
#[test]
fn listings_execute_what_thesis_b_counts() {
    let published = [
        ("moller1", [9, 16, 25, 1, 4]),
        ("badouel", [8, 11, 13, 3, 4]),
        ("chirkov-line", [11, 20, 29, 1, 2]),
    ];
    let found = every_path();
    for (kernel, counts) in published {
        let of = |(c, _): &&(Counter, Vec<ExitPath>)| c.kernel == kernel && c.output == "t";
        let (_, paths) = found.iter().find(of).unwrap();
        let Operations { add, sub, neg, mul, div, condition, .. } = longest(paths);
        assert_eq!([add, sub + neg, mul, div, condition], counts, "{kernel}");
    }
}

/// Claim H-7.c (thesis H, 4.2.4): dividing last costs 10 -> 15 multiplications before the last test
/// for Wald and 15 -> 21 for the perpendicular planes. They are those of the exit at that test.
#[test]
fn dividing_last_adds_what_thesis_h_counts_before_the_last_test() {
    let found = every_path();
    for (kernel, first, last) in [("wald", 10, 15), ("perpendicular-planes", 15, 21)] {
        let before_the_last = |division: &str| {
            let of =
                |(c, _): &&(Counter, Vec<ExitPath>)| c.kernel == kernel && c.division == division;
            let (_, paths) = found.iter().find(of).unwrap();
            let exit = paths.last().unwrap();
            assert_eq!(
                (exit.code, exit.longest.div),
                (3, u64::from(division == "first")),
                "{kernel}"
            );
            exit.longest.mul
        };
        assert_eq!([before_the_last("first"), before_the_last("last")], [first, last], "{kernel}");
    }
}

/// An exit has one path, but where a listing branches on its way to it.
#[test]
fn an_exit_tells_the_path() {
    let found = every_path();
    for (counter, paths) in &found {
        let branching: &[u8] = match counter.kernel {
            // A hit of a back face has passed one more condition, and `v < 0 || u + v > det` does
            // not add where v < 0.
            "moller0" => &[2],
            "moller1" | "moller2" | "moller3" => &[0, 2, 4],
            "badouel" => &[0, 4],
            "chirkov-line" => &[1],
            _ => &[],
        };
        for path in paths {
            let counts = |o: &Operations| [o.add, o.sub, o.neg, o.mul, o.div, o.condition];
            let same = counts(&path.shortest) == counts(&path.longest);
            assert_eq!(same, !branching.contains(&path.code), "{path:?}");
        }
        assert_eq!(paths.iter().map(|path| path.calls).sum::<u64>(), DRAWN as u64 + 2);
        assert!(paths[0].code == 0 && paths[0].calls >= 1_000 && paths.len() >= 2, "{paths:?}");
    }
}

/// What the headers of the kernels' files say of a hit: kernel, stored (or how edge functions keep
/// their signs, where that is what differs), division, output, then + - unary minus * /.
const HEADERS: &[(&str, &str, &str, &str, [u64; 5])] = &[
    ("moller0", "vertices", "first", "t", [9, 15, 1, 27, 1]),
    ("moller0", "vertices", "first", "tuv", [9, 15, 1, 27, 1]),
    ("moller1", "vertices", "last", "t", [9, 15, 1, 25, 1]),
    ("moller1", "vertices", "last", "tuv", [9, 15, 1, 27, 1]),
    ("moller2", "vertices", "first", "t", [9, 15, 1, 25, 1]),
    ("moller2", "vertices", "first", "tuv", [9, 15, 1, 27, 1]),
    ("moller3", "vertices", "first", "t", [9, 15, 1, 25, 1]),
    ("moller3", "vertices", "first", "tuv", [9, 15, 1, 27, 1]),
    ("badouel", "precomputed", "first", "t", [8, 9, 2, 13, 3]),
    ("badouel", "precomputed", "first", "tuv", [8, 9, 2, 13, 3]),
    ("chirkov-line", "precomputed", "last", "t", [11, 19, 1, 29, 1]),
    ("chirkov-line", "precomputed", "last", "tuv", [11, 20, 1, 34, 2]),
    ("moller-trumbore", "vertices", "first", "tuv", [9, 15, 0, 27, 1]),
    ("moller-trumbore", "vertices", "last", "tuv", [9, 15, 0, 28, 1]),
    ("kensler-shirley", "vertices", "first", "tuv", [9, 15, 0, 27, 1]),
    ("kensler-shirley", "vertices", "last", "tuv", [9, 15, 0, 28, 1]),
    ("kensler-shirley", "normal", "first", "tuv", [9, 12, 0, 21, 1]),
    ("kensler-shirley", "normal", "last", "tuv", [9, 12, 0, 22, 1]),
    ("kensler-shirley", "precomputed", "first", "tuv", [9, 6, 0, 21, 1]),
    ("kensler-shirley", "precomputed", "last", "tuv", [9, 6, 0, 22, 1]),
    ("kensler-shirley", "edges", "first", "tuv", [9, 18, 0, 33, 1]),
    ("kensler-shirley", "edges", "last", "tuv", [9, 18, 0, 34, 1]),
    ("shevtsov", "precomputed", "first", "tuv", [7, 5, 1, 10, 1]),
    ("shevtsov", "precomputed", "last", "tuv", [7, 5, 1, 16, 1]),
    ("badouel-cramer", "precomputed", "first", "tuv", [7, 10, 0, 16, 2]),
    ("badouel-cramer", "precomputed", "last", "tuv", [7, 10, 0, 23, 2]),
    ("wald", "precomputed", "first", "tuv", [11, 1, 0, 10, 1]),
    ("wald", "precomputed", "last", "tuv", [11, 1, 0, 18, 1]),
    ("keidy", "vertices", "first", "tuv", [18, 18, 0, 38, 2]),
    ("keidy", "vertices", "last", "tuv", [18, 18, 0, 47, 2]),
    ("keidy", "normal", "first", "tuv", [18, 15, 0, 32, 2]),
    ("keidy", "normal", "last", "tuv", [18, 15, 0, 41, 2]),
    ("perpendicular-planes", "precomputed", "first", "tuv", [14, 1, 0, 15, 1]),
    ("perpendicular-planes", "precomputed", "last", "tuv", [14, 1, 0, 24, 1]),
    ("chirkov", "precomputed", "last", "tuv", [9, 21, 2, 32, 2]),
    ("plucker", "vertices", "last", "tuv", [21, 33, 0, 58, 2]),
    ("half-spaces", "vertices", "last", "tuv", [12, 27, 0, 43, 2]),
    ("signed-areas", "normal", "first", "tuv", [15, 30, 0, 41, 2]),
    ("angle-sum", "vertices", "first", "t", [28, 22, 8, 47, 4]),
    ("woop-watertight", "fallback", "first", "tuv", [4, 18, 0, 21, 4]),
    ("woop-watertight", "fallback", "last", "tuv", [4, 18, 0, 22, 4]),
    ("woop-watertight", "no-fallback", "first", "tuv", [4, 18, 0, 21, 4]),
    ("woop-watertight", "no-fallback", "last", "tuv", [4, 18, 0, 22, 4]),
    ("woop-watertight", "exact-sign", "first", "tuv", [4, 63, 0, 51, 4]),
    ("woop-watertight", "exact-sign", "last", "tuv", [4, 63, 0, 52, 4]),
    ("embree-plucker", "vertices", "first", "tuv", [21, 33, 1, 48, 2]),
    ("baldwin-weber", "precomputed", "first", "tuv", [15, 0, 1, 15, 1]),
    ("baldwin-weber", "precomputed", "last", "tuv", [15, 0, 1, 24, 1]),
    ("baldwin-weber", "row-offsets", "first", "tuv", [15, 0, 1, 15, 1]),
    ("baldwin-weber", "row-offsets", "last", "tuv", [15, 0, 1, 24, 1]),
    ("woop-affine", "precomputed", "first", "tuv", [18, 0, 1, 20, 1]),
    ("woop-affine", "precomputed", "last", "tuv", [18, 0, 1, 26, 1]),
    ("moller-trumbore-in-f64", "vertices", "first", "tuv", [9, 15, 0, 27, 1]),
    ("moller-trumbore-in-f64", "vertices", "last", "tuv", [9, 15, 0, 28, 1]),
];

#[test]
fn headers_state_what_a_hit_executes() {
    let found = every_path();
    let mut wrong = Vec::new();
    for (c, paths) in &found {
        let Operations { add, sub, neg, mul, div, .. } = paths[0].longest;
        let form = [c.cross, c.edges, c.stored].into_iter().find(|word| !word.is_empty());
        let form = form.expect("something is stored");
        let row = (c.kernel, form, c.division, c.output, [add, sub, neg, mul, div]);
        if !HEADERS.contains(&row) {
            wrong.push(format!("    {row:?},"));
        }
    }
    assert!(wrong.is_empty(), "\n{}", wrong.join("\n"));
    assert_eq!(HEADERS.len(), found.len());
}
