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
use crate::Lab;
use crate::task::Runner;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// A room with a tree in it; removed when this is dropped, unless it is to be used again.
#[derive(Debug)]
pub(crate) struct Tree {
    room: PathBuf,
    /// Whether the room stays, and the next tree in it is compiled with what was made for this one.
    pub(super) stays: bool,
    /// The package, and the program it builds.
    pub(super) package: String,
    /// The student's files, as paths in the lab.
    pub(super) graded: Vec<String>,
}

impl Tree {
    /// Lays the tree out in a new folder `room`.
    pub(crate) fn lay(room: PathBuf, lab: &Lab, intake: &Intake, runner: &dyn Runner) -> io::Result<Self> {
        let tree = Self::in_room(room, lab, false);
        tree.furnish(runner)?;
        tree.write(lab, intake)?;
        Ok(tree)
    }

    /// Lays the tree out in a folder `room` that stays: new, or with the tree of an earlier check in it.
    pub(crate) fn lay_again(room: PathBuf, lab: &Lab, intake: &Intake, runner: &dyn Runner) -> io::Result<Self> {
        let tree = Self::in_room(room, lab, true);
        if tree.room.exists() {
            match fs::remove_dir_all(tree.folder()) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
                _ => {}
            }
        } else {
            tree.furnish(runner)?;
        }
        tree.write(lab, intake)?;
        Ok(tree)
    }

    fn in_room(room: PathBuf, lab: &Lab, stays: bool) -> Self {
        Self { room, stays, package: lab.manifest.package.clone(), graded: lab.manifest.graded.clone() }
    }

    /// Makes the room and the folders in which the compiler may write.
    fn furnish(&self, runner: &dyn Runner) -> io::Result<()> {
        fs::create_dir(&self.room)?;
        own_only(&self.room, 0o750)?;
        runner.let_in(&self.room)?;
        for folder in [self.target(), self.tmp(), self.home()] {
            fs::create_dir(&folder)?;
            own_only(&folder, 0o700)?;
            runner.give(&folder)?;
        }
        Ok(())
    }

    fn write(&self, lab: &Lab, intake: &Intake) -> io::Result<()> {
        let given =
            lab.files.iter().filter(|(path, _)| path.starts_with("src/") && !self.graded.iter().any(|g| g == path));
        let students = intake.graded.iter().map(|(path, text)| (path.as_str(), text.as_str()));
        for (path, text) in given.chain(students) {
            let file = self.folder().join(path);
            fs::create_dir_all(file.parent().unwrap_or(&self.room))?;
            fs::write(file, text)?;
        }
        fs::write(self.folder().join("Cargo.toml"), manifest_of(&self.package, self.stays))?;
        fs::write(self.folder().join("Cargo.lock"), lock_of(&self.package))
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
        if !self.stays {
            let _ = fs::remove_dir_all(&self.room);
        }
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
///
/// What is built once is not optimised: that would take a second, and saves a half. What is built again after each save
/// is: only the parts with changed functions are compiled then, and without optimising across parts, which would touch
/// all of them again. Calls stay calls at this level, so that a recursion without end overflows the stack in both.
fn manifest_of(package: &str, incremental: bool) -> String {
    // An older compiler is told so by cargo, and not by errors in files that nobody here wrote.
    let oldest = env!("CARGO_PKG_RUST_VERSION");
    let level = u8::from(incremental);
    format!(
        "[package]\nname = \"{package}\"\nversion = \"0.0.0\"\nedition = \"2024\"\nrust-version = \"{oldest}\"\n\
         publish = false\nbuild = false\n\
         autolib = false\nautobins = false\nautotests = false\nautoexamples = false\nautobenches = false\n\n\
         [[bin]]\nname = \"{package}\"\npath = \"src/main.rs\"\ntest = false\n\n\
         [lints.rust]\nunsafe_code = \"forbid\"\n\n\
         [profile.dev]\ndebug = false\nopt-level = {level}\nlto = \"off\"\nincremental = {incremental}\n\n[workspace]\n"
    )
}

fn lock_of(package: &str) -> String {
    format!("version = 4\n\n[[package]]\nname = \"{package}\"\nversion = \"0.0.0\"\n")
}
