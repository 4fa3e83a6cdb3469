//! The self-test: do the verdicts hold what they promise, on this machine, now?

use super::slowed::Slowed;
use super::ward::{DoctorError, Ward, measure};
use crate::experiment::Bench;
use crate::measure::{Contestant, GroupReport, Order, Role};
use crate::stats::Verdict;
use std::sync::atomic::Ordering as Atomic;

/// Comparisons of the reference with a copy of itself.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AaTrials {
    /// Comparisons made.
    pub comparisons: u64,
    /// Verdicts `faster` or `slower`: false alarms.
    pub different: u64,
    /// Verdicts `same`.
    pub same: u64,
    /// Largest ratio seen, as a relative difference.
    pub largest: f64,
}

/// Compares the reference with each of its copies in turn, the other copies being the placebos
/// that tell the noise, `comparisons` times or until cancelled.
///
/// # Errors
/// When the reference cannot be measured.
pub fn aa_trials(
    order: Order,
    comparisons: u64,
    bench: &mut Bench<'_>,
    mut tell: impl FnMut(u64),
) -> Result<AaTrials, DoctorError> {
    let ward = Ward::new(order)?;
    let mut trials = AaTrials::default();
    for trial in 0..comparisons {
        if bench.cancel.load(Atomic::Relaxed) {
            break;
        }
        let subject = trial as usize % ward.copies().max(1);
        let report = measure(&mut ward.group(Some(subject))?, order, trial, bench)?;
        let judged = report.figures.iter().find(|figures| figures.role == Role::Subject);
        let Some((ratio, decision)) =
            judged.and_then(|figures| figures.ratio_to_reference.zip(figures.decision))
        else {
            continue;
        };
        trials.comparisons += 1;
        trials.largest = trials.largest.max(ratio.estimate.ln().abs().exp_m1());
        match decision.verdict {
            Verdict::Faster | Verdict::Slower => trials.different += 1,
            Verdict::Same => trials.same += 1,
            Verdict::Unresolved { .. } => {}
        }
        tell(trial + 1);
    }
    Ok(trials)
}

/// One comparison of the reference with itself made slower.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InjectedTrial {
    /// Whether the verdict was `slower`.
    pub found: bool,
    /// The slow-down as measured, as a share.
    pub size: f64,
    /// The slow-down as injected: the cycles added over those that the reference took in this trial.
    pub injected: f64,
    /// Whether somebody else computed on the core to the end: the reference then takes other cycles
    /// than it took in the trial before, so that what was injected is not what was asked for.
    pub crowded: bool,
}

/// Comparisons with a kernel that does a known share of work more.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InjectedTrials {
    /// The share asked for, 0.02 for 2 %.
    pub share: f64,
    /// One after the other.
    pub trials: Vec<InjectedTrial>,
}

impl InjectedTrials {
    /// How many were found.
    pub fn found(&self) -> usize {
        self.trials.iter().filter(|trial| trial.found).count()
    }

    /// How many were found with a size within `error` of what was injected.
    pub fn sized_within(&self, error: f64) -> usize {
        let right =
            |trial: &&InjectedTrial| trial.found && (trial.size - trial.injected).abs() <= error;
        self.trials.iter().filter(right).count()
    }

    /// How many had a neighbour on the core to the end.
    pub fn crowded(&self) -> usize {
        self.trials.iter().filter(|trial| trial.crowded).count()
    }
}

/// Compares the reference with itself made slower by `share`, `trials` times or until cancelled, in
/// order `fixed`. The work added is a chain of known cycles, as many as the share makes of the
/// cycles that the reference took in the trial before.
///
/// # Errors
/// When the reference cannot be measured.
pub fn injected_trials(
    share: f64,
    trials: u64,
    bench: &mut Bench<'_>,
    mut tell: impl FnMut(u64),
) -> Result<InjectedTrials, DoctorError> {
    let ward = Ward::new(Order::Fixed)?;
    let mut found = InjectedTrials { share, trials: Vec::new() };
    let plain = measure(&mut ward.group(None)?, Order::Fixed, trials, bench)?;
    let mut cycles = reference_cycles(&plain);
    for trial in 0..trials {
        if bench.cancel.load(Atomic::Relaxed) {
            break;
        }
        let Some(before) = cycles else { return Err(DoctorError::NoReference) };
        let mut group = ward.group(None)?;
        let plain = ward.reference(Role::Subject)?;
        let job = Box::new(Slowed::new(plain.job, share * before));
        group.push(Contestant { id: "slowed".to_owned(), job, ..plain });
        let report = measure(&mut group, Order::Fixed, trial, bench)?;
        let now = reference_cycles(&report);
        found.trials.extend(trial_of(&report, share * before, now.unwrap_or(before)));
        cycles = now.or(cycles);
        tell(trial + 1);
    }
    Ok(found)
}

/// What a trial tells whose last contestant was given so many cycles more a test than the reference,
/// which took `reference` cycles.
fn trial_of(report: &GroupReport, added: f64, reference: f64) -> Option<InjectedTrial> {
    let slowed = report.figures.last()?;
    let (ratio, decision) = slowed.ratio_to_reference.zip(slowed.decision)?;
    Some(InjectedTrial {
        found: decision.verdict == Verdict::Slower,
        size: ratio.estimate - 1.0,
        injected: added / reference,
        crowded: report.crowded_share > 0.0,
    })
}

fn reference_cycles(report: &GroupReport) -> Option<f64> {
    let reference = report.figures.iter().find(|figures| figures.role == Role::Reference);
    reference.and_then(|figures| figures.cycles_per_test)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn found_and_sized() {
        let trial = |found, size, injected| InjectedTrial {
            found,
            size,
            injected,
            crowded: injected < 0.02,
        };
        // The second is far from what was asked for, but not from what was injected.
        let trials = vec![
            trial(true, 0.021, 0.02),
            trial(true, 0.0155, 0.014),
            trial(true, 0.0295, 0.02),
            trial(false, 0.02, 0.02),
        ];
        let injected = InjectedTrials { share: 0.02, trials };
        assert_eq!((injected.found(), injected.sized_within(0.003), injected.crowded()), (3, 2, 1));
    }
}
