//! The compiler for submissions: one that a user without an account can reach.
//!
//! Toolchains are often installed in the home of the user who grades, which is closed to others. Then hard links to
//! the parts that are needed, in a folder that is open, make them reachable without opening the home; where links
//! cannot be made, copies.

#[cfg(feature = "grade")]
use super::USUAL_BUILD;
#[cfg(feature = "grade")]
use super::linker::Linker;
#[cfg(feature = "grade")]
use super::tree::own_only;
#[cfg(feature = "grade")]
use crate::End;
#[cfg(feature = "grade")]
use crate::sandbox::{Runner, Sandbox, Task, View, unguessable};
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
    /// The standard library, whose sources the compiler may name.
    pub(super) library: PathBuf,
    /// Where programs are looked for while a submission is built.
    pub(super) path: String,
    /// What the compiler sees of the machine besides the system's own: itself and its linker.
    pub(super) parts: Vec<PathBuf>,
}

impl Toolchain {
    /// The toolchain that is in use here. `room` is a folder for links to it, if it has to be opened.
    #[cfg(feature = "grade")]
    pub(crate) fn find(sandbox: &Sandbox, room: &Path) -> Result<Self, String> {
        let root = sysroot()?;
        let linker = linker()?;
        let found = Self::at(&root).with(linker.as_ref());
        if !found.cargo.is_file() {
            return Err(format!("{} is missing: cargo and rustc must come from one toolchain", found.cargo.display()));
        }
        let Err(first) = found.works(sandbox, room) else { return Ok(found) };
        let copy = room.join("toolchain");
        open(&root, &copy).map_err(|error| format!("{first}; and no copy of the toolchain can be made: {error}"))?;
        let copied = Self::at(&copy).with(linker.as_ref());
        copied.works(sandbox, room).map(|()| copied)
    }

    /// What the compiler sees of the machine besides the system's own.
    #[cfg(feature = "grade")]
    pub(crate) fn parts(&self) -> &[PathBuf] {
        &self.parts
    }

    /// The toolchain of this machine, for a build without a sandbox.
    pub(crate) fn installed() -> Result<Self, String> {
        let found = Self::at(&sysroot()?);
        if found.cargo.is_file() {
            return Ok(found);
        }
        // Systems that keep the compiler apart have cargo somewhere on the path.
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        Ok(Self { cargo: cargo.into(), ..found })
    }

    /// What the compiler says of itself: version, commit, host.
    #[cfg(feature = "grade")]
    pub(crate) fn version(&self) -> Result<String, String> {
        let asked = Command::new(&self.rustc).arg("-vV").current_dir(std::env::temp_dir()).output();
        let out = asked.map_err(|error| format!("{}: {error}", self.rustc.display()))?;
        Ok(String::from_utf8_lossy(&out.stdout).trim().to_owned())
    }

    fn at(root: &Path) -> Self {
        let program = |name: &str| root.join("bin").join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
        Self {
            cargo: program("cargo"),
            rustc: program("rustc"),
            library: library_of(root),
            path: std::env::var("PATH").unwrap_or_default(),
            parts: parts_of(root),
        }
    }

    /// The same toolchain, and this linker alone is found.
    #[cfg(feature = "grade")]
    fn with(mut self, linker: Option<&Linker>) -> Self {
        if let Some(linker) = linker {
            self.path = format!("{}:/usr/bin:/bin", linker.folder.display());
            self.parts.extend(linker.parts.clone());
        }
        self
    }

    /// Whether the compiler and its linker work in the sandbox: what fails for every submission is no submission's
    /// fault.
    #[cfg(feature = "grade")]
    fn works(&self, sandbox: &Sandbox, room: &Path) -> Result<(), String> {
        let why = |error: io::Error| format!("no room to try the compiler: {error}");
        let resident = sandbox.resident().map_err(|error| error.to_string())?;
        let folder = room.join(format!("trial-{}", unguessable()));
        let made = folder.join("made");
        fs::create_dir(&folder).map_err(why)?;
        let laid = own_only(&folder, 0o750)
            .and_then(|()| resident.let_in(&folder))
            .and_then(|()| fs::write(folder.join("main.rs"), "fn main() {}\n"))
            .and_then(|()| fs::create_dir(&made))
            .and_then(|()| own_only(&made, 0o700))
            .and_then(|()| resident.give(&made));
        let text = |path: &Path| path.to_string_lossy().into_owned();
        let task = Task {
            program: self.rustc.clone(),
            args: vec!["main.rs".to_owned(), "-o".to_owned(), text(&made.join("program"))],
            env: [("PATH", self.path.clone()), ("TMPDIR", text(&made))].map(|(n, v)| (n.to_owned(), v)).into(),
            folder: folder.clone(),
            view: View {
                run: self.parts.iter().cloned().chain([folder.join("main.rs")]).collect(),
                write: vec![made],
                tools: true,
            },
            limits: USUAL_BUILD,
        };
        let ran = laid.map(|()| resident.run(&task, "")).map_err(why);
        let _ = fs::remove_dir_all(&folder);
        let ran = ran?;
        match ran.end {
            End::Exited(0) => Ok(()),
            End::NotStarted(why) => Err(why),
            end => Err(format!("the compiler does not run: {end:?} {}", String::from_utf8_lossy(&ran.stderr))),
        }
    }
}

/// The linker, on systems where it can be asked for its parts.
#[cfg(feature = "grade")]
fn linker() -> Result<Option<Linker>, String> {
    if cfg!(target_os = "linux") { Linker::find().map(Some) } else { Ok(None) }
}

/// What a build needs of a toolchain, and nothing that lies beside it: its root is `/usr` or `/usr/local` on some
/// machines.
fn parts_of(root: &Path) -> Vec<PathBuf> {
    let program = |name: &str| root.join("bin").join(format!("{name}{}", std::env::consts::EXE_SUFFIX));
    let mut parts = vec![program("cargo"), program("rustc"), library_of(root)];
    let libraries = fs::read_dir(root.join("lib")).into_iter().flatten().filter_map(Result::ok);
    let shared = |name: &str| name.contains(".so") || name.contains(".dylib");
    parts.extend(libraries.filter(|entry| entry.file_name().to_str().is_some_and(shared)).map(|entry| entry.path()));
    parts
}

/// The standard library, with the compiler's own tools.
fn library_of(root: &Path) -> PathBuf {
    root.join("lib/rustlib")
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_lies_beside_a_toolchain_is_no_part_of_it() {
        let dir = tempfile::tempdir().unwrap();
        for file in
            ["bin/cargo", "bin/mail", "lib/librustc.so", "lib/rustlib/x/lib/a", "lib/secrets/seed", "src/lab.rs"]
        {
            let path = dir.path().join(file);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, "").unwrap();
        }
        let parts = parts_of(dir.path());
        let shown = |file: &str| parts.iter().any(|part| dir.path().join(file).starts_with(part));
        assert!(shown("bin/cargo") && shown("lib/librustc.so") && shown("lib/rustlib/x/lib/a"));
        assert!(!shown("bin/mail") && !shown("lib/secrets/seed") && !shown("src/lab.rs"));
    }
}
