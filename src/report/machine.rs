//! What a machine and its build are, from `environment.json`.

use crate::results::Source;
use serde_json::Value;

/// A machine and build, in words. What is not known is empty.
pub(super) struct Machine {
    pub label: String,
    pub processor: String,
    pub levels: String,
    pub system: String,
    pub counters: String,
    pub build: String,
    pub version: String,
    pub commit: String,
    pub date: String,
}

impl Machine {
    /// Of a source.
    pub fn of(source: &Source) -> Self {
        let environment = &source.environment;
        let text = |path: &str| text(environment, path);
        let join = |parts: &[String]| {
            let parts: Vec<&str> =
                parts.iter().map(String::as_str).filter(|part| !part.is_empty()).collect();
            parts.join(", ")
        };
        let flags = text("/build/flags");
        let level = text("/build/opt_level");
        let cpus = text("/machine/logical_cpus");
        Machine {
            label: source.label.clone(),
            processor: join(&[
                text("/machine/processor"),
                text("/machine/processor_id"),
                with("", &cpus, " logical processors"),
                if flag(environment, "/machine/hypervisor") { "virtual".into() } else { "".into() },
                caches(environment),
            ]),
            levels: words(environment, "/levels"),
            system: join(&[text("/system_name"), with("kernel ", &text("/kernel_release"), "")]),
            counters: counters(environment),
            build: join(&[
                text("/build/compiler"),
                text("/build/target"),
                with("opt-level ", &level, ""),
                with("flags ", &flags, ""),
            ]),
            version: text("/build/version"),
            commit: text("/build/commit"),
            date: text("/date"),
        }
    }
}

fn with(before: &str, text: &str, after: &str) -> String {
    if text.is_empty() { String::new() } else { format!("{before}{text}{after}") }
}

/// A value as text; empty if it is not there.
pub(super) fn text(environment: &Value, path: &str) -> String {
    match environment.pointer(path) {
        Some(Value::String(text)) => text.clone(),
        Some(Value::Number(number)) => number.to_string(),
        _ => String::new(),
    }
}

fn flag(environment: &Value, path: &str) -> bool {
    environment.pointer(path).and_then(Value::as_bool).unwrap_or(false)
}

fn words(environment: &Value, path: &str) -> String {
    let list = environment.pointer(path).and_then(Value::as_array);
    list.into_iter().flatten().filter_map(Value::as_str).collect::<Vec<_>>().join(", ")
}

fn counters(environment: &Value) -> String {
    let counters = words(environment, "/counters");
    if counters.is_empty() {
        with("none: ", &text(environment, "/counters_reason"), "")
    } else {
        counters
    }
}

/// Sizes of the caches that hold data.
fn caches(environment: &Value) -> String {
    let list = environment.pointer("/machine/caches").and_then(Value::as_array);
    let size = |cache: &Value| {
        let (level, bytes) = (cache.get("level")?.as_u64()?, cache.get("size_bytes")?.as_u64()?);
        let holds_data = cache.get("kind")?.as_str()? != "Instruction";
        holds_data.then(|| format!("L{level} {} KiB", bytes / 1024))
    };
    list.into_iter().flatten().filter_map(size).collect::<Vec<_>>().join(", ")
}
