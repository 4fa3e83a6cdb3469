//! What is better in a column, more or less of it, and the words for that.

/// Which end of a column is the good one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Better {
    Less,
    More,
    /// Neither is: a share, a price.
    Neither,
}

/// How a column is spoken of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sense {
    pub better: Better,
    /// Said of the best: `is the fastest`.
    pub best: &'static str,
    /// Said of the worst.
    pub worst: &'static str,
    /// Behind a percentage or, with `times`, a factor: `slower`, `the error`.
    pub more: &'static str,
    /// Behind a factor.
    pub times: &'static str,
    /// Unit of the values; `%` says that values are already differences.
    pub unit: &'static str,
}

const TIME: Sense = Sense {
    better: Better::Less,
    best: "is the fastest",
    worst: "is the slowest",
    more: "slower",
    times: "times the time",
    unit: "",
};

const ERROR: Sense = Sense {
    better: Better::Less,
    best: "errs least",
    worst: "errs most",
    more: "more",
    times: "times the error",
    unit: "",
};

const PLAIN: Sense = Sense {
    better: Better::Less,
    best: "is the lowest",
    worst: "is the highest",
    more: "more",
    times: "times as much",
    unit: "",
};

/// Times by the way they end.
const TIMES: [(&str, &str); 11] = [
    ("ns_per_test", "ns"),
    ("min_ns", "ns"),
    ("ns_per_triangle", "ns"),
    ("cycles_per_test", "cycles"),
    ("cycles_per_triangle", "cycles"),
    ("cycles_per_ray", "cycles"),
    ("seconds", "s"),
    ("ratio_to_reference", ""),
    ("floor_ns", "ns"),
    ("seconds_per_frame", "s"),
    ("build_ms", "ms"),
];

/// Parts of the names of errors and failures.
const ERRORS: [&str; 9] = [
    "err_",
    "false_",
    "nan_",
    "bits_lost",
    "excess",
    "backward",
    "inexcusable",
    "hits_of",
    "metamorphic",
];

const RISING: Sense = Sense {
    better: Better::More,
    best: "is the highest",
    worst: "is the lowest",
    more: "less",
    times: "times less",
    unit: "",
};

const NEITHER: Sense = Sense { better: Better::Neither, ..RISING };

/// Columns that are spoken of in words of their own.
const NAMED: [(&str, Sense); 14] = [
    ("mtests_per_s", Sense { better: Better::More, unit: "M tests/s", ..TIME }),
    ("percent_slower", Sense { unit: "%", ..TIME }),
    ("bound_fraction", LIMIT),
    ("knee", KNEE),
    ("knee_share", KNEE),
    ("useful_lanes", RISING),
    ("attained_share", RISING),
    ("pays_from_rays", Sense { best: "pays soonest", worst: "pays latest", unit: "rays", ..PLAIN }),
    ("pays_triangles", SOONEST),
    ("pays_triangles_built", SOONEST),
    ("frames_per_s", Sense { better: Better::More, unit: "pictures/s", ..TIME }),
    ("intersection_percent", Sense { unit: "%", ..NEITHER }),
    ("share", Sense { unit: "%", ..NEITHER }),
    ("price", NEITHER),
];

const SOONEST: Sense =
    Sense { best: "pays soonest", worst: "pays latest", unit: "triangles", ..PLAIN };

const LIMIT: Sense = Sense {
    best: "comes closest to the limit",
    worst: "stays farthest from it",
    more: "farther",
    times: "times as far",
    ..RISING
};

const KNEE: Sense = Sense { best: "holds longest", worst: "fails first", ..RISING };

const LEAKS: Sense = Sense {
    best: "is right most often",
    worst: "is wrong most often",
    times: "times as often",
    ..PLAIN
};

/// The sense of a column.
pub(super) fn sense(column: &str) -> Sense {
    let has = |parts: &[&str]| parts.iter().any(|part| column.contains(part));
    if let Some((_, sense)) = NAMED.iter().find(|(name, _)| *name == column) {
        return *sense;
    }
    if has(&["leaks", "double_hits"]) {
        let unit = if column.ends_with("per_million") { "in a million" } else { "" };
        return Sense { unit, ..LEAKS };
    }
    if has(&["bytes"]) {
        let (best, worst) = ("needs the least", "needs the most");
        return Sense { best, worst, unit: "bytes", ..PLAIN };
    }
    if has(&ERRORS) {
        return ERROR;
    }
    let time = TIMES.iter().find(|(end, _)| column.ends_with(end));
    time.map_or(PLAIN, |(_, unit)| Sense { unit, ..TIME })
}

impl Sense {
    /// Orders values from the best on; where neither end is, from the highest on.
    pub fn order(&self, a: f64, b: f64) -> std::cmp::Ordering {
        if self.better == Better::Less { a.total_cmp(&b) } else { b.total_cmp(&a) }
    }

    /// How much worse a value is than the best: `12 % slower`, `3.1 times the time`. Empty where
    /// that has no meaning.
    pub fn behind(&self, best: f64, value: f64) -> String {
        if self.unit == "%" && self.better == Better::Less {
            return format!("{} % {}", crate::chart::short_figure(value), self.more);
        }
        let factor = if self.better == Better::Less { value / best } else { best / value };
        if self.better == Better::Neither || best <= 0.0 || value <= 0.0 || !factor.is_finite() {
            return String::new();
        }
        if factor < 2.0 {
            return format!("{} {}", super::words::percent(factor - 1.0), self.more);
        }
        format!("{} {}", crate::chart::short_figure(factor), self.times)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn less_time_and_more_tests_are_better() {
        for (column, better, best) in [
            ("ns_per_test", Better::Less, "is the fastest"),
            ("latency_ns_per_test", Better::Less, "is the fastest"),
            ("mtests_per_s", Better::More, "is the fastest"),
            ("err_t_max_ulp", Better::Less, "errs least"),
            ("leaks_per_million", Better::Less, "is right most often"),
            ("bound_fraction", Better::More, "comes closest to the limit"),
            ("share", Better::Neither, "is the highest"),
            ("ops_add", Better::Less, "is the lowest"),
        ] {
            let sense = sense(column);
            assert_eq!((sense.better, sense.best), (better, best), "{column}");
        }
    }

    #[test]
    fn what_is_slower_is_slower_in_tests_a_second_too() {
        assert_eq!(sense("ns_per_test").behind(10.0, 11.5), "15 % slower");
        assert_eq!(sense("mtests_per_s").behind(115.0, 100.0), "15 % slower");
        assert_eq!(sense("ns_per_test").behind(10.0, 31.0), "3.10 times the time");
        assert_eq!(sense("percent_slower").behind(0.0, 3.7), "3.70 % slower");
        assert_eq!(sense("err_b_p99").behind(0.0, 1.0), "");
        assert_eq!(sense("price").behind(0.3, 0.1), "");
    }
}
