//! The compiler for submissions: one that a user without an account can reach.
//!
//! Toolchains are often installed in the home of the user who grades, which is closed to others. Then hard links to
//! the parts that are needed, in a folder that is open, make them reachable without opening the home; where links
//! cannot be made, copies.

#[cfg(feature = "grade")]
use crate::lab::walls::{Task, View, Walls};
#[cfg(feature = "grade")]
use crate::lab::{End, Limits};
#[cfg(feature = "grade")]
use std::fs;
#[cfg(feature = "grade")]
use std::io;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Cargo and the compiler, not by way of any wrapper.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Toolchain {
    pub(super) cargo: PathBuf,
    pub(super) rustc: PathBuf,
    pub(super) root: PathBuf,
}

impl Toolchain {
    /// The toolchain that is in use here. `room` is a folder for links to it, if it has to be opened.
    #[cfg(feature = "grade")]
    pub(crate) fn find(walls: &Walls, room: &Path) -> Result<Self, String> {
        let root = sysroot()?;
        let found = Self::at(&root);
        if !found.cargo.is_file() {
            return Err(format!("{} is missing: cargo and rustc must come from one toolchain", found.cargo.display()));
        }
        let Err(first) = found.works(walls) else { return Ok(found) };
        let copy = room.join("toolchain");
        open(&root, &copy).map_err(|error| format!("{first}; and no copy of the toolchain can be made: {error}"))?;
        let copied = Self::at(&copy);
        copied.works(walls).map(|()| copied)
    }

    /// The folder of all of it.
    #[cfg(feature = "grade")]
    pub(crate) fn root(&self) -> &Path {
        &self.root
    }

    /// The toolchain of this machine, for a build without walls.
    pub(crate) fn installed() -> Result<Self, String> {
        let found = Self::at(&sysroot()?);
        if found.cargo.is_file() {
            return Ok(found);
        }
        // Systems that keep the compiler apart have cargo somewhere on the path.
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        Ok(Self { cargo: cargo.into(), ..found })
    }

    fn at(root: &Path) -> Self {
        let program = |name: &str| root.join("bin").join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
        Self { cargo: program("cargo"), rustc: program("rustc"), root: root.to_path_buf() }
    }

    /// Whether the compiler starts behind the walls.
    #[cfg(feature = "grade")]
    fn works(&self, walls: &Walls) -> Result<(), String> {
        let resident = walls.resident().map_err(|error| error.to_string())?;
        let task = Task {
            program: self.rustc.clone(),
            args: vec!["--version".to_owned()],
            env: Vec::new(),
            folder: std::env::temp_dir(),
            view: View { run: vec![self.root.clone()], write: Vec::new(), tools: true },
            limits: Limits { seconds: 20.0, memory_mb: 4096, processes: 256, ..Limits::default() },
        };
        let ran = resident.run(&task, "");
        match ran.end {
            End::Exited(0) => Ok(()),
            End::NotStarted(why) => Err(why),
            end => Err(format!("the compiler does not run: {end:?} {}", String::from_utf8_lossy(&ran.stderr))),
        }
    }
}

fn sysroot() -> Result<PathBuf, String> {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let asked = Command::new(&rustc).args(["--print", "sysroot"]).current_dir(std::env::temp_dir()).output();
    let out = asked.map_err(|error| format!("{}: {error}; grading needs a Rust toolchain", rustc.to_string_lossy()))?;
    let path = String::from_utf8_lossy(&out.stdout).trim().to_owned();
    if out.status.success() && !path.is_empty() {
        return Ok(PathBuf::from(path));
    }
    Err(format!("{} does not say where it is: {}", rustc.to_string_lossy(), String::from_utf8_lossy(&out.stderr)))
}

/// Links what a build of plain code needs: the programs, the compiler's own libraries, the standard library.
#[cfg(feature = "grade")]
fn open(root: &Path, to: &Path) -> io::Result<()> {
    link_files(&root.join("bin"), &to.join("bin"), &|name| ["cargo", "rustc"].contains(&name))?;
    link_files(&root.join("lib"), &to.join("lib"), &|name| name.contains(".so") || name.contains(".dylib"))?;
    for entry in fs::read_dir(root.join("lib/rustlib"))?.filter_map(Result::ok) {
        let (from, to) = (entry.path(), to.join("lib/rustlib").join(entry.file_name()));
        if from.join("lib").is_dir() {
            link_files(&from.join("lib"), &to.join("lib"), &|_| true)?;
            if from.join("bin").is_dir() {
                link_tree(&from.join("bin"), &to.join("bin"))?;
            }
        }
    }
    Ok(())
}

#[cfg(feature = "grade")]
fn link_files(from: &Path, to: &Path, wanted: &dyn Fn(&str) -> bool) -> io::Result<()> {
    fs::create_dir_all(to)?;
    for entry in fs::read_dir(from)?.filter_map(Result::ok) {
        let name = entry.file_name();
        if entry.path().is_file() && name.to_str().is_some_and(wanted) {
            let target = to.join(&name);
            fs::hard_link(entry.path(), &target).or_else(|_| fs::copy(entry.path(), &target).map(drop))?;
        }
    }
    Ok(())
}

#[cfg(feature = "grade")]
fn link_tree(from: &Path, to: &Path) -> io::Result<()> {
    link_files(from, to, &|_| true)?;
    for entry in fs::read_dir(from)?.filter_map(Result::ok) {
        if entry.file_type()?.is_dir() {
            link_tree(&entry.path(), &to.join(entry.file_name()))?;
        }
    }
    Ok(())
}
