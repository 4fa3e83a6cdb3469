use super::*;
use crate::oracle::{Class, condition, solve};

fn classes(pairs: &Pairs) -> Vec<bool> {
    pairs
        .rays
        .iter()
        .zip(&pairs.triangles)
        .map(|(ray, triangle)| classify(&Query::of(ray, triangle)).is_hit())
        .collect()
}

#[test]
fn the_density_is_exact_for_every_query_and_winding() {
    for query in [QueryKind::Line, QueryKind::Ray, QueryKind::Segment] {
        for winding in [Winding::Natural, Winding::Facing] {
            for (density, hits) in [(0.0, 0), (0.25, 250), (0.3335, 334), (1.0, 1001)] {
                let spec = PairSpec { query, winding, ..PairSpec::new(1001, density, 3) };
                let pairs = Pairs::draw(spec).unwrap();
                assert_eq!((pairs.rays.len(), pairs.triangles.len()), (1001, 1001));
                let counted = classes(&pairs).into_iter().filter(|hit| *hit).count();
                assert_eq!((pairs.hits, counted), (hits, hits), "{query:?} {density}");
            }
        }
    }
}

#[test]
fn products_are_rounded_half_up() {
    let hits = |count, density| PairSpec::new(count, density, 1).hits().unwrap();
    assert_eq!([hits(2, 0.25), hits(6, 0.25), hits(10, 0.25), hits(1, 0.49)], [1, 2, 3, 0]);
    assert_eq!([hits(1 << 24, 1.0), hits(1 << 24, 1.0 - f64::EPSILON)], [1 << 24, 1 << 24]);
}

#[test]
fn every_window_holds_the_density_within_one_pair() {
    let pairs = Pairs::draw(PairSpec::new(500, 0.3, 9)).unwrap();
    let hits = classes(&pairs);
    for length in [1, 7, 50, 333] {
        for window in hits.windows(length) {
            let found = window.iter().filter(|hit| **hit).count() as f64;
            assert!((found - 0.3 * length as f64).abs() < 1.0, "{found} of {length}");
        }
    }
}

#[test]
fn facing_pairs_face_and_natural_ones_do_not_care() {
    let fronts = |winding| {
        let spec = PairSpec { winding, ..PairSpec::new(2000, 0.5, 4) };
        let pairs = Pairs::draw(spec).unwrap();
        let front =
            |(ray, t): (&Ray, &Triangle)| ray.direction.dot((t.b - t.a).cross(t.c - t.a)) < 0.0;
        pairs.rays.iter().zip(&pairs.triangles).filter(|pair| front(*pair)).count()
    };
    assert_eq!(fronts(Winding::Facing), 2000);
    // Five standard errors of 2 000 fair coins are 112.
    assert!(fronts(Winding::Natural).abs_diff(1000) < 112);
}

#[test]
fn margins_exceed_what_a_stable_kernel_can_lose() {
    let spec = PairSpec { query: QueryKind::Segment, ..PairSpec::new(3000, 0.5, 6) };
    let pairs = Pairs::draw(spec).unwrap();
    let unit = f64::from(f32::EPSILON) / 2.0;
    for (ray, triangle) in pairs.rays.iter().zip(&pairs.triangles) {
        let query = Query::of(ray, triangle);
        let exact = solve(&query);
        let kappa = condition(&query, &exact);
        // 63: the condition numbers are good to about 2 %.
        for (margin, kappa) in [
            (exact.u, kappa.kappa_u),
            (exact.v, kappa.kappa_v),
            (exact.w, kappa.kappa_w),
            (exact.t, kappa.kappa_t),
            (query.t_max - exact.t, kappa.kappa_t),
        ] {
            assert!(margin.abs() > 62.0 * unit * kappa, "{exact:?} {kappa}");
        }
        assert!(matches!(exact.class, Class::Interior | Class::Outside | Class::Behind));
    }
    // The redrawing is at work, and is no more than a correction.
    assert!((1..pairs.attempts / 20).contains(&pairs.redrawn), "{pairs:?}");
}

#[test]
fn segments_of_origin_and_end_agree_with_their_rays() {
    let spec = PairSpec { query: QueryKind::Segment, ..PairSpec::new(3000, 0.5, 8) };
    let pairs = Pairs::draw(spec).unwrap();
    for (ray, triangle) in pairs.rays.iter().zip(&pairs.triangles) {
        let by_direction = classify(&Query::of(ray, triangle)).is_hit();
        assert_eq!(by_direction, classify(&Query::of_segment(ray, triangle)).is_hit());
    }
}

#[test]
fn sets_are_golden() {
    let hash = |spec: PairSpec| Pairs::draw(spec).unwrap().hash;
    let base = PairSpec::new(1000, 0.25, 1);
    let segment = PairSpec { query: QueryKind::Segment, winding: Winding::Facing, ..base };
    let hashes = [
        hash(base),
        hash(PairSpec { seed: 2, ..base }),
        hash(PairSpec { generator: Generator::Msvc, ..base }),
        hash(segment),
    ];
    let golden = [
        0x1af6_4880_bfa7_2e0a,
        0x90ac_a0b6_67f4_26a6,
        0xcf05_60e0_99f6_60a1,
        0x0ba6_18d2_eb14_3296,
    ];
    assert_eq!(hashes, golden, "{hashes:#x?}");
}

#[test]
fn bad_specifications_are_refused_with_what_is_allowed() {
    let message = |spec: PairSpec| {
        let refused = Pairs::draw(spec).unwrap_err().to_string();
        assert_eq!(spec.check().unwrap_err().to_string(), refused);
        refused
    };
    assert_eq!(PairSpec::new(10, 0.5, 1).check(), Ok(()));
    for density in [f64::NAN, -0.1, 1.5, f64::INFINITY] {
        let text = message(PairSpec::new(10, density, 1));
        assert_eq!(text, format!("density is {density}; allowed is a number from 0 to 1"));
    }
    for count in [0, usize::MAX, (1 << 24) + 1] {
        let text = message(PairSpec::new(count, 0.5, 1));
        assert_eq!(text, format!("number of pairs is {count}; allowed is 1 to 16777216"));
    }
    let generator = Generator::Msvc;
    let seed = PairSpec { generator, ..PairSpec::new(10, 0.5, u64::MAX) };
    assert!(message(seed).starts_with("seed is 18446744073709551615"));
}

#[test]
fn a_set_that_is_cancelled_is_none_and_bad_specifications_come_first() {
    let draw = |spec: PairSpec, cancel: bool| {
        Pairs::draw_unless(spec, &AtomicBool::new(cancel)).map(|pairs| pairs.hash)
    };
    let spec = PairSpec::new(100, 0.5, 1);
    assert_eq!(draw(spec, true), Err(WorkloadError::Cancelled));
    assert_eq!(draw(spec, false), Pairs::draw(spec).map(|pairs| pairs.hash));
    let bad = draw(PairSpec::new(100, 1.5, 1), true);
    assert_eq!(bad, Err(WorkloadError::Density { value: 1.5 }));
}
