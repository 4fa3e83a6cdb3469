//! How much of a run goes into getting away from neighbours.

use std::time::Duration;

use crate::measure::Protocol;

/// What may still be run again because somebody else used the core. Once it is used up, what is
/// measured beside a neighbour stands, and is marked as such.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Patience {
    /// Groups that may be measured once more.
    pub groups: u32,
    /// Time for that, and for single blocks; `None` for as long as it takes.
    pub spare: Option<Duration>,
}

impl Patience {
    /// Of a run that takes what comes.
    pub const NONE: Self = Patience { groups: 0, spare: Some(Duration::ZERO) };

    /// So many groups again, and as many blocks as a protocol allows.
    pub fn groups(groups: u32) -> Self {
        Patience { groups, spare: None }
    }

    /// Adds what is granted for the next experiment to what the ones before left.
    pub fn grant(&mut self, spare: Duration) {
        self.spare = self.spare.map(|left| left.saturating_add(spare));
    }

    /// The protocol, with as many blocks to be run again as there is time for in this share of what is
    /// left, 0 to 1.
    pub fn limit(&self, protocol: &Protocol, share: f64) -> Protocol {
        let blocks = |left: Duration| {
            (left.mul_f64(share).as_nanos() / protocol.attempt_ns() as u128) as usize
        };
        let most_spare_blocks = self.spare.map_or(usize::MAX, blocks);
        Protocol { most_spare_blocks, ..protocol.clone() }
    }

    /// Takes the time off.
    pub fn spend(&mut self, time: Duration) {
        self.spare = self.spare.map(|left| left.saturating_sub(time));
    }

    /// Takes off a group that is to be measured again in this time; whether that is granted.
    pub fn take_group(&mut self, time: Duration) -> bool {
        let granted = self.groups > 0 && self.spare.is_none_or(|left| left >= time);
        if granted {
            self.groups -= 1;
            self.spend(time);
        }
        granted
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::Order;

    const MS: Duration = Duration::from_millis(1);

    #[test]
    fn what_is_left_of_one_experiment_is_for_the_next() {
        let mut patience = Patience { groups: 2, spare: Some(MS) };
        patience.spend(MS / 2);
        patience.grant(MS);
        assert_eq!(patience.spare, Some(MS * 3 / 2));
        patience.spend(2 * MS);
        assert_eq!(patience.spare, Some(Duration::ZERO));
        patience.grant(3 * MS);
        // There is time for one, then none for a long one, then none left in number.
        assert!(patience.take_group(MS) && !patience.take_group(3 * MS));
        assert!(patience.take_group(2 * MS) && patience.spare == Some(Duration::ZERO));
        patience.grant(MS);
        assert!(!patience.take_group(MS));
    }

    #[test]
    fn blocks_are_limited_by_the_time_that_is_left() {
        let protocol = Protocol::new(Order::Literal, 1);
        let attempts = |count: u64| Some(Duration::from_nanos(count * protocol.attempt_ns()));
        let patience = Patience { groups: 0, spare: attempts(8) };
        assert_eq!(patience.limit(&protocol, 1.0).spare_blocks(4), 8);
        assert_eq!(patience.limit(&protocol, 0.25).spare_blocks(4), 2);
        assert_eq!(Patience::NONE.limit(&protocol, 1.0).spare_blocks(4), 0);
        // Five quarters of 64 rounds of four blocks.
        assert_eq!(Patience::groups(1).limit(&protocol, 0.5).spare_blocks(4), 320);
    }

    #[test]
    fn without_a_limit_time_is_no_matter() {
        let mut patience = Patience::groups(1);
        patience.spend(MS);
        patience.grant(MS);
        assert_eq!(patience, Patience::groups(1));
        assert!(patience.take_group(MS) && !patience.take_group(MS));
    }
}
