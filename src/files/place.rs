//! Where a name leads.

use std::fs::{self, Metadata};
use std::io;
use std::path::{Path, PathBuf};

/// What is to be written under a name.
pub(super) enum Place {
    /// Standard output, under the name of its descriptor: a file that it is redirected to is not begun anew.
    Stdout,
    /// A device, a pipe, or another descriptor of a process: written to as it is.
    Stream(PathBuf),
    /// An ordinary file, there or not, by its own name: links are followed.
    File { path: PathBuf, old: Option<Metadata> },
}

/// So many links one after the other lead in a circle.
const MOST_LINKS: usize = 40;

impl Place {
    /// Where `path` leads. A directory is an error.
    pub(super) fn of(path: &Path) -> io::Result<Self> {
        if path.as_os_str().as_encoded_bytes().last().is_some_and(|&b| std::path::is_separator(b.into())) {
            return Err(io::ErrorKind::IsADirectory.into());
        }
        let mut path = path.to_owned();
        for _ in 0..MOST_LINKS {
            match descriptor(&path) {
                Some(1) => return Ok(Self::Stdout),
                Some(_) => return Ok(Self::Stream(path)),
                None => {}
            }
            match fs::symlink_metadata(&path) {
                Ok(data) if data.is_symlink() => {
                    let to = fs::read_link(&path)?;
                    path = path.parent().map_or_else(|| to.clone(), |folder| folder.join(&to));
                }
                Ok(data) if data.is_dir() => return Err(io::ErrorKind::IsADirectory.into()),
                Ok(data) if data.is_file() => return Ok(Self::File { path, old: Some(data) }),
                Ok(_) => return Ok(Self::Stream(path)),
                Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Self::File { path, old: None }),
                Err(error) => return Err(error),
            }
        }
        Err(io::Error::other("its links lead in a circle"))
    }
}

/// The number of an open file of this process, if that is what the name means: `/dev/fd/3`, `/proc/self/fd/3`.
#[cfg(unix)]
fn descriptor(path: &Path) -> Option<u32> {
    let number = path.file_name()?.to_str()?.parse().ok()?;
    let folder = path.parent()?.canonicalize().ok()?;
    let own = Path::new("/proc").join(std::process::id().to_string());
    let is_one = folder == Path::new("/dev/fd") || (folder.starts_with(own) && folder.ends_with("fd"));
    is_one.then_some(number)
}

#[cfg(not(unix))]
fn descriptor(_: &Path) -> Option<u32> {
    None
}

/// Whether both names lead to one ordinary file: by path, by links, by hard links. Names of files that are not there
/// are the same if they would be one file. Devices and pipes are never the same: what is written to them is not lost
/// by writing more.
#[must_use]
pub fn is_same_file(a: &Path, b: &Path) -> bool {
    let (Ok(Place::File { path: a, old: old_a }), Ok(Place::File { path: b, old: old_b })) =
        (Place::of(a), Place::of(b))
    else {
        return false;
    };
    match (old_a, old_b) {
        (Some(old_a), Some(old_b)) => one_file((&a, &old_a), (&b, &old_b)),
        (None, None) => {
            let place = |path: &Path| {
                let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
                Some((folder.canonicalize().ok()?, path.file_name()?.to_owned()))
            };
            place(&a).is_some_and(|there| place(&b) == Some(there))
        }
        _ => false,
    }
}

/// Whether standard input is the ordinary file of this name: `< plan.obj` of a shell.
#[cfg(unix)]
#[must_use]
pub fn is_standard_input(path: &Path) -> bool {
    use std::os::fd::AsFd;
    let Ok(Place::File { path, old: Some(old) }) = Place::of(path) else { return false };
    let input = io::stdin().as_fd().try_clone_to_owned().map(fs::File::from);
    input.and_then(|file| file.metadata()).is_ok_and(|input| one_file((&path, &old), (&path, &input)))
}

/// Whether standard input is the ordinary file of this name: `< plan.obj` of a shell. Not known here.
#[cfg(not(unix))]
#[must_use]
pub fn is_standard_input(_: &Path) -> bool {
    false
}

#[cfg(unix)]
pub(super) fn one_file((_, a): (&Path, &Metadata), (_, b): (&Path, &Metadata)) -> bool {
    use std::os::unix::fs::MetadataExt;
    (a.dev(), a.ino()) == (b.dev(), b.ino())
}

#[cfg(not(unix))]
pub(super) fn one_file((a, _): (&Path, &Metadata), (b, _): (&Path, &Metadata)) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}
