//! Every kernel can be asked.

use ray_test::check::{Judged, Known, Precision, Reply, Verdict, form, kernels};
use ray_test::oracle::Query;

/// Hits the triangle (0,0,0), (1,0,0), (0,1,0) from above at t = 1/2.
const HIT: Query = Query {
    origin: [0.25, 0.5, 1.0],
    direction: [0.0, 0.0, -2.0],
    end: None,
    triangle: [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    t_min: 0.0,
    t_max: f64::INFINITY,
};

#[test]
fn every_kernel_has_a_form_and_finds_a_plain_hit() {
    assert!(kernels().len() >= 18, "{:?}", kernels());
    for precision in Precision::ALL {
        let ray = Known::of_ray(HIT, precision);
        for form in kernels().iter().filter_map(|kernel| form(kernel, precision)) {
            assert_eq!((form.axes.rounding, form.axes.tests), ("plain", "compare"));
            let known = if form.is_segment { ray.of_segment() } else { ray };
            let judged = Judged::of(&Reply::of(form, &known), &known);
            assert_eq!(judged.verdict, Verdict::Agree, "{}", form.id());
            assert_eq!(judged.values[0], Some(0.5), "{}", form.id());
        }
    }
    let own = form("kensler-shirley", Precision::F32).expect("it is one of the first").axes.clone();
    assert!(own.stored_is_native && own.leading_is_native && own.division == "last");
}
