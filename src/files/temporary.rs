//! Temporaries beside the places of files, while they are written.
//!
//! ```text
//!   .plan.obj.dcel-part      locked: in use by a process that lives  ──> take .plan.obj.2.dcel-part
//!                            not locked: left by one that was killed ──> remove it, and take its name
//! ```

use super::place::one_file;
use std::ffi::OsString;
use std::fs::{self, File, Metadata, TryLockError};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The temporaries of this process. Whoever makes, renames or removes one holds the lock, so that a signal finds all.
static LIVE: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// So many runs may write the same file at the same time.
const MOST: u32 = 100;
/// Names with more bytes than this are cut off: file systems know at most 255.
const LONGEST_NAME: usize = 200;

fn live() -> MutexGuard<'static, Vec<PathBuf>> {
    LIVE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes all temporaries of this process, for one that is about to end: whoever wants to write after this waits for
/// ever.
pub fn abandon_all() {
    let mut live = live();
    for path in live.drain(..) {
        remove(&path);
    }
    std::mem::forget(live);
}

/// A file or folder that goes when this is dropped, unless it was renamed.
#[derive(Debug)]
pub(super) struct Temporary {
    path: PathBuf,
    /// What is locked.
    _lock: Option<File>,
}

impl Temporary {
    /// An empty file beside `target`; a `private` one is for nobody else's eyes.
    pub(super) fn file(target: &Path, private: bool) -> io::Result<(Self, File)> {
        let mut options = File::options();
        options.write(true).create_new(true);
        #[cfg(unix)]
        if private {
            std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
        }
        #[cfg(not(unix))]
        let _ = private;
        let temporary = Self::make(target, Metadata::is_file, |path| options.open(path).map(Some))?;
        let Self { path: _, _lock: Some(lock) } = &temporary else { return Err(io::ErrorKind::NotFound.into()) };
        let file = lock.try_clone()?;
        Ok((temporary, file))
    }

    /// An empty folder beside `target`.
    pub(super) fn folder(target: &Path) -> io::Result<Self> {
        Self::make(target, Metadata::is_dir, |path| {
            fs::create_dir(path)?;
            // Elsewhere folders cannot be opened, and so not be locked.
            if cfg!(unix) { opened(path).map(Some) } else { Ok(None) }
        })
    }

    /// Makes a temporary of a kind.
    fn make(
        target: &Path,
        is_kind: fn(&Metadata) -> bool,
        create: impl Fn(&Path) -> io::Result<Option<File>>,
    ) -> io::Result<Self> {
        let Some(name) = target.file_name() else { return Err(io::ErrorKind::InvalidFilename.into()) };
        let mut live = live();
        for number in 1..=MOST {
            let path = target.with_file_name(hidden(name, number));
            let claimed = claim(&path, is_kind, &create).map_err(|error| in_the_folder(&error, target))?;
            if let Some(lock) = claimed {
                live.push(path.clone());
                return Ok(Self { path, _lock: lock });
            }
        }
        Err(io::Error::other(format!("{MOST} others are writing it")))
    }

    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Writes a file into a temporary folder.
    pub(super) fn write(&self, path: &str, bytes: &[u8]) -> io::Result<()> {
        // A folder that grows could not be removed.
        let _live = live();
        let path = self.path.join(path);
        fs::create_dir_all(path.parent().unwrap_or(&self.path))?;
        fs::write(path, bytes)
    }

    /// Gives it its name.
    pub(super) fn rename(self, target: &Path) -> io::Result<()> {
        let mut live = live();
        let done = fs::rename(&self.path, target);
        if done.is_ok() {
            live.retain(|path| *path != self.path);
        }
        drop(live);
        done
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let mut live = live();
        if let Some(at) = live.iter().position(|path| *path == self.path) {
            remove(&live.swap_remove(at));
        }
    }
}

/// Nothing can be done about one that stays: the next run replaces it.
fn remove(path: &Path) {
    // A program that this one started may still write into a folder.
    for _ in 0..10 {
        let removed = if path.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
        if removed.is_ok() || fs::symlink_metadata(path).is_err() {
            return;
        }
    }
}

/// `.plan.obj.dcel-part`, `.plan.obj.2.dcel-part`, ...
fn hidden(name: &std::ffi::OsStr, number: u32) -> OsString {
    let mut hidden = OsString::from(".");
    if name.len() <= LONGEST_NAME {
        hidden.push(name);
    } else {
        hidden.push(name.to_string_lossy().chars().take(LONGEST_NAME / 4).collect::<String>());
    }
    hidden.push(if number == 1 { ".dcel-part".to_owned() } else { format!(".{number}.dcel-part") });
    hidden
}

/// Opens a folder that was just made. If it is gone, [`claim`] tries again: it was not locked yet, and so another process
/// that looked for what was left behind has removed it.
fn opened(path: &Path) -> io::Result<File> {
    File::open(path).map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => io::ErrorKind::Interrupted.into(),
        _ => error,
    })
}

/// Makes a temporary under this name and locks it. Nothing if somebody else uses the name.
fn claim(
    path: &Path,
    is_kind: fn(&Metadata) -> bool,
    create: impl Fn(&Path) -> io::Result<Option<File>>,
) -> io::Result<Option<Option<File>>> {
    for _ in 0..3 {
        match create(path) {
            Ok(Some(file)) => match file.try_lock() {
                // Somebody took it for one that was left behind, and removes it.
                Err(TryLockError::WouldBlock) => return Ok(None),
                // Without locks nothing of others is ever removed.
                Ok(()) | Err(TryLockError::Error(_)) if is_at(&file, path) => return Ok(Some(Some(file))),
                Ok(()) | Err(TryLockError::Error(_)) => {}
            },
            Ok(None) => return Ok(Some(None)),
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                if !clear(path, is_kind) {
                    return Ok(None);
                }
            }
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(None)
}

/// Removes what a killed process left under this name: what nobody has locked.
fn clear(path: &Path, is_kind: fn(&Metadata) -> bool) -> bool {
    let is_ours = fs::symlink_metadata(path).is_ok_and(|data| is_kind(&data));
    let Some(old) = is_ours.then(|| File::open(path).ok()).flatten() else { return false };
    if old.try_lock().is_err() || !is_at(&old, path) {
        return false;
    }
    remove(path);
    true
}

/// Whether an open file still has this name.
fn is_at(file: &File, path: &Path) -> bool {
    match (file.metadata(), fs::symlink_metadata(path)) {
        (Ok(open), Ok(there)) => cfg!(not(unix)) || one_file((path, &open), (path, &there)),
        _ => false,
    }
}

/// Says that the folder is to blame, where the machine speaks of a file that nobody has named.
fn in_the_folder(error: &io::Error, target: &Path) -> io::Error {
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    match error.kind() {
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => io::Error::new(
            error.kind(),
            format!(
                "no file can be made in {}, where it is written before it takes its name: {error}",
                folder.display()
            ),
        ),
        kind => io::Error::new(kind, error.to_string()),
    }
}
