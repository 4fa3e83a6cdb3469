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
            .for_each(|point| divide(point, unit));
        first_x = x;
    }
    Ok(first_x)
}

/// Divides each point by that of series `base` in its panel at its x. Points without such a one are
/// taken out; returns how many.
pub(super) fn normalise_within_x(points: &mut Vec<Point>, base: &str) -> usize {
    let units: Vec<Point> =
        points.iter().filter(|point| point.series == base && point.y != 0.0).cloned().collect();
    let unit = |point: &Point| {
        units
            .iter()
            .find(|unit| (&unit.panel, &unit.x) == (&point.panel, &point.x))
            .map(|one| one.y)
    };
    let before = points.len();
    points.retain_mut(|point| unit(point).map(|unit| divide(point, unit)).is_some());
    before - points.len()
}

/// Multiplies a point and its interval.
pub(super) fn scale(point: &mut Point, factor: f64) {
    change(point, |value| value * factor);
}

/// Divides them: the unit itself becomes 1, which a product with its inverse need not be.
fn divide(point: &mut Point, unit: f64) {
    change(point, |value| value / unit);
}

fn change(point: &mut Point, of: impl Fn(f64) -> f64) {
    point.y = of(point.y);
    point.interval = point.interval.map(|(low, high)| {
        let (a, b) = (of(low), of(high));
        (a.min(b), a.max(b))
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    fn point(x: &str, series: &str, y: f64) -> Point {
        let (panel, x, series) = (String::new(), x.to_owned(), series.to_owned());
        Point { panel, x, series, y, interval: Some((y - 1.0, y + 1.0)) }
    }

    #[test]
    fn each_category_has_its_own_unit_or_goes() {
        let mut points = vec![
            point("old", "a", 20.0),
            point("old", "b", 30.0),
            point("new", "b", 3.0),
            point("new", "a", 4.0),
            point("other", "b", 1.0),
            point("zero", "a", 0.0),
        ];
        assert_eq!(normalise_within_x(&mut points, "a"), 2);
        let values: Vec<_> = points.iter().map(|point| (point.x.as_str(), point.y)).collect();
        assert_eq!(values, [("old", 1.0), ("old", 1.5), ("new", 0.75), ("new", 1.0)]);
        assert_eq!(points[2].interval, Some((0.5, 1.0)));
    }
}
