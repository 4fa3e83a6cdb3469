//! Answers against the exact ones, without a clock: random pairs, stiff families, closed meshes.

use super::entrant::Entrant;
use crate::accuracy::{Judgement, Truth, judge};
use crate::job::Answer;
use crate::number::Precision;
use crate::oracle::Query;
use crate::spread::on_all_cores;
use crate::stability::{
    Draw, Family, Leaks, Mesh, MeshKind, Range, RayClass, Work, fails, families, found,
};
use crate::workload::{PairSpec, Pairs, QueryKind, WorkloadError};

/// Random pairs for every case of a setting: they are cheap, for their answers are told in f64.
const PAIRS_PER_CASE: usize = 10;

/// What was found of one entrant.
#[derive(Clone, Debug)]
pub struct Examination {
    /// The entrant's id.
    pub id: String,
    /// Random pairs of which half hit, none so near to an edge that rounding could decide it: any
    /// wrong decision is a fault of the kernel.
    pub pairs: Judgement,
    /// The families of single stiff or extreme cases, in their order.
    pub families: Vec<FamilyFound>,
    /// Rays at closed meshes, by what they are aimed at.
    pub meshes: Vec<MeshFound>,
}

/// What was found at a family's settings together.
#[derive(Clone, Debug, PartialEq)]
pub struct FamilyFound {
    /// The family's id.
    pub family: &'static str,
    /// What its knob is, with its unit.
    pub knob: &'static str,
    /// Cases in all.
    pub cases: u64,
    /// Hits that were reported.
    pub hits: u64,
    /// The first setting at which the kernel fails, by the rule of `ray_test stability`: errors above
    /// 1e-3 (f32) or 1e-9 (f64) in one hit of a hundred, or more than one decision in a thousand deep
    /// in the wrong. `None` where it never does, and in families without settings that get harder.
    pub knee: Option<f64>,
    /// Whether the settings get harder, so that there can be a knee.
    pub has_knee: bool,
    /// Decisions deep in the wrong.
    pub deep: u64,
    /// Hits with an output that is NaN or infinite, or of input that is.
    pub not_finite: u64,
}

/// What became of rays that exactly leave a closed mesh in one point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MeshFound {
    /// What they are aimed at: `random`, `edge`, `vertex`, `exact edge`, `exact vertex`.
    pub class: &'static str,
    /// Rays.
    pub rays: u64,
    /// Rays that no triangle was hit by: leaks.
    pub lost: u64,
    /// Rays that several triangles were hit by.
    pub doubled: u64,
}

/// One piece of the work: a setting of a family's knob.
struct Setting {
    family: usize,
    precision: Precision,
    knob: f64,
    class: Option<RayClass>,
}

/// What one entrant did at a setting.
struct Met {
    setting: usize,
    entrant: usize,
    fails: bool,
    deep: u64,
    not_finite: u64,
    cases: u64,
    hits: u64,
    leaks: Leaks,
}

impl Met {
    fn of_rays(setting: usize, entrant: usize, leaks: Leaks) -> Self {
        let Leaks { rays: cases, hits, non_finite: not_finite, .. } = leaks;
        Met { setting, entrant, fails: false, deep: 0, not_finite, cases, hits, leaks }
    }
}

/// Examines entrants of one or both precisions on the same cases, on all cores: `cases` a setting (as
/// many rays a mesh), ten times as many random pairs, all drawn from `seed`. 100 take about a second,
/// 1000 are what `ray_test stability --depth quick` takes.
///
/// # Errors
/// `cases` that are none, or too many pairs.
pub fn examine(
    entrants: &[Entrant],
    cases: usize,
    seed: u64,
) -> Result<Vec<Examination>, WorkloadError> {
    let pairs = PairSpec {
        query: QueryKind::Ray,
        ..PairSpec::new(cases.saturating_mul(PAIRS_PER_CASE), 0.5, seed)
    };
    let truths = exact(&Pairs::draw(pairs)?);
    let families = families();
    let settings = settings(&families, entrants);
    let met: Vec<Met> = on_all_cores(settings.len(), |place| {
        let setting = &settings[place];
        at(place, setting, &families[setting.family], entrants, (cases, seed))
    })
    .into_iter()
    .flatten()
    .collect();
    let of = |(place, entrant): (usize, &Entrant)| {
        let answers: Vec<Answer> = truths.iter().map(|truth| (entrant.ask)(&truth.query)).collect();
        let met: Vec<&Met> = met.iter().filter(|one| one.entrant == place).collect();
        Examination {
            id: entrant.id.clone(),
            pairs: judge(&answers, &truths, entrant.reported()),
            families: of_families(&families, &settings, &met),
            meshes: of_meshes(&settings, &met),
        }
    };
    Ok(entrants.iter().enumerate().map(of).collect())
}

/// The exact answers to pairs.
pub(super) fn exact(pairs: &Pairs) -> Vec<Truth> {
    pairs.rays.iter().zip(&pairs.triangles).map(|(ray, one)| Truth::of(ray, one)).collect()
}

/// The settings of single cases and of meshes. Rays off surfaces and transformed cases need more than
/// one answer at a time, and are left to `ray_test stability`.
fn settings(families: &[Family], entrants: &[Entrant]) -> Vec<Setting> {
    let mut settings = Vec::new();
    let of = |precision: &Precision| entrants.iter().any(|one| one.precision == *precision);
    for precision in Precision::ALL.into_iter().filter(of) {
        for (family, about) in families.iter().enumerate() {
            let classes: Vec<Option<RayClass>> = match about.work {
                Work::Aimed(_) | Work::Free(_) => vec![None],
                Work::Mesh(kind) => RayClass::of(kind).iter().copied().map(Some).collect(),
                Work::Spawned | Work::Metamorphic(_) => Vec::new(),
            };
            for class in classes {
                let knobs = (about.knobs)(precision).into_iter();
                settings.extend(knobs.map(|knob| Setting { family, precision, knob, class }));
            }
        }
    }
    settings
}

/// What every entrant of the precision does at a setting.
fn at(
    place: usize,
    setting: &Setting,
    family: &Family,
    entrants: &[Entrant],
    (cases, seed): (usize, u64),
) -> Vec<Met> {
    let (knob, precision) = (setting.knob, setting.precision);
    let asked = entrants.iter().enumerate().filter(|(_, one)| one.precision == precision);
    let met = |entrant: usize, leaks: Leaks| Met::of_rays(place, entrant, leaks);
    if let (Work::Mesh(kind), Some(class)) = (&family.work, setting.class) {
        let purpose = format!("{} {}", family.id, class.word());
        let draw = Draw::new(seed, &purpose, knob, precision);
        let asks: Vec<fn(&Query) -> Answer> = asked.clone().map(|(_, one)| one.ask).collect();
        let leaks = shoot(*kind, class, knob, draw, cases, &asks);
        return asked.zip(leaks).map(|((entrant, _), leaks)| met(entrant, leaks)).collect();
    }
    let mut draw = Draw::new(seed, family.id, knob, precision);
    let cases = family.cases(&mut draw, knob, cases, false);
    let one = |(entrant, of): (usize, &Entrant)| {
        let found = found(of.ask, false, of.reported(), &cases);
        let accuracy = &found.accuracy;
        let deep = accuracy.deep_false_hits + accuracy.deep_false_misses;
        let errors = [accuracy.t_relative.p99, accuracy.barycentric.p99];
        Met {
            fails: fails(errors, deep, accuracy.cases, precision),
            deep,
            not_finite: accuracy.non_finite + found.hits_of_nothing,
            cases: accuracy.cases,
            hits: found.hits,
            ..met(entrant, Leaks::default())
        }
    };
    asked.map(one).collect()
}

/// Rays at a mesh, the same for all who are asked.
fn shoot(
    kind: MeshKind,
    class: RayClass,
    offset: f64,
    mut draw: Draw,
    rays: usize,
    asks: &[fn(&Query) -> Answer],
) -> Vec<Leaks> {
    let mesh = Mesh::new(kind, offset, draw.precision);
    let range = Range::new(&mesh, kind, class, &mut draw);
    let mut tallies = vec![Leaks::default(); asks.len()];
    for _ in 0..rays {
        let (query, aim, sees_all) = range.shot(&mut draw);
        let met = range.met(&query, &aim, sees_all);
        if met.is_one {
            for (ask, tally) in asks.iter().zip(&mut tallies) {
                tally.add(range.hits(*ask, &query, &met));
            }
        }
    }
    tallies
}

fn of_families(families: &[Family], settings: &[Setting], met: &[&Met]) -> Vec<FamilyFound> {
    let of = |(place, family): (usize, &Family)| {
        let mine: Vec<&&Met> =
            met.iter().filter(|one| settings[one.setting].family == place).collect();
        let single = matches!(family.work, Work::Aimed(_) | Work::Free(_));
        let first = mine.iter().find(|one| one.fails && family.has_knee());
        (single && !mine.is_empty()).then(|| FamilyFound {
            family: family.id,
            knob: family.knob,
            cases: mine.iter().map(|one| one.cases).sum(),
            hits: mine.iter().map(|one| one.hits).sum(),
            knee: first.map(|one| settings[one.setting].knob),
            has_knee: family.has_knee(),
            deep: mine.iter().map(|one| one.deep).sum(),
            not_finite: mine.iter().map(|one| one.not_finite).sum(),
        })
    };
    families.iter().enumerate().filter_map(of).collect()
}

fn of_meshes(settings: &[Setting], met: &[&Met]) -> Vec<MeshFound> {
    let of = |class: RayClass| {
        let mine = met.iter().filter(|one| settings[one.setting].class == Some(class));
        let sum = mine.map(|one| one.leaks).fold(Leaks::default(), Leaks::plus);
        let Leaks { rays, leaks: lost, doubles: doubled, .. } = sum;
        (rays > 0).then(|| MeshFound { class: class.word(), rays, lost, doubled })
    };
    RayClass::ALL.into_iter().filter_map(of).collect()
}
