//! A picture made again from recorded hits: what it takes without any intersection.

use super::tracer::{Hit, Tracer};
use crate::workload::Ray;

/// Writes down what another tracer answers.
pub struct Recorder<'a> {
    tracer: &'a mut dyn Tracer,
    answers: Vec<Option<Hit>>,
}

impl<'a> Recorder<'a> {
    /// Of that tracer; nothing is written down yet.
    pub fn new(tracer: &'a mut dyn Tracer) -> Self {
        Recorder { tracer, answers: Vec::new() }
    }

    /// The answers, in the order of the rays.
    pub fn recorded(self) -> Vec<Option<Hit>> {
        self.answers
    }

    fn keep(&mut self, answer: Option<Hit>) -> Option<Hit> {
        self.answers.push(answer);
        answer
    }
}

impl Tracer for Recorder<'_> {
    fn begin(&mut self, pixel: usize) {
        self.tracer.begin(pixel);
    }

    fn nearest(&mut self, ray: &Ray) -> Option<Hit> {
        let answer = self.tracer.nearest(ray);
        self.keep(answer)
    }

    fn any(&mut self, ray: &Ray) -> Option<Hit> {
        let answer = self.tracer.any(ray);
        self.keep(answer)
    }

    fn triangles_tested(&self) -> u64 {
        self.tracer.triangles_tested()
    }
}

/// Answers as recorded, whatever the ray: the same picture in the same manner asks for the same rays,
/// since all that it is made of are answers.
pub struct Replay<'a> {
    answers: std::slice::Iter<'a, Option<Hit>>,
}

impl<'a> Replay<'a> {
    /// From the first answer on.
    pub fn new(answers: &'a [Option<Hit>]) -> Self {
        Replay { answers: answers.iter() }
    }

    /// Answers that were not asked for so far.
    pub fn left(&self) -> usize {
        self.answers.len()
    }
}

impl Tracer for Replay<'_> {
    fn nearest(&mut self, _: &Ray) -> Option<Hit> {
        self.answers.next().copied().flatten()
    }

    fn any(&mut self, _: &Ray) -> Option<Hit> {
        self.answers.next().copied().flatten()
    }

    fn triangles_tested(&self) -> u64 {
        0
    }
}
