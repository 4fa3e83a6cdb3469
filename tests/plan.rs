//! Plans for built-in scenes, on a clock that cannot tell one form from another: what may be left out is,
//! and no answer changes.

use std::sync::atomic::AtomicBool;

use ray_test::experiment::{Bench, KeepNothing};
use ray_test::measure::{NoCounters, NoRuler, Remember, ScriptedClock, Undisturbed};
use ray_test::plan::{Asking, Found, Outcome, Task, Use, Wanted};
use ray_test::scene::built_in::named;

/// Every reading of the clock is as long after the one before.
fn outcome(model: &str, usage: Option<Use>, cancelled: bool) -> Outcome {
    let mesh = named(model).expect("a name").expect("a size");
    let triangles = mesh.list();
    let wanted = Wanted::of(None, usage, None);
    let asking = Asking { side: 24, seed: 1 };
    let task = Task::new(&mesh, &triangles, wanted, asking).expect("rays");
    let mut bench = Bench {
        rounds: 16,
        calls: false,
        guards: false,
        patience: 0,
        clock: &mut ScriptedClock::new(60_000),
        disturbance: &mut Undisturbed,
        counters: &mut NoCounters,
        forget: &mut Remember,
        ruler: &mut NoRuler,
        progress: &mut |_| {},
        cancel: &AtomicBool::new(cancelled),
        keep: &mut KeepNothing,
    };
    task.run(&mut bench).expect("groups that can be measured")
}

fn found(model: &str, usage: Option<Use>) -> Found {
    outcome(model, usage, false).found.expect("a plan")
}

fn leaves_out(found: &Found, piece: &str) -> bool {
    let plan = &found.report.plan;
    let gone = plan.left_out.iter().any(|one| one.piece == piece);
    assert_ne!(gone, plan.kept.iter().any(|one| one.piece == piece), "{piece}");
    gone
}

#[test]
fn a_ball_from_outside_leaves_out_back_faces() {
    let ball = found("icosphere:2", None);
    assert!(leaves_out(&ball, "two-sidedness") && !leaves_out(&ball, "u and v"));
    assert!(ball.report.plan.variant.ends_with("/cull=on"), "{}", ball.report.plan.variant);
    assert!(leaves_out(&ball, "f64") && leaves_out(&ball, "epsilon"));
    let answers = ball.report.answers;
    assert_eq!((answers.rays, answers.agree, answers.disagree), (576, 576, 0));
}

/// What is said of a piece, left out or kept.
fn said_of(found: &Found, piece: &str) -> String {
    let plan = &found.report.plan;
    let gone = plan.left_out.iter().map(|one| (one.piece, &one.because));
    let mut all = gone.chain(plan.kept.iter().map(|one| (one.piece, &one.because)));
    all.find(|(name, _)| *name == piece).expect("a piece").1.clone()
}

/// Whether the fixed projection is taken is for a clock to say, and this one cannot.
#[test]
fn a_terrain_may_take_one_projection() {
    let terrain = found("terrain:16", None);
    let said = said_of(&terrain, "general plane");
    assert!(said.contains("no triangle is a line seen along z"), "{said}");
    assert!(said.contains("projection=fixed") || leaves_out(&terrain, "general plane"), "{said}");
    assert!(!leaves_out(&terrain, "two-sidedness"));
    assert_eq!(terrain.report.answers.disagree, 0);
}

#[test]
fn shadow_rays_and_few_rays_leave_out_what_they_do_not_need() {
    let shadow = found("terrain:16", Some(Use::Shadow));
    assert!(leaves_out(&shadow, "u and v") && leaves_out(&shadow, "division"));
    assert!(shadow.report.plan.variant.contains("/last/plain/hit"));
    let collision = found("terrain:16", Some(Use::Collision));
    assert!(leaves_out(&collision, "precomputation") && !leaves_out(&collision, "division"));
    assert_eq!(collision.report.answers.disagree, 0);
}

#[test]
fn a_room_far_off_is_translated() {
    let room = found("room-far:1", None);
    assert!(!leaves_out(&room, "translation") && !leaves_out(&room, "two-sidedness"));
    let planes =
        ["wald", "shevtsov", "badouel", "perpendicular", "baldwin", "woop-affine", "plucker"];
    let variant = &room.report.plan.variant;
    assert!(!planes.iter().any(|kernel| variant.starts_with(kernel)), "{variant}");
}

#[test]
fn rows_are_of_the_scene_and_an_interrupted_run_has_no_plan() {
    let done = outcome("icosphere:1", None, false);
    assert!(!done.rows.is_empty());
    for row in &done.rows {
        assert!(row.experiment == "scene" && row.workload.starts_with("scene"), "{}", row.workload);
    }
    assert!(outcome("icosphere:1", None, true).found.is_none());
}
