//! The files that `render` writes: whether they can be written is found out before anything runs.

use std::path::{Path, PathBuf};

use super::failure::Failure;
use super::render::{Render, beside};
use super::render_frames::Shown;
use super::render_kernels::Chosen;
use crate::render::Picture;
use crate::table::{can_write, write_atomically};

/// Where pictures go.
pub struct Files {
    picture: PathBuf,
    /// One a kernel; none without `--compare`.
    differences: Vec<PathBuf>,
}

/// Where pictures go, if they can.
///
/// # Errors
/// Usage for a name that is no PNG file's, or a folder that is not there or cannot be written.
pub fn check(arguments: &Render, chosen: &[Chosen]) -> Result<Files, Failure> {
    let path = &arguments.out;
    let refused = |what: String| Failure::Usage(format!("--out: {}: {what}", path.display()));
    let ending = path.extension().and_then(|ending| ending.to_str());
    if !ending.is_some_and(|ending| ending.eq_ignore_ascii_case("png")) {
        return Err(refused("allowed: a name that ends in .png".into()));
    }
    if path.is_dir() {
        return Err(refused("a folder; allowed: a file".into()));
    }
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    can_write(folder.unwrap_or(Path::new("."))).map_err(|error| {
        refused(format!("{error}; allowed: a file in a folder that can be written"))
    })?;
    let name = |one: &Chosen| match chosen.len() {
        1 => beside(path, "-compare"),
        // Ids have slashes.
        _ => beside(path, &format!("-{}-compare", one.word.replace('/', "-"))),
    };
    let compared = chosen.iter().filter(|_| arguments.compare);
    Ok(Files { picture: path.clone(), differences: compared.map(name).collect() })
}

impl Files {
    /// Writes the picture of the first kernel, and the differences of each.
    ///
    /// # Errors
    /// What the system says.
    pub fn write(&self, shown: &[&Shown]) -> Result<(), Failure> {
        if let Some(frame) = shown.first().and_then(|one| one.frame.as_ref()) {
            write(&self.picture, &frame.picture)?;
        }
        for (path, one) in self.differences.iter().zip(shown) {
            if let Some(differences) = &one.differences {
                write(path, &differences.painted)?;
            }
        }
        Ok(())
    }
}

fn write(path: &Path, picture: &Picture) -> Result<(), Failure> {
    let bytes = picture.png().map_err(|error| Failure::Runtime(error.into()))?;
    write_atomically(path, &bytes)?;
    say!("{}", path.display());
    Ok(())
}
