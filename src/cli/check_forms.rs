//! Which forms `check` runs.

use super::failure::Failure;
use crate::check::{Precision, form, kernels};
use crate::registry::{Asked, asked};

/// A form, by the word that it was asked for by.
pub struct Chosen {
    /// The word: the column `kernel`.
    pub word: String,
    /// The form.
    pub form: &'static Asked,
    /// Its precision.
    pub precision: Precision,
}

/// The forms asked for, those of one precision together. Without words every kernel, without a
/// precision both.
///
/// # Errors
/// Usage for an unknown word, for one that stands there twice, and for one without a form in the
/// precision.
pub fn chosen(
    words: Option<&[String]>,
    precision: Option<Precision>,
) -> Result<Vec<Chosen>, Failure> {
    let precisions = precision.map_or(Precision::ALL.to_vec(), |precision| vec![precision]);
    let every = || kernels().into_iter().map(str::to_owned).collect();
    let given: Vec<String> = words.map_or_else(every, <[String]>::to_vec);
    let mut chosen = Vec::new();
    for precision in &precisions {
        chosen.extend(given.iter().filter_map(|word| find(word, *precision)));
    }
    for (place, word) in given.iter().enumerate() {
        if given[..place].contains(word) {
            return Err(Failure::Usage(format!("--kernels: '{word}' stands there twice")));
        }
        if words.is_some() && chosen.iter().all(|chosen: &Chosen| chosen.word != *word) {
            return Err(refused(word, &precisions));
        }
    }
    Ok(chosen)
}

/// A kernel's own form, or the one with that id.
fn find(word: &str, precision: Precision) -> Option<Chosen> {
    let in_full = |form: &&Asked| form.axes.precision == precision.name() && form.id() == word;
    let found =
        if word.contains('/') { asked().iter().find(in_full) } else { form(word, precision) };
    found.map(|form| Chosen { word: word.to_owned(), form, precision })
}

fn refused(word: &str, asked_for: &[Precision]) -> Failure {
    let others = Precision::ALL.into_iter().filter(|precision| !asked_for.contains(precision));
    let mut others = others.filter(|precision| find(word, *precision).is_some());
    if let Some(other) = others.next() {
        let name = other.name();
        return Failure::Usage(format!(
            "--kernels: '{word}' has no form in that precision; allowed: --precision {name}"
        ));
    }
    let in_full = asked().iter().map(Asked::id).filter(|_| word.contains('/'));
    let known = kernels().into_iter().map(str::to_owned).chain(in_full);
    let alike = |known: &String| strsim::jaro_winkler(word, known);
    let best = known.max_by(|a, b| alike(a).total_cmp(&alike(b)));
    Failure::Usage(format!(
        "--kernels: '{word}' is not allowed; allowed: {} and full ids of their single early forms \
         with output tuv{}",
        kernels().join(", "),
        best.map(|best| format!(". Did you mean '{best}'?")).unwrap_or_default()
    ))
}
