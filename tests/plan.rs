//! Plans for built-in scenes of different kinds, on a clock that has a time for every form: what may be
//! left out is, where that is no slower, and no answer changes.

use std::sync::atomic::AtomicBool;

use ray_test::experiment::{Bench, KeepNothing, Patience};
use ray_test::measure::{Clock, NoCounters, NoRuler, Remember, Undisturbed};
use ray_test::plan::{Asking, Found, Outcome, PIECES, Task, Use, Wanted};
use ray_test::scene::built_in::named;

/// ns of one test of each form, one triangle prepared, one ray through a structure.
type Price = fn(&str) -> f64;

/// A clock on which every test takes what its form's price is, up to a tenth of a per cent.
struct PricedClock {
    now: u64,
    price: Price,
    /// What passes after the next reading, if that begins a block of a round.
    block: Option<u64>,
    noise: u64,
}

/// Between two readings of which nothing is known: a block, so that calibrating ends at once.
const OTHERWISE_NS: u64 = 60_000;

impl PricedClock {
    fn new(price: Price) -> Self {
        PricedClock { now: 0, price, block: None, noise: 1 }
    }

    /// From 0.999 to 1.001, by a generator of Lehmer's kind.
    fn unsteady(&mut self) -> f64 {
        self.noise = self.noise * 48_271 % 2_147_483_647;
        0.999 + 0.002 * (self.noise as f64 / 2_147_483_647.0)
    }
}

impl Clock for PricedClock {
    fn now_ns(&mut self) -> u64 {
        let now = self.now;
        self.now += self.block.take().unwrap_or(OTHERWISE_NS);
        now
    }

    fn announce(&mut self, id: &str, tests: u64) {
        let ns = (self.price)(id) * tests as f64 * self.unsteady();
        self.block = Some(ns.round().max(1.0) as u64);
    }
}

/// By the operations that are left out, in the order of their costs on the machines that we know.
fn usual(id: &str) -> f64 {
    let kernel = id.split('/').next().unwrap_or_default();
    let test = match kernel {
        "chain" | "empty loop" => return 0.5,
        // Ways to the triangles: a ray through 32 of them, or through thousands.
        "list" | "box" => return 5_000.0,
        "surface" | "surface again" | "obvhs" => return 200.0,
        // What is stored, in words without a slash.
        _ if !id.contains('/') => return 15.0,
        "wald" | "perpendicular-planes" | "woop-affine" | "baldwin-weber" => 9.0,
        "moller-trumbore" => 10.0,
        "woop-watertight" | "embree-plucker" | "plucker" => 15.0,
        _ => 12.0,
    };
    let has = |word: &str| id.split('/').any(|part| part == word);
    let mut ns = test;
    ns -= if has("cull=on") { 2.0 } else { 0.0 };
    ns -= if has("projection=fixed") { 1.0 } else { 0.0 };
    ns -= if has("t") { 0.5 } else { 0.0 };
    ns -= if has("hit") { 0.8 } else { 0.0 };
    // Without t there is no division but in what divides first.
    ns -= if has("hit") && has("last") { 0.7 } else { 0.0 };
    ns -= if has("edges=no-fallback") { 1.0 } else { 0.0 };
    ns + if has("f64") { 2.0 } else { 0.0 }
}

/// As usual, but projecting along one axis for all is slower than along each triangle's own.
fn dear_projection(id: &str) -> f64 {
    usual(id) + if id.contains("projection=fixed") { 1.5 } else { 0.0 }
}

/// As usual, but tests that pass over back faces are slower.
fn dear_culling(id: &str) -> f64 {
    usual(id) + if id.contains("cull=on") { 3.0 } else { 0.0 }
}

/// Everything takes the same.
fn level(id: &str) -> f64 {
    if id.contains('/') { 10.0 } else { usual(id) }
}

/// As usual, but a list is faster than any hierarchy.
fn short_list(id: &str) -> f64 {
    if ["list", "box"].contains(&id) { 100.0 } else { usual(id) }
}

fn outcome(model: &str, usage: Option<Use>, price: Price, cancelled: bool) -> Outcome {
    let mesh = named(model).expect("a name").expect("a size");
    let triangles = mesh.list();
    let wanted = Wanted::of(None, usage, None);
    let asking = Asking { side: 24, seed: 1 };
    let task = Task::new(&mesh, &triangles, wanted, asking).expect("rays");
    let (rounds, blocks) = (16, task.blocks(16));
    let mut done = 0;
    let outcome = task.run(&mut Bench {
        rounds,
        calls: false,
        guards: false,
        patience: &mut Patience::NONE.clone(),
        clock: &mut PricedClock::new(price),
        disturbance: &mut Undisturbed,
        counters: &mut NoCounters,
        forget: &mut Remember,
        ruler: &mut NoRuler,
        progress: &mut |blocks| done += blocks,
        cancel: &AtomicBool::new(cancelled),
        keep: &mut KeepNothing,
    });
    // What was announced is no less than what was done, and of its order.
    assert!(done <= blocks && (cancelled || 4 * done > blocks), "{done} of {blocks}");
    outcome.expect("groups that can be measured")
}

/// The plan; whatever it is, no answer changed, and it is not slower than the default.
fn found(model: &str, usage: Option<Use>, price: Price) -> Found {
    let found = outcome(model, usage, price, false).found.expect("a plan");
    assert_eq!(found.report.answers.disagree, 0, "{model}");
    let beside = found.settled.beside_default;
    assert_eq!(beside.is_none(), found.report.plan.variant == found.default, "{model}");
    assert!(beside.is_none_or(|saving| !saving.is_loss()), "{model}: {beside:?}");
    found
}

/// Percent that leaving a piece out saves; `None` where it stays.
fn saves(found: &Found, piece: &str) -> Option<f64> {
    let plan = &found.report.plan;
    let gone = plan.left_out.iter().find(|one| one.piece == piece);
    let stays = plan.kept.iter().any(|one| one.piece == piece);
    assert_ne!(gone.is_some(), stays, "{piece}");
    gone.map(|one| one.saves_percent)
}

fn leaves_out(found: &Found, piece: &str) -> bool {
    saves(found, piece).is_some()
}

/// What is said of a piece, left out or kept.
fn said_of(found: &Found, piece: &str) -> String {
    let plan = &found.report.plan;
    let gone = plan.left_out.iter().map(|one| (one.piece, &one.because));
    let mut all = gone.chain(plan.kept.iter().map(|one| (one.piece, &one.because)));
    all.find(|(name, _)| *name == piece).expect("a piece").1.clone()
}

/// Whether a piece saves so many per cent of the time with it, as prices have it.
fn saves_about(found: &Found, piece: &str, with: f64, without: f64) -> bool {
    let percent = 100.0 * (1.0 - without / with);
    // Each block is up to 0.1 % off its price, and so is the reference.
    saves(found, piece).is_some_and(|saves| (saves - percent).abs() < 0.3)
}

#[test]
fn a_ball_from_outside_leaves_out_back_faces() {
    let ball = found("icosphere:2", None, usual);
    assert_eq!((ball.report.answers.rays, ball.report.answers.agree), (576, 576));
    assert!(ball.report.plan.variant.ends_with("/cull=on"), "{}", ball.report.plan.variant);
    assert!(saves_about(&ball, "two-sidedness", 10.0, 8.0), "{:?}", ball.report.plan.left_out);
    assert!(!leaves_out(&ball, "u and v") && !leaves_out(&ball, "hierarchy"));
    assert!(leaves_out(&ball, "f64") && leaves_out(&ball, "epsilon"));
    assert_eq!(PIECES.len(), ball.report.plan.left_out.len() + ball.report.plan.kept.len());
}

#[test]
fn back_faces_stay_where_passing_over_them_is_slower() {
    let ball = found("icosphere:2", None, dear_culling);
    assert!(!ball.report.plan.variant.contains("cull"), "{}", ball.report.plan.variant);
    assert!(!leaves_out(&ball, "two-sidedness"));
    let said = said_of(&ball, "two-sidedness");
    assert!(said.contains("two triangles that face one side") && said.contains("slower"), "{said}");
}

#[test]
fn a_terrain_takes_one_projection() {
    let terrain = found("terrain:16", None, usual);
    let variant = &terrain.report.plan.variant;
    assert!(variant.ends_with("/projection=fixed"), "{variant}");
    assert!(
        saves_about(&terrain, "general plane", 9.0, 8.0),
        "{}",
        said_of(&terrain, "general plane")
    );
    assert!(!leaves_out(&terrain, "two-sidedness"));
    // It is as much faster than the default as prices say: preparing is spread over a picture's rays.
    let beside = terrain.settled.beside_default.expect("it is not the default");
    assert!((beside.percent() - 20.0).abs() < 0.5, "{}", beside.words());
}

#[test]
fn a_terrain_does_not_take_one_projection_that_is_slower() {
    let terrain = found("terrain:16", None, dear_projection);
    let variant = &terrain.report.plan.variant;
    assert!(!variant.contains("projection=fixed"), "{variant}");
    assert!(!leaves_out(&terrain, "general plane"));
    let said = said_of(&terrain, "general plane");
    assert!(
        said.contains("no triangle is a line seen along z") && said.contains("slower"),
        "{said}"
    );
    // What is left is the fastest of those that do what is needed.
    assert!((terrain.settled.beside_default.expect("it is not").percent() - 10.0).abs() < 0.5);
}

#[test]
fn shadow_rays_leave_out_weights_and_division() {
    let shadow = found("terrain:16", Some(Use::Shadow), usual);
    assert!(shadow.report.plan.variant.contains("/last/plain/hit"));
    assert!(saves_about(&shadow, "u and v", 10.0, 9.5), "{}", said_of(&shadow, "u and v"));
    assert!(saves_about(&shadow, "division", 9.2, 8.5), "{}", said_of(&shadow, "division"));
}

#[test]
fn few_rays_leave_out_precomputation() {
    let collision = found("terrain:16", Some(Use::Collision), usual);
    let said = said_of(&collision, "precomputation");
    assert!(saves(&collision, "precomputation").is_some_and(|saves| saves > 10.0), "{said}");
    assert!(said.contains("pays from"), "{said}");
    assert!(!leaves_out(&collision, "division"));
    // The same mesh under a picture's rays prepares.
    let picture = found("terrain:16", None, usual);
    assert!(!leaves_out(&picture, "precomputation"));
}

#[test]
fn a_room_far_off_is_translated() {
    let room = found("room-far:1", None, usual);
    assert!(!leaves_out(&room, "translation") && !leaves_out(&room, "two-sidedness"));
    let planes =
        ["wald", "shevtsov", "badouel", "perpendicular", "baldwin", "woop-affine", "plucker"];
    let variant = &room.report.plan.variant;
    assert!(!planes.iter().any(|kernel| variant.starts_with(kernel)), "{variant}");
}

#[test]
fn a_box_of_few_triangles_needs_no_hierarchy() {
    let small = found("cornell-box:1", None, short_list);
    assert!(saves_about(&small, "hierarchy", 200.0, 100.0), "{}", said_of(&small, "hierarchy"));
    assert!(["list", "box"].contains(&small.structure.as_str()), "{}", small.structure);
    let large = found("cornell-box:1", None, usual);
    assert!(!leaves_out(&large, "hierarchy") && !leaves_out(&large, "bounding volume"));
    assert!(["surface", "obvhs"].contains(&large.structure.as_str()), "{}", large.structure);
}

#[test]
fn what_cannot_be_told_apart_does_as_little_as_it_may() {
    let ball = found("icosphere:2", None, level);
    assert!(ball.report.plan.variant.ends_with("/cull=on"), "{}", ball.report.plan.variant);
    assert_eq!(saves(&ball, "two-sidedness"), Some(0.0));
    // Nothing is gained by preparing, and so nothing is prepared.
    let terrain = found("terrain:16", None, level);
    assert_eq!(saves(&terrain, "precomputation"), Some(0.0));
    assert!(terrain.settled.beside_default.is_none_or(|saving| saving.is_noise()));
}

#[test]
fn rows_are_of_the_scene_and_an_interrupted_run_has_no_plan() {
    let done = outcome("icosphere:1", None, usual, false);
    assert!(!done.rows.is_empty());
    for row in &done.rows {
        assert!(row.experiment == "scene" && row.workload.starts_with("scene"), "{}", row.workload);
    }
    assert!(outcome("icosphere:1", None, usual, true).found.is_none());
}
