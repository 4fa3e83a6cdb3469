//! Which variants an experiment, and a filter, choose.

use regex::Regex;

use crate::registry::{Variant, variants};

/// The variants that a pattern matches, for each pattern in turn, none twice.
///
/// # Errors
/// For a pattern that is not a regular expression, or that matches no variant of any machine.
pub fn select(patterns: &[String]) -> Result<Vec<&'static Variant>, String> {
    let mut chosen: Vec<&'static Variant> = Vec::new();
    for pattern in patterns {
        let regex = pattern_of(pattern).map_err(|error| format!("variants: {error}"))?;
        let mut seen = 0;
        for variant in variants() {
            if regex.is_match(&variant.id()) {
                seen += 1;
                if chosen.iter().all(|other| !std::ptr::eq(*other, variant)) {
                    chosen.push(variant);
                }
            }
        }
        if seen == 0 {
            return Err(format!(
                "variants: '{pattern}' matches no variant; `ray_test list variants` shows them all"
            ));
        }
    }
    Ok(chosen)
}

/// A regular expression over ids.
///
/// # Errors
/// What is wrong with it.
pub fn pattern_of(text: &str) -> Result<Regex, String> {
    Regex::new(text).map_err(|error| format!("'{text}' is no regular expression: {error}"))
}
