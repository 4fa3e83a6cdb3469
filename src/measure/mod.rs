//! Blocks, rounds, clock: what a group of contestants takes, side by side, on a shared machine.
//!
//! ```text
//! Contestants --validate, expectation--> Runners --plan--> rounds of timed blocks --> GroupReport
//! ```
//! All contestants of a group run once a round, in positions drawn by a Latin square, in blocks too
//! short for a pre-emption to fall into many of them. Comparisons are between blocks of one round.
//! Groups take turns with their rounds, so that what lasts for a second is not all that one of them sees.

mod affinity;
mod build_info;
mod calibrate;
mod chain;
mod clock;
mod contestant;
mod counters;
mod course;
mod date;
mod dependent;
mod disturbance;
mod empty;
mod environment;
mod expectation;
mod figures;
mod forget;
mod group;
#[cfg(test)]
mod group_tests;
mod guard;
mod interference;
mod latin;
mod machine;
mod measuring;
mod neighbour;
mod pin;
mod plan;
mod protocol;
mod report;
mod ruler;
mod runner;
mod sample;
#[cfg(test)]
mod scripted;
mod shared;
mod shuffle;
mod steadiness;
mod trace;
mod windows;

pub use affinity::{alike_cpus, allowed_cpus, anywhere, run_anywhere};
pub use build_info::BuildInfo;
pub use chain::{CYCLES_PER_STEP, Chain, cycles_per_ns};
pub use clock::{Clock, ScriptedClock, TimerFigures, WallClock, timer_figures};
pub use contestant::{Contestant, Expected, MOST_SUBJECTS, PLACEBOS, Role, yardsticks};
pub use counters::{Counters, Counts, HardwareCounters, NoCounters, ScriptedCounters};
pub use date::{now_rfc3339, rfc3339};
pub use dependent::Dependent;
pub use disturbance::{Disturbance, InvoluntarySwitches, Undisturbed};
pub use empty::EmptyLoop;
pub use environment::Environment;
pub use figures::{CyclesSource, Figures, GroupReport, Invalid, Status};
pub use forget::{Forget, Remember};
pub use group::{Group, Progress, Surroundings, measure_group, measure_groups};
pub use guard::MOST_OPERATIONS_PER_CYCLE;
pub use interference::Interference;
pub use latin::LatinOrder;
pub use machine::{Cache, Machine};
pub use neighbour::NeighbourRuler;
pub use pin::{Pin, Pinned, pin};
pub use protocol::{Order, Pace, Protocol, ProtocolError};
pub use ruler::{NoRuler, Reading, Ruler};
pub use shared::PREDICTED_TESTS;
pub use trace::{RoundState, RoundTrace};
