//! The pristine tree: the lab's given files and the student's, under a manifest of our own.
//!
//! ```text
//!   room/                  the submission's own; nobody else's user can enter
//!     tree/Cargo.toml      written here: no build script, no tests, unsafe code forbidden
//!     tree/Cargo.lock      written here: nothing but the package itself
//!     tree/src/…           given, but for the student's file
//!     target/ tmp/ home/   where the compiler may write
//!     program              what was built, out of the compiler's reach again
//! ```

use super::intake::Intake;
use crate::lab::Lab;
use crate::lab::task::Sandbox;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// A room with a tree in it; removed when this is dropped.
#[derive(Debug)]
pub(crate) struct Tree {
    room: PathBuf,
    /// The package, and the program it builds.
    pub(super) package: String,
    /// The student's files, as paths in the lab.
    pub(super) graded: Vec<String>,
}

impl Tree {
    /// Lays the tree out in a new folder `room`.
    pub(crate) fn lay(room: PathBuf, lab: &Lab, intake: &Intake, sandbox: &dyn Sandbox) -> io::Result<Self> {
        let manifest = &lab.manifest;
        let tree = Self { room, package: manifest.package.clone(), graded: manifest.graded.clone() };
        fs::create_dir(&tree.room)?;
        own_only(&tree.room, 0o750)?;
        sandbox.let_in(&tree.room)?;
        for folder in [tree.target(), tree.tmp(), tree.home()] {
            fs::create_dir(&folder)?;
            own_only(&folder, 0o700)?;
            sandbox.give(&folder)?;
        }
        let given =
            lab.files.iter().filter(|(path, _)| path.starts_with("src/") && !manifest.graded.iter().any(|g| g == path));
        let students = intake.graded.iter().map(|(path, text)| (path.as_str(), text.as_str()));
        for (path, text) in given.chain(students) {
            let file = tree.folder().join(path);
            fs::create_dir_all(file.parent().unwrap_or(&tree.room))?;
            fs::write(file, text)?;
        }
        fs::write(tree.folder().join("Cargo.toml"), manifest_of(&tree.package))?;
        fs::write(tree.folder().join("Cargo.lock"), lock_of(&tree.package))?;
        Ok(tree)
    }

    pub(super) fn folder(&self) -> PathBuf {
        self.room.join("tree")
    }

    pub(super) fn target(&self) -> PathBuf {
        self.room.join("target")
    }

    pub(super) fn tmp(&self) -> PathBuf {
        self.room.join("tmp")
    }

    pub(super) fn home(&self) -> PathBuf {
        self.room.join("home")
    }

    pub(super) fn program(&self) -> PathBuf {
        self.room.join("program")
    }
}

impl Drop for Tree {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.room);
    }
}

/// Sets who may enter, where the system knows such a thing.
pub(super) fn own_only(path: &Path, mode: u32) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        fs::set_permissions(path, fs::Permissions::from_mode(mode))
    }
    #[cfg(not(unix))]
    {
        let _ = (path, mode);
        Ok(())
    }
}

/// The manifest. Overflow is checked as in the student's own build, so that the same cases panic.
fn manifest_of(package: &str) -> String {
    // An older compiler is told so by cargo, and not by errors in files that nobody here wrote.
    let oldest = env!("CARGO_PKG_RUST_VERSION");
    format!(
        "[package]\nname = \"{package}\"\nversion = \"0.0.0\"\nedition = \"2024\"\nrust-version = \"{oldest}\"\n\
         publish = false\nbuild = false\n\
         autolib = false\nautobins = false\nautotests = false\nautoexamples = false\nautobenches = false\n\n\
         [[bin]]\nname = \"{package}\"\npath = \"src/main.rs\"\ntest = false\n\n\
         [lints.rust]\nunsafe_code = \"forbid\"\n\n\
         [profile.dev]\ndebug = false\nincremental = false\n\n[workspace]\n"
    )
}

fn lock_of(package: &str) -> String {
    format!("version = 4\n\n[[package]]\nname = \"{package}\"\nversion = \"0.0.0\"\n")
}
