//! How straight a row of figures is.

use super::estimate::Estimate;
use super::lack::Lack;

/// Most figures of a row; two to this power ends are looked at.
const MOST: usize = 16;

/// The share of the variance of figures over `x` that the straight line of least squares explains.
///
/// It is the squared cosine between the figures and `x`, both without their means. Where the cosine is
/// positive it is quasi-concave (the figures with at least some cosine are a convex cone), so its least
/// value within the intervals is at their ends, and all ends are tried. Its largest is bounded by the
/// least distance of the intervals to any straight line, over the largest variance within them.
///
/// # Errors
/// Fewer than three figures, more than 16, or figures that may all be equal.
pub fn r_squared(x: &[f64], figures: &[Estimate]) -> Result<Estimate, Lack> {
    if !(3..=MOST).contains(&figures.len()) {
        return Err(Lack::new(format!("r2 needs from 3 to {MOST} figures")));
    }
    let values: Vec<f64> = figures.iter().map(|figure| figure.value).collect();
    let value = cosine(x, &values).map(|cosine| cosine * cosine);
    let lack = || Lack::new("r2: the figures are all the same");
    let value = value.ok_or_else(lack)?;
    if figures.iter().all(Estimate::is_exact) {
        return Ok(Estimate::exact(value));
    }
    // A falling line is a rising one the other way round.
    let sign = cosine(x, &values).unwrap_or(0.0).signum();
    let mut least = f64::INFINITY;
    for ends in 0..1usize << figures.len() {
        let corner: Vec<f64> = figures
            .iter()
            .enumerate()
            .map(|(place, figure)| if ends >> place & 1 == 0 { figure.low } else { figure.high })
            .collect();
        least = least.min(cosine(x, &corner).unwrap_or(0.0) * sign);
    }
    let low = least.max(0.0).powi(2).min(value);
    Ok(Estimate { value, low, high: most(x, figures, &values).max(value) })
}

/// Cosine of the angle between both, without their means.
fn cosine(x: &[f64], y: &[f64]) -> Option<f64> {
    let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
    let (mx, my) = (mean(x), mean(y));
    let sum = |f: &dyn Fn(f64, f64) -> f64| -> f64 {
        x.iter().zip(y).map(|(x, y)| f(x - mx, y - my)).sum()
    };
    let found = sum(&|x, y| x * y) / (sum(&|x, _| x * x) * sum(&|_, y| y * y)).sqrt();
    found.is_finite().then_some(found.clamp(-1.0, 1.0))
}

/// An upper bound of the share that is explained.
fn most(x: &[f64], figures: &[Estimate], values: &[f64]) -> f64 {
    let mean = values.iter().sum::<f64>() / values.len() as f64;
    let farthest = |figure: &Estimate| (figure.low - mean).abs().max((figure.high - mean).abs());
    let variance: f64 = figures.iter().map(|figure| farthest(figure).powi(2)).sum();
    // Turn by turn the nearest line, and the figures within their intervals that are nearest to it: the
    // distance of two convex sets, from above. The last step's change bounds what is left.
    let mut inside = values.to_vec();
    let mut distance = f64::INFINITY;
    for _ in 0..1000 {
        let line = line(x, &inside);
        for ((place, figure), on_line) in inside.iter_mut().zip(figures).zip(&line) {
            *place = on_line.clamp(figure.low, figure.high);
        }
        let found: f64 = inside.iter().zip(&line).map(|(a, b)| (a - b).powi(2)).sum();
        if found >= distance * (1.0 - 1e-6) {
            break;
        }
        distance = found;
    }
    1.0 - (distance * (1.0 - 1e-3) / variance).min(1.0)
}

/// The straight line of least squares, at every `x`.
fn line(x: &[f64], y: &[f64]) -> Vec<f64> {
    let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
    let (mx, my) = (mean(x), mean(y));
    let square: f64 = x.iter().map(|x| (x - mx) * (x - mx)).sum();
    let both: f64 = x.iter().zip(y).map(|(x, y)| (x - mx) * (y - my)).sum();
    let slope = if square > 0.0 { both / square } else { 0.0 };
    x.iter().map(|x| my + slope * (x - mx)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const X: [f64; 4] = [0.0, 1.0, 2.0, 3.0];

    fn with(half_width: f64, values: [f64; 4]) -> Vec<Estimate> {
        let of = |value| Estimate { value, low: value - half_width, high: value + half_width };
        values.map(of).to_vec()
    }

    #[test]
    fn known_shares() {
        let line = r_squared(&X, &with(0.0, [1.0, 3.0, 5.0, 7.0])).expect("a line");
        assert!((line.value - 1.0).abs() < 1e-12);
        // Sums of squares: 5 of x, 5 of y, 4 of both, so 16 / 25.
        let bent = r_squared(&X, &with(0.0, [0.0, 2.0, 1.0, 3.0])).expect("four");
        assert!((bent.value - 0.64).abs() < 1e-12);
        let falling = r_squared(&X, &with(0.0, [3.0, 1.0, 2.0, 0.0])).expect("four");
        assert!((falling.value - 0.64).abs() < 1e-12);
    }

    #[test]
    fn ends_contain_what_the_intervals_allow() {
        let figures = with(0.25, [0.0, 2.0, 1.0, 3.0]);
        let found = r_squared(&X, &figures).expect("four");
        // Ten thousand places within the intervals, by a simple congruence.
        let mut state = 1u64;
        for _ in 0..10_000 {
            let inside: Vec<Estimate> = figures
                .iter()
                .map(|figure| {
                    state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                    let share = (state >> 11) as f64 * (-53f64).exp2();
                    Estimate::exact(figure.low + share * (figure.high - figure.low))
                })
                .collect();
            let one = r_squared(&X, &inside).expect("four").value;
            assert!(found.low <= one && one <= found.high, "{one} {found:?}");
        }
        // The ends themselves: 2.25 and 0.75 in the middle, 0.25 and 2.75 outside.
        assert!(found.low < 0.45 && found.high < 0.95, "{found:?}");
    }

    #[test]
    fn a_wide_interval_allows_a_line_and_nothing_at_all() {
        let found = r_squared(&X, &with(2.0, [0.0, 2.0, 1.0, 3.0])).expect("four");
        assert!(found.low == 0.0 && found.high > 0.99, "{found:?}");
    }

    #[test]
    fn what_has_no_share() {
        assert!(r_squared(&X[..2], &with(0.0, [0.0; 4])[..2]).is_err());
        assert!(r_squared(&X, &with(0.0, [1.0; 4])).is_err());
    }
}
