//! What to do about it, in plain sentences.

use super::examination::Examination;
use crate::measure::{Environment, Order};

/// Dirty rounds beyond this share are worth a word: they are run again, so they cost time.
const MANY_DIRTY: f64 = 0.05;

/// A chain that wavers by more than this is worth a word: cycles then say more than time.
const WAVERING: f64 = 0.1;

/// Sentences on how small a difference this machine can see, and what would help; the first is the
/// answer.
pub fn advice(found: &Examination, environment: &Environment) -> Vec<String> {
    let mut sentences = vec![what_can_be_seen(found)];
    sentences.extend(of_the_predictor(found));
    if environment.counters.is_empty() {
        let reason = environment.counters_reason.as_deref().unwrap_or("the reason is not known");
        sentences.push(format!(
            "Cycles come from a chain of known length, since there are no hardware counters \
             ({reason})."
        ));
    }
    sentences.extend(of_disturbances(found));
    let powersave = environment.governor.as_deref().filter(|governor| *governor != "performance");
    if let Some(governor) = powersave {
        sentences.push(format!(
            "The clock speed is governed by '{governor}': 'performance' would keep it steadier."
        ));
    }
    sentences
}

fn percent(share: f64) -> String {
    format!("{:.2} %", share * 100.0)
}

fn what_can_be_seen(found: &Examination) -> String {
    let Some(floor) = found.noise_floor() else {
        return "Nothing can be told: no group was measured to its end.".to_owned();
    };
    let of = |order: Order| {
        let noise = found.noise(order)?;
        Some(format!("{} in order {order}", percent(noise.floor.max(noise.half_width))))
    };
    let orders = [Order::Literal, Order::Fixed, Order::Reshuffled];
    let parts: Vec<String> = orders.into_iter().filter_map(of).collect();
    let verdict = if floor <= 0.01 {
        "well enough for the threshold of 1 %"
    } else {
        "so differences near 1 % are not to be trusted in the worst of these orders, and verdicts \
         there wait for larger ones"
    };
    format!(
        "This machine can tell differences of {} (copies of one kernel differ by that much), \
         {verdict}.",
        parts.join(", ")
    )
}

fn of_the_predictor(found: &Examination) -> Option<String> {
    let predictor = found.predictor.as_ref()?;
    Some(match predictor.tests {
        None => {
            "Prediction costs the reference kernel nothing that could be seen: order fixed and \
                 order reshuffled mean the same here."
                .to_owned()
        }
        Some(tests) => format!(
            "The branch predictor remembers a replayed set of {tests} tests{}: keep kernels x pairs \
             of order fixed below that.",
            if predictor.or_more { " or more" } else { "" }
        ),
    })
}

fn of_disturbances(found: &Examination) -> Vec<String> {
    let mut sentences = Vec::new();
    let worst = |of: fn(&super::Noise) -> f64| {
        found.noise.iter().map(|(_, noise)| of(noise)).fold(0.0, f64::max)
    };
    let dirty = worst(|noise| noise.dirty_share);
    if dirty > MANY_DIRTY {
        sentences.push(format!(
            "{} of the rounds were disturbed and dropped: close what else is running, or leave the \
             measuring one processor of its own.",
            percent(dirty)
        ));
    }
    let spread = worst(|noise| noise.chain_spread);
    if spread > WAVERING {
        sentences.push(format!(
            "Code of a known number of cycles varied by {} in time: compare cycles and ratios of \
             one run, never nanoseconds of two.",
            percent(spread)
        ));
    }
    let steal = found.interference.steal_ticks.filter(|ticks| *ticks > 0);
    if let Some(ticks) = steal {
        sentences.push(format!(
            "A hypervisor took {} ms of all processors' time away meanwhile.",
            ticks * 10
        ));
    }
    sentences
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::doctor::{Noise, Predictor};
    use crate::measure::ScriptedClock;

    fn environment() -> Environment {
        let mut environment = Environment::capture(&mut ScriptedClock::new(20));
        environment.counters = vec!["cycles".to_owned()];
        environment.governor = None;
        environment
    }

    fn quiet(floor: f64) -> Examination {
        let noise = Noise { floor, half_width: 0.001, dirty_share: 0.0, chain_spread: 0.01 };
        let predictor = Predictor {
            replayed: vec![],
            unforeseen_ns: 20.0,
            tests: Some(16_384),
            or_more: false,
        };
        Examination {
            noise: vec![(Order::Fixed, noise)],
            predictor: Some(predictor),
            ..Examination::default()
        }
    }

    #[test]
    fn a_quiet_machine_needs_two_sentences() {
        let sentences = advice(&quiet(0.003), &environment());
        assert_eq!(sentences.len(), 2, "{sentences:?}");
        assert!(sentences[0].contains("0.30 % in order fixed"), "{}", sentences[0]);
        assert!(sentences[0].contains("well enough"));
        assert!(sentences[1].contains("16384 tests:"));
    }

    #[test]
    fn a_noisy_one_is_told_what_helps() {
        let mut found = quiet(0.025);
        found.noise[0].1.dirty_share = 0.3;
        found.noise[0].1.chain_spread = 0.4;
        found.interference.steal_ticks = Some(7);
        let mut environment = environment();
        environment.counters.clear();
        environment.counters_reason = Some("none here".to_owned());
        environment.governor = Some("powersave".to_owned());
        let text = advice(&found, &environment).join(" ");
        for part in ["2.50 %", "not to be trusted", "none here", "30.00 %", "40.00 %", "70 ms"] {
            assert!(text.contains(part), "no '{part}' in: {text}");
        }
        assert!(text.contains("powersave"));
    }

    #[test]
    fn nothing_measured_is_said() {
        let sentences = advice(&Examination::default(), &environment());
        assert!(sentences[0].starts_with("Nothing can be told"));
    }
}
