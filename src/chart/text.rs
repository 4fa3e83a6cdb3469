//! How wide a text is, where it breaks, and how numbers are written.

/// Width of a text in the units of its font size. SVG leaves the font to the reader's machine, so
/// this is an upper estimate for common sans-serif fonts, not a measurement.
pub(super) fn width(text: &str, size: f64, bold: bool) -> f64 {
    let em = if bold { 0.62 } else { 0.59 };
    text.chars().count() as f64 * em * size
}

/// Breaks a text at blanks into lines that are not wider than `limit`; a word that is wider by
/// itself is cut, so that nothing leaves the picture.
pub(super) fn wrap(text: &str, size: f64, bold: bool, limit: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace().flat_map(|word| cut(word, size, bold, limit)) {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), size, bold) <= limit => {
                line.push(' ');
                line.push_str(&word);
            }
            _ => lines.push(word),
        }
    }
    lines
}

/// The same number of lines as [`wrap`] needs, but about equally long: no last line of one word.
pub(super) fn balanced(text: &str, size: f64, bold: bool, limit: f64) -> Vec<String> {
    let lines = wrap(text, size, bold, limit);
    let narrower = (10..20).map(|twentieth| limit * f64::from(twentieth) / 20.0);
    let mut narrower = narrower.map(|limit| wrap(text, size, bold, limit));
    narrower.find(|other| other.len() == lines.len()).unwrap_or(lines)
}

fn cut(word: &str, size: f64, bold: bool, limit: f64) -> Vec<String> {
    let most = (limit / width("x", size, bold)).max(1.0) as usize;
    let characters: Vec<char> = word.chars().collect();
    characters.chunks(most).map(|part| part.iter().collect()).collect()
}

/// A figure with three significant digits, without an exponent where that stays short.
pub fn figure(value: f64) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    let magnitude = value.abs().log10().floor();
    if !(-4.0..7.0).contains(&magnitude) {
        return format!("{value:.2e}");
    }
    let decimals = (2.0 - magnitude).max(0.0) as usize;
    let rounded = format!("{value:.decimals$}");
    if decimals > 0 && magnitude < -1.0 { trim(&rounded) } else { rounded }
}

/// A tick's label: as many decimals as the step needs, and no more.
pub(super) fn tick(value: f64, step: f64) -> String {
    if value != 0.0 && !(1e-4..1e7).contains(&value.abs()) {
        return format!("{value:e}");
    }
    // The step is 1, 2 or 5 times a power of ten, so its own magnitude tells the decimals.
    let decimals = (-step.abs().log10().floor()).clamp(0.0, 8.0) as usize;
    let label = format!("{value:.decimals$}");
    if label.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') {
        "0".into()
    } else {
        label
    }
}

fn trim(number: &str) -> String {
    number.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// A figure that is mostly whole, as short as it goes.
pub(super) fn figure_short(value: f64) -> String {
    if value.fract() == 0.0 && value.abs() < 1e6 { format!("{value:.0}") } else { figure(value) }
}
