//! One picture, made.

use super::picture::Picture;
use super::shade::{Follower, Following, Rays};
use super::stage::Stage;
use super::subsample::{Sampler, Subsampling};
use super::tracer::Tracer;

/// How a picture is made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Manner {
    /// How far rays are followed.
    pub following: Following,
    /// Which pixels get a ray.
    pub subsampling: Subsampling,
}

/// A picture, and what it took.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The picture.
    pub picture: Picture,
    /// Rays that were cast.
    pub rays: Rays,
    /// Tests of a ray against a triangle.
    pub triangles_tested: u64,
}

impl Frame {
    /// Pixels that were filled without a ray.
    pub fn saved(&self) -> u64 {
        self.picture.pixels().len() as u64 - self.rays.primary
    }
}

/// Makes a picture. `go_on` is asked before every row of cells, with the share that is done, from 0 to
/// 1; `None` if it said no.
pub fn frame(
    stage: &Stage,
    tracer: &mut dyn Tracer,
    manner: Manner,
    go_on: &mut dyn FnMut(f64) -> bool,
) -> Option<Frame> {
    let tested = tracer.triangles_tested();
    let mut picture = Picture::new(stage.size());
    let mut follower =
        Follower { stage, tracer, following: manner.following, rays: Rays::default() };
    let mut sampler = Sampler::new(manner.subsampling, &mut picture);
    let bands = sampler.bands();
    for band in 0..bands {
        if !go_on(band as f64 / bands as f64) {
            return None;
        }
        sampler.band(band, &mut |column, row| follower.pixel(column, row));
    }
    let (rays, tested_now) = (follower.rays, follower.tracer.triangles_tested());
    Some(Frame { picture, rays, triangles_tested: tested_now - tested })
}
