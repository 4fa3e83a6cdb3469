//! The whole sweep: families x knobs x precisions, every form on the same cases.

use super::family::{Family, Work};
use super::forms::Form;
use super::places::places;
use super::precision::Precision;
use super::shots::RayClass;
use super::{cells, knee, mesh_rays, metamorphic, spawned};
use crate::shard::Shard;
use crate::spread::{Watch, pieces};
use crate::table::Row;
use std::sync::atomic::AtomicBool;

/// How much is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Depth {
    /// To look whether it works.
    Quick,
    /// At least a million edge rays and a million vertex rays over all closed meshes.
    #[default]
    Standard,
    /// Five times as much.
    Thorough,
}

impl Depth {
    /// Cases a setting.
    fn cases(self) -> usize {
        match self {
            Depth::Quick => 1_000,
            Depth::Standard => 10_000,
            Depth::Thorough => 50_000,
        }
    }

    /// Rays a mesh, offset and class: at the standard depth a million and a half over three meshes
    /// and five offsets, since some are not counted where rounding has closed a mesh up. Random
    /// rays, which hardly ever come near an edge, are a fifth.
    fn rays(self, class: RayClass) -> usize {
        let rays = match self {
            Depth::Quick => 4_000,
            Depth::Standard => 100_000,
            Depth::Thorough => 500_000,
        };
        if class == RayClass::Random { rays / 5 } else { rays }
    }
}

/// One piece of the sweep: a setting of a family's knob.
#[derive(Clone, Copy, Debug)]
pub struct Setting {
    /// What inputs are rounded to.
    pub precision: Precision,
    /// The knob.
    pub knob: f64,
    /// Of everything.
    pub seed: u64,
    /// Cases, or rays.
    pub count: usize,
    /// Of rays against meshes.
    pub class: Option<RayClass>,
}

/// What is swept.
pub struct Sweep {
    /// The families.
    pub families: Vec<Family>,
    /// The forms.
    pub forms: Vec<Form>,
    /// How much.
    pub depth: Depth,
    /// Where the generators start.
    pub seed: u64,
    /// Which of the forms are asked: every row is about one form, so that no row needs another
    /// shard's.
    pub shard: Shard,
}

/// What came of a sweep.
pub struct Outcome {
    /// All rows: those of settings in the order of families, precisions and knobs, then knees and
    /// leaks.
    pub rows: Vec<Row>,
    /// Where each row stands among those of all shards: sorted by this, they stand as in the whole.
    pub places: Vec<u64>,
    /// Whether every setting was done.
    pub complete: bool,
}

impl Sweep {
    /// The forms of this shard.
    fn asked(&self) -> &[Form] {
        &self.forms[self.shard.range(self.forms.len())]
    }

    /// Every setting, with the place of its family.
    fn settings(&self) -> Vec<(usize, Setting)> {
        let mut settings = Vec::new();
        for (index, family) in self.families.iter().enumerate() {
            for precision in Precision::ALL.into_iter().filter(|one| self.has(*one)) {
                for knob in (family.knobs)(precision) {
                    let setting = |class: Option<RayClass>| {
                        let count = class.map_or(self.depth.cases(), |one| self.depth.rays(one));
                        (index, Setting { precision, knob, seed: self.seed, count, class })
                    };
                    match family.work {
                        Work::Mesh(kind) => {
                            settings
                                .extend(RayClass::of(kind).iter().map(|one| setting(Some(*one))));
                        }
                        _ => settings.push(setting(None)),
                    }
                }
            }
        }
        settings
    }

    fn has(&self, precision: Precision) -> bool {
        self.asked().iter().any(|form| form.precision == precision)
    }

    /// Number of pieces that [`Watch::done`] is told of.
    pub fn pieces(&self) -> usize {
        self.settings().len()
    }

    /// Expected time of a piece on one processor, in seconds. Rates as measured on a processor of
    /// 2024; they differ by a factor of two or so.
    fn seconds_of(&self, (index, setting): &(usize, Setting)) -> f64 {
        let forms = self.asked().iter().filter(|form| form.precision == setting.precision).count();
        let (each, of_form) = match self.families[*index].work {
            Work::Aimed(_) | Work::Free(_) => (10e-6, 0.6e-6),
            Work::Mesh(_) => (10e-6, 0.4e-6),
            Work::Spawned => (2.5e-6, 2e-6),
            Work::Metamorphic(_) => (0.8e-6, 0.15e-6),
        };
        setting.count as f64 * (each + of_form * forms as f64)
    }

    /// Expected time of all, in seconds, on so many processors.
    pub fn seconds(&self, processors: usize) -> f64 {
        let all: f64 = self.settings().iter().map(|setting| self.seconds_of(setting)).sum();
        all / processors.max(1) as f64
    }

    /// Does it.
    pub fn run(&self, watch: &Watch<'_>) -> Outcome {
        let settings = self.settings();
        // The longest first, so that no processor is left alone with one at the end.
        let mut order: Vec<usize> = (0..settings.len()).collect();
        let seconds: Vec<f64> = settings.iter().map(|one| self.seconds_of(one)).collect();
        order.sort_by(|a, b| seconds[*b].total_cmp(&seconds[*a]).then(a.cmp(b)));
        let done = pieces(settings.len(), watch, |piece| {
            let (family, setting) = &settings[order[piece]];
            self.rows_of(&self.families[*family], setting, watch.cancel)
        });
        let mut by_setting: Vec<Option<Vec<Row>>> = vec![None; settings.len()];
        for (place, rows) in order.into_iter().zip(done) {
            // A setting in the midst of which it was cancelled is not done.
            by_setting[place] = rows.flatten();
        }
        let complete = by_setting.iter().all(Option::is_some);
        let mut rows: Vec<Row> = by_setting.into_iter().flatten().flatten().collect();
        let knees = knee::knees(&self.families, self.asked(), &rows);
        let leaks = knee::leaks(self.asked(), &rows);
        rows.extend(knees);
        rows.extend(leaks);
        Outcome { places: places(&self.families, &self.forms, &rows), rows, complete }
    }

    /// The rows of a setting; `None` once cancelled: at a thorough depth a setting takes half a
    /// minute, so the flag is looked at within it, too.
    fn rows_of(&self, family: &Family, setting: &Setting, cancel: &AtomicBool) -> Option<Vec<Row>> {
        let forms = self.asked();
        match family.work {
            Work::Aimed(_) | Work::Free(_) => cells::rows_of(family, setting, forms, cancel),
            Work::Mesh(kind) => mesh_rays::rows_of(family, kind, setting, forms, cancel),
            Work::Spawned => spawned::rows_of(family, setting, forms, cancel),
            Work::Metamorphic(transform) => {
                metamorphic::rows_of(family, transform, setting, forms, cancel)
            }
        }
    }
}
