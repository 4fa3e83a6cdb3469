//! `ray_test doctor`: can this machine measure, and how finely.

use std::io::Write;

use serde_json::{Map, Value, json};

use super::arguments::{Doctor, Format};
use super::failure::Failure;
use super::instruments::Instruments;
use super::{interrupt, lock, progress};
use crate::doctor::{
    AaTrials, DoctorError, Examination, InjectedTrials, OracleSpeed, aa_trials, advice,
    injected_trials, oracle_speed,
};
use crate::experiment::{KeepNothing, Profile};
use crate::measure::{Environment, Order, WallClock};

const ORDERS: [Order; 3] = [Order::Literal, Order::Fixed, Order::Reshuffled];

/// Sizes of an injected slow-down that count as right: within so much of the truth.
const SIZE_ERROR: f64 = 0.003;

/// What was found, in the order in which it is printed.
type Facts = Vec<(String, Value)>;

/// Examines the machine, and with `--self-test` the verdicts.
pub fn run(arguments: &Doctor) -> Result<(), Failure> {
    let share = injected_share(arguments)?;
    let _lock = lock::take()?;
    let (mut instruments, environment) = Instruments::set_up(arguments.pin)?;
    if arguments.oracle {
        let speed =
            oracle_speed(&mut WallClock::new()).map_err(|error| Failure::Runtime(error.into()))?;
        return print(&of_oracle(&speed), arguments.format);
    }
    let cancel = interrupt::flag();
    let (mut silent, mut keep) = (|_: usize| {}, KeepNothing);
    let mut bench = instruments.bench(Profile::Quick.rounds(), &mut silent, cancel, &mut keep);
    let found = Examination::of_this_machine(&mut bench)?;
    let mut facts = facts(&found, &environment);
    if arguments.self_test {
        let bar = progress::bar((arguments.comparisons + arguments.trials) as usize);
        let each = arguments.comparisons.div_ceil(3);
        let (mut done, mut aa) = (0, (0, 0));
        for order in ORDERS {
            let comparisons = each.min(arguments.comparisons - done);
            let trials = aa_trials(order, comparisons, &mut bench, |n| bar.set_position(done + n))?;
            done += comparisons;
            put_aa(&mut facts, order, &trials);
            aa = (aa.0 + trials.comparisons, aa.1 + trials.different);
        }
        let injected =
            injected_trials(share, arguments.trials, &mut bench, |n| bar.set_position(done + n))?;
        put_injected(&mut facts, &injected);
        facts.push(("self_test".to_owned(), json!(promises(aa, &injected))));
        bar.finish_and_clear();
    }
    print(&facts, arguments.format)?;
    if cancel.load(std::sync::atomic::Ordering::Relaxed) {
        return Err(Failure::Interrupted);
    }
    Ok(())
}

/// The slow-down of the self-test, as a share.
///
/// # Errors
/// Usage for one that is not allowed.
pub fn injected_share(arguments: &Doctor) -> Result<f64, Failure> {
    let share = arguments.inject / 100.0;
    if !(share > 0.0 && share < 1.0) {
        return Err(Failure::Usage(format!(
            "--inject: {} is not allowed; allowed: above 0, below 100 (percent)",
            arguments.inject
        )));
    }
    Ok(share)
}

/// What the examination and the environment tell.
fn facts(found: &Examination, environment: &Environment) -> Facts {
    let machine = &environment.machine;
    let predictor = found.predictor.as_ref();
    let mut facts = Facts::new();
    let mut put = |key: &str, value: Value| facts.push((key.to_owned(), value));
    put("processor", json!(machine.processor));
    put("testbed_id", json!(environment.testbed_id));
    put("logical_cpus", json!(machine.logical_cpus));
    put("hypervisor", json!(machine.hypervisor));
    put("pinned_cpu", json!(environment.pinned_cpu));
    put("pin_note", json!(environment.pin_note));
    put("levels", json!(environment.levels));
    put("counters", json!(environment.counters));
    put("counters_reason", json!(environment.counters_reason));
    put("timer_ns", json!(environment.timer.resolution_ns));
    put("timer_cost_ns", json!(environment.timer.cost_ns));
    put("noise_floor_percent", json!(found.noise_floor().map(percent)));
    for (order, noise) in &found.noise {
        put(&format!("noise_floor_{order}_percent"), json!(percent(noise.floor)));
        put(&format!("half_width_{order}_percent"), json!(percent(noise.half_width)));
        put(&format!("dirty_{order}_percent"), json!(percent(noise.dirty_share)));
    }
    let spread = found.noise.iter().map(|(_, noise)| noise.chain_spread).reduce(f64::max);
    put("chain_spread_percent", json!(spread.map(percent)));
    put("predictor_tests", json!(predictor.and_then(|predictor| predictor.tests)));
    put("predictor_or_more", json!(predictor.map(|predictor| predictor.or_more)));
    put("unforeseen_ns", json!(predictor.map(|predictor| predictor.unforeseen_ns)));
    for (size, ns) in predictor.map_or(&[][..], |predictor| &predictor.replayed) {
        put(&format!("replayed_{size}_ns"), json!(ns));
    }
    put("steal_ticks", json!(found.interference.steal_ticks));
    put("involuntary_switches", json!(found.interference.involuntary_switches));
    put("load_average", json!(found.interference.load_average.map(|load| load[0])));
    put("advice", json!(advice(found, environment).join(" ")));
    facts
}

/// Decisions a second the exact answer owes: where the filter decides, and in integers.
const OWED: [f64; 2] = [10e6, 0.5e6];

fn of_oracle(speed: &OracleSpeed) -> Facts {
    let facts = [
        ("oracle_filtered_percent", percent(speed.filtered)),
        ("oracle_pairs_per_second", speed.pairs),
        ("oracle_pairs_over_owed", speed.pairs / OWED[0]),
        ("oracle_128_bit_per_second", speed.small_integers),
        ("oracle_128_bit_over_owed", speed.small_integers / OWED[1]),
        ("oracle_big_per_second", speed.big_integers),
        ("oracle_big_over_owed", speed.big_integers / OWED[1]),
    ];
    facts.map(|(key, value)| (key.to_owned(), json!(value))).to_vec()
}

fn percent(share: f64) -> f64 {
    share * 100.0
}

fn put_aa(facts: &mut Facts, order: Order, trials: &AaTrials) {
    let mut put = |key: &str, value: Value| facts.push((format!("aa_{order}_{key}"), value));
    put("comparisons", json!(trials.comparisons));
    put("different", json!(trials.different));
    put("same", json!(trials.same));
    put("largest_percent", json!(percent(trials.largest)));
}

fn put_injected(facts: &mut Facts, injected: &InjectedTrials) {
    let mut put = |key: &str, value: Value| facts.push((format!("injected_{key}"), value));
    put("percent", json!(percent(injected.share)));
    put("trials", json!(injected.trials.len()));
    put("found", json!(injected.found()));
    put("sized_within_0.3_points", json!(injected.sized_within(SIZE_ERROR)));
    put("crowded", json!(injected.crowded()));
    let sizes: Vec<f64> = injected.trials.iter().map(|trial| trial.size).collect();
    put("median_percent", json!(crate::stats::median(&sizes).map(percent)));
}

/// Whether the promises were kept: of (comparisons, different) with copies at most one in a
/// thousand a false alarm; of the slow-downs 95 in a hundred found, at their size.
fn promises((comparisons, different): (u64, u64), injected: &InjectedTrials) -> String {
    let (trials, sized) = (injected.trials.len(), injected.sized_within(SIZE_ERROR));
    let alarms = different * 1000 <= comparisons;
    let found = sized * 100 >= trials * 95;
    let word = |kept: bool| if kept { "kept" } else { "BROKEN" };
    format!(
        "{different} of {comparisons} comparisons of a kernel with its copies called different, at \
         most 1 in 1000 promised: {}. {sized} of {trials} slow-downs of {} % found with their size \
         right to 0.3 points, at least 95 in 100 promised: {}.",
        word(alarms),
        percent(injected.share),
        word(found)
    )
}

fn print(facts: &Facts, format: Format) -> Result<(), Failure> {
    let mut out = std::io::stdout().lock();
    let text = |value: &Value| match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        Value::Array(values) => {
            let words = values.iter().map(|value| value.as_str().unwrap_or_default());
            words.collect::<Vec<_>>().join(" ")
        }
        other => other.to_string(),
    };
    match format {
        Format::Json => {
            let object: Map<String, Value> = facts.iter().cloned().collect();
            let json = serde_json::to_string_pretty(&object)
                .map_err(|error| Failure::Runtime(error.into()))?;
            writeln!(out, "{json}")?;
        }
        Format::Csv => {
            let failed = |error: ::csv::Error| Failure::Runtime(error.into());
            let mut writer = ::csv::Writer::from_writer(out);
            writer.write_record(facts.iter().map(|(key, _)| key)).map_err(failed)?;
            writer.write_record(facts.iter().map(|(_, value)| text(value))).map_err(failed)?;
            writer.flush()?;
        }
        Format::Text => {
            let is_text = |key: &str| matches!(key, "advice" | "self_test");
            for (key, value) in facts.iter().filter(|(key, _)| !is_text(key)) {
                let value = match value.as_f64() {
                    Some(number) if value.is_f64() => format!("{number:.3}"),
                    _ => text(value),
                };
                writeln!(out, "{:<32}{value}", key.replace('_', " "))?;
            }
            for (_, words) in facts.iter().filter(|(key, _)| is_text(key)) {
                writeln!(out, "\n{}", text(words))?;
            }
        }
    }
    Ok(())
}

impl From<DoctorError> for Failure {
    fn from(error: DoctorError) -> Self {
        Failure::Runtime(error.into())
    }
}
