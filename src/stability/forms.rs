//! Which forms of which kernels are asked.

use super::precision::Precision;
use crate::accuracy::Reported;
use crate::registry::{Asked, asked, asked_with_peers};

/// A form of a kernel, with the name that tables and charts call it by.
#[derive(Clone)]
pub struct Form {
    /// How it is asked.
    pub asked: &'static Asked,
    /// The kernel's id, followed by the words of the form's id that its kernel's usual form has not.
    pub name: String,
    /// What it computes in.
    pub precision: Precision,
}

impl Form {
    /// A form of the registry.
    pub fn of(asked: &'static Asked) -> Option<Self> {
        let precision = Precision::of(asked.axes.precision)?;
        Some(Form { asked, name: name(asked), precision })
    }

    /// What it reports, and how it rounds.
    pub fn reported(&self) -> Reported {
        Reported {
            unit_roundoff: self.precision.unit_roundoff(),
            t: true,
            uv: self.asked.axes.output != "t",
            surface: false,
            culls: self.asked.axes.cull == "on",
        }
    }

    /// Whether it replaces subnormal numbers by zeros, as processors can be told to.
    pub fn flushes(&self) -> bool {
        flushes(self.asked)
    }
}

/// A word of `--kernels` that names nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnknownForm {
    /// The word.
    pub word: String,
}

/// The forms that are asked: without `wanted` the usual form of every kernel, with it those of the
/// kernels and the forms that it names.
///
/// Of a watertight kernel plain and fused forms are usual, and all treatments of edges, since what
/// makes it watertight is easily lost. Of every usual form the one that flushes subnormal numbers
/// comes along, for the families that have such.
///
/// # Errors
/// The first word that is neither a kernel's id nor a form's.
pub fn forms(wanted: &[String], precision: Option<Precision>) -> Result<Vec<Form>, UnknownForm> {
    let all = asked();
    for word in wanted {
        if !all.iter().any(|form| form.about.id == word || form.id() == *word) {
            return Err(UnknownForm { word: word.clone() });
        }
    }
    let is_wanted = |form: &Asked| {
        let by_kernel = wanted.is_empty() || wanted.iter().any(|word| word == form.about.id);
        (by_kernel && is_usual(form)) || wanted.contains(&form.id())
    };
    let precisions = Precision::ALL.into_iter();
    let precisions: Vec<Precision> =
        precisions.filter(|one| precision.is_none_or(|only| only == *one)).collect();
    let mut forms = Vec::new();
    for precision in precisions {
        let of_precision = all.iter().filter(|form| form.axes.precision == precision.name());
        for form in of_precision.filter(|form| is_wanted(form)) {
            forms.push(Form { asked: form, name: name(form), precision });
        }
    }
    Ok(forms)
}

/// Ids of all kernels and forms, for suggestions.
pub fn known_words() -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    for form in asked() {
        for word in [form.about.id.to_owned(), form.id()] {
            if !words.contains(&word) {
                words.push(word);
            }
        }
    }
    words
}

const FLUSHED: &str = "subnormals=flushed";

fn flushes(form: &Asked) -> bool {
    form.id().split('/').any(|word| word == FLUSHED)
}

fn is_usual(form: &Asked) -> bool {
    if form.about.watertight && !flushes(form) {
        return form.axes.division == usual(form).axes.division;
    }
    // What it would be called without flushing.
    let id = form.id();
    let id: Vec<&str> = id.split('/').filter(|word| *word != FLUSHED).collect();
    usual(form).id() == id.join("/")
}

/// The usual form of a form's kernel in its precision: divided last and rounded plainly, where
/// there are several, and the first one of the registry besides.
fn usual(form: &Asked) -> &'static Asked {
    let alike = asked_with_peers().filter(|other| {
        other.about.id == form.about.id
            && other.axes.precision == form.axes.precision
            && !flushes(other)
    });
    let rank = |form: &&Asked| {
        let axes = &form.axes;
        (
            axes.tests != "compare",
            axes.rounding != "plain",
            axes.division != "last",
            !axes.stored_is_native,
        )
    };
    // `min_by_key` gives the first of equals; the form itself stands for a kernel without any.
    let first = alike.min_by_key(rank);
    first.unwrap_or(&asked()[0])
}

/// Place of the level in an id. Levels have the same bits, so that it is in no name.
const LEVEL: usize = 3;

fn name(form: &Asked) -> String {
    let (id, usual) = (form.id(), usual(form).id());
    let usual: Vec<&str> = usual.split('/').collect();
    let words = id.split('/').enumerate().filter(|(place, _)| *place != LEVEL);
    let other: Vec<&str> =
        words.map(|(_, word)| word).filter(|word| !usual.contains(word)).collect();
    std::iter::once(form.about.id).chain(other).collect::<Vec<_>>().join(" ")
}
