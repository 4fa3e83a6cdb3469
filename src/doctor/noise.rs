//! The A/A noise floor: what identical code is seen to differ by.

use super::ward::{DoctorError, Ward, measure};
use crate::experiment::Bench;
use crate::measure::{Order, Role};
use crate::stats::median;

/// What identical code differs by in one order, as relative differences.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Noise {
    /// Largest ratio of a copy to the reference over all groups: chance and code placement.
    pub floor: f64,
    /// Median half-width of the intervals of these ratios: chance alone.
    pub half_width: f64,
    /// Rounds that were disturbed, as a share of all.
    pub dirty_share: f64,
    /// How far the slowest tenth of the chain's blocks lies above its fastest, which need the same
    /// cycles: what the clock speed and the neighbours do.
    pub chain_spread: f64,
}

/// Measures `groups` groups of the reference and its copies; `None` if cancelled before the first.
///
/// # Errors
/// When the reference cannot be measured.
pub fn noise(
    order: Order,
    groups: u64,
    bench: &mut Bench<'_>,
) -> Result<Option<Noise>, DoctorError> {
    let ward = Ward::new(order)?;
    let (mut ends, mut widths, mut chain) = (Vec::new(), Vec::new(), Vec::new());
    let (mut clean, mut dirty) = (0, 0);
    for seed in 0..groups {
        let report = measure(&mut ward.group(None)?, order, seed, bench)?;
        clean += report.rounds;
        dirty += report.dirty_rounds;
        for figures in report.figures {
            match figures.role {
                Role::Placebo => {
                    let Some(ratio) = figures.ratio_to_reference else { continue };
                    ends.push(ratio.estimate.ln().abs().exp_m1());
                    widths.push((ratio.high / ratio.low).ln() / 2.0);
                }
                Role::Chain => chain.extend(figures.samples),
                _ => {}
            }
        }
    }
    let Some(half_width) = median(&widths) else { return Ok(None) };
    chain.sort_by(f64::total_cmp);
    let ninth = chain.get(chain.len() * 9 / 10).zip(chain.first());
    Ok(Some(Noise {
        floor: ends.into_iter().fold(0.0, f64::max),
        half_width,
        dirty_share: dirty as f64 / (clean + dirty).max(1) as f64,
        chain_spread: ninth.map_or(0.0, |(slow, fast)| slow / fast - 1.0),
    }))
}
