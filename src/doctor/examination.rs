//! Everything that is asked of a machine.

use super::noise::{Noise, noise};
use super::predictor::{Predictor, predictor};
use super::ward::DoctorError;
use crate::experiment::Bench;
use crate::measure::{Interference, Order};
use std::sync::atomic::Ordering as Atomic;

/// Groups of the reference and its copies in each order.
const GROUPS: u64 = 8;

/// What was found.
#[derive(Clone, Debug, Default)]
pub struct Examination {
    /// Noise in each order that was reached before it was cancelled.
    pub noise: Vec<(Order, Noise)>,
    /// The predictor's memory.
    pub predictor: Option<Predictor>,
    /// What else the machine did meanwhile.
    pub interference: Interference,
}

impl Examination {
    /// Examines this machine; about two seconds.
    ///
    /// # Errors
    /// When the reference kernel cannot be measured.
    pub fn of_this_machine(bench: &mut Bench<'_>) -> Result<Self, DoctorError> {
        let before = Interference::now();
        let mut found = Examination::default();
        for order in [Order::Literal, Order::Fixed, Order::Reshuffled] {
            if let Some(noise) = noise(order, GROUPS, bench)? {
                found.noise.push((order, noise));
            }
        }
        if !bench.cancel.load(Atomic::Relaxed) {
            found.predictor = Some(predictor(bench)?);
        }
        found.interference = Interference::now().since(&before);
        Ok(found)
    }

    /// The noise in an order.
    pub fn noise(&self, order: Order) -> Option<Noise> {
        self.noise.iter().find(|(of, _)| *of == order).map(|(_, noise)| *noise)
    }

    /// The smallest relative difference that can be told in every order.
    pub fn noise_floor(&self) -> Option<f64> {
        self.noise.iter().map(|(_, noise)| noise.floor.max(noise.half_width)).reduce(f64::max)
    }
}
