//! Keeping the measuring thread on one processor, where it can be done.

use super::affinity::{allowed_cpus, list_of, run_on};
use super::calibrate::{repeats, timed};
use super::chain::Chain;
use super::clock::Clock;
use super::disturbance::Disturbance;
use crate::job::Block;
use std::fmt;
use std::str::FromStr;

/// Length of a trial block, ns: that of the blocks which are measured later.
const BLOCK_NS: u64 = 60_000;

/// Most blocks of a trial: about 4 ms.
const MOST_BLOCKS: usize = 64;

/// Blocks over all processors, about 250 ms: where there are many, each is tried more briefly.
const ALL_BLOCKS: usize = 4096;

/// Which processor the measuring thread is to stay on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Pin {
    /// The quietest of those that are allowed.
    #[default]
    Auto,
    /// None: the system moves the thread as it likes.
    Off,
    /// The one of this number, counted from 0 as the system does.
    Cpu(usize),
}

impl FromStr for Pin {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text {
            "auto" => Ok(Pin::Auto),
            "off" => Ok(Pin::Off),
            // A number may have a plus sign in front for `parse`, but not for us.
            _ if text.starts_with(|c: char| c.is_ascii_digit()) => {
                text.parse().map(Pin::Cpu).map_err(|_| refusal(text))
            }
            _ => Err(refusal(text)),
        }
    }
}

fn refusal(text: &str) -> String {
    format!("`{text}` is none of `auto`, `off` and the number of a processor, such as `0`")
}

impl fmt::Display for Pin {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Pin::Auto => formatter.write_str("auto"),
            Pin::Off => formatter.write_str("off"),
            Pin::Cpu(cpu) => write!(formatter, "{cpu}"),
        }
    }
}

/// What became of a [`Pin`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pinned {
    /// The only processor that the thread runs on; `None` if there may be several.
    pub cpu: Option<usize>,
    /// What was done; or why it was not, where more was wanted.
    pub note: String,
}

impl Pinned {
    fn nowhere(note: impl Into<String>) -> Self {
        Pinned { cpu: None, note: note.into() }
    }
}

/// Keeps the calling thread, and those that it starts from now on, on one processor. For
/// [`Pin::Auto`] each allowed one is tried for a few milliseconds if there are several. What
/// cannot be done is left undone, and the note says why.
pub fn pin(wanted: Pin, clock: &mut dyn Clock, disturbance: &mut dyn Disturbance) -> Pinned {
    if wanted == Pin::Off {
        return Pinned::nowhere("not pinned, as was asked for");
    }
    let allowed = match allowed_cpus() {
        Ok(allowed) => allowed,
        Err(error) => return Pinned::nowhere(format!("not pinned: {error}")),
    };
    match (wanted, allowed.as_slice()) {
        (Pin::Cpu(cpu), _) if !allowed.contains(&cpu) => Pinned::nowhere(format!(
            "not pinned: processor {cpu} is none of those allowed ({})",
            list_of(&allowed)
        )),
        (Pin::Cpu(cpu), _) => stay_on(cpu, &allowed, format!("processor {cpu}, as was asked for")),
        (_, &[only]) => stay_on(only, &allowed, format!("processor {only}, the only one allowed")),
        _ => quietest_of(&allowed, clock, disturbance),
    }
}

/// Stays on `cpu`, or goes back to all that are `allowed`.
fn stay_on(cpu: usize, allowed: &[usize], note: String) -> Pinned {
    match run_on(&[cpu]) {
        Ok(()) => Pinned { cpu: Some(cpu), note },
        Err(error) => {
            // If this is refused, too, the thread still runs wherever it was.
            let _ = run_on(allowed);
            Pinned::nowhere(format!("not pinned: processor {cpu}: {error}"))
        }
    }
}

fn quietest_of(
    allowed: &[usize],
    clock: &mut dyn Clock,
    disturbance: &mut dyn Disturbance,
) -> Pinned {
    let mut chain = Chain::default();
    let mut block = Block::whole(&chain);
    // Once for all of them: blocks of other lengths could not be compared.
    block.repeats = repeats(&mut chain, block, 1, BLOCK_NS, clock);
    let blocks = (ALL_BLOCKS / allowed.len().max(1)).clamp(8, MOST_BLOCKS);
    let mut trials = Vec::with_capacity(allowed.len());
    for &cpu in allowed {
        // One that is refused (taken off-line meanwhile) is not chosen.
        if run_on(&[cpu]).is_ok() {
            trials.push(trial(cpu, &mut chain, block, blocks, clock, disturbance));
        }
    }
    match quietest(&trials) {
        Some(cpu) => {
            let note =
                format!("processor {cpu}, the quietest of those allowed ({})", list_of(allowed));
            stay_on(cpu, allowed, note)
        }
        None => Pinned::nowhere("not pinned: the system refuses every allowed processor"),
    }
}

/// How one processor did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Trial {
    cpu: usize,
    /// Times that the thread had to make room; `None` where the system does not tell.
    switches: Option<u64>,
    median_ns: u64,
}

/// Runs `blocks` equal blocks where the thread is.
fn trial(
    cpu: usize,
    chain: &mut Chain,
    block: Block,
    blocks: usize,
    clock: &mut dyn Clock,
    disturbance: &mut dyn Disturbance,
) -> Trial {
    // The first one after a move meets cold caches and a core that may have slept.
    timed(chain, block, clock);
    let before = disturbance.count();
    let mut times: Vec<u64> = (0..blocks).map(|_| timed(chain, block, clock).0).collect();
    let after = disturbance.count();
    times.sort_unstable();
    let switches = after.zip(before).and_then(|(after, before)| after.checked_sub(before));
    Trial { cpu, switches, median_ns: times.get(times.len() / 2).copied().unwrap_or(u64::MAX) }
}

/// The one with the fewest switches, among these the fastest, then the first; `None` of none.
fn quietest(trials: &[Trial]) -> Option<usize> {
    let key = |trial: &&Trial| (trial.switches.unwrap_or(u64::MAX), trial.median_ns);
    trials.iter().min_by_key(key).map(|trial| trial.cpu)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::measure::{InvoluntarySwitches, ScriptedClock, Undisturbed, WallClock};

    /// In a thread of its own: what is set dies with it.
    fn pinned(wanted: Pin) -> (Pinned, Result<Vec<usize>, String>) {
        let work = move || {
            let pinned = pin(wanted, &mut WallClock::new(), &mut InvoluntarySwitches);
            (pinned, allowed_cpus())
        };
        std::thread::spawn(work).join().expect("pinning does not panic")
    }

    #[test]
    fn words_and_numbers() {
        for (text, pin) in [("auto", Pin::Auto), ("off", Pin::Off), ("12", Pin::Cpu(12))] {
            assert_eq!(text.parse(), Ok(pin));
            assert_eq!(pin.to_string(), text);
        }
        for text in ["", "on", "-1", "+1", "1.5", "99999999999999999999999"] {
            let refused = text.parse::<Pin>().expect_err("is nothing");
            assert!(refused.contains("`auto`, `off` and the number"), "{refused}");
        }
    }

    #[test]
    fn fewest_switches_then_shortest_block_then_first() {
        let trial = |cpu, switches, median_ns| Trial { cpu, switches, median_ns };
        let (a, b, c) = (trial(0, Some(3), 50), trial(1, Some(1), 70), trial(2, Some(1), 60));
        assert_eq!(quietest(&[a, b, c]), Some(2));
        assert_eq!(quietest(&[a, b]), Some(1));
        assert_eq!(quietest(&[trial(4, None, 50), trial(5, None, 50), a]), Some(0));
        assert_eq!(quietest(&[trial(4, None, 50), trial(5, None, 50)]), Some(4));
        assert_eq!(quietest(&[]), None);
    }

    #[test]
    fn trial_reports_the_median_and_no_unknown_switches() {
        let mut chain = Chain::new(1);
        let block = Block::whole(&chain);
        let clock = &mut ScriptedClock::new(7);
        let found = trial(3, &mut chain, block, 5, clock, &mut Undisturbed);
        assert_eq!(found, Trial { cpu: 3, switches: None, median_ns: 7 });
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn one_processor_is_left() {
        let allowed = allowed_cpus().expect("Linux tells");
        let (pinned_to, left) = pinned(Pin::Auto);
        let cpu = pinned_to.cpu.expect("Linux pins");
        assert_eq!(left, Ok(vec![cpu]));
        assert!(
            allowed.contains(&cpu) && pinned_to.note.starts_with(&format!("processor {cpu}, "))
        );
        assert_eq!(pinned(Pin::Cpu(allowed[0])).1, Ok(vec![allowed[0]]));
    }

    #[test]
    fn off_and_the_impossible_change_nothing() {
        let before = allowed_cpus();
        for wanted in [Pin::Off, Pin::Cpu(usize::MAX)] {
            let (pinned_to, left) = pinned(wanted);
            assert_eq!((pinned_to.cpu, &left), (None, &before));
            assert!(pinned_to.note.starts_with("not pinned"), "{}", pinned_to.note);
        }
    }
}
