//! A picture made again from recorded hits: what it takes without any intersection.

use super::tracer::Tracer;
use crate::structure::Hit;
use crate::workload::Ray;

/// What a tracer answered, in the order of the rays.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Recording {
    nearest: Vec<Option<Hit>>,
    any: Vec<bool>,
}

/// Writes down what another tracer answers.
pub struct Recorder<'a> {
    tracer: &'a mut dyn Tracer,
    recording: Recording,
}

impl<'a> Recorder<'a> {
    /// Of that tracer; nothing is written down yet.
    pub fn new(tracer: &'a mut dyn Tracer) -> Self {
        Recorder { tracer, recording: Recording::default() }
    }

    /// What was written down.
    pub fn recording(self) -> Recording {
        self.recording
    }
}

impl Tracer for Recorder<'_> {
    fn begin(&mut self, pixel: usize) {
        self.tracer.begin(pixel);
    }

    fn nearest(&mut self, ray: &Ray) -> Option<Hit> {
        let hit = self.tracer.nearest(ray);
        self.recording.nearest.push(hit);
        hit
    }

    fn any(&mut self, ray: &Ray) -> bool {
        let is_hit = self.tracer.any(ray);
        self.recording.any.push(is_hit);
        is_hit
    }

    fn triangles_tested(&self) -> u64 {
        self.tracer.triangles_tested()
    }
}

/// Answers as recorded, whatever the ray. The same stage in the same manner asks for the same rays,
/// since they depend on nothing but the answers.
pub struct Replay<'a> {
    nearest: std::slice::Iter<'a, Option<Hit>>,
    any: std::slice::Iter<'a, bool>,
}

impl<'a> Replay<'a> {
    /// From the first answer on.
    pub fn new(recording: &'a Recording) -> Self {
        Replay { nearest: recording.nearest.iter(), any: recording.any.iter() }
    }
}

impl Tracer for Replay<'_> {
    fn nearest(&mut self, _: &Ray) -> Option<Hit> {
        self.nearest.next().copied().flatten()
    }

    fn any(&mut self, _: &Ray) -> bool {
        self.any.next().copied().unwrap_or(false)
    }

    fn triangles_tested(&self) -> u64 {
        0
    }
}
