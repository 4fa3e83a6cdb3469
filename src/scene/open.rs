//! The mesh that a word on the command line means.

use super::built_in::{self, ALL};
use super::mesh::{Mesh, load};
use crate::check::read::ReadError;
use std::io::ErrorKind;

/// A built-in scene by its name, with a size behind a colon if wanted, or the mesh in a file.
///
/// # Errors
/// What is wrong with the name or the file, where, and what is allowed.
pub fn open(model: &str) -> Result<Mesh, ReadError> {
    if let Some(mesh) = built_in::named(model) {
        return mesh;
    }
    load(model).map_err(|error| match error {
        ReadError::Io { file, source } if source.kind() == ErrorKind::NotFound => {
            let names: Vec<&str> = ALL.iter().map(|scene| scene.name).collect();
            let wanted = model.split(':').next().unwrap_or(model);
            let alike = |name: &str| strsim::jaro_winkler(wanted, name);
            let best = names.iter().copied().max_by(|a, b| alike(a).total_cmp(&alike(b)));
            let hint = best.filter(|best| alike(best) >= ALIKE);
            let hint = hint.map(|best| format!(". Did you mean '{best}'?")).unwrap_or_default();
            let names = names.join(", ");
            let message = format!("no such file or scene; allowed: a file, or {names}{hint}");
            ReadError::Whole { file, message }
        }
        error => error,
    })
}

/// How alike a name must be to be offered (Jaro-Winkler, 1 is equal).
const ALIKE: f64 = 0.8;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_scenes_and_others_are_files() {
        assert_eq!(open("icosphere:0").map(|mesh| mesh.triangles.len()).ok(), Some(20));
        let refusal = |model: &str| open(model).expect_err("it must be refused").to_string();
        let text = refusal("icospere");
        assert!(text.starts_with("icospere: no such file or scene; allowed: a file, or"), "{text}");
        assert!(text.ends_with("Did you mean 'icosphere'?"), "{text}");
        assert!(!refusal("nothing.obj").contains("Did you mean"));
    }
}
