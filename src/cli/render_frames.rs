//! Pictures against the clock.

use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Instant;

use indicatif::ProgressBar;

use super::failure::Failure;
use super::progress;
use super::render_kernels::Chosen;
use crate::render::{
    Compared, Count, Exactly, Frame, Manner, Picture, Recorder, Replay, Searcher, Stage, Tracer,
    Way, frame,
};
use crate::structure::Structure;

/// What one kernel showed.
pub struct Shown {
    /// The form.
    pub chosen: Chosen,
    /// Seconds to prepare its triangles.
    pub preparing: f64,
    /// The picture, and what it took; `None` before the first is made.
    pub frame: Option<Frame>,
    /// Seconds of each frame.
    pub seconds: Vec<f64>,
    /// Seconds of frames that are made from recorded hits.
    pub without_tests: Vec<f64>,
    /// Where it differs from the exact one.
    pub differences: Option<Differences>,
}

/// Where a kernel's picture differs.
pub struct Differences {
    /// By kind, in the order of [`Way::ALL`].
    pub counts: [Count; Way::ALL.len()],
    /// Pixel and kind of the first that rounding does not explain.
    pub first_wrong: Option<(usize, Way)>,
    /// The picture that shows them.
    pub painted: Picture,
}

/// A kernel with its triangles.
pub struct Contender<'a> {
    /// What it showed so far.
    pub shown: Shown,
    tracer: Searcher<'a>,
}

/// Above so many pixels hits are not recorded: they would take hundreds of megabytes.
const MOST_RECORDED: usize = 1 << 22;
/// Steps of the progress bar per frame.
const STEPS: f64 = 1000.0;

/// A stage, a structure around its triangles, and a clock.
pub struct Studio<'a> {
    /// The stage.
    pub stage: &'a Stage,
    /// Around its triangles.
    pub structure: &'a dyn Structure,
    /// How pictures are made.
    pub manner: Manner,
    /// Tells that it should end.
    pub cancel: &'a AtomicBool,
    /// Shows how far it is.
    pub bar: ProgressBar,
    /// Frames that were begun.
    pub begun: u64,
}

impl<'a> Studio<'a> {
    /// A studio that expects to make so many frames.
    pub fn new(
        (stage, structure): (&'a Stage, &'a dyn Structure),
        manner: Manner,
        cancel: &'a AtomicBool,
        frames: usize,
    ) -> Self {
        let bar = match frames {
            0 => ProgressBar::hidden(),
            frames => progress::bar(frames.saturating_mul(STEPS as usize)),
        };
        Studio { stage, structure, manner, cancel, bar, begun: 0 }
    }

    /// A frame, and its seconds.
    fn timed(&mut self, tracer: &mut dyn Tracer) -> Result<(Frame, f64), Failure> {
        let (bar, cancel, before) = (&self.bar, self.cancel, self.begun as f64);
        self.begun += 1;
        let start = Instant::now();
        let made = frame(self.stage, tracer, self.manner, &mut |share| {
            bar.set_position(((before + share) * STEPS) as u64);
            !cancel.load(Ordering::Relaxed)
        });
        let seconds = start.elapsed().as_secs_f64();
        Ok((made.ok_or(Failure::Interrupted)?, seconds))
    }

    /// A kernel with the stage's triangles, prepared.
    pub fn contender(&self, chosen: Chosen) -> Contender<'a> {
        let start = Instant::now();
        let leaf = chosen.leaf(&self.stage.triangles);
        let preparing = start.elapsed().as_secs_f64();
        let (frame, seconds, without_tests) = (None, Vec::new(), Vec::new());
        let shown = Shown { chosen, preparing, frame, seconds, without_tests, differences: None };
        Contender { shown, tracer: Searcher::new(self.structure, leaf) }
    }

    /// Seconds of one frame of a kernel, or with `compares` of one that is held against the exact one.
    ///
    /// # Errors
    /// When interrupted.
    pub fn tried(&mut self, one: &mut Contender<'_>, compares: bool) -> Result<f64, Failure> {
        if compares { Ok(self.compared(one)?.1) } else { Ok(self.timed(&mut one.tracer)?.1) }
    }

    /// `count` frames of every kernel. They take turns, each first as often as any other, so that a
    /// disturbance does not fall on one alone.
    ///
    /// # Errors
    /// When interrupted; the frames that were made stay.
    pub fn frames(&mut self, all: &mut [Contender<'_>], count: usize) -> Result<(), Failure> {
        for turn in 0..count {
            for place in 0..all.len() {
                let one = &mut all[(turn + place) % all.len()];
                let (frame, seconds) = self.timed(&mut one.tracer)?;
                one.shown.seconds.push(seconds);
                one.shown.frame.get_or_insert(frame);
            }
        }
        Ok(())
    }

    /// `count` frames from the hits of one: what is left of the time without any test. Nothing for
    /// pictures so large that their hits take too much memory.
    ///
    /// # Errors
    /// When interrupted; the frames that were made stay.
    pub fn without_tests(&mut self, one: &mut Contender<'_>, count: usize) -> Result<(), Failure> {
        let [columns, rows] = self.stage.size();
        if columns as usize * rows as usize > MOST_RECORDED {
            return Ok(());
        }
        let mut recorder = Recorder::new(&mut one.tracer);
        self.timed(&mut recorder)?;
        let recording = recorder.recording();
        for _ in 0..count {
            let (_, seconds) = self.timed(&mut Replay::new(&recording))?;
            one.shown.without_tests.push(seconds);
        }
        Ok(())
    }

    /// Holds a kernel's picture against the exact one.
    ///
    /// # Errors
    /// When interrupted.
    pub fn compare(&mut self, one: &mut Contender<'_>) -> Result<(), Failure> {
        one.shown.differences = Some(self.compared(one)?.0);
        Ok(())
    }

    fn compared(&mut self, one: &mut Contender<'_>) -> Result<(Differences, f64), Failure> {
        let [columns, rows] = self.stage.size();
        let is_segment = one.shown.chosen.is_segment;
        let exactly = Exactly::new(&self.stage.triangles, self.structure, is_segment);
        let pixels = columns as usize * rows as usize;
        let mut compared = Compared::new(&mut one.tracer, exactly, pixels);
        let (frame, seconds) = self.timed(&mut compared)?;
        let counts = Way::ALL.map(|way| compared.count(way));
        let painted = compared.painted(&frame.picture);
        Ok((Differences { counts, first_wrong: compared.first_wrong(), painted }, seconds))
    }
}
