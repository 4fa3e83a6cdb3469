//! Times beside the reference, by the protocol of every experiment.

use super::entrant::Entrant;
use super::examine::exact;
use crate::accuracy::{Judgement, Truth, judge};
use crate::job::Answer;
use crate::measure::{
    Contestant, Figures, GroupReport, MOST_SUBJECTS, Order, PLACEBOS, Protocol, ProtocolError,
    Role, Surroundings, measure_group, yardsticks,
};
use crate::number::Precision;
use crate::registry::{self, Variant};
use crate::stats::{Ratio, paired_ratio};
use crate::workload::{PairSpec, Pairs, QueryKind, WorkloadError};

/// Pairs beyond those that are timed, on which kernels of one's own are judged: a triangle that is
/// taken for larger by a hundredth changes one answer in two hundred, which 500 pairs may miss.
const OTHERS: usize = 10_000;
/// What is added to the seed for them.
const ANOTHER_SEED: u64 = 1 << 32;

/// Why nothing was measured.
#[derive(Debug, thiserror::Error)]
pub enum OwnError {
    /// A kernel of ours that there is not.
    #[error(
        "{kernel}: no kernel with a usual form for pairs in {}; allowed: {}",
        precision.name(),
        crate::check::kernels().join(", ")
    )]
    Unknown {
        /// The word.
        kernel: String,
        /// The precision that was asked for.
        precision: Precision,
    },
    /// More than a group can hold.
    #[error("{0} entrants are too many for one group; allowed: 1 to {MOST_SUBJECTS}")]
    TooMany(usize),
    /// The reference is not there, or this processor has not its level.
    #[error("the reference kernel cannot be measured here")]
    NoReference,
    /// Pairs cannot be drawn.
    #[error(transparent)]
    Workload(#[from] WorkloadError),
    /// The group cannot be measured.
    #[error(transparent)]
    Protocol(#[from] ProtocolError),
}

/// What came of one entrant.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Its id.
    pub id: String,
    /// Its answers against the exact ones: those to the pairs that are timed, by the very function that
    /// is timed; or, where only those to other pairs are wrong, to these.
    pub judgement: Judgement,
    /// What it took; `None` if it was wrong, or its level is not there.
    pub figures: Option<Figures>,
}

/// What came of a contest.
#[derive(Clone, Debug)]
pub struct Outcome {
    /// In the order of the entrants.
    pub entries: Vec<Entry>,
    /// Id of the reference that ratios are to.
    pub reference: String,
    /// The order of the items.
    pub order: Order,
    /// The group with its controls.
    pub report: GroupReport,
}

impl Outcome {
    /// Time of one contestant over that of another in the same round (above 1 is slower), with the
    /// exact 95 % interval of its median; `None` unless both have six rounds or more.
    pub fn ratio(&self, id: &str, to: &str) -> Option<Ratio> {
        let samples = |id: &str| {
            let found = self.report.figures.iter().find(|figures| figures.id == id);
            found.map(|figures| &figures.samples[..])
        };
        paired_ratio(samples(id)?, samples(to)?)
    }
}

/// Measures entrants on random pairs of which half hit, 500 of them, or 1000 where they are
/// reshuffled, drawn from the protocol's seed. What is wrong about one of them, or one's own about one
/// of 10 000 others, by more than rounding explains, is not timed. Beside them run Moeller and Trumbore's test in f32 as the reference, copies
/// of it whose differences tell the noise, an empty loop, and a chain of known cycles.
///
/// # Errors
/// Entrants or a protocol that cannot be measured; nothing was timed then.
pub fn contest(
    entrants: &[Entrant],
    protocol: &Protocol,
    surroundings: &mut Surroundings<'_>,
) -> Result<Outcome, OwnError> {
    if entrants.is_empty() || entrants.len() > MOST_SUBJECTS {
        return Err(OwnError::TooMany(entrants.len()));
    }
    let pairs = drawn(timed_pairs(protocol.order), protocol.seed)?;
    let others = exact(&drawn(OTHERS, protocol.seed.wrapping_add(ANOTHER_SEED))?);
    let truths = exact(&pairs);
    let mut entries = Vec::new();
    let mut contestants = Vec::new();
    for entrant in entrants {
        let (mut judgement, contestant) = judged(entrant, Role::Subject, &pairs, &truths);
        let elsewhere = entrant.is_own().then(|| judged_elsewhere(entrant, &others)).flatten();
        match elsewhere.filter(|_| contestant.is_some()) {
            Some(wrong) => judgement = wrong,
            None => contestants.extend(contestant),
        }
        entries.push(Entry { id: entrant.id.clone(), judgement, figures: None });
    }
    let reference = add_controls(&mut contestants, &pairs, &truths)?;
    let report = measure_group(&mut contestants, protocol, surroundings)?;
    for entry in &mut entries {
        let mine = report.figures.iter().find(|figures| figures.id == entry.id);
        entry.figures = mine.cloned();
    }
    Ok(Outcome { entries, reference, order: protocol.order, report })
}

fn timed_pairs(order: Order) -> usize {
    if order == Order::Reshuffled { 1000 } else { 500 }
}

fn drawn(count: usize, seed: u64) -> Result<Pairs, WorkloadError> {
    Pairs::draw(PairSpec { query: QueryKind::Ray, ..PairSpec::new(count, 0.5, seed) })
}

/// What is wrong with the answers to pairs that are not timed; `None` if nothing is.
fn judged_elsewhere(entrant: &Entrant, others: &[Truth]) -> Option<Judgement> {
    let answers: Vec<Answer> = others.iter().map(|truth| (entrant.ask)(&truth.query)).collect();
    let judgement = judge(&answers, others, entrant.reported());
    let wrong = judgement.wrong.map(|reason| format!("of {OTHERS} other pairs, {reason}"))?;
    Some(Judgement { wrong: Some(wrong), ..judgement })
}

/// Judges an entrant; a contestant only if it is not wrong.
fn judged(
    entrant: &Entrant,
    role: Role,
    pairs: &Pairs,
    truths: &[Truth],
) -> (Judgement, Option<Contestant>) {
    let Some(mut job) = entrant.job(&pairs.rays, &pairs.triangles) else {
        return (Judgement::default(), None);
    };
    let answers = job.answers();
    let judgement = judge(&answers, truths, entrant.reported());
    let hits = answers.iter().filter(|answer| answer.triangle.is_some()).count() as u64;
    let is_right = judgement.wrong.is_none() || !entrant.claims_exactness();
    let contestant = is_right.then(|| Contestant::new(&entrant.id, role, job).with_hits(hits));
    (judgement, contestant)
}

/// Adds the reference, unless it is an entrant itself, its copies, the empty loop and the chain; the
/// reference's id.
fn add_controls(
    contestants: &mut Vec<Contestant>,
    pairs: &Pairs,
    truths: &[Truth],
) -> Result<String, OwnError> {
    let reference = Entrant::ours("moller-trumbore", Precision::F32)?;
    if let Some(own) = contestants.iter_mut().find(|one| one.id == reference.id) {
        own.role = Role::Reference;
    } else {
        let (_, contestant) = judged(&reference, Role::Reference, pairs, truths);
        contestants.push(contestant.ok_or(OwnError::NoReference)?);
    }
    let original = registry::find(&reference.id).ok_or(OwnError::NoReference)?;
    let is_copy = |copy: &&Variant| copy.is_copy_of(original);
    for copy in registry::placebos().iter().filter(is_copy).take(PLACEBOS) {
        let Some(copy) = Entrant::of(copy, Precision::F32) else { continue };
        contestants.extend(judged(&copy, Role::Placebo, pairs, truths).1);
    }
    let yardsticks = contestants.first().map(|first| yardsticks(first.job.as_ref()));
    contestants.extend(yardsticks.into_iter().flatten());
    Ok(reference.id)
}
