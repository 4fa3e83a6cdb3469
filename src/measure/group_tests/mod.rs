//! The whole protocol on a scripted clock: what comes out is known before.

mod neighbours;
mod orders;
mod rounds;
mod turns;
mod verdicts;

use super::scripted::{Call, Script, ScriptedJob};
use super::*;
use crate::job::Block;
use crate::stats::Ratio;
use std::cell::RefCell;
use std::rc::Rc;
use std::sync::atomic::AtomicBool;

type Calls = Rc<RefCell<Vec<Call>>>;

fn subject(id: &str, role: Role, job: ScriptedJob) -> (Contestant, Calls) {
    let calls = Rc::clone(&job.calls);
    (Contestant::new(id, role, Box::new(job)), calls)
}

/// Reference of 4 ns, placebo, a subject twice as slow, chain of 1 ns a step, loop of 1 ns.
fn usual(script: &Script, items: usize) -> Vec<Contestant> {
    let contestants = [
        ("reference", Role::Reference, 4),
        ("placebo", Role::Placebo, 4),
        ("slow", Role::Subject, 8),
        ("chain", Role::Chain, 1),
        ("empty", Role::Empty, 1),
    ];
    let one = |(id, role, cost)| subject(id, role, ScriptedJob::new(script, items, cost)).0;
    contestants.map(one).into()
}

/// A group of the reference at 1000 ns a test and whoever else, with chain and empty loop.
fn with(script: &Script, others: &[(&str, Role, u64)]) -> Vec<Contestant> {
    let controls = [
        ("reference", Role::Reference, 1000),
        ("chain", Role::Chain, 500),
        ("empty", Role::Empty, 1),
    ];
    let one = |(id, role, cost): &(&str, Role, u64)| {
        subject(id, *role, ScriptedJob::new(script, 100, *cost)).0
    };
    controls.iter().chain(others).map(one).collect()
}

/// 20 rounds of 60 us in every order.
fn protocol(order: Order) -> Protocol {
    let exact_rounds = order == Order::Reshuffled;
    Protocol { rounds: 20, block_ns: 60_000, exact_rounds, ..Protocol::new(order, 11) }
}

fn measure(contestants: &mut [Contestant], protocol: &Protocol, script: &Script) -> GroupReport {
    measure_with(
        contestants,
        protocol,
        script,
        &mut Undisturbed,
        &mut |_| {},
        &AtomicBool::new(false),
    )
}

fn measure_with(
    contestants: &mut [Contestant],
    protocol: &Protocol,
    script: &Script,
    disturbance: &mut dyn Disturbance,
    progress: &mut dyn FnMut(Progress),
    cancel: &AtomicBool,
) -> GroupReport {
    let clock = &mut script.clock.clone();
    let (counters, forget, ruler) = (&mut NoCounters, &mut Remember, &mut NoRuler);
    let mut surroundings =
        Surroundings { clock, disturbance, counters, forget, ruler, progress, cancel };
    measure_group(contestants, protocol, &mut surroundings).expect("a group that can be measured")
}

fn is_near(ratio: Option<Ratio>, wanted: f64) -> bool {
    let near = |x: f64| (x / wanted - 1.0).abs() < 1e-12;
    ratio.is_some_and(|r| near(r.estimate) && near(r.low) && near(r.high))
}

/// The blocks that were timed, those of the calibration first.
fn timed_blocks(calls: &Calls) -> Vec<Block> {
    let timed = |call: &Call| match call {
        Call::Run { block, timed: true } => Some(*block),
        _ => None,
    };
    calls.borrow().iter().filter_map(timed).collect()
}
