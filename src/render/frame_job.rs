//! Pictures behind a [`Job`]: what a clock is put to.

use super::frame::{Frame, Manner, frame};
use super::replay::{Recorder, Recording, Replay};
use super::stage::Stage;
use super::tracer::{Searcher, Tracer};
use crate::job::{Answer, Block, Job, Tally};
use crate::structure::{Leaf, Search, Structure};
use std::rc::Rc;

/// Pictures of a stage by one kernel in a structure. An item is a picture, and so is a test.
pub struct FrameJob {
    stage: Rc<Stage>,
    structure: Rc<dyn Structure>,
    search: Search,
    manner: Manner,
}

/// The same pictures from recorded answers: what is left of their time without any search.
pub struct ReplayJob {
    stage: Rc<Stage>,
    recording: Recording,
    manner: Manner,
}

impl FrameJob {
    /// `structure` holds the stage's triangles, as the leaf does.
    pub fn new(
        stage: Rc<Stage>,
        structure: Rc<dyn Structure>,
        leaf: Box<dyn Leaf>,
        manner: Manner,
    ) -> Self {
        FrameJob { stage, structure, search: Search::new(leaf), manner }
    }

    /// A picture, by a tracer that is given the kernel's.
    pub fn with(&mut self, made: impl FnOnce(&Stage, &mut dyn Tracer, Manner) -> Frame) -> Frame {
        let mut lent = Searcher::lent(self.structure.as_ref(), &mut self.search);
        made(&self.stage, &mut lent, self.manner)
    }

    /// A picture, and what it took.
    pub fn frame(&mut self) -> Frame {
        self.with(whole)
    }

    /// The same pictures without any search.
    pub fn replay(&mut self) -> ReplayJob {
        let mut recording = Recording::default();
        self.with(|stage, tracer, manner| {
            let mut recorder = Recorder::new(tracer);
            let frame = whole(stage, &mut recorder, manner);
            recording = recorder.recording();
            frame
        });
        ReplayJob { stage: Rc::clone(&self.stage), recording, manner: self.manner }
    }
}

/// A picture that nobody interrupts.
pub fn whole(stage: &Stage, tracer: &mut dyn Tracer, manner: Manner) -> Frame {
    match frame(stage, tracer, manner, &mut |_| true) {
        Some(frame) => frame,
        None => unreachable!("nobody said no"),
    }
}

/// Rays that were cast, and the bits of all colours.
fn tally(frame: &Frame) -> Tally {
    let mut tally = Tally { hits: frame.rays.all(), ..Tally::default() };
    for pixel in frame.picture.pixels() {
        for (sum, share) in tally.bits.iter_mut().zip(pixel.to_array()) {
            *sum = sum.wrapping_add(share.to_bits());
        }
    }
    tally
}

fn repeated(block: Block, mut one: impl FnMut() -> Frame) -> Tally {
    let times = block.items * block.repeats;
    (0..times).fold(Tally::default(), |sum, _| sum.plus(tally(&one())))
}

impl Job for FrameJob {
    fn items(&self) -> usize {
        1
    }

    fn tests_per_item(&self) -> u64 {
        1
    }

    fn run(&mut self, block: Block) -> Tally {
        repeated(block, || self.frame())
    }

    fn permute(&mut self, _permutation: &[u32]) {}

    /// None: pictures are held against the exact ones ray by ray.
    fn answers(&mut self) -> Vec<Answer> {
        Vec::new()
    }
}

impl Job for ReplayJob {
    fn items(&self) -> usize {
        1
    }

    fn tests_per_item(&self) -> u64 {
        1
    }

    fn run(&mut self, block: Block) -> Tally {
        repeated(block, || whole(&self.stage, &mut Replay::new(&self.recording), self.manner))
    }

    fn permute(&mut self, _permutation: &[u32]) {}

    fn answers(&mut self) -> Vec<Answer> {
        Vec::new()
    }
}
