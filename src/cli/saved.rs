//! Files that are saved: what is to be done again is told here.
//!
//! ```text
//!   editor writes in steps ──▶ events of the folder ──▶ of our files only ──▶ quiet for a moment ──▶ again
//! ```

use super::Failure;
use notify::{RecommendedWatcher, RecursiveMode, Watcher};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::Duration;

/// Editors write a file in several steps; this long after the last of them it is complete.
pub(crate) const QUIET: Duration = Duration::from_millis(60);

/// Tells of every file that changes below a folder that is added to the watcher. `tell` says whether anybody listens.
pub(crate) fn watcher(tell: impl Fn(PathBuf) -> bool + Send + 'static) -> notify::Result<RecommendedWatcher> {
    notify::recommended_watcher(move |event: notify::Result<notify::Event>| {
        // Whoever reads the file opens it, too: only changes count, or each work would start the next one.
        if let Some(event) = event.ok().filter(|event| !event.kind.is_access()) {
            // Nobody listens any more only when the program ends.
            let _ = event.paths.into_iter().all(&tell);
        }
    })
}

/// Whether a path is one of some files, by its last part: paths of events are written in full.
pub(crate) fn is_one_of(path: &Path, files: &[PathBuf]) -> bool {
    path.file_name().is_some_and(|name| files.iter().any(|file| file.file_name() == Some(name)))
}

/// Some files, watched.
pub(crate) struct Saved {
    files: Vec<PathBuf>,
    events: Receiver<PathBuf>,
    /// Listens as long as it is there.
    _watcher: RecommendedWatcher,
}

impl Saved {
    /// Begins to watch.
    pub(crate) fn watch(files: Vec<PathBuf>) -> Result<Self, Failure> {
        let (send, events) = channel();
        let cannot = |error: notify::Error| {
            Failure::machine(format!("the files cannot be watched: {error}"), "leave --watch out, and call it again")
        };
        let mut watcher = watcher(move |path| send.send(path).is_ok()).map_err(cannot)?;
        let mut folders: Vec<&Path> = files.iter().map(|file| folder(file)).collect();
        folders.sort_unstable();
        folders.dedup();
        for folder in folders {
            // The folder and not the file: editors replace files.
            watcher.watch(folder, RecursiveMode::NonRecursive).map_err(cannot)?;
        }
        Ok(Self { files, events, _watcher: watcher })
    }

    /// Waits until one of the files has been saved. Whether there is anything more to wait for.
    pub(crate) fn again(&self) -> bool {
        loop {
            match self.events.recv() {
                Ok(path) if is_one_of(&path, &self.files) => break,
                Ok(_) => {}
                Err(_) => return false,
            }
        }
        loop {
            match self.events.recv_timeout(QUIET) {
                Ok(_) => {}
                Err(RecvTimeoutError::Timeout) => return true,
                Err(RecvTimeoutError::Disconnected) => return false,
            }
        }
    }
}

/// The folder of a file.
fn folder(file: &Path) -> &Path {
    file.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}
