//! Variants of the registry, asked for answers about all rays: first the usual one, to see what it cannot.

use super::contest::default_variant;
use super::form::Output;
use super::nearby::Nearby;
use super::pieces::PIECES;
use super::proof::{Exactly, Standing};
use super::situation::{Pilot, Situation};
use crate::accuracy::{NearestTruth, Reported, judge_nearest};
use crate::experiment::reported;
use crate::job::Answer;
use crate::registry::Variant;
use crate::workload::{Ray, Triangle};

/// Which triangles a ray is tested against.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// All.
    List,
    /// Those whose boxes in a hierarchy it meets.
    Nearby,
}

/// Asks variants about rays whose exact answers are known.
pub struct Asking<'a, 'b> {
    /// The rays and their answers.
    pub exactly: &'a Exactly<'a>,
    /// What is near a ray.
    pub nearby: &'a mut Nearby<'b>,
    /// The way that answers are found.
    pub way: Way,
    /// What is wanted of a hit: nothing else is judged.
    pub output: Output,
}

/// Rays are given in f32: what its rounding explains is explained in f64 as well. Outputs beyond what is
/// wanted may be as they like.
fn judged_as(variant: &Variant, output: Output) -> Reported {
    let reported = reported(variant);
    Reported {
        unit_roundoff: 0.5f64.powi(24),
        t: reported.t && output >= Output::T,
        uv: reported.uv && output >= Output::Tuv,
        surface: reported.surface && output == Output::Surface,
        ..reported
    }
}

impl Asking<'_, '_> {
    /// The answers of a variant about all rays, judged.
    pub fn standing(&mut self, variant: &Variant) -> Standing {
        let all: Vec<usize> = (0..self.exactly.rays.len()).collect();
        let answers = self.answers(variant, &all);
        self.exactly.judge(&answers, judged_as(variant, self.output))
    }

    /// The answers of a variant about some rays, by their places.
    fn answers(&mut self, variant: &Variant, places: &[usize]) -> Vec<Answer> {
        let Some(bind) = &variant.nearest else {
            return vec![Answer::default(); places.len()];
        };
        let rays: Vec<Ray> = places.iter().map(|place| self.exactly.rays[*place]).collect();
        if self.way == Way::List {
            return bind(&rays, self.exactly.triangles).answers();
        }
        let nearby = &mut self.nearby;
        let one = |ray: &Ray| {
            let near = nearby.of(ray);
            if near.is_empty() {
                return Answer::default();
            }
            let mut answers = bind(std::slice::from_ref(ray), &nearby.taken(&near)).answers();
            let answer = answers.pop().unwrap_or_default();
            Answer { triangle: answer.triangle.map(|place| near[place] as usize), ..answer }
        };
        rays.iter().map(one).collect()
    }

    /// Of rays whose answer is wrong, or that are lost, how many another variant has right.
    fn better(&mut self, variant: Option<&Variant>, places: &[usize], what: Better) -> u64 {
        let Some(variant) = variant.filter(|_| !places.is_empty()) else { return 0 };
        let answers = self.answers(variant, places);
        let exactly = Exactly {
            rays: &places.iter().map(|place| self.exactly.rays[*place]).collect::<Vec<_>>(),
            triangles: self.exactly.triangles,
            nearest: places.iter().map(|place| self.exactly.nearest[*place]).collect(),
        };
        let standing = exactly.judge(&answers, judged_as(variant, self.output));
        match what {
            Better::Tight => (places.len() - standing.lost.len()) as u64,
            Better::Fine => standing.agree(),
        }
    }

    /// Whether the plan tests every ray against all triangles: then the proof does so, too.
    pub fn goes_through_all(&self, situation: &Situation) -> bool {
        let hierarchy = PIECES.iter().find(|piece| piece.name == "hierarchy");
        hierarchy.is_some_and(|piece| (piece.look)(situation).is_spare())
    }
}

/// What is counted of other answers.
#[derive(Clone, Copy)]
enum Better {
    /// Rays that are not lost.
    Tight,
    /// Rays that are right.
    Fine,
}

/// The usual f32 test on all rays; then a watertight one on those that are lost, and the same in f64 on
/// those that are wrong.
pub fn fly(asking: &mut Asking<'_, '_>) -> Pilot {
    let Some(usual) = default_variant(Output::Tuv, false, false) else { return Pilot::default() };
    let standing = asking.standing(usual);
    let tight = default_variant(Output::Tuv, true, false);
    let fine = default_variant(Output::Tuv, false, true);
    Pilot {
        rays: standing.right.len() as u64,
        leaks: asking.better(tight, &standing.lost, Better::Tight),
        too_coarse: asking.better(fine, &standing.wrong(), Better::Fine),
    }
}

/// Whether the variant is right about a ray among these triangles, and no other of them is hit at nearly
/// the same distance: then no form that is right can be taken for wrong.
pub fn is_plain(variant: &Variant, ray: &Ray, triangles: &[Triangle]) -> bool {
    let Some(bind) = &variant.nearest else { return false };
    let rays = std::slice::from_ref(ray);
    let truth = NearestTruth::of(rays, triangles);
    let answers = bind(rays, triangles).answers();
    let reported = judged_as(variant, Output::Surface);
    let right = judge_nearest(&answers, &truth.any, (rays, triangles), reported);
    right.wrong.is_none() && !super::proof::has_ties(ray, triangles, reported)
}
