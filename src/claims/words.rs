//! Figures and verdicts in words.

use super::estimate::Estimate;
use super::{Finding, Verdict};

/// A figure with four significant digits, zeros behind the point left out.
pub fn shown(value: f64) -> String {
    const DIGITS: i32 = 4;
    // Adding 0 makes 0 of -0.
    let scientific = format!("{:.*e}", DIGITS as usize - 1, value + 0.0);
    let Some((digits, exponent)) = scientific.split_once('e') else { return scientific };
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if !(-4..=6).contains(&exponent) {
        return format!("{}e{exponent}", trimmed(digits));
    }
    // The digits that were rounded to, at the places that they have without an exponent.
    let rounded: f64 = scientific.parse().unwrap_or(value);
    let behind = (DIGITS - 1 - exponent).max(0) as usize;
    trimmed(&format!("{rounded:.behind$}")).to_owned()
}

fn trimmed(digits: &str) -> &str {
    if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits }
}

/// A figure with its interval, where one is to be seen.
pub fn shown_with_interval(found: &Estimate) -> String {
    let [value, low, high] = [found.value, found.low, found.high].map(shown);
    if low == value && high == value { value } else { format!("{value} [{low}, {high}]") }
}

/// All findings of one claim in a line, for instance `reproduced (literal, fixed); contradicted
/// (reshuffled)`; the verdict that the claim itself is about comes first.
pub fn headline(findings: &[&Finding]) -> String {
    let mut groups: Vec<(Verdict, Vec<&Finding>)> = Vec::new();
    let deciding = findings.iter().filter(|finding| finding.decides);
    for finding in deciding.chain(findings.iter().filter(|finding| !finding.decides)) {
        match groups.iter_mut().find(|(verdict, _)| *verdict == finding.verdict) {
            Some((_, group)) => group.push(finding),
            None => groups.push((finding.verdict, vec![finding])),
        }
    }
    let words = |(verdict, group): &(Verdict, Vec<&Finding>)| {
        let word = match verdict {
            Verdict::Reproduced => "reproduced",
            Verdict::NotReproduced if group.iter().any(|f| f.decides) => "not reproduced",
            Verdict::NotReproduced => "contradicted",
            Verdict::Undecided => "undecided",
            Verdict::NotTestable => "not testable",
        };
        let conditions: Vec<&str> = group.iter().map(|f| f.condition.as_str()).collect();
        match conditions.join(", ") {
            none if none.is_empty() => word.to_owned(),
            all => format!("{word} ({all})"),
        }
    };
    groups.iter().map(words).collect::<Vec<_>>().join("; ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_digits_are_shown() {
        for (value, wanted) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (0.971_26, "0.9713"),
            (36.0, "36"),
            (1.152_499, "1.152"),
            (120_720.0, "120700"),
            (9.999_96, "10"),
            (-0.002_5, "-0.0025"),
            (1.234_56e-7, "1.235e-7"),
            (1e12, "1e12"),
        ] {
            assert_eq!(shown(value), wanted);
        }
        let found = Estimate { value: 1.5, low: 1.25, high: 2.0 };
        assert_eq!(shown_with_interval(&found), "1.5 [1.25, 2]");
        assert_eq!(shown_with_interval(&Estimate::exact(3.0)), "3");
    }

    fn finding(condition: &str, verdict: Verdict, decides: bool) -> Finding {
        Finding {
            id: String::new(),
            source: String::new(),
            statement: String::new(),
            published: String::new(),
            measured: None,
            low: None,
            high: None,
            condition: condition.to_owned(),
            verdict,
            details: String::new(),
            decides,
        }
    }

    #[test]
    fn the_deciding_verdict_comes_first() {
        use Verdict::{NotReproduced, Reproduced, Undecided};
        let all = [
            finding("literal", Reproduced, true),
            finding("fixed", Reproduced, false),
            finding("reshuffled", NotReproduced, false),
        ];
        let all: Vec<&Finding> = all.iter().collect();
        assert_eq!(headline(&all), "reproduced (literal, fixed); contradicted (reshuffled)");
        let all = [
            finding("literal", Undecided, false),
            finding("fixed", NotReproduced, true),
            finding("reshuffled", NotReproduced, false),
        ];
        let all: Vec<&Finding> = all.iter().collect();
        assert_eq!(headline(&all), "not reproduced (fixed, reshuffled); undecided (literal)");
        let one = finding("", Reproduced, true);
        assert_eq!(headline(&[&one]), "reproduced");
        assert_eq!(headline(&[]), "");
    }
}
