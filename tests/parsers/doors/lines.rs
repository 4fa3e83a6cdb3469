//! What people write by hand.

use super::folder::Folder;
use ray_test::cli::doors;
use ray_test::scene::built_in;
use ray_test::scene::look::Looks;
use ray_test::scene::rays::{Asked, Plan, Rays};
use std::ffi::OsString;

/// The words of a command line, one a line.
pub fn arguments(bytes: &[u8]) {
    let words = bytes.split(|byte| *byte == b'\n').map(word);
    doors::arguments(words.collect::<Vec<_>>()).ok();
}

#[cfg(unix)]
fn word(bytes: &[u8]) -> OsString {
    std::os::unix::ffi::OsStringExt::from_vec(bytes.to_vec())
}

#[cfg(not(unix))]
fn word(bytes: &[u8]) -> OsString {
    String::from_utf8_lossy(bytes).into_owned().into()
}

/// An experiment, as `run --dry-run` takes it.
pub fn config(bytes: &[u8]) {
    if let Ok(text) = str::from_utf8(bytes) {
        doors::experiment(text).ok();
    }
}

/// Two cases for answers.
const CASES: &str = "id,ox,oy,oz,dx,dy,dz,ax,ay,az,bx,by,bz,cx,cy,cz\n\
                     a,0.25,0.25,1,0,0,-1,0,0,0,1,0,0,0,1,0\n\
                     b,9,9,1,0,0,-1,0,0,0,1,0,0,0,1,0\n";

/// Cases of one's own, and answers to other ones.
pub fn cases(bytes: &[u8]) {
    doors::check(bytes, false).ok();
    doors::check(bytes, true).ok();
    doors::answers(CASES.as_bytes(), bytes).ok();
}

/// Rays for a scene.
pub fn rays(bytes: &[u8]) {
    let folder = Folder::new();
    let file = folder.write("rays.csv", bytes).display().to_string();
    let mesh = built_in::named("icosphere:0").expect("a scene").expect("its smallest size");
    let plan = Plan { width: 4, height: 4, per_point: 1, seed: 1 };
    let Ok(read) = Rays::of(&Asked::File(file), &mesh, plan, |_| None) else { return };
    assert!(!read.rays.is_empty());
    for ray in &read.rays {
        assert!(ray.origin.is_finite() && ray.direction.is_finite() && ray.end.is_finite());
        assert!(ray.t_min <= ray.t_max && ray.t_min.is_finite() && ray.t_max.is_finite());
    }
    Looks::of(&mesh).with_rays(&mesh, &read.rays, |_| None);
}
