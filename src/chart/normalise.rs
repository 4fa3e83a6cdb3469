//! Values divided by that of one series, so that figures of different machines share an axis.

use super::ChartError;
use super::select::{Point, distinct};

/// Divides ours and the published points, which may be none, each by their own.
pub(super) fn normalise_both(
    ours: &mut [Point],
    theirs: &mut [Point],
    base: &str,
) -> Result<String, ChartError> {
    let first = normalise(ours, base)?;
    if !theirs.is_empty() {
        normalise(theirs, base)?;
    }
    Ok(first)
}

/// Divides the points of each panel by that of series `base` at its first x: the smallest number,
/// or the first category. Returns the name of that x.
fn normalise(points: &mut [Point], base: &str) -> Result<String, ChartError> {
    let mut first_x = String::new();
    for panel in distinct(points, |point| &point.panel) {
        let candidates = points.iter().filter(|point| point.panel == panel && point.series == base);
        let first = candidates.reduce(|first, next| match (first.x_number(), next.x_number()) {
            (Some(a), Some(b)) if b < a => next,
            _ => first,
        });
        let Some((unit, x)) = first.map(|point| (point.y, point.x.clone())) else {
            return Err(ChartError::Nothing(format!("there is no value of {base} to divide by")));
        };
        if unit == 0.0 {
            return Err(ChartError::Nothing(format!("the value of {base} to divide by is zero")));
        }
        points
            .iter_mut()
            .filter(|point| point.panel == panel)
            .for_each(|point| scale(point, 1.0 / unit));
        first_x = x;
    }
    Ok(first_x)
}

/// Multiplies a point and its interval.
pub(super) fn scale(point: &mut Point, factor: f64) {
    point.y *= factor;
    point.interval = point.interval.map(|(low, high)| {
        let (a, b) = (low * factor, high * factor);
        (a.min(b), a.max(b))
    });
}
