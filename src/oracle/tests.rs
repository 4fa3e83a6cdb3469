use super::aligned::Aligned;
use super::draws::{
    DRAWS, Draw, coordinates, cube, lattice, lattice_segment, query, stretched_lattice, subnormal,
};
use super::exact::classify_in_integers;
use super::filter::Filtered;
use super::numerators::Numerators;
use super::reference::{is_nearest, is_sum, reference};
use super::*;
use crate::workload::Pcg;
use dashu_int::IBig;

fn counts(draw: Draw, number: usize) -> [usize; 7] {
    let mut pcg = Pcg::new(number as u64);
    let mut counts = [0; 7];
    for _ in 0..number {
        let class = classify(&draw(&mut pcg));
        counts[Class::ALL.iter().position(|c| *c == class).unwrap_or(0)] += 1;
    }
    counts
}

#[test]
fn every_answer_is_the_references() {
    for (name, draw, number) in DRAWS {
        let mut pcg = Pcg::new(number as u64);
        for _ in 0..number {
            let query = draw(&mut pcg);
            let expected = reference(&query);
            assert_eq!(classify(&query), expected.class, "{name} {query:?}");
            assert_eq!(classify_in_integers(&query), expected.class, "{name} {query:?}");
            let exact = solve(&query);
            assert_eq!(exact.class, expected.class, "{name} {query:?}");
            let found = [exact.t, exact.u, exact.v, exact.w];
            let rest = [exact.t_lo, exact.u_lo, exact.v_lo, exact.w_lo];
            let Some(values) = expected.values else {
                assert!(found.iter().chain(&rest).all(|x| x.is_nan()), "{name} {query:?}");
                continue;
            };
            for ((value, high), low) in values.iter().zip(found).zip(rest) {
                assert!(is_nearest(value, high), "{name} {query:?} {exact:?}");
                assert!(high.is_infinite() || is_sum(value, high, low), "{name} {exact:?}");
            }
        }
    }
}

#[test]
fn the_draws_hold_what_they_are_for() {
    // Degenerate, Coplanar, Outside, Behind, Vertex, Edge, Interior: at least this many.
    let floors: [(Draw, usize, [usize; 7]); 5] = [
        (lattice, 20_000, [300, 100, 5000, 500, 300, 200, 200]),
        (stretched_lattice, 5000, [50, 20, 1000, 100, 50, 50, 50]),
        (lattice_segment, 5000, [50, 20, 1000, 100, 50, 50, 50]),
        (cube, 3000, [0, 0, 2000, 50, 0, 0, 50]),
        (subnormal, 1500, [0, 0, 500, 20, 0, 0, 20]),
    ];
    for (draw, number, floor) in floors {
        let found = counts(draw, number);
        assert!(found.iter().zip(floor).all(|(found, floor)| *found >= floor), "{found:?}");
    }
}

#[test]
fn each_stage_is_used_and_agrees_with_the_next() {
    let (mut filtered, mut small, mut big) = (0, 0, 0);
    for (name, draw, number) in DRAWS {
        let mut pcg = Pcg::new(number as u64 + 1);
        for _ in 0..3 * number {
            let query = draw(&mut pcg);
            let aligned = Aligned::of(&query);
            let exact = Numerators::<IBig>::of(&aligned);
            let class = exact.class(query.t_min, query.t_max);
            if let Some(found) =
                Filtered::of(&query).and_then(|f| f.class(query.t_min, query.t_max))
            {
                assert_eq!(found, class, "{name} {query:?}");
                filtered += 1;
            }
            if aligned.fits_i128() {
                let narrow = Numerators::<i128>::of(&aligned);
                let same = [narrow.det, narrow.u, narrow.v, narrow.w, narrow.t].map(IBig::from);
                assert_eq!(same, [exact.det, exact.u, exact.v, exact.w, exact.t], "{query:?}");
                small += 1;
            } else {
                big += 1;
            }
        }
    }
    assert!(filtered > 10_000 && small > 20_000 && big > 5000);
}

#[test]
fn the_widest_numbers_that_fit_i128_do_fit() {
    // Positions of 40 bits fill t's budget, with directions of 39 bits that of det.
    let (p, d) = ((1u64 << 40) as f64 - 1.0, (1u64 << 39) as f64 - 1.0);
    let mut pcg = Pcg::new(8);
    for _ in 0..2000 {
        let mut sign = || if pcg.below(2) == 0 { -1.0 } else { 1.0 };
        let mut points = coordinates(|| p * sign());
        points[1] = std::array::from_fn(|_| d * sign());
        let query = query(points, 0.0, 1.0);
        let aligned = Aligned::of(&query);
        assert!(aligned.fits_i128());
        let (narrow, wide) = (Numerators::<i128>::of(&aligned), Numerators::<IBig>::of(&aligned));
        let same = [narrow.det, narrow.u, narrow.v, narrow.w, narrow.t].map(IBig::from);
        assert_eq!(same, [wide.det, wide.u, wide.v, wide.w, wide.t]);
    }
    let wider = query([[p * 2.0 + 1.0; 3], [1.0; 3], [0.0; 3], [1.0; 3], [2.0; 3]], 0.0, 1.0);
    assert!(!Aligned::of(&wider).fits_i128());
}

#[test]
fn a_difference_that_overflows_is_still_exact() {
    let far = f64::MAX;
    let triangle = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 1.0, 0.0]];
    let query = Query::segment([0.0, 0.0, -far], [0.0, 0.0, far], triangle);
    assert!(query.direction[2].is_infinite());
    let exact = solve(&query);
    assert_eq!((exact.class, exact.t, exact.t_lo), (Class::Interior, 0.5, 0.0));
}

#[test]
fn input_that_is_not_finite_is_a_miss_without_values() {
    let good = query(
        [[0.2, 0.2, -1.0], [0.0, 0.0, 1.0], [0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        0.0,
        f64::INFINITY,
    );
    assert_eq!(classify(&good), Class::Interior);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for place in 0..15 {
            let mut query = good;
            match place {
                0..3 => query.origin[place] = bad,
                3..6 => query.direction[place - 3] = bad,
                _ => query.triangle[(place - 6) / 3][place % 3] = bad,
            }
            let exact = solve(&query);
            assert!(!query.is_finite() && !excusable(&query, &exact, 1e-7, true));
            assert_eq!((classify(&query), exact.class), (Class::Outside, Class::Outside));
            assert!(exact.t.is_nan() && exact.u.is_nan());
        }
    }
    for query in [Query { t_min: f64::NAN, ..good }, Query { t_max: f64::NAN, ..good }] {
        assert_eq!((classify(&query), solve(&query).class), (Class::Outside, Class::Outside));
    }
}
