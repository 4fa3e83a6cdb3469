//! A drawn workload with its exact answers: what variants are checked on and timed on.

use std::cell::OnceCell;

use super::nearest_workload::NearestWorkload;
use super::workload::PairsWorkload;
use crate::accuracy::{Judgement, NearestTruth, Reported, Truth, judge, judge_nearest};
use crate::job::Job;
use crate::measure::Order;
use crate::registry::Variant;
use crate::workload::{NearestSet, PairSpec, Pairs, QueryKind, Ray, Triangle, WorkloadError};
use std::sync::atomic::{AtomicBool, Ordering};

/// What rows say of a workload.
#[derive(Clone, Debug, Default)]
pub struct Facts {
    /// The column `workload`.
    pub workload: String,
    /// Effective share of hits; pairs only.
    pub density: Option<f64>,
    /// How far the rays of a bunch lie apart; bunches only.
    pub spread: Option<f64>,
    /// `line`, `ray`, `segment`, `point`.
    pub query: &'static str,
    /// `natural` or `facing`; pairs only.
    pub winding: &'static str,
    /// `pcg` or `msvc`.
    pub generator: &'static str,
    /// Hash of every number drawn.
    pub hash: u64,
    /// Seed of the draw.
    pub seed: u64,
}

/// Rays and triangles with their exact answers.
pub struct Scene {
    /// What rows say of it.
    pub facts: Facts,
    /// Rays, as drawn.
    pub rays: Vec<Ray>,
    /// Triangles, as drawn.
    pub triangles: Vec<Triangle>,
    truth: Exactly,
}

/// The exact answers, computed when a variant first asks.
enum Exactly {
    Pairs { truths: OnceCell<Vec<Truth>>, segments: OnceCell<Vec<Truth>> },
    Points(OnceCell<Vec<Truth>>),
    Nearest(OnceCell<NearestTruth>),
}

/// Kernels that are judged on (origin, end); the others are on (origin, direction).
const SEGMENT_KERNEL: &str = "chirkov";

impl Scene {
    /// Pairs of an experiment at a density, as many as the order takes.
    ///
    /// # Errors
    /// As [`Pairs::draw`].
    pub fn pairs(
        workload: &PairsWorkload,
        density: f64,
        order: Order,
        seed: u64,
    ) -> Result<Self, WorkloadError> {
        let reshuffled = order == Order::Reshuffled;
        let count = if reshuffled { workload.reshuffled_count } else { workload.count };
        let spec = PairSpec {
            count,
            density,
            query: workload.query,
            winding: workload.winding,
            generator: workload.generator,
            seed,
        };
        Ok(Self::of_pairs(Pairs::draw(spec)?))
    }

    /// Pairs that were drawn elsewhere.
    pub fn of_pairs(pairs: Pairs) -> Self {
        let facts = Facts {
            workload: format!("pairs-{}", pairs.spec.query.word()),
            density: Some(pairs.density()),
            query: pairs.spec.query.word(),
            winding: pairs.spec.winding.word(),
            generator: pairs.spec.generator.word(),
            hash: pairs.hash,
            seed: pairs.spec.seed,
            ..Facts::default()
        };
        Self::given_pairs(facts, pairs.rays, pairs.triangles)
    }

    /// Points of planes, each the `end` of its ray.
    pub fn of_points(facts: Facts, rays: Vec<Ray>, triangles: Vec<Triangle>) -> Self {
        Scene { facts, rays, triangles, truth: Exactly::Points(OnceCell::new()) }
    }

    /// Rays against all triangles, as many as the order takes.
    ///
    /// # Errors
    /// As [`NearestSet::draw`].
    pub fn nearest(
        workload: &NearestWorkload,
        spread: Option<f64>,
        order: Order,
        seed: u64,
    ) -> Result<Self, WorkloadError> {
        let rays = match order {
            Order::Reshuffled => workload.reshuffled_rays,
            Order::Fixed | Order::Literal => workload.rays,
        };
        let set = NearestSet::draw(workload.spec(rays, spread, seed))?;
        let facts = Facts {
            workload: format!("nearest-{}", workload.coherence.word()),
            spread,
            query: QueryKind::Ray.word(),
            generator: "pcg",
            hash: set.hash,
            seed,
            ..Facts::default()
        };
        let truth = Exactly::Nearest(OnceCell::new());
        Ok(Scene { facts, rays: set.rays, triangles: set.triangles, truth })
    }

    /// Rays and triangles of somewhere else, every ray against every triangle.
    pub fn given(facts: Facts, rays: Vec<Ray>, triangles: Vec<Triangle>) -> Self {
        Scene { facts, rays, triangles, truth: Exactly::Nearest(OnceCell::new()) }
    }

    /// Rays and triangles of somewhere else, as many of each, ray i against triangle i.
    pub fn given_pairs(facts: Facts, rays: Vec<Ray>, triangles: Vec<Triangle>) -> Self {
        let truth = Exactly::Pairs { truths: OnceCell::new(), segments: OnceCell::new() };
        Scene { facts, rays, triangles, truth }
    }

    /// Whether it is rays against all triangles.
    pub fn is_nearest(&self) -> bool {
        matches!(self.truth, Exactly::Nearest(_))
    }

    /// Tests of one pass.
    pub fn tests(&self) -> u64 {
        let per_ray = if self.is_nearest() { self.triangles.len() } else { 1 };
        (self.rays.len() * per_ray) as u64
    }

    /// The variant, bound to this scene; `None` if it has no loop for it.
    pub fn bind(&self, variant: &Variant) -> Option<Box<dyn Job>> {
        let binder = if self.is_nearest() { &variant.nearest } else { &variant.pairs };
        binder.as_ref().map(|bind| bind(&self.rays, &self.triangles))
    }

    /// Compares a job's answers, by the very function that will be timed, with the exact ones.
    pub fn judge(&self, variant: &Variant, job: &mut dyn Job) -> Judgement {
        let reported = reported(variant);
        let answers = job.answers();
        match &self.truth {
            Exactly::Nearest(truth) => {
                let truth = truth.get_or_init(|| NearestTruth::of(&self.rays, &self.triangles));
                let exact = if reported.culls { &truth.front } else { &truth.any };
                judge_nearest(&answers, exact, (&self.rays, &self.triangles), reported)
            }
            Exactly::Points(truths) => {
                judge(&answers, truths.get_or_init(|| self.solve(Truth::of_point)), reported)
            }
            Exactly::Pairs { truths, segments } => {
                let truths = if variant.axes.kernel == SEGMENT_KERNEL {
                    segments.get_or_init(|| self.solve(Truth::of_segment))
                } else {
                    truths.get_or_init(|| self.solve(Truth::of))
                };
                judge(&answers, truths, reported)
            }
        }
    }

    /// Computes the exact answers that a variant on pairs is judged by, where that was not done before:
    /// of millions, it takes many seconds. `false` once cancelled; then there are none.
    pub fn solve_unless(&self, variant: &Variant, cancel: &AtomicBool) -> bool {
        let Exactly::Pairs { truths, segments } = &self.truth else { return true };
        let is_segment = variant.axes.kernel == SEGMENT_KERNEL;
        let place = if is_segment { segments } else { truths };
        let one = if is_segment { Truth::of_segment } else { Truth::of };
        if place.get().is_some() {
            return true;
        }
        let pairs = self.rays.iter().zip(&self.triangles);
        let solved = pairs
            .map(|(ray, triangle)| (!cancel.load(Ordering::Relaxed)).then(|| one(ray, triangle)));
        // There was nothing in its place.
        solved.collect::<Option<Vec<Truth>>>().is_some_and(|solved| place.set(solved).is_ok())
    }

    fn solve(&self, one: fn(&Ray, &Triangle) -> Truth) -> Vec<Truth> {
        self.rays.iter().zip(&self.triangles).map(|(ray, triangle)| one(ray, triangle)).collect()
    }
}

/// What the form of a variant reports.
pub fn reported(variant: &Variant) -> Reported {
    let axes = &variant.axes;
    Reported {
        unit_roundoff: if axes.precision == "f64" { 0.5f64.powi(53) } else { 0.5f64.powi(24) },
        t: axes.output != "hit" && axes.query != "point",
        uv: matches!(axes.output, "tuv" | "surface"),
        surface: axes.output == "surface",
        culls: axes.cull == "on",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::experiment::select;

    #[test]
    fn what_is_solved_ahead_is_what_is_judged_by_and_what_is_cancelled_is_not_there() {
        let pattern = "^(wald|chirkov)/f32/single/sse2/early/last/plain/tuv$".to_owned();
        let variants = select(&[pattern]).expect("it matches");
        assert_eq!(variants.len(), 2);
        for variant in variants {
            let scene = || Scene::of_pairs(Pairs::draw(PairSpec::new(60, 0.5, 1)).expect("plain"));
            let judged = |scene: &Scene| {
                let mut job = scene.bind(variant).expect("it runs on pairs");
                scene.judge(variant, job.as_mut())
            };
            let (ahead, cancelled) = (scene(), scene());
            assert!(ahead.solve_unless(variant, &AtomicBool::new(false)));
            // What is there need not be computed again.
            assert!(ahead.solve_unless(variant, &AtomicBool::new(true)));
            assert!(!cancelled.solve_unless(variant, &AtomicBool::new(true)));
            assert_eq!(judged(&ahead), judged(&scene()));
            assert_eq!(judged(&cancelled), judged(&scene()));
        }
    }
}
