//! What the thesis's program is asked for: densities, numbers, kernels.

use super::arguments::Thesis;
use super::failure::Failure;
use super::slices::Slices;
use crate::registry::{Variant, kernels, variants};

/// Densities of the sweep.
const SWEEP: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// What was asked for, where all of it is allowed.
pub struct Asked {
    /// Shares of pairs that hit.
    pub densities: Vec<f64>,
    /// Kernels, with the words that they were asked for by.
    pub chosen: Vec<(String, &'static Variant)>,
    /// Pairs.
    pub count: usize,
    /// All tests, cut.
    pub slices: Slices,
}

/// Refuses what can be seen to be wrong before anything runs.
///
/// # Errors
/// Usage for numbers and kernels that are not allowed.
pub fn checked(arguments: &Thesis) -> Result<Asked, Failure> {
    let densities = densities(arguments.density.as_deref());
    let triangles = positive("TRIANGLES", &arguments.triangles)?;
    let repeats = positive("REPEATS", &arguments.repeats)?;
    let chosen = chosen(arguments)?;
    let work = (chosen.len() * densities.len()) as u64;
    if triangles.checked_mul(repeats).and_then(|tests| tests.checked_mul(work)).is_none() {
        return Err(Failure::Usage(format!(
            "TRIANGLES x REPEATS: {triangles} x {repeats} tests, {work} times, are more than can \
             be counted; allowed: a product below 2^64"
        )));
    }
    let count = usize::try_from(triangles).unwrap_or(usize::MAX);
    let slices = Slices::new(arguments.order.value(), count, repeats);
    Ok(Asked { densities, chosen, count, slices })
}

/// One density, or the sweep: without a word when asked for, with a warning when the word is none.
fn densities(word: Option<&str>) -> Vec<f64> {
    let sweep = SWEEP.to_vec();
    match word {
        None | Some("all") => sweep,
        Some(word) => match word.parse::<f64>() {
            Ok(density) if (0.0..=1.0).contains(&density) => vec![density],
            _ => {
                say!(
                    "warning: DENSITY: '{}' is no number in [0, 1]; running the sweep \
                     0, 0.25, 0.5, 0.75, 1 (`all` asks for it)",
                    word.escape_debug()
                );
                sweep
            }
        },
    }
}

fn positive(name: &str, text: &str) -> Result<u64, Failure> {
    match text.parse::<u64>() {
        Ok(number) if number > 0 => Ok(number),
        _ => Err(Failure::Usage(format!(
            "{name}: '{text}' is not allowed; allowed: a positive integer"
        ))),
    }
}

/// The kernels asked for, with the words that they were asked for by.
fn chosen(arguments: &Thesis) -> Result<Vec<(String, &'static Variant)>, Failure> {
    let mut chosen: Vec<(String, &'static Variant)> = Vec::new();
    for word in &arguments.kernels {
        let id = match word.as_str() {
            "moller" => "moller1",
            "chirkov" => "chirkov-line",
            other => other,
        };
        let Some(variant) = line_form(id, arguments.output.value()) else {
            let known: Vec<_> = kernels().iter().map(|variant| variant.about.id).collect();
            let alike = |known: &&str| strsim::jaro_winkler(word, known);
            let best = known.iter().copied().max_by(|a, b| alike(a).total_cmp(&alike(b)));
            return Err(Failure::Usage(format!(
                "--kernels: '{word}' is not allowed; allowed: moller, badouel, chirkov and {}{}",
                known.join(", "),
                best.map(|best| format!(". Did you mean '{best}'?")).unwrap_or_default()
            )));
        };
        if chosen.iter().any(|(other, _)| other == word) {
            return Err(Failure::Usage(format!("--kernels: '{word}' stands there twice")));
        }
        chosen.push((word.clone(), variant));
    }
    Ok(chosen)
}

/// A kernel's single f32 form that answers for lines, at the lowest level, divided last if it can.
fn line_form(id: &str, output: &str) -> Option<&'static Variant> {
    let fits = |variant: &&Variant| {
        let axes = &variant.axes;
        let plain = axes.precision == "f32" && axes.drive == "single" && axes.rounding == "plain";
        let usual = axes.cull == "off" && axes.tests == "compare" && axes.priced.is_empty();
        let usual = usual && axes.reciprocal == "divide";
        let native = axes.leading_is_native && axes.stored_is_native && axes.query == "ray";
        axes.kernel == id
            && plain
            && usual
            && native
            && axes.exit == "early"
            && axes.output == output
    };
    let mut forms: Vec<&Variant> = variants().iter().filter(fits).collect();
    forms.sort_by_key(|variant| variant.axes.division != "last");
    forms.first().copied()
}
