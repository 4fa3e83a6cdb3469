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

/// Comparisons with a kernel that does a known share of work more.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct InjectedTrials {
    /// The share, 0.02 for 2 %.
    pub share: f64,
    /// Verdict `slower`, and by how much, one a trial.
    pub trials: Vec<(bool, f64)>,
}

impl InjectedTrials {
    /// How many were found.
    pub fn found(&self) -> usize {
        self.trials.iter().filter(|(found, _)| *found).count()
    }

    /// How many were found with a size within `error` of the truth.
    pub fn sized_within(&self, error: f64) -> usize {
        let right = |(found, size): &&(bool, f64)| *found && (size - self.share).abs() <= error;
        self.trials.iter().filter(right).count()
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
        let slowed = report.figures.last();
        if let Some((ratio, decision)) =
            slowed.and_then(|figures| figures.ratio_to_reference.zip(figures.decision))
        {
            let slower = decision.verdict == Verdict::Slower;
            found.trials.push((slower, ratio.estimate - 1.0));
        }
        cycles = reference_cycles(&report).or(cycles);
        tell(trial + 1);
    }
    Ok(found)
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
        let trials = vec![(true, 0.021), (true, 0.0295), (false, 0.02)];
        let injected = InjectedTrials { share: 0.02, trials };
        assert_eq!((injected.found(), injected.sized_within(0.003)), (2, 1));
    }
}
