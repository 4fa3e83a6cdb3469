//! Scenes of different kinds, and each with the one thing that changes what may be left out.

use crate::plan::evidence::Saving;
use crate::plan::form::Output;
use crate::plan::nearby::Nearby;
use crate::plan::piece::Look;
use crate::plan::pieces::PIECES;
use crate::plan::rays::{Asking, draw};
use crate::plan::situation::{Crowding, Paths, Pilot, Preparing, Situation};
use crate::plan::usage::{Use, Wanted};
use crate::scene::built_in::named;
use crate::scene::look::Looks;
use crate::scene::mesh::Mesh;
use crate::scene::rays::Asked;
use crate::stats::Ratio;
use crate::workload::Ray;
use glam::Vec3;

fn mesh(model: &str) -> Mesh {
    named(model).expect("a name").expect("a size")
}

/// A mesh with its rays, nothing measured.
fn situation(mesh: &Mesh, wanted: Wanted) -> Situation {
    let list = mesh.list();
    let mut nearby = Nearby::new(&list);
    let mut nearest = |ray: &Ray| nearby.nearest(ray).map(|(index, _)| index as u32);
    let crowd =
        draw(&wanted, mesh, Asking { side: 24, seed: 1 }, &mut nearest).expect("there are rays");
    let looks = Looks::of(mesh).with_rays(mesh, &crowd.rays, &mut nearest);
    let rays = crowd.rays.len() as u64;
    Situation {
        looks,
        wanted,
        crowd: Crowding {
            rays,
            in_use: crowd.in_use,
            triangles: list.len() as u64,
            tests_per_ray: 4.0,
        },
        pilot: Pilot { rays, leaks: 0, too_coarse: 0 },
        paths: None,
        preparing: None,
    }
}

fn pictured(mesh: &Mesh) -> Situation {
    situation(mesh, Wanted::of(None, None, None))
}

fn look(situation: &Situation, piece: &str) -> Look {
    let piece = PIECES.iter().find(|one| one.name == piece).expect("a piece");
    (piece.look)(situation)
}

/// Time without over time with, beyond doubt.
fn saving(ratio: f64) -> Saving {
    Saving { ratio: Ratio { estimate: ratio, low: 0.99 * ratio, high: 1.01 * ratio }, floor: 0.01 }
}

#[test]
fn names_are_unique_and_reasons_have_numbers() {
    let situation = pictured(&mesh("icosphere:2"));
    for (place, piece) in PIECES.iter().enumerate() {
        assert!(PIECES[..place].iter().all(|other| other.name != piece.name), "{}", piece.name);
        assert!(!(piece.look)(&situation).because().is_empty(), "{}", piece.name);
    }
}

#[test]
fn one_turned_triangle_brings_two_sidedness_back() {
    let closed = mesh("icosphere:2");
    assert!(look(&pictured(&closed), "two-sidedness").is_spare());
    let mut turned = closed.clone();
    turned.triangles[7].swap(0, 1);
    let seen = look(&pictured(&turned), "two-sidedness");
    assert!(!seen.is_spare() && seen.because().contains("3 edges"), "{seen:?}");
    let mut open = closed.clone();
    open.triangles.pop();
    let seen = look(&pictured(&open), "two-sidedness");
    assert!(!seen.is_spare() && seen.because().contains("3 edges"), "{seen:?}");
    // Rays that start on its surface are inside its box.
    let shadow = situation(&closed, Wanted::of(None, Some(Use::Shadow), None));
    assert!(!look(&shadow, "two-sidedness").is_spare());
    // A room is closed, too, and faces inwards.
    assert!(!look(&pictured(&mesh("room-far")), "two-sidedness").is_spare());
}

#[test]
fn one_upright_triangle_brings_the_general_plane_back() {
    let mut terrain = mesh("terrain:8");
    assert!(look(&pictured(&terrain), "general plane").is_spare());
    let first = terrain.vertices.len() as u32;
    let corners = [[0.0, 0.0, 0.0], [0.5, 0.25, 0.0], [0.25, 0.125, 0.5]];
    terrain.vertices.extend(corners.map(Vec3::from));
    terrain.triangles.push([first, first + 1, first + 2]);
    let seen = look(&pictured(&terrain), "general plane");
    assert!(!seen.is_spare() && seen.because().contains(" 1 triangles are lines"), "{seen:?}");
    // One that is not quite upright loses nearly all digits.
    terrain.vertices[first as usize + 2].y += 1e-3;
    assert!(!look(&pictured(&terrain), "general plane").is_spare());
    assert!(!look(&pictured(&mesh("icosphere:3")), "general plane").is_spare());
}

#[test]
fn what_lies_far_off_is_translated() {
    let far = look(&pictured(&mesh("room-far")), "translation");
    assert!(!far.is_spare() && far.because().contains("bits"), "{far:?}");
    for model in ["icosphere:2", "terrain:8", "cornell-box"] {
        assert!(matches!(look(&pictured(&mesh(model)), "translation"), Look::Open(_)), "{model}");
    }
}

#[test]
fn shadow_rays_need_no_weights_and_no_division() {
    let terrain = mesh("terrain:8");
    let shadow = situation(&terrain, Wanted::of(None, Some(Use::Shadow), None));
    let picture = pictured(&terrain);
    for piece in ["u and v", "division"] {
        assert!(look(&shadow, piece).is_spare() && !look(&picture, piece).is_spare(), "{piece}");
    }
    let collision = situation(&terrain, Wanted::of(None, Some(Use::Collision), None));
    assert!(look(&collision, "u and v").is_spare());
    assert!(!look(&collision, "division").is_spare());
    // They end at the light.
    assert!(look(&shadow, "t range").because().contains("end"));
    let asked = Wanted::of(Some(Output::Tuv), None, Some(Asked::Shadow));
    assert!(!look(&situation(&terrain, asked), "u and v").is_spare());
}

#[test]
fn few_rays_prepare_nothing() {
    let mut situation = pictured(&mesh("icosphere:2"));
    let preparing = |pays_from: Option<f64>| {
        let with = "wald".to_owned();
        Some(Preparing { with, prepare_ns: 12.0, pays_from, saving: Some(saving(0.7)) })
    };
    situation.preparing = preparing(Some(5.0));
    // The rays of a picture, 4 tests each, 320 triangles.
    assert_eq!(situation.crowd.tests_per_triangle(), 1920.0 * 1080.0 * 4.0 / 320.0);
    assert!(matches!(look(&situation, "precomputation"), Look::Open(_)));
    situation.crowd.in_use = 64;
    let few = look(&situation, "precomputation");
    assert!(few.is_spare() && few.because().contains("0.8 tests"), "{few:?}");
    assert!(matches!(few, Look::Measured(_, saved) if saved.percent() > 25.0));
    situation.crowd.in_use = u64::MAX;
    situation.preparing = preparing(None);
    assert!(look(&situation, "precomputation").is_spare());
}

#[test]
fn where_a_list_is_no_slower_there_is_no_hierarchy() {
    let mut situation = pictured(&mesh("cornell-box"));
    let paths = |list: Option<f64>, without_box: f64| {
        Some(Paths {
            hierarchy: "surface".into(),
            tests_in_hierarchy: 5.0,
            list: list.map(saving),
            without_box: Some(saving(without_box)),
        })
    };
    situation.paths = paths(Some(0.6), 0.9);
    for piece in ["hierarchy", "bounding volume"] {
        assert!(look(&situation, piece).is_spare(), "{piece}");
    }
    // All rays miss, say: the box pays.
    situation.paths = paths(Some(0.6), 1.5);
    assert!(look(&situation, "hierarchy").is_spare());
    assert!(!look(&situation, "bounding volume").is_spare());
    for list in [Some(30.0), None] {
        situation.paths = paths(list, 0.9);
        for piece in ["hierarchy", "bounding volume"] {
            assert!(!look(&situation, piece).is_spare(), "{piece} {list:?}");
        }
    }
}

#[test]
fn what_f32_and_open_edges_get_wrong_is_asked_for() {
    let mut situation = pictured(&mesh("icosphere:2"));
    for piece in ["f64", "watertightness"] {
        assert!(look(&situation, piece).is_spare(), "{piece}");
    }
    situation.pilot.leaks = 2;
    situation.pilot.too_coarse = 1;
    for piece in ["f64", "watertightness"] {
        assert!(!look(&situation, piece).is_spare(), "{piece}");
    }
    // Triangles that share nothing have nothing to leak.
    let soup = Situation { pilot: situation.pilot, ..pictured(&mesh("soup")) };
    assert!(look(&soup, "watertightness").is_spare());
}

#[test]
fn triangles_without_area_are_told() {
    let mut ball = mesh("icosphere:1");
    assert!(look(&pictured(&ball), "degenerate triangles").is_spare());
    ball.triangles.push([0, 1, 1]);
    let seen = look(&pictured(&ball), "degenerate triangles");
    assert!(!seen.is_spare() && seen.because().starts_with("1 of 81 "), "{seen:?}");
}
