//! Writing a file wholly or not at all.

use super::TableError;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// Writes `bytes` to `path` so that a reader sees the old file or the new one, never a part:
/// into a temporary file in the same folder (a rename is atomic only within one file system),
/// synced to the disk, then renamed. On failure the temporary file is removed.
pub fn write_atomically(path: &Path, bytes: &[u8]) -> Result<(), TableError> {
    let failed = |source| TableError::Io { file: path.to_owned(), source };
    let temporary = temporary_name(path).map_err(failed)?;
    let written = write_synced(&temporary, bytes).and_then(|()| fs::rename(&temporary, path));
    if written.is_err() {
        // The first error is the one to report; that nothing was left to remove is no second one.
        fs::remove_file(&temporary).ok();
    }
    written.map_err(failed)?;
    sync_folder(path);
    Ok(())
}

fn temporary_name(path: &Path) -> io::Result<PathBuf> {
    static COUNTER: AtomicU64 = AtomicU64::new(0);
    let name = path
        .file_name()
        .ok_or_else(|| io::Error::new(io::ErrorKind::InvalidInput, "the path names no file"))?;
    let count = COUNTER.fetch_add(1, Ordering::Relaxed);
    let unique = format!(".{}.{}-{count}{PARTIAL}", name.to_string_lossy(), std::process::id());
    Ok(path.with_file_name(unique))
}

/// How the names of temporary files end; they begin with a dot.
const PARTIAL: &str = ".partial";

/// Removes the temporary files that a program which was killed has left in a folder; nobody else
/// may be writing there. What cannot be removed stays, and harms nobody.
pub fn remove_partial_files(folder: &Path) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let name = name.to_string_lossy();
        if name.starts_with('.') && name.ends_with(PARTIAL) {
            fs::remove_file(entry.path()).ok();
        }
    }
}

/// Makes a folder, and those above it, unless they are there.
///
/// # Errors
/// When it cannot be made.
pub fn make_folder(path: &Path) -> Result<(), TableError> {
    fs::create_dir_all(path).map_err(|source| TableError::Io { file: path.to_owned(), source })
}

/// Removes a file.
///
/// # Errors
/// When it is not there or cannot be removed.
pub fn remove_file(path: &Path) -> Result<(), TableError> {
    fs::remove_file(path).map_err(|source| TableError::Io { file: path.to_owned(), source })
}

/// Makes a folder unless it is there, and finds out whether it can be written.
///
/// # Errors
/// What the system says; or that there is something else of that name.
pub fn try_folder(path: &Path) -> io::Result<()> {
    // The system would say that it exists, which is what was asked for.
    if !path.is_dir() && path.symlink_metadata().is_ok() {
        let words = "there is something of that name that is no folder";
        return Err(io::Error::new(io::ErrorKind::NotADirectory, words));
    }
    fs::create_dir_all(path)?;
    can_write(path)
}

/// Whether a folder can be written: found out by a file that is removed at once.
///
/// # Errors
/// What the system says.
pub fn can_write(folder: &Path) -> io::Result<()> {
    let probe = temporary_name(&folder.join("probe"))?;
    OpenOptions::new().write(true).create_new(true).open(&probe)?;
    fs::remove_file(&probe)
}

fn write_synced(path: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
    file.write_all(bytes)?;
    file.flush()?;
    file.sync_all()
}

/// Makes the rename itself last through a power cut, where the system lets a folder be synced.
fn sync_folder(path: &Path) {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    if let Ok(folder) = File::open(folder.unwrap_or(Path::new("."))) {
        folder.sync_all().ok();
    }
}
