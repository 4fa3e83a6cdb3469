//! Kernels of one's own on a clock that tells what it is told.

use std::cell::RefCell;
use std::sync::atomic::AtomicBool;

use super::*;
use crate::measure::{
    NoCounters, NoRuler, Order, Protocol, Remember, ScriptedClock, Status, Surroundings,
    Undisturbed,
};
use crate::number::Precision;
use crate::stats::{Ratio, Verdict};

thread_local! {
    /// The clock that a test of [`Slow`] moves on.
    static CLOCK: RefCell<Option<ScriptedClock>> = const { RefCell::new(None) };
}

/// What a reading of the clock takes, ns: a block, so that nothing is repeated.
const READING_NS: u64 = 60_000;
/// What a test of [`Slow`] takes, ns: with 500 of them, as long as a reading.
const TEST_NS: u64 = READING_NS / 500;

fn sub(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Moeller and Trumbore's test; weights may be below 0, or their sum above 1, by so much.
fn test(ray: &Ray<f64>, triangle: &Triangle<f64>, beyond: f64) -> Option<Hit<f64>> {
    let (e1, e2) = (sub(triangle.b, triangle.a), sub(triangle.c, triangle.a));
    let p = cross(ray.direction, e2);
    let det = dot(e1, p);
    if det == 0.0 {
        return None;
    }
    let s = sub(ray.origin, triangle.a);
    let q = cross(s, e1);
    let hit = Hit { t: dot(e2, q) / det, u: dot(s, p) / det, v: dot(ray.direction, q) / det };
    let inside = hit.u >= -beyond && hit.v >= -beyond && hit.u + hit.v <= 1.0 + beyond;
    (inside && hit.t >= ray.t_min && hit.t <= ray.t_max).then_some(hit)
}

/// Right, and as slow as it says.
struct Slow;

impl OwnKernel for Slow {
    const NAME: &'static str = "slow";
    type Number = f64;
    type Record = Triangle<f64>;

    fn prepare(triangle: &Triangle<f64>) -> Triangle<f64> {
        *triangle
    }

    fn test(ray: &Ray<f64>, record: &Triangle<f64>) -> Option<Hit<f64>> {
        CLOCK.with_borrow(|clock| {
            let time = clock.as_ref().map(ScriptedClock::time);
            time.into_iter().for_each(|time| time.set(time.get() + TEST_NS));
        });
        test(ray, record, 0.0)
    }
}

/// Takes triangles for larger than they are, by so little that 500 pairs do not show it.
struct Wide;

impl OwnKernel for Wide {
    const NAME: &'static str = "wide";
    type Number = f64;
    type Record = Triangle<f64>;

    fn prepare(triangle: &Triangle<f64>) -> Triangle<f64> {
        *triangle
    }

    fn test(ray: &Ray<f64>, record: &Triangle<f64>) -> Option<Hit<f64>> {
        test(ray, record, 0.01)
    }
}

fn measured(entrants: &[Entrant], rounds: usize) -> Result<Outcome, OwnError> {
    let protocol = Protocol { rounds, guards: false, ..Protocol::new(Order::Fixed, 7) };
    let clock = ScriptedClock::new(READING_NS);
    CLOCK.set(Some(clock.clone()));
    let mut surroundings = Surroundings {
        clock: &mut clock.clone(),
        disturbance: &mut Undisturbed,
        counters: &mut NoCounters,
        forget: &mut Remember,
        ruler: &mut NoRuler,
        progress: &mut |_| {},
        cancel: &AtomicBool::new(false),
    };
    let outcome = contest(entrants, &protocol, &mut surroundings);
    CLOCK.set(None);
    outcome
}

/// But for the rounding of a logarithm and its inverse.
fn is_two(ratio: Ratio) -> bool {
    [ratio.low, ratio.estimate, ratio.high].iter().all(|end| (end / 2.0 - 1.0).abs() < 1e-12)
}

#[test]
fn times_are_those_of_the_clock_and_what_is_wrong_has_none() {
    let ours = Entrant::ours("moller-trumbore", Precision::F64).expect("there is one");
    let entrants = [Entrant::own::<Slow>(), Entrant::own::<Wide>(), ours];
    let outcome = measured(&entrants, 24).expect("it can be measured");
    let [slow, wide, ours] = &outcome.entries[..] else { panic!("three took part") };
    let slow = slow.figures.as_ref().expect("it is right");
    assert_eq!(slow.status, Status::Ok);
    // Its tests take as long as the reading of the clock that is the reference's whole block.
    let ratio = slow.ratio_to_reference.expect("there is a reference");
    assert!(is_two(ratio), "{ratio:?}");
    assert_eq!(slow.decision.map(|decision| decision.verdict), Some(Verdict::Slower));
    let ours = ours.figures.as_ref().and_then(|figures| figures.decision);
    assert_eq!(ours.map(|decision| decision.verdict), Some(Verdict::Same));
    let to_ours = outcome.ratio("slow/f64", &entrants[2].id).expect("both were timed");
    assert!(is_two(to_ours), "{to_ours:?}");
    assert!(wide.figures.is_none());
    assert!(wide.judgement.wrong.as_ref().is_some_and(|reason| reason.contains("a hit where")));
    let reason = wide.judgement.wrong.as_deref().unwrap_or_default();
    assert!(reason.starts_with("of 10000 other pairs, item "), "{reason}");
}

#[test]
fn tables_fit_a_terminal_and_say_what_was_found() {
    let entrants = [Entrant::own::<Slow>(), Entrant::own::<Wide>()];
    let text = outcome(&measured(&entrants, 24).expect("it can be measured"));
    let of = |name: &str| text.lines().find(|line| line.starts_with(name)).expect(name).to_owned();
    assert!(of("slow/f64").ends_with("2.000 (2.000 to 2.000)  slower"), "{text}");
    assert!(of("wide/f64").ends_with("wrong-result"), "{text}");
    assert!(
        text.contains("  of 10000 other pairs") && text.contains("24 rounds, 0 dropped"),
        "{text}"
    );
    let found = examine(&entrants, 20, 1).expect("it is drawn");
    let tables = text + &examinations(&found);
    assert!(tables.lines().all(|line| line.chars().count() <= 100), "{tables}");
    assert!(tables.contains("lost of edge rays") && tables.contains("needle"), "{tables}");
}

#[test]
fn an_examination_finds_what_is_wrong_and_nothing_else() {
    let ours = Entrant::ours("moller-trumbore", Precision::F64).expect("there is one");
    let entrants = [Entrant::own::<Slow>(), Entrant::own::<Wide>(), ours];
    let found = examine(&entrants, 200, 3).expect("it is drawn");
    let [slow, wide, ours] = &found[..] else { panic!("three were examined") };
    assert_eq!((&slow.pairs.wrong, &ours.pairs.wrong), (&None, &None));
    assert!(wide.pairs.wrong.is_some() && wide.pairs.accuracy.false_hits > 0);
    assert_eq!(wide.pairs.accuracy.false_misses, 0);
    // Triangles that overlap let nothing through, and are hit twice where they do.
    let doubled = |one: &Examination| one.meshes.iter().map(|mesh| mesh.doubled).sum::<u64>();
    let rays = |one: &Examination| one.meshes.iter().map(|mesh| mesh.rays).sum::<u64>();
    assert_eq!(rays(slow), rays(wide));
    assert!(doubled(wide) > doubled(slow), "{} {}", doubled(wide), doubled(slow));
    assert_eq!(slow.families.len(), ours.families.len());
    assert!(slow.families.iter().any(|family| family.knee.is_some()));
    // The same on every machine: the same again.
    assert_eq!(examine(&entrants, 200, 3).expect("again")[0].families, slow.families);
}

#[test]
fn entrants_that_cannot_take_part_are_refused_by_name() {
    let refused = |kernel| Entrant::ours(kernel, Precision::F32).map(|_| ()).expect_err(kernel);
    assert!(refused("wlad").to_string().contains("wlad: no kernel"));
    assert!(refused("wlad").to_string().contains("wald"));
    assert!(refused("chirkov").to_string().contains("chirkov"), "a test of segments");
    let many = vec![Entrant::own::<Slow>(); 13];
    assert!(measured(&many, 24).is_err_and(|error| error.to_string().contains("1 to 12")));
    assert!(matches!(measured(&[], 24), Err(OwnError::TooMany(0))));
    let twice = vec![Entrant::own::<Slow>(); 2];
    assert!(matches!(measured(&twice, 24), Err(OwnError::Protocol(_))));
}
