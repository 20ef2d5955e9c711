//! Files and folders that appear whole or not at all.
//!
//! ```text
//!                         create           write            commit
//!   .plan.obj.dcel-part   ▒                ▒▒▒▒▒▒▒▒ ──rename──╮
//!   plan.obj              the old file     the old file       ╰──> the new one
//! ```
//!
//! A file is written to a temporary beside its place and renamed when it is complete. So nobody ever reads half of
//! it, and whatever ends the work before (a full disk, an error, a signal, a lost machine) leaves the old file as it
//! was. A temporary is removed when the work fails; one that a killed process left behind is replaced by the next run
//! that writes the same file. It is locked while it is in use, so that two runs at the same time never share one.
//!
//! What is not an ordinary file (a device, a pipe, `/dev/stdout`) is written to as it is. Links are followed: the file
//! behind them is replaced, and they stay. The new file has the permissions of the old one, and its owner where that is
//! allowed; its other hard links keep the old contents. A file that may not be written to is not replaced either.

mod place;
mod temporary;

use place::Place;
use std::fs::{self, File, Metadata};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use temporary::Temporary;

pub use place::{is_same_file, is_standard_input};
pub use temporary::abandon_all;

/// A file that is there whole after [`commit`](Self::commit), and not at all without.
///
/// It does not buffer: wrap it in a [`BufWriter`](io::BufWriter) for many small writes.
///
/// ```
/// use dcel_kit::files::WholeFile;
/// use std::io::Write;
/// # let folder = std::env::temp_dir().join(format!("dcel-doc-whole-{}", std::process::id()));
/// # std::fs::create_dir_all(&folder)?;
/// let path = folder.join("notes.txt");
/// let mut file = WholeFile::create(&path)?;
/// file.write_all(b"half of it, ")?;
/// assert!(!path.exists());
/// file.write_all(b"all of it\n")?;
/// file.commit()?;
/// assert_eq!(std::fs::read_to_string(&path)?, "half of it, all of it\n");
/// # std::fs::remove_dir_all(&folder)?;
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct WholeFile(Sink);

#[derive(Debug)]
enum Sink {
    /// Standard output under the name of a file.
    Stdout,
    /// A device or a pipe.
    Stream(File),
    File {
        file: File,
        temporary: Temporary,
        target: PathBuf,
        /// Whether there is a file of that name.
        replaces: bool,
    },
}

impl WholeFile {
    /// Begins to write a file.
    ///
    /// # Errors
    /// What the machine says: a folder that is not there or may not be written to, a directory of that name, a file
    /// that may not be written to.
    pub fn create(path: &Path) -> io::Result<Self> {
        Ok(Self(match Place::of(path)? {
            Place::Stdout => Sink::Stdout,
            Place::Stream(path) => Sink::Stream(File::options().write(true).open(path)?),
            Place::File { path: target, old } => {
                if old.is_some() {
                    // Renaming asks for the folder's permission alone.
                    File::options().write(true).open(&target)?;
                }
                let (temporary, file) = Temporary::file(&target, old.is_some())?;
                if let Some(old) = &old {
                    take_after(&file, old)?;
                }
                Sink::File { file, temporary, target, replaces: old.is_some() }
            }
        }))
    }

    /// Puts the file in its place.
    ///
    /// # Errors
    /// What the machine says; then the old file is as it was.
    pub fn commit(self) -> io::Result<()> {
        match self.0 {
            Sink::Stdout => io::stdout().flush(),
            Sink::Stream(mut file) => file.flush(),
            Sink::File { file, temporary, target, replaces } => {
                if replaces {
                    on_disk(&file)?;
                }
                temporary.rename(&target)
            }
        }
    }
}

impl Write for WholeFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.0 {
            Sink::Stdout => io::stdout().write(bytes),
            Sink::Stream(file) | Sink::File { file, .. } => file.write(bytes),
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.0 {
            Sink::Stdout => io::stdout().flush(),
            Sink::Stream(file) | Sink::File { file, .. } => file.flush(),
        }
    }
}

/// The old file goes when the new one takes its name: by then the new one must not only be in the machine's memory.
fn on_disk(file: &File) -> io::Result<()> {
    match file.sync_data() {
        // Some file systems cannot do this.
        Err(error) if matches!(error.kind(), io::ErrorKind::InvalidInput | io::ErrorKind::Unsupported) => Ok(()),
        done => done,
    }
}

/// Gives a new file the owner, where that is allowed, and the permissions of the old one.
fn take_after(file: &File, old: &Metadata) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, fchown};
        let new = file.metadata()?;
        let changed = |old: u32, new: u32| (old != new).then_some(old);
        // One by one: a user may choose among his groups, and only the administrator among the owners.
        for (owner, group) in [(None, changed(old.gid(), new.gid())), (changed(old.uid(), new.uid()), None)] {
            if owner.is_some() || group.is_some() {
                let _ = fchown(file, owner, group);
            }
        }
    }
    file.set_permissions(old.permissions())
}

/// Writes a file whole or not at all: see [`WholeFile`].
///
/// # Errors
/// What the machine says; then the old file is as it was.
pub fn write_whole(path: &Path, bytes: impl AsRef<[u8]>) -> io::Result<()> {
    let mut file = WholeFile::create(path)?;
    file.write_all(bytes.as_ref())?;
    file.commit()
}

/// A folder for work in between, in the system's folder for such things or beside a place: it goes when this is dropped, and when a
/// signal ends the program (see [`abandon_all`]).
#[derive(Debug)]
pub struct ScratchFolder(Temporary);

impl ScratchFolder {
    /// An empty folder; the name says whose it is, others may use the same.
    ///
    /// # Errors
    /// What the machine says.
    pub fn new(name: &str) -> io::Result<Self> {
        Self::beside(&std::env::temp_dir().join(name))
    }

    /// An empty folder in the folder of `target`, with a hidden name made of its name. What a process that was killed
    /// left behind there under such a name is removed.
    ///
    /// # Errors
    /// What the machine says.
    pub fn beside(target: &Path) -> io::Result<Self> {
        Temporary::folder(target).map(Self)
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        self.0.path()
    }
}

/// A folder that is there with all its files after [`commit`](Self::commit), and not at all without.
#[derive(Debug)]
pub struct WholeFolder {
    temporary: Temporary,
    target: PathBuf,
}

impl WholeFolder {
    /// Begins to make a folder. One of that name must be empty.
    ///
    /// # Errors
    /// [`io::ErrorKind::DirectoryNotEmpty`], [`io::ErrorKind::NotADirectory`], or what the machine says.
    pub fn create(path: &Path) -> io::Result<Self> {
        match fs::read_dir(path).map(|mut entries| entries.next().is_some()) {
            Ok(true) => return Err(io::ErrorKind::DirectoryNotEmpty.into()),
            Ok(false) => {}
            Err(error) if error.kind() == io::ErrorKind::NotFound => {}
            Err(error) => return Err(error),
        }
        let target = match path.canonicalize() {
            Ok(there) => there,
            Err(_) => std::path::absolute(path)?,
        };
        let temporary = Temporary::folder(&target)?;
        if let Ok(old) = fs::metadata(&target) {
            fs::set_permissions(temporary.path(), old.permissions())?;
        }
        Ok(Self { temporary, target })
    }

    /// Writes a file into it, and makes the folders on the way; `path` is relative to the folder.
    ///
    /// # Errors
    /// What the machine says.
    pub fn write(&self, path: &str, bytes: &[u8]) -> io::Result<()> {
        self.temporary.write(path, bytes)
    }

    /// Puts the folder in its place; an empty one that was there gives way.
    ///
    /// # Errors
    /// What the machine says; then nothing of the folder is left.
    pub fn commit(self) -> io::Result<()> {
        if cfg!(not(unix)) && self.target.is_dir() {
            fs::remove_dir(&self.target)?;
        }
        self.temporary.rename(&self.target)
    }
}
