//! Colours computed by hand.

use super::*;
use glam::DVec3;

/// What `terrain` is made of, and the light that comes from everywhere.
const GRASS: DVec3 = DVec3::new(0.40, 0.50, 0.25);
const AMBIENT: f64 = 0.12;
/// The light of the view, and the other.
const STRENGTHS: [f64; 2] = [0.65, 0.35];

fn assert_shows(pixel: DVec3, light: DVec3) {
    let shown = pixel * pixel;
    assert!((shown - light).abs().max_element() < 1e-6, "{shown} where {light} is expected");
}

#[test]
fn a_surface_across_the_sight_has_all_light_and_the_rest_is_sky() {
    let stage = Stage::new(&mesh(&[facing(0.0, 1.0)]), [3, 3]);
    let frame = picture(&stage, right(), FULL);
    let pixels = frame.picture.pixels();
    assert_shows(pixels[4], GRASS * (AMBIENT + STRENGTHS[0] + STRENGTHS[1]));
    // Through a corner: the sight's angle is 2 atan(1/2), a third of a side is a pixel.
    let up = (1.0 / 3.0) / (1.0 + 2.0 * (1.0 / 3.0f64).powi(2)).sqrt();
    let sky = DVec3::new(0.90, 0.90, 0.88).lerp(DVec3::new(0.55, 0.65, 0.80), up);
    for corner in [0, 2, 6, 8] {
        assert_shows(pixels[corner], sky);
    }
    let hits = pixels.iter().filter(|pixel| pixel.x < 0.7).count() as u64;
    assert_eq!(frame.rays, Rays { primary: 9, shadow: 2 * hits, reflected: 0 });
}

#[test]
fn a_shadow_takes_one_light_and_casting_has_no_shadows() {
    // The second triangle is halfway from the middle of the first to a light.
    let halfway = facing(1.0, 0.2).map(|corner| corner + Vec3::X);
    let mut stage = Stage::new(&mesh(&[facing(0.0, 1.0), halfway]), [3, 3]);
    stage.lights[0].place = Vec3::new(2.0, 0.0, 2.0);
    stage.lights[1].place = Vec3::new(0.0, 0.0, 4.0);
    let full = picture(&stage, right(), FULL);
    assert_shows(full.picture.pixels()[4], GRASS * (AMBIENT + STRENGTHS[1]));
    let following = Following { casts_only: true, ..FULL.following };
    let cast = picture(&stage, right(), Manner { following, ..FULL });
    let slanting = STRENGTHS[0] * 0.5f64.sqrt();
    assert_shows(cast.picture.pixels()[4], GRASS * (AMBIENT + slanting + STRENGTHS[1]));
    assert_eq!(cast.rays, Rays { primary: 9, ..Rays::default() });
}

#[test]
fn a_mirror_shows_what_is_before_it_to_the_depth() {
    // Two mirrors that face each other, the nearer one with the eye between them.
    let mut stage = Stage::new(&mesh(&[facing(0.0, 1.0), facing(6.0, 9.0)]), [1, 1]);
    stage.surfaces = vec![Material { mirror: 1.0, ..Material::matt(1.0, 1.0, 1.0) }; 2];
    for depth in 0..4 {
        let following = Following { depth, casts_only: false };
        let frame = picture(&stage, right(), Manner { following, ..FULL });
        assert_eq!(frame.rays.reflected, u64::from(depth));
    }
    // Behind the last mirror is its own light; a half mirror shows half of either.
    stage.surfaces[0] = Material { mirror: 0.5, ..Material::matt(0.0, 0.0, 0.0) };
    stage.surfaces[1] = Material { glows: true, ..Material::matt(0.2, 0.4, 0.8) };
    let frame = picture(&stage, right(), FULL);
    assert_shows(frame.picture.pixels()[0], DVec3::new(0.1, 0.2, 0.4));
}

#[test]
fn highlights_are_where_the_mirror_of_the_light_is() {
    let mut stage = Stage::new(&mesh(&[facing(0.0, 1.0)]), [1, 1]);
    stage.surfaces = vec![Material::polished(0.0, 0.0, 0.0, 0.0)];
    let frame = picture(&stage, right(), FULL);
    assert_shows(frame.picture.pixels()[0], DVec3::splat(0.5));
    // The bisector of sight and light is 45 degrees / 2 off the normal: its cosine to the 32nd power.
    stage.lights.truncate(1);
    stage.lights[0].place = Vec3::new(2.0, 0.0, 2.0);
    let frame = picture(&stage, right(), FULL);
    let squared_cosine = (1.0 + 0.5f64.sqrt()) / 2.0;
    assert_shows(
        frame.picture.pixels()[0],
        DVec3::splat(0.5 * STRENGTHS[0] * squared_cosine.powi(16)),
    );
}

#[test]
fn pictures_come_again_bit_by_bit_as_png_and_from_a_recording() {
    let stage = Stage::new(&mesh(&[facing(0.0, 1.0), facing(-1.0, 3.0)]), [9, 7]);
    let structure = structure(&stage.triangles);
    let leaf = AskingLeaf::new(right(), &stage.triangles, false);
    let mut tracer = Searcher::new(structure.as_ref(), Box::new(leaf));
    let mut recorder = Recorder::new(&mut tracer);
    let first = frame(&stage, &mut recorder, FULL, &mut |_| true).expect("no interruption");
    let recording = recorder.recording();
    let again = frame(&stage, &mut Replay::new(&recording), FULL, &mut |_| true).expect("nor here");
    assert_eq!((&first.picture, first.rays), (&again.picture, again.rays));
    assert!(first.triangles_tested > 0 && again.triangles_tested == 0);
    let bytes = first.picture.png().expect("a size that PNG holds");
    let mut reader = png::Decoder::new(std::io::Cursor::new(&bytes)).read_info().expect("a PNG");
    let mut data = vec![0; 9 * 7 * 3];
    let info = reader.next_frame(&mut data).expect("whole");
    assert_eq!((info.width, info.height), (9, 7));
    let expected = first.picture.pixels().iter().flat_map(|pixel| (*pixel * 255.0).to_array());
    for (byte, expected) in data.iter().zip(expected) {
        assert!((f64::from(*byte) - expected).abs() <= 0.5, "{byte} {expected}");
    }
}

#[test]
fn an_interrupted_picture_is_none() {
    let stage = Stage::new(&mesh(&[facing(0.0, 1.0)]), [4, 4]);
    let mut shares = Vec::new();
    let nothing = Recording::default();
    let mut tracer = Replay::new(&nothing);
    let made = frame(&stage, &mut tracer, FULL, &mut |share| {
        shares.push(share);
        shares.len() < 3
    });
    assert_eq!(made, None);
    assert_eq!(shares.len(), 3);
}
