//! Where work folders are: a folder of the grader's own, through which a user without an account can pass but not look.

use crate::sandbox::{Sandbox, unguessable};
use std::fs::{self, DirBuilder};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};

/// The folder of the work folders of one grading run; removed with everything in it when this is dropped.
#[derive(Debug)]
pub(crate) struct WorkFolders {
    folder: PathBuf,
    taken: AtomicU64,
}

impl WorkFolders {
    /// A new folder in `parent`, or else where the system keeps temporary files.
    pub(crate) fn new(sandbox: &Sandbox, parent: Option<&Path>) -> io::Result<Self> {
        let usual = [std::env::temp_dir(), PathBuf::from("/var/tmp"), PathBuf::from("/tmp")];
        let places = parent.map_or_else(|| usual.to_vec(), |parent| vec![parent.to_path_buf()]);
        // Only a folder that everybody may pass through can hold the room of another user.
        let fits = |place: &&PathBuf| place.is_dir() && (!sandbox.up().own_user || is_open(place));
        let place = places.iter().find(fits).ok_or_else(|| {
            io::Error::other(format!("{} is closed to other users: name another folder", places[0].display()))
        })?;
        let folder = place.canonicalize()?.join(format!("dcel-{}", unguessable()));
        let mut builder = DirBuilder::new();
        let_in(&mut builder, if sandbox.up().own_user { 0o711 } else { 0o700 });
        builder.create(&folder)?;
        Ok(Self { folder, taken: AtomicU64::new(0) })
    }

    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }

    /// The path of a room that nobody had before. It does not exist yet.
    pub(crate) fn next(&self) -> PathBuf {
        self.folder.join(self.taken.fetch_add(1, Ordering::Relaxed).to_string())
    }
}

impl Drop for WorkFolders {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// Says who may enter a folder that is made, where the system knows such a thing.
fn let_in(builder: &mut DirBuilder, mode: u32) {
    #[cfg(unix)]
    {
        use std::os::unix::fs::DirBuilderExt;
        builder.mode(mode);
    }
    #[cfg(not(unix))]
    {
        let _ = (builder, mode);
    }
}

fn is_open(path: &Path) -> bool {
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let Ok(path) = path.canonicalize() else { return false };
        path.ancestors().all(|part| part.metadata().is_ok_and(|data| data.mode() & 0o001 != 0))
    }
    #[cfg(not(unix))]
    {
        let _ = path;
        true
    }
}
