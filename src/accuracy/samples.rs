//! The errors of hits, collected and summed up.

use super::case::Case;
use super::deviation::Deviation;
use super::quantiles::Sorted;
use super::reported::Reported;
use super::summary::Accuracy;
use crate::job::Answer;
use crate::number::Precision;

/// A value for every hit that is compared, in no particular order.
#[derive(Clone, Debug, Default)]
pub(super) struct Samples {
    t_relative: Vec<f64>,
    u_relative: Vec<f64>,
    v_relative: Vec<f64>,
    t_bits: Vec<f64>,
    uv_bits: Vec<f64>,
    t_ulp: Vec<f64>,
    u: Vec<f64>,
    v: Vec<f64>,
    barycentric: Vec<f64>,
    backward: Vec<f64>,
    t_excess: Vec<f64>,
    barycentric_excess: Vec<f64>,
}

impl Samples {
    /// Takes in a hit.
    pub fn take(
        &mut self,
        case: &Case<'_>,
        answer: &Answer,
        deviation: &Deviation,
        (reported, precision): (Reported, Precision),
    ) {
        let exact = case.exact;
        let [t_bits, u_bits, v_bits] = Deviation::bits_lost(case, answer, precision);
        let (t_excess, weight_excess) = deviation.excess(case, reported.unit_roundoff);
        let t = deviation.t.abs();
        if reported.t {
            self.t_bits.push(t_bits);
        }
        if reported.t && t.is_finite() {
            self.t_relative.push(relative(t, exact.t));
            self.t_ulp.push(t / precision.ulp(exact.t, exact.t_lo));
            self.t_excess.push(t_excess);
        }
        if !reported.uv {
            return;
        }
        let (u, v) = (deviation.u.abs(), deviation.v.abs());
        self.uv_bits.extend([u_bits, v_bits]);
        if u.is_finite() && v.is_finite() {
            self.u_relative.push(relative(u, exact.u));
            self.v_relative.push(relative(v, exact.v));
            self.u.push(u);
            self.v.push(v);
            self.barycentric.push(deviation.barycentric());
            self.barycentric_excess.push(weight_excess);
        }
        if deviation.is_finite(reported) && reported.t {
            self.backward.push(deviation.backward(case, answer, reported.unit_roundoff));
        }
    }

    /// Takes in what another one has collected.
    pub fn append(&mut self, other: Samples) {
        self.t_relative.extend(other.t_relative);
        self.u_relative.extend(other.u_relative);
        self.v_relative.extend(other.v_relative);
        self.t_bits.extend(other.t_bits);
        self.uv_bits.extend(other.uv_bits);
        self.t_ulp.extend(other.t_ulp);
        self.u.extend(other.u);
        self.v.extend(other.v);
        self.barycentric.extend(other.barycentric);
        self.backward.extend(other.backward);
        self.t_excess.extend(other.t_excess);
        self.barycentric_excess.extend(other.barycentric_excess);
    }

    /// Completes what is known of the decisions.
    pub fn sum_up(self, decisions: Accuracy) -> Accuracy {
        let relative = [self.t_relative, self.u_relative, self.v_relative].map(Sorted::new);
        let [t_mean, u_mean, v_mean] = [0, 1, 2].map(|i| relative[i].mean());
        let mean = |t: f64, u: f64, v: f64| (t + u + v) / 3.0;
        let all = t_mean.zip(u_mean).zip(v_mean).map(|((t, u), v)| mean(t, u, v));
        let (t_bits, uv_bits) = (Sorted::new(self.t_bits), Sorted::new(self.uv_bits));
        let largest = |values: Vec<f64>| values.into_iter().reduce(f64::max);
        Accuracy {
            t_mean_relative: t_mean,
            u_mean_relative: u_mean,
            v_mean_relative: v_mean,
            mean_relative: all,
            max_relative: relative.iter().filter_map(Sorted::max).reduce(f64::max),
            t_bits_lost_mean: t_bits.mean(),
            t_bits_lost_max: t_bits.max(),
            uv_bits_lost_mean: uv_bits.mean(),
            uv_bits_lost_max: uv_bits.max(),
            t_ulp: Sorted::new(self.t_ulp).quantiles(),
            t_relative: relative[0].quantiles(),
            u_max: largest(self.u),
            v_max: largest(self.v),
            barycentric: Sorted::new(self.barycentric).quantiles(),
            backward: Sorted::new(self.backward).quantiles(),
            t_excess_max: largest(self.t_excess),
            barycentric_excess_max: largest(self.barycentric_excess),
            ..decisions
        }
    }
}

/// Relative error; infinite where the exact value is 0 and the computed one is not.
fn relative(error: f64, exact: f64) -> f64 {
    if error == 0.0 { 0.0 } else { error / exact.abs() }
}
