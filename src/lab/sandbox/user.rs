//! A user of its own for a submission: a number that nobody has, taken for a while.
//!
//! ```text
//!   take ──▶ lock the number ──▶ build and run as it ──▶ end everything of it ──▶ remove what it left ──▶ unlock
//! ```
//!
//! The numbers are those that service managers use for users without an account. A number is free if no account has
//! it, no process runs as it, and no other grader holds its lock.

use super::processes::processes;
use nix::fcntl::{Flock, FlockArg};
use std::fs::{self, DirBuilder, File};
use std::io;
use std::os::unix::fs::{DirBuilderExt, MetadataExt};
use std::path::{Path, PathBuf};

/// Numbers for users without an account.
const NUMBERS: std::ops::Range<u32> = 61_184..65_000;

/// A number, held until this is dropped.
#[derive(Debug)]
pub(super) struct OwnUser {
    pub(super) id: u32,
    _lock: Flock<File>,
}

impl OwnUser {
    /// Takes the first free number.
    pub(super) fn take() -> io::Result<Self> {
        let locks = lock_folder()?;
        let accounts = fs::read_to_string("/etc/passwd").unwrap_or_default();
        let known: Vec<u32> = accounts.lines().filter_map(|line| line.split(':').nth(2)?.parse().ok()).collect();
        let running = processes();
        for id in NUMBERS {
            if known.contains(&id) || running.iter().any(|process| process.user == id) {
                continue;
            }
            let file = File::options().create(true).append(true).open(locks.join(id.to_string()))?;
            match Flock::lock(file, FlockArg::LockExclusiveNonblock) {
                Ok(lock) => return Ok(Self { id, _lock: lock }),
                Err((_, nix::errno::Errno::EWOULDBLOCK)) => {}
                Err((_, error)) => return Err(error.into()),
            }
        }
        Err(io::Error::other("every number for a user without an account is taken"))
    }

    /// Whether anything still runs as this user.
    pub(super) fn is_running(&self) -> bool {
        processes().iter().any(|process| process.user == self.id && !process.zombie)
    }

    /// Removes what this user left where everybody may write. Nothing may run as it any more.
    pub(super) fn clear(&self) {
        for folder in ["/tmp", "/var/tmp", "/dev/shm", "/dev/mqueue"] {
            let Ok(entries) = fs::read_dir(folder) else { continue };
            for entry in entries.filter_map(Result::ok) {
                let Ok(data) = entry.metadata() else { continue };
                if data.uid() == self.id {
                    let _ =
                        if data.is_dir() { fs::remove_dir_all(entry.path()) } else { fs::remove_file(entry.path()) };
                }
            }
        }
    }
}

/// A folder for locks that only root can write.
fn lock_folder() -> io::Result<PathBuf> {
    let run = Path::new("/run");
    let base = if run.is_dir() { run.to_path_buf() } else { std::env::temp_dir() };
    let folder = base.join("dcel-users");
    match DirBuilder::new().mode(0o700).create(&folder) {
        Err(error) if error.kind() != io::ErrorKind::AlreadyExists => return Err(error),
        _ => {}
    }
    let data = fs::symlink_metadata(&folder)?;
    if data.is_dir() && data.uid() == 0 && data.mode() & 0o077 == 0 {
        return Ok(folder);
    }
    Err(io::Error::other(format!("{} is not root's own", folder.display())))
}
