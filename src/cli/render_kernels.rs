//! Which kernels `render` makes pictures with.

use super::failure::Failure;
use crate::check::{Precision, form, kernels};
use crate::job::Answer;
use crate::oracle::Query;
use crate::registry::{Asked, LeafForm, Variant, asked, find, leaves};
use crate::render::AskingLeaf;
use crate::structure::Leaf;
use crate::workload::Triangle;

/// A form of a kernel, by the word that it was asked for by.
pub struct Chosen {
    /// The word: the column `kernel`.
    pub word: String,
    /// The variant's id.
    pub id: String,
    /// It answers about the segment from origin to end, not about the ray.
    pub is_segment: bool,
    /// A wrong answer that rounding does not explain is a fault.
    pub claims_exactness: bool,
    prepare: Prepare,
}

/// How triangles are prepared.
#[derive(Clone, Copy)]
enum Prepare {
    /// Once, before the first ray, as renderers do.
    Once(fn(&[Triangle]) -> Box<dyn Leaf>),
    /// Anew for every test: forms that are built for their answers alone.
    EveryTest(fn(&Query) -> Answer),
}

impl Chosen {
    fn of(word: &str, asked: &Asked) -> Self {
        let id = asked.id();
        let once = leaves().into_iter().find(|leaf: &LeafForm| leaf.axes.id() == id);
        Chosen {
            word: word.to_owned(),
            is_segment: asked.is_segment,
            claims_exactness: find(&id).is_some_and(Variant::claims_exactness),
            prepare: once.map_or(Prepare::EveryTest(asked.ask), |leaf| Prepare::Once(leaf.prepare)),
            id,
        }
    }

    /// Whether triangles are prepared once, so that the time says something.
    pub fn prepares_once(&self) -> bool {
        matches!(self.prepare, Prepare::Once(_))
    }

    /// Triangles, prepared.
    pub fn leaf(&self, triangles: &[Triangle]) -> Box<dyn Leaf> {
        match self.prepare {
            Prepare::Once(prepare) => prepare(triangles),
            Prepare::EveryTest(ask) => {
                let hit = move |query: &Query| {
                    let Answer { triangle, t, u, v, .. } = ask(query);
                    triangle.map(|_| [t, u, v])
                };
                Box::new(AskingLeaf::new(Box::new(hit), triangles, self.is_segment))
            }
        }
    }
}

/// The forms asked for.
///
/// # Errors
/// Usage for an unknown word, and for one that stands there twice.
pub fn chosen(words: &[String]) -> Result<Vec<Chosen>, Failure> {
    let mut chosen: Vec<Chosen> = Vec::new();
    for word in words {
        let Some(asked) = form_of(word) else { return Err(refused(word)) };
        let new = Chosen::of(word, asked);
        if chosen.iter().any(|other| other.id == new.id) {
            return Err(Failure::Usage(format!("--kernel: '{word}' stands there twice")));
        }
        chosen.push(new);
    }
    Ok(chosen)
}

/// A kernel's own form in f32, or the one with that id: meshes are of f32 numbers.
fn form_of(word: &str) -> Option<&'static Asked> {
    if word.contains('/') {
        forms().find(|form| form.id() == word)
    } else {
        form(word, Precision::F32)
    }
}

fn forms() -> impl Iterator<Item = &'static Asked> {
    asked().iter().filter(|form| form.axes.precision == Precision::F32.name())
}

fn refused(word: &str) -> Failure {
    let in_full = forms().map(Asked::id).filter(|_| word.contains('/'));
    let known = kernels().into_iter().map(str::to_owned).chain(in_full);
    let alike = |known: &String| strsim::jaro_winkler(word, known);
    let best = known.max_by(|a, b| alike(a).total_cmp(&alike(b)));
    Failure::Usage(format!(
        "--kernel: '{word}' is not allowed; allowed: {} and full ids of their single early forms in \
         f32 with output tuv{}",
        kernels().join(", "),
        best.map(|best| format!(". Did you mean '{best}'?")).unwrap_or_default()
    ))
}
