//! Plans over answers of real kernels and times that are made up.

use super::evidence::Saving;
use super::form::{Form, Output, translates};
use super::nearby::Nearby;
use super::piece::Look;
use super::pieces::PIECES;
use super::proof::{Answers, Exactly, Standing};
use super::rays::{Asking, draw};
use super::settle::{Entry, Finals, Looked, Settled, settle};
use super::usage::Wanted;
use crate::accuracy::Reported;
use crate::job::Answer;
use crate::kernels::{Fixed, MollerTrumbore, Wald};
use crate::policy::{
    Between, Compare, Cull, Distance, Early, Form as Compiled, Inside, Last, Plain, Tuv, TwoSided,
};
use crate::scene::built_in::named;
use crate::scene::mesh::Mesh;
use crate::structure::{KernelLeaf, Leaf, List, Search};
use crate::workload::{Ray, Triangle};
use glam::Vec3;

type Usual = Compiled<Early, Last, Plain, Tuv, TwoSided, Compare, Inside, Between>;
type Culling = Compiled<Early, Last, Plain, Tuv, Cull, Compare, Inside, Between>;
type Planar = Compiled<Early, Last, Plain, Tuv, TwoSided, Compare, Distance, Between>;

/// Four forms of two kernels.
const FORMS: [&str; 4] = ["usual", "culling", "wald", "fixed"];

fn form(id: &str) -> Form {
    let kernel = if ["wald", "fixed"].contains(&id) { "wald" } else { "moller-trumbore" };
    Form {
        id: id.into(),
        kernel: kernel.into(),
        in_f64: false,
        output: Output::Tuv,
        divides_last: true,
        culls: id == "culling",
        projects_along_z: id == "fixed",
        prepares: kernel == "wald",
        watertight: false,
        falls_back: false,
        translates: translates(kernel),
    }
}

/// What a form answers, by the kernel itself.
fn answers(id: &str, rays: &[Ray], triangles: &[Triangle]) -> Vec<Answer> {
    let leaf: Box<dyn Leaf> = match id {
        "culling" => Box::new(KernelLeaf::<MollerTrumbore, Culling>::new(triangles, false)),
        "wald" => Box::new(KernelLeaf::<Wald, Planar>::new(triangles, false)),
        "fixed" => Box::new(KernelLeaf::<Wald<Fixed<2>>, Planar>::new(triangles, false)),
        _ => Box::new(KernelLeaf::<MollerTrumbore, Usual>::new(triangles, false)),
    };
    let list = List::new(triangles.len() as u32);
    let mut search = Search::new(leaf);
    let mut one = |ray: &Ray| {
        search.nearest(&list, ray).map_or_else(Answer::default, |hit| Answer {
            triangle: Some(hit.triangle as usize),
            t: hit.t.into(),
            u: hit.u.into(),
            v: hit.v.into(),
            ..Answer::default()
        })
    };
    rays.iter().map(&mut one).collect()
}

const REPORTED: Reported =
    Reported { unit_roundoff: 1.0 / 16_777_216.0, t: true, uv: true, surface: false, culls: false };

/// A mesh, some rays of a camera, and the exact answers.
struct Stage {
    rays: Vec<Ray>,
    triangles: Vec<Triangle>,
}

impl Stage {
    fn of(mesh: &Mesh) -> Self {
        let crowd =
            draw(&Wanted::of(None, None, None), mesh, Asking { side: 24, seed: 1 }, |_| None)
                .expect("rays");
        let rays = crowd.rays;
        Stage { rays, triangles: mesh.list() }
    }

    /// Settles, with the pieces in `spare` taken for spare, whatever the mesh is like.
    fn settle(&self, spare: &[&str], ns: [f64; 4]) -> Settled {
        let mut nearby = Nearby::new(&self.triangles);
        let nearest = self.rays.iter().map(|ray| nearby.nearest(ray)).collect();
        let exactly = Exactly { rays: &self.rays, triangles: &self.triangles, nearest };
        let standing = |id: &str| -> Standing {
            exactly.judge(&answers(id, &self.rays, &self.triangles), REPORTED)
        };
        let usual = standing("usual");
        let look = |name: &str| {
            let is_spare = spare.contains(&name);
            if is_spare { Look::Spare("said so".into()) } else { Look::Needed("said so".into()) }
        };
        let mut looked: Vec<Looked<'_>> = PIECES
            .iter()
            .map(|piece| Looked { piece, look: look(piece.name), saving: None, back: None })
            .collect();
        let mut prove = |form: &Form| -> Answers { standing(&form.id).beside(&usual) };
        settle(&mut looked, &finals(ns), usual.agree(), &mut prove)
    }
}

fn finals(ns: [f64; 4]) -> Finals {
    let rounds = [1.0, 1.001, 0.999, 1.0, 1.002, 0.998, 1.0, 1.0];
    let entry = |(id, ns): (&str, f64)| Entry {
        form: form(id),
        times: rounds.iter().map(|slow| slow * ns).collect(),
        again: None,
    };
    Finals { entries: FORMS.into_iter().zip(ns).map(entry).collect(), default: 0, floor: 0.01 }
}

fn mesh(model: &str) -> Mesh {
    named(model).expect("a name").expect("a size")
}

fn kept<'a>(settled: &'a Settled, piece: &str) -> Option<&'a str> {
    let kept = settled.plan.kept.iter().find(|one| one.piece == piece);
    kept.map(|one| one.because.as_str())
}

fn left_out(settled: &Settled) -> Vec<&'static str> {
    settled.plan.left_out.iter().map(|one| one.piece).collect()
}

/// What every one of the four forms does without, and what Wald's does.
const ALWAYS: [&str; 3] = ["f64", "watertightness", "fallback"];

#[test]
fn a_closed_mesh_leaves_back_faces_out_and_one_turned_triangle_brings_them_back() {
    let ns = [10.0, 8.0, 20.0, 20.0];
    let spare = [&ALWAYS[..], &["two-sidedness", "precomputation"]].concat();
    let mut ball = mesh("icosphere:2");
    let settled = Stage::of(&ball).settle(&spare, ns);
    assert_eq!(settled.plan.variant, "culling");
    assert!(left_out(&settled).contains(&"two-sidedness"));
    assert_eq!(settled.answers.disagree, 0);
    assert_eq!(settled.answers.agree, settled.answers.rays);
    let saving = settled.beside_default.expect("it is not the default");
    assert!((saving.percent() - 20.0).abs() < 1e-6);

    // A triangle that rays see first. The look is not asked: the proof sees it alone.
    let stage = Stage::of(&ball);
    let first = stage.rays.iter().find_map(|ray| Nearby::new(&stage.triangles).nearest(ray));
    let (turned, _) = first.expect("rays meet the ball");
    ball.triangles[turned].swap(0, 1);
    let settled = Stage::of(&ball).settle(&spare, ns);
    assert_eq!(settled.plan.variant, "usual");
    let because = kept(&settled, "two-sidedness").expect("it is back");
    assert!(because.contains("worse answer"), "{because}");
    assert_eq!((settled.answers.disagree, settled.beside_default), (0, None));
}

#[test]
fn a_terrain_takes_one_projection_and_one_upright_triangle_brings_the_plane_back() {
    let ns = [10.0, 9.9, 8.0, 6.0];
    let spare = [&ALWAYS[..], &["general plane", "translation"]].concat();
    let mut terrain = mesh("terrain:8");
    let settled = Stage::of(&terrain).settle(&spare, ns);
    assert_eq!(settled.plan.variant, "fixed");
    assert_eq!(settled.answers.disagree, 0);

    // A wall across the view, from below the terrain to far above it.
    let first = terrain.vertices.len() as u32;
    let corners = [[-1.0, -0.5, -1.0], [1.0, -0.5, -1.0], [0.0, -0.5, 4.0]];
    terrain.vertices.extend(corners.map(Vec3::from));
    terrain.triangles.push([first, first + 1, first + 2]);
    let settled = Stage::of(&terrain).settle(&spare, ns);
    // The other piece that it leaves out is not to blame.
    assert_eq!(settled.plan.variant, "wald");
    assert!(kept(&settled, "general plane").is_some_and(|text| text.contains("worse answer")));
    assert!(left_out(&settled).contains(&"translation"));
    assert_eq!(settled.answers.disagree, 0);
}

#[test]
fn a_plan_is_never_slower_than_the_default() {
    let spare = [&ALWAYS[..], &["two-sidedness", "precomputation", "translation"]].concat();
    let stage = Stage::of(&mesh("icosphere:1"));
    let settled = stage.settle(&spare, [10.0, 11.0, 12.0, 13.0]);
    assert_eq!((settled.plan.variant.as_str(), settled.beside_default), ("usual", None));
    let because = kept(&settled, "two-sidedness").expect("it stays");
    assert!(because.contains("culling") && because.contains("slower"), "{because}");
    // What noise cannot tell apart does as little as it may.
    let settled = stage.settle(&spare, [10.0, 10.02, 12.0, 13.0]);
    assert_eq!(settled.plan.variant, "culling");
    assert!(settled.beside_default.is_some_and(|saving| saving.is_noise()));
}

#[test]
fn a_plan_that_is_slower_once_more_makes_way() {
    let times = |ns: f64| [ns, 1.001 * ns, 0.999 * ns, ns, 1.002 * ns, 0.998 * ns, ns, ns];
    let again = |ns: f64| Saving::of(&times(ns), &times(10.0), 0.01);
    let look = |piece| Looked { piece, look: Look::Spare("so".into()), saving: None, back: None };
    let settled = |finals: &Finals| {
        let mut looked: Vec<Looked<'_>> = PIECES.iter().map(look).collect();
        let mut prove = |_: &Form| Answers { rays: 5, agree: 5, disagree: 0 };
        settle(&mut looked, finals, 5, &mut prove)
    };
    let before = finals([10.0, 9.0, 20.0, 8.0]);
    let mut finals = before.clone();
    let first = settled(&finals).plan.variant;
    assert!(finals.is_unconfirmed(&first) && !finals.is_unconfirmed("usual"));
    finals.confirm(&first, again(8.5));
    let confirmed = settled(&finals);
    assert_eq!(confirmed.plan.variant, first);
    let saving = confirmed.beside_default.expect("it is not the default");
    assert!((saving.percent() - 15.0).abs() < 1e-6, "the later times count: {}", saving.words());
    assert!(!finals.is_unconfirmed(&first));
    finals.confirm(&first, again(10.5));
    let second = settled(&finals).plan.variant;
    assert!(second != first && second != "usual" && finals.is_unconfirmed(&second), "{second}");
    finals.confirm(&second, again(10.5));
    assert_eq!(settled(&finals).plan.variant, "usual");
    // Without enough rounds the finals' own times stand.
    let mut finals = before;
    finals.confirm(&first, None);
    let unconfirmed = settled(&finals);
    assert_eq!(unconfirmed.plan.variant, first);
    assert!(!finals.is_unconfirmed(&first));
    assert!((unconfirmed.beside_default.expect("as before").percent() - 20.0).abs() < 1e-6);
}

#[test]
fn what_does_less_is_taken_and_what_is_faster_is_told() {
    let spare = [&ALWAYS[..], &["two-sidedness", "precomputation", "translation"]].concat();
    let stage = Stage::of(&mesh("icosphere:1"));
    let settled = stage.settle(&spare, [10.0, 9.0, 7.0, 20.0]);
    assert_eq!(settled.plan.variant, "culling");
    let (faster, saving) = settled.faster.expect("there is one");
    assert!(faster == "wald" && saving.percent() > 20.0);
    // One that does too little is no match.
    let settled = stage.settle(&spare, [10.0, 9.0, 20.0, 1.0]);
    assert_eq!((settled.plan.variant.as_str(), settled.faster), ("culling", None));
}

#[test]
fn what_is_needed_is_done_however_fast_others_are() {
    let stage = Stage::of(&mesh("icosphere:1"));
    let settled = stage.settle(&ALWAYS, [10.0, 1.0, 20.0, 20.0]);
    assert_eq!(settled.plan.variant, "usual");
    assert_eq!(kept(&settled, "two-sidedness"), Some("said so"));
    let places = left_out(&settled).len() + settled.plan.kept.len();
    assert_eq!(places, PIECES.len());
}

#[test]
fn savings_are_those_of_the_pair() {
    let one = Saving::of(&[8.0; 8], &[10.0; 8], 0.01).expect("eight rounds");
    let piece = &PIECES[0];
    let look = Look::Spare("it is closed".into());
    let mut looked = [Looked { piece, look, saving: Some(one), back: None }];
    let mut prove = |_: &Form| Answers { rays: 5, agree: 5, disagree: 0 };
    let settled = settle(&mut looked, &finals([10.0, 8.0, 20.0, 20.0]), 5, &mut prove);
    let gone = &settled.plan.left_out[0];
    assert!((gone.saves_percent - 20.0).abs() < 1e-9);
    assert!(gone.because.starts_with("it is closed; saves 20.0 %"), "{}", gone.because);
}

#[test]
fn two_triangles_at_one_distance_are_one_as_good_as_the_other() {
    let corners = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::new(1.0, 1.0, 0.0)];
    let triangles = [
        Triangle { a: corners[0], b: corners[1], c: corners[2] },
        Triangle { a: corners[1], b: corners[3], c: corners[2] },
    ];
    let origin = Vec3::new(0.5, 0.5, 1.0);
    let direction = -Vec3::Z;
    let ray = Ray { origin, direction, end: origin - Vec3::Z * 2.0, t_min: 0.0, t_max: f32::MAX };
    let rays = [ray];
    let nearest = vec![Nearby::new(&triangles).nearest(&ray)];
    let exactly = Exactly { rays: &rays, triangles: &triangles, nearest };
    let answer = |triangle: Option<usize>, u: f64| {
        let one = Answer { triangle, t: 1.0, u, v: 0.5, ..Answer::default() };
        exactly.judge(&[one], REPORTED)
    };
    // The shared edge belongs to both; outputs are those of the one that was found.
    assert!(answer(Some(0), 0.5).right[0] && answer(Some(1), 0.0).right[0]);
    assert!(!answer(Some(1), 0.5).right[0]);
    // Rounding may lose a ray on an edge: no wrong answer, but the ray is gone.
    let nothing = answer(None, 0.0);
    assert_eq!((nothing.right[0], nothing.lost.as_slice()), (true, &[0][..]));
    assert!(super::proof::has_ties(&ray, &triangles, REPORTED));
    let aside = Ray { origin: Vec3::new(0.25, 0.25, 1.0), ..ray };
    assert!(!super::proof::has_ties(&aside, &triangles, REPORTED));
}
