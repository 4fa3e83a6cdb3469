//! One measuring run at a time on a machine: two would spoil each other's times.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{ErrorKind, Read, Write};
use std::path::{Path, PathBuf};

use super::failure::Failure;
use crate::measure::now_rfc3339;

/// Environment variable that names another file.
const VARIABLE: &str = "RAY_TEST_LOCK";

/// The lock, held until it is dropped. The system releases it when the process ends, however it
/// does, so that no lock is ever left behind; the file stays, and means nothing by itself.
#[derive(Debug)]
pub struct Lock {
    _file: Option<File>,
}

/// Takes the lock of this machine. Where there can be none, that is said on stderr.
///
/// # Errors
/// If another run holds it.
pub fn take() -> Result<Lock, Failure> {
    let named = std::env::var_os(VARIABLE).filter(|path| !path.is_empty());
    let path = named.map_or_else(|| std::env::temp_dir().join("ray_test.lock"), PathBuf::from);
    take_file(&path)
}

fn take_file(path: &Path) -> Result<Lock, Failure> {
    let without = |error: &dyn std::fmt::Display| {
        say!(
            "note: {} cannot be locked ({error}): see to it yourself that nothing else measures; \
             {VARIABLE} names another file",
            path.display()
        );
        Ok(Lock { _file: None })
    };
    let mut file = match open(path) {
        Ok(file) => file,
        Err(error) => return without(&error),
    };
    match file.try_lock() {
        Ok(()) => {}
        Err(TryLockError::WouldBlock) => return Err(held(&mut file, path)),
        Err(TryLockError::Error(error)) => return without(&error),
    }
    let text = format!("pid {} since {}\n", std::process::id(), now_rfc3339());
    // The text is for the message of whoever comes next. A file of another user's can be locked
    // but not written; then the message names no holder.
    let _ = file.set_len(0).and_then(|()| file.write_all(text.as_bytes()));
    Ok(Lock { _file: Some(file) })
}

/// Opens the file, or makes it: for everybody, since it is one for the whole machine.
fn open(path: &Path) -> std::io::Result<File> {
    // Whoever follows a link writes into a file that somebody else has chosen.
    if std::fs::symlink_metadata(path).is_ok_and(|data| !data.is_file()) {
        return Err(std::io::Error::new(ErrorKind::InvalidInput, "it is no regular file"));
    }
    match OpenOptions::new().read(true).write(true).open(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => {}
        Err(error) if error.kind() == ErrorKind::PermissionDenied => return File::open(path),
        opened => return opened,
    }
    match OpenOptions::new().read(true).write(true).create_new(true).open(path) {
        Ok(file) => {
            #[cfg(unix)]
            {
                use std::os::unix::fs::PermissionsExt;
                // Without it others lock the file all the same, by reading it.
                let _ = file.set_permissions(std::fs::Permissions::from_mode(0o666));
            }
            Ok(file)
        }
        // Somebody else was faster.
        Err(error) if error.kind() == ErrorKind::AlreadyExists => File::open(path),
        Err(error) => Err(error),
    }
}

fn held(file: &mut File, path: &Path) -> Failure {
    let mut text = String::new();
    // Where a locked file cannot be read, the holder stays unnamed.
    let _ = file.take(200).read_to_string(&mut text);
    let holder = text.trim();
    let holder = if holder.is_empty() { String::new() } else { format!(" ({holder})") };
    Failure::Runtime(anyhow::anyhow!(
        "another run is measuring on this machine{holder}, and two at once spoil each other's \
         times; wait for its end, or stop it ({} is locked)",
        path.display()
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder of its own, removed when the test ends.
    struct Folder(PathBuf);

    impl Drop for Folder {
        fn drop(&mut self) {
            std::fs::remove_dir_all(&self.0).ok();
        }
    }

    fn folder(name: &str) -> Folder {
        let name = format!("ray_test-lock-{name}-{}", std::process::id());
        let path = std::env::temp_dir().join(name);
        std::fs::create_dir_all(&path).expect("a folder for temporary files");
        Folder(path)
    }

    #[test]
    fn held_once_and_free_again() {
        let folder = folder("held");
        let path = folder.0.join("lock");
        let lock = take_file(&path).expect("nobody holds it");
        let Err(Failure::Runtime(error)) = take_file(&path) else {
            unreachable!("it is held");
        };
        let message = error.to_string();
        let pid = format!("pid {} since", std::process::id());
        for part in [pid.as_str(), "another run", "spoil", "lock"] {
            assert!(message.contains(part), "no '{part}' in: {message}");
        }
        drop(lock);
        take_file(&path).expect("it is free again");
    }

    #[test]
    fn where_there_can_be_no_lock_the_run_goes_on() {
        let folder = folder("none");
        for path in [folder.0.join("no-such-folder/lock"), folder.0.clone()] {
            let lock = take_file(&path).expect("it goes on without");
            assert!(lock._file.is_none());
        }
    }
}
